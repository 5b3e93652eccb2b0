// The sphere that stands for a spheroid: what grazes the one grazes the other.
#include "atmosphere/scaled_sphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "quantity/constants.h"

namespace antumbra {
namespace {

// Whether a ray meets the spheroid, by its own quadratic.
bool meets(const glm::dvec3& from, const glm::dvec3& d, double a, double c) {
  double const aa = (d.x * d.x + d.y * d.y) / (a * a) + d.z * d.z / (c * c);
  double const ab = (d.x * from.x + d.y * from.y) / (a * a) + d.z * from.z / (c * c);
  double const bb = (from.x * from.x + from.y * from.y) / (a * a) + from.z * from.z / (c * c) - 1.0;
  return ab < 0.0 && ab * ab > aa * bb;
}

TEST(ScaledSphere, KeepsHorizonsAndTheSunOnTheHorizon) {
  double const a = 6378137.0, c = 6356752.3;
  for (double h : {2.0, 4e5, 3.6e7})
    for (double latitude : {0.0, 0.8, -1.5707}) {
      glm::dvec3 const up(std::cos(latitude), 0.0, std::sin(latitude));
      glm::dvec3 const north(-std::sin(latitude), 0.0, std::cos(latitude)), east(0.0, 1.0, 0.0);
      // On the geodetic normal of a spheroid.
      double const n = a * a / std::sqrt(a * a * up.x * up.x + c * c * up.z * up.z);
      glm::dvec3 const place((n + h) * up.x, 0.0, (n * c * c / (a * a) + h) * up.z);
      for (double azimuth : {0.0, 1.0, 2.5}) {
        glm::dvec3 const level = north * std::cos(azimuth) + east * std::sin(azimuth);
        double low = -1.57, high = 0.0;  // elevation of the horizon
        for (int i = 0; i < 60; ++i) {
          double const middle = 0.5 * (low + high);
          (meets(place, level * std::cos(middle) + up * std::sin(middle), a, c) ? low : high) =
              middle;
        }
        glm::dvec3 const horizon = level * std::cos(low) + up * std::sin(low);
        ScaledSphere const sphere(Length(a), Length(c), {place}, {horizon});
        EXPECT_NEAR(sphere.height().si, h, 0.0035 * h + 1e-6);
        double const r = a + sphere.height().si;
        double const expected = std::acos(-std::sqrt(1.0 - (a / r) * (a / r)));
        // Radians; a float knows no better, and bisection at 2 m ends at a root of rounding.
        EXPECT_NEAR(std::acos(sphere({horizon}).u.z), expected, 1e-7) << h << " " << latitude;
        EXPECT_NEAR(sphere.sunZenith().si, expected, 1e-7);
        EXPECT_NEAR(sphere({horizon}).u.y, 0.0, 1e-12);
      }
      // Angles change by no more than twice the flattening's 0.00336 rad.
      glm::dvec3 const slant = glm::normalize(up + east + 0.5 * north);
      ScaledSphere const sphere(Length(a), Length(c), {place}, {east});
      EXPECT_NEAR(std::acos(sphere({slant}).u.z), std::acos(glm::dot(slant, up)), 0.0034);
    }
}

}  // namespace
}  // namespace antumbra
