// The ray reference itself, against closed forms that owe it nothing.
#include "eclipse/rays_to_sun.h"

#include <gtest/gtest.h>

#include <cmath>

namespace antumbra {
namespace {

// Area of the part of a unit disc inside another disc (radius o, centre d away), by circular
// segments.
double coveredByDisc(double o, double d) {
  if (d >= 1.0 + o) return 0.0;
  if (o >= 1.0 + d) return 1.0;
  if (1.0 >= o + d) return o * o;
  double const a = std::acos((d * d + 1.0 - o * o) / (2.0 * d));
  double const b = std::acos((d * d + o * o - 1.0) / (2.0 * d * o));
  return (a - std::sin(a) * std::cos(a) + o * o * (b - std::sin(b) * std::cos(b))) / M_PI;
}

TEST(RaysToSun, SpheresHideWhatTheirDiscsCover) {
  // Far away and small, so that the sky is a plane: 1e-6 of curvature.
  double const sun = 1e-3, far = 1e11, near = 1e8;
  for (double o : {0.3, 0.7, 1.0, 1.4, 8.0})
    for (double d : {0.0, 0.2, 0.5, 0.9, 1.3, 1.8, 7.5}) {
      OpaqueSpheroid const body{
          {near, near * sun * d, 0.0}, {0, 0, 1}, near * sun * o, near * sun * o};
      double const found =
          visibleLightByRays({0, 0, 0}, {far, 0, 0}, far * sun, std::span(&body, 1), {});
      EXPECT_NEAR(found, 1.0 - coveredByDisc(o, d), 1e-4) << o << " " << d;
    }
}

TEST(RaysToSun, ASpheroidHidesItsEllipse) {
  // Equator on: inside the Sun an ellipse of area a c.
  double const sun = 1e-3, far = 1e11, near = 1e8;
  OpaqueSpheroid const body{{near, 0.0, 0.0}, {0, 0, 1}, near * sun * 0.8, near * sun * 0.5};
  EXPECT_NEAR(visibleLightByRays({0, 0, 0}, {far, 0, 0}, far * sun, std::span(&body, 1), {}),
              1.0 - 0.8 * 0.5, 1e-4);
  // Pole on: a circle.
  OpaqueSpheroid const turned{{near, 0.0, 0.0}, {1, 0, 0}, near * sun * 0.8, near * sun * 0.5};
  EXPECT_NEAR(visibleLightByRays({0, 0, 0}, {far, 0, 0}, far * sun, std::span(&turned, 1), {}),
              1.0 - 0.64, 1e-4);
}

}  // namespace
}  // namespace antumbra
