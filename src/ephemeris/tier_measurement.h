// What cutting a series costs in accuracy and saves in terms: truncated against full, at random
// dates. Serves the table of tiers (tiers.h), `antumbra trade ephemeris` and the tests.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ephemeris/tiers.h"

namespace antumbra {

struct TierMeasurement {
  std::size_t terms = 0;       // of the target's own series
  std::size_t earthTerms = 0;  // of the Earth's, evaluated beside it
  Angle geocentricMax, geocentricRms;
  Angle heliocentricMax;
  Angle
      droppedSum;  // rigorous: the sum of the amplitudes left out, heliocentric (Moon: geocentric)
  Angle worst() const { return std::max(geocentricMax, heliocentricMax); }
};

// The full series of one target at many dates, against which truncated ones are measured.
class TierMeasurer {
 public:
  // body: a planet other than the Earth, "Sun" or "Moon". `dates` random days over the span's years
  // (1900-2100, or -3000 to 3000), drawn with a fixed generator from `seed`.
  TierMeasurer(std::string body, TierSpan span, std::size_t dates, std::uint64_t seed);
  TierMeasurement measure(double thresholdRadians) const;

 private:
  std::string body_;
  TierSpan span_;
  std::vector<double> days_;
  std::vector<glm::dvec3> target_, earth_;  // heliocentric metres (Moon: geocentric)
};

// Every body that has tiers.
const std::vector<std::string>& tierBodies();

}  // namespace antumbra
