// Where the bodies of the solar system are: geometric places and velocities at an instant, along
// the axes of Icrs, from any centre. No light time, no aberration: for what an eye sees,
// apparent.h.
//
// Evaluation is const and safe from any thread. Loading maps the catalogues without reading them.
#pragma once

#include <array>
#include <memory>

#include "ephemeris/body_id.h"
#include "ephemeris/elp_mpp02.h"
#include "ephemeris/state.h"
#include "ephemeris/vsop87.h"

namespace antumbra {

class Ephemeris {
 public:
  struct Options {
    bool extrapolate = false;  // no SpanError outside the spans; the caller says so in its output
  };
  // The project's own catalogues; loaded at the first call. Throws InputError if one is broken.
  static const Ephemeris& standard();
  explicit Ephemeris(Options options);

  // State of `target` relative to `centre`. Throws SpanError outside the theories' span.
  State state(BodyId target, BodyId centre, Instant t) const;
  // The span over which every body is known: -3000 to 3000.
  Span span() const;

 private:
  State heliocentric(BodyId body, double tdbDays) const;
  State sunFromBarycentre(double tdbDays) const;
  Options options_;
  std::shared_ptr<const SeriesCatalogue> planetCatalogue_, moonCatalogue_;
  std::array<PlanetSeries, kPlanets> planets_;
  MoonSeries moon_;
};

}  // namespace antumbra
