// Depths of straight ways against a fine sum of the medium's own extinction.
#include "plan/air_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace antumbra {
namespace {

TEST(AirProfile, DepthsAreThoseOfTheMediumWithinAPercent) {
  Medium const medium = readMedium(mediumFile("earth"));
  Length const green = 550.0 * nanometre;
  AirProfile const profile(medium, green);
  double const ground = 6371e3;
  for (double const height : {0.0, 2e3, 30e3})
    for (double const cosine : {1.0, 0.5, 0.1, 0.0, -0.03}) {
      double const radius = ground + height, nearest = radius * std::sqrt(1.0 - cosine * cosine);
      if (cosine < 0.0 && nearest < ground) {
        EXPECT_EQ(profile.passed(radius, cosine, ground), 0.0);
        continue;
      }
      double const top = ground + medium.topHeight.si, from = radius * cosine;
      double const to = std::sqrt(top * top - nearest * nearest);
      constexpr int kFine = 40000;
      double depth = 0.0;
      for (int i = 0; i < kFine; ++i) {
        double const along = from + (to - from) * (i + 0.5) / kFine;
        double const above = std::hypot(along, nearest) - ground;
        depth += medium.extinctionAt(Length(above), green).si * (to - from) / kFine;
      }
      EXPECT_NEAR(-std::log(profile.passed(radius, cosine, ground)) / depth, 1.0, 0.01)
          << height << " m, " << cosine;
    }
}

// A Sun in the very zenith, whose cosine rounding lifts above 1.
TEST(AirProfile, RoundingMakesNoRootOfANegative) {
  Medium const medium = readMedium(mediumFile("earth"));
  AirProfile const profile(medium, 550.0 * nanometre);
  double const above = std::nextafter(1.0, 2.0);
  EXPECT_GT(profile.passed(6371e3, above, 6371e3), 0.1);
  EXPECT_GT(profile.passed(6371e3 + medium.topHeight.si + 1e-3, 0.0, 6371e3), 0.99);
}

}  // namespace
}  // namespace antumbra
