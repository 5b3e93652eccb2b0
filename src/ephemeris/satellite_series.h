// Moons of the planets, and the planets about their barycentres, as fitted trigonometric series
// with powers of time (method and layout: tools/build_moon_catalogue). Source: JPL's numerical
// integrations of 2020 (Horizons), 1900-2100 or 1900-2046; the residual of each is stored with it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ephemeris/mapped_catalogue.h"
#include "ephemeris/state.h"

namespace antumbra {

// One body's series: r(t) = sum t^p (C cos(w tau) + S sin(w tau)), kilometres along Icrs.
struct SatelliteSeries {
  struct Term {
    double radiansPerDay;
    std::uint32_t power, unused;
    float cosineKm[3], sineKm[3];
  };
  std::string body, centre;
  double middleTdbDays = 0.0, halfSpanDays = 1.0;  // since J2000
  double drift[4] = {};                            // tau - d in days: powers 2 to 5 of t
  const Term* terms = nullptr;
  std::size_t termCount = 0;
  Length residual;  // largest error against the source

  Span span() const;
  bool covers(double tdbDays) const;
  // Relative to `centre`. Throws SpanError outside the span unless `extrapolate`.
  State state(double tdbDays, bool extrapolate) const;
};

class SatelliteCatalogue {
 public:
  // Throws InputError if the file is missing or inconsistent.
  explicit SatelliteCatalogue(const std::filesystem::path& file);
  // Null where the catalogue lacks the body.
  const SatelliteSeries* find(const std::string& body) const;
  const std::vector<SatelliteSeries>& all() const { return series_; }

 private:
  MappedCatalogue file_;
  std::vector<SatelliteSeries> series_;
};

}  // namespace antumbra
