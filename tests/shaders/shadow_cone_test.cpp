// Depth of a line of sight in a cone of shadow, against quadrature along the ray.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/as_cpp.h"

namespace antumbra {
namespace {

struct Case {
  glm::dvec3 foot, axis, ray;
  glsl::ConePiece piece;
  double farthest;
};

// The integral of 1/radius over the part of the ray inside, by many short steps.
double quadrature(const Case& c) {
  constexpr int kSteps = 400000;
  double sum = 0.0;
  double const step = c.farthest / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    glm::dvec3 const p = c.ray * ((i + 0.5) * step) - c.foot;
    double const along = glm::dot(p, c.axis);
    if (along < c.piece.start || along > c.piece.end) continue;
    double const radius = c.piece.radius + c.piece.gain * along;
    if (glm::length(p - along * c.axis) < radius) sum += step / radius;
  }
  return sum;
}

glm::dvec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

TEST(ShadowCone, DepthIsItsIntegral) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int met = 0;
  for (int i = 0; i < 120; ++i) {
    Case c;
    c.axis = randomDirection(random);
    // Camera within twice the cone's radius of the axis: in and out of it.
    glm::dvec3 const side = glm::normalize(glm::cross(c.axis, randomDirection(random)));
    c.foot = side * (2.0 * unit(random));
    c.piece.gain = 0.6 * (unit(random) - 0.5);
    c.piece.radius = 1.0;
    c.piece.start = -3.0 * unit(random);
    c.piece.end = 3.0 * unit(random);
    c.farthest = 1.0 + 8.0 * unit(random);
    c.ray = randomDirection(random);
    double const want = quadrature(c);
    double const found = glsl::depthInCone(c.foot, c.axis, c.piece, c.ray, c.farthest, 0.0);
    // Steps of 2e-5 lose up to one at each end of the stretch, over a radius of at least 0.1.
    EXPECT_NEAR(found, want, 5e-4) << i;
    if (want > 0.0) ++met;
  }
  EXPECT_GT(met, 40);
}

// Steeper than the flank a ray stays within the cone; along the axis the depth is a logarithm.
TEST(ShadowCone, AlongTheAxisItIsALogarithm) {
  glsl::ConePiece const piece{1000.0, -0.01, 0.0, 99000.0};
  glm::dvec3 const axis(0, 0, 1);
  double const depth = glsl::depthInCone({0, 0, 0}, axis, piece, axis, 1e30, 0.0);
  EXPECT_NEAR(depth, std::log(1000.0 / 10.0) / 0.01, 1e-3);
}

// The same number from both sides of the surface: nothing flickers as the camera passes through it.
TEST(ShadowCone, IsContinuousAcrossItsSurface) {
  glm::dvec3 const axis(0, 0, 1);
  glsl::ConePiece const piece{1.0, -0.0046, -100.0, 100.0};
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    glm::dvec3 const ray = randomDirection(random);
    double const step = 1e-7;
    double const inside = glsl::depthInCone({1.0 - step, 0, 0}, axis, piece, ray, 1e30, 1e-3);
    double const outside = glsl::depthInCone({1.0 + step, 0, 0}, axis, piece, ray, 1e30, 1e-3);
    // A grazing ray changes by the square root of the step.
    EXPECT_NEAR(inside, outside, 4e-3 * (1.0 + inside)) << i;
  }
}

// Far thinner than a pixel a cone's light over a line across it is that of its width.
TEST(ShadowCone, FadesWhereItIsThinnerThanAPixel) {
  glm::dvec3 const axis(1, 0, 0);
  double const distance = 1e4, pixel = 1e-3;  // 10 m a pixel
  auto const across = [&](double radius) {
    glsl::ConePiece const piece{radius, 0.0, -1e6, 1e6};
    double sum = 0.0;
    for (int i = -2000; i < 2000; ++i) {
      double const angle = (i + 0.5) * pixel / 100.0;
      glm::dvec3 const ray(0.0, std::sin(angle), std::cos(angle));
      sum += glsl::depthInCone({0, 0, distance}, axis, piece, ray, 1e30, pixel) / 100.0;
    }
    return sum;  // in pixels
  };
  EXPECT_NEAR(across(0.01) / across(0.1), 0.1, 0.01);
  EXPECT_GT(across(0.01), 0.0);
  // A wide one holds its own integral: pi/2 of its radius in pixels times 2.
  EXPECT_NEAR(across(40.0), 3.14159265 * 4.5 * 40.0 / 45.0, 0.4);
}

}  // namespace
}  // namespace antumbra
