// Aberration of starlight against its constant, and the limiting magnitude.
#include "scene/apparent_stars.h"

#include <gtest/gtest.h>

#include "quantity/constants.h"

namespace antumbra {
namespace {

StarCatalogue oneStar(Direction<Icrs> direction, double magnitude) {
  StarCatalogue catalogue;
  Star star;
  star.directionAtJ2000 = direction;
  star.magnitudeV = magnitude;
  catalogue.stars.push_back(star);
  return catalogue;
}

// A star at right angles to the motion moves by atan(v/c) (gamma is 1 within 5e-9): 20.49551" at
// the Earth's mean speed, the constant of aberration (IAU 1976: 20.49552").
TEST(ApparentStars, MoveTowardTheObserversMotionByTheConstantOfAberration) {
  auto const stars =
      apparentStars(oneStar({{0, 1, 0}}, 1.0), Instant(),
                    Velocity<Icrs>{{20.49551 * arcsecond.si * kSpeedOfLight.si, 0, 0}}, 6.0);
  ASSERT_EQ(stars.size(), 1u);
  EXPECT_NEAR(angleBetween(stars[0].direction, Direction<Icrs>{{0, 1, 0}}) / arcsecond, 20.49551,
              1e-5);
  EXPECT_GT(stars[0].direction.u.x, 0.0);
}

TEST(ApparentStars, StopsAtTheLimitingMagnitude) {
  EXPECT_TRUE(apparentStars(oneStar({{0, 1, 0}}, 6.1), Instant(), {}, 6.0).empty());
  auto const bright = apparentStars(oneStar({{0, 1, 0}}, 0.0), Instant(), {}, 6.0);
  ASSERT_EQ(bright.size(), 1u);
  EXPECT_NEAR(bright[0].illuminance, 2.54e-6, 1e-12);
}

}  // namespace
}  // namespace antumbra
