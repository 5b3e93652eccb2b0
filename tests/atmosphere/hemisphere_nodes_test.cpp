// Irradiance summed over directions, against series.
#include "atmosphere/hemisphere_nodes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace antumbra {
namespace {

double henyeyGreenstein(double cosine, double g) {
  return (1.0 - g * g) / (4.0 * std::numbers::pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

// Irradiance of a plane by radiance henyeyGreenstein about a pole at a zenith angle: in Legendre
// polynomials the phase function has the coefficients (2 l + 1) g^l / 4 pi, and the cosine cut off
// below the horizon those that its integral over [0, 1] gives (Ramamoorthi & Hanrahan 2001, eq.
// 19).
double irradianceBySeries(double poleCosine, double g) {
  double sum = 0.25 + 0.5 * g * poleCosine;
  double before = 1.0, legendre = poleCosine, power = g, integral = 0.0;
  for (int l = 1; std::fabs(power) > 1e-12; ++l) {
    double const next = ((2.0 * l + 1.0) * poleCosine * legendre - l * before) / (l + 1.0);
    before = legendre;
    legendre = next;
    power *= g;
    int const degree = l + 1;
    if (degree % 2) continue;
    integral = degree == 2 ? 0.125 : integral * (3.0 - degree) / (degree + 2.0);
    sum += 0.5 * (2.0 * degree + 1.0) * integral * power * legendre;
  }
  return sum;
}

TEST(HemisphereNodes, SumUniformAndCosineSkies) {
  for (double zenith : {0.0, 7.0, 30.0, 60.0, 80.0, 89.0, 90.0, 96.0, 120.0, 180.0}) {
    double uniform = 0.0, cosine = 0.0;
    for (auto const& node : hemisphereNodes(zenith * degree)) {
      ASSERT_GE(node.direction.u.z, -1e-12);
      ASSERT_NEAR(glm::length(node.direction.u), 1.0, 1e-12);
      uniform += node.weight;
      cosine += node.weight * node.direction.u.z;
    }
    EXPECT_NEAR(uniform / std::numbers::pi, 1.0, 1e-7) << zenith;
    EXPECT_NEAR(cosine / (2.0 / 3.0 * std::numbers::pi), 1.0, 1e-7) << zenith;
  }
}

TEST(HemisphereNodes, ResolveAureoles) {
  for (double g : {-0.5, 0.0, 0.8, 0.9, 0.97, 0.99, 0.999}) {
    double worst = 0.0;
    for (double zenith : {0.0, 5.0, 30.0, 60.0, 80.0, 88.0, 89.9}) {
      double const pole = std::cos(zenith * degree.si);
      glm::dvec3 const sun(std::sin(zenith * degree.si), 0.0, pole);
      double sum = 0.0;
      for (auto const& node : hemisphereNodes(zenith * degree))
        sum += node.weight * henyeyGreenstein(glm::dot(node.direction.u, sun), g);
      worst = std::max(worst, std::fabs(sum / irradianceBySeries(pole, g) - 1.0));
    }
    std::printf("g %6.3f: within %.1e\n", g, worst);
    EXPECT_LT(worst, g < 0.995 ? 1e-6 : 2e-4) << g;
  }
}

}  // namespace
}  // namespace antumbra
