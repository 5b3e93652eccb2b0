// Where the bodies of the solar system are: geometric places and velocities at an instant, along
// the axes of Icrs, from any centre. No light time, no aberration: for what an eye sees,
// apparent.h.
//
// Two theories. The table reproduces JPL DE431 over 1800-2400 (0.003" for Sun, Moon, Mercury to
// Saturn; 0.02" for Uranus to Pluto; chebyshev_table.h). The series are full or truncated VSOP87
// and ELP/MPP02, -3000 to 3000 (vsop87.h, elp_mpp02.h), without Pluto.
//
// Moons of the planets, and the planets relative to their systems' barycentres, come from fitted
// series over 1900-2100 (Deimos, Mimas, moons of Neptune: 1900-2046; Phobos: 1900-2028;
// satellite_series.h). To be
// honest: outside that span the centre of a planet is taken to be its system's barycentre, which it
// leaves by up to 220 km (Jupiter, 0.07"), 300 km (Saturn, 0.05"), 2 100 km (Pluto, 0.1").
//
// Evaluation is const and safe from any thread. Loading maps the catalogues without reading them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "ephemeris/body_id.h"
#include "ephemeris/chebyshev_table.h"
#include "ephemeris/elp_mpp02.h"
#include "ephemeris/satellite_series.h"
#include "ephemeris/state.h"
#include "ephemeris/vsop87.h"

namespace antumbra {

enum class Theory { Auto, Series, Table };

// Series cut for a requested error, as seen by one target: every planet and the Moon keep the terms
// that this target needs.
struct TruncatedSeries {
  std::array<PlanetSeries, kPlanets> planets;
  MoonSeries moon;
  double thresholdRadians = 0.0;
  Angle measuredError;  // largest over 1e5 dates, geocentric and heliocentric
                        // (catalogs/ephemeris/tiers.txt)
  Angle droppedSum;     // sum of the amplitudes left out: the rigorous bound, heliocentric
};

class Ephemeris {
 public:
  struct Options {
    Theory theory = Theory::Auto;  // the table where it covers the date, else the series
    // Largest error of truncation that a series may add; none: every term. With theory Auto the
    // table still comes first where it covers.
    std::optional<Angle> error = std::nullopt;
    bool extrapolate = false;  // no SpanError outside the spans; the caller says so in its output
  };
  // The project's own catalogues with the options' defaults; loaded at the first call. Throws
  // InputError if one is broken.
  static const Ephemeris& standard();
  explicit Ephemeris(Options options);
  virtual ~Ephemeris();

  // State of `target` relative to `centre`. Throws SpanError outside the theories' span.
  virtual State state(BodyId target, BodyId centre, Instant t) const;
  // The same for several targets, sharing what they have in common; out as long as targets.
  virtual void states(std::span<const BodyId> targets, BodyId centre, Instant t,
                      std::span<State> out) const;

  // Which theory answers at this date: Table or Series. Throws SpanError outside.
  Theory theoryAt(Instant t) const;
  // "de431-table" or "vsop87+elpmpp02".
  static std::string nameOfTheory(Theory theory);
  // What answers for this pair: nameOfTheory, "+moons-fit" where a fitted series of the moons' file
  // takes part (also for a planet about its barycentre), "+extrapolated" outside a theory's span.
  std::string theoryName(BodyId target, BodyId centre, Instant t) const;
  // The largest error to expect of the direction from centre to target, against JPL DE431: measured
  // floor of the theory, by epoch, and what truncation adds. A moon outside its series may stand
  // anywhere on its orbit: the bound is that orbit's width.
  Angle errorBound(BodyId target, BodyId centre, Instant t) const;
  // The same with every term kept: no requested error reaches below it.
  Angle untruncatedErrorBound(BodyId target, BodyId centre, Instant t) const;
  // The span over which every body but Pluto is known: -3000 to 3000, or the table's.
  Span span() const;
  static Span tableSpan();
  // The truncated series that serve a target near 1900-2100; null where nothing is truncated.
  const TruncatedSeries* truncated(BodyId target, Instant t) const;
  const Options& options() const { return options_; }

 protected:
  // Place of a planet or moon relative to the body of its system (systemOf); zero for that body
  // itself. Throws SpanError for a moon outside its series.
  State withinSystem(BodyId body, double tdbDays) const;

 private:
  struct Tables;
  void systemStates(std::span<const BodyId> targets, BodyId centre, Instant t,
                    std::span<State> out) const;
  State fromSeries(BodyId target, BodyId centre, Instant t) const;
  State heliocentric(BodyId body, double tdbDays, const std::array<PlanetSeries, kPlanets>& planets,
                     const MoonSeries& moon) const;
  State sunFromBarycentre(double tdbDays, const std::array<PlanetSeries, kPlanets>& planets,
                          const MoonSeries& moon) const;
  void truncate(Angle error);
  Options options_;
  std::shared_ptr<const SeriesCatalogue> planetCatalogue_, moonCatalogue_;
  std::shared_ptr<const Tables> tables_;
  std::shared_ptr<const SatelliteCatalogue> satellites_;
  std::array<const SatelliteSeries*, 48> satelliteOf_{};  // by BodyId; null where it is its system
  std::array<PlanetSeries, kPlanets> planets_;
  MoonSeries moon_;
  // Two sets: for |t| up to a century from J2000, and for the whole span. Index: planet, then the
  // Moon.
  std::array<std::vector<TruncatedSeries>, 2> truncated_;
};

}  // namespace antumbra
