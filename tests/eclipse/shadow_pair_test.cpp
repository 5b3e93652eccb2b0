// The shadow of a sphere against rays from a point to the points of the Sun, and against angles
// computed in extended precision.
#include "eclipse/shadow_pair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "document/input_error.h"
#include "eclipse/limb_darkening.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

using Extended = long double;
constexpr Length kSun = kSolarRadiusIau;
constexpr Length kMoon = kLunarKIau * kEarthEquatorialRadius;

// Share of a spherical Sun's disc seen past a sphere, by rays to a polar grid of equal areas on it.
double visibleByRays(const glm::dvec3& point, const glm::dvec3& sun, double sunRadius,
                     const glm::dvec3& caster, double casterRadius) {
  glm::dvec3 toSun = sun - point;
  double distance = glm::length(toSun);
  glm::dvec3 w = toSun / distance;
  glm::dvec3 u = glm::normalize(glm::cross(w, glm::dvec3(0.3, -0.5, 0.8)));
  glm::dvec3 v = glm::cross(w, u);
  double edge = std::tan(std::asin(sunRadius / distance));
  const int kRings = 1000, kTurns = 1000;
  int seen = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    double r = edge * std::sqrt((ring + 0.5) / kRings);
    for (int turn = 0; turn < kTurns; ++turn) {
      double a = 2.0 * M_PI * (turn + 0.5 * (ring % 2)) / kTurns;
      glm::dvec3 ray = glm::normalize(w + u * (r * std::cos(a)) + v * (r * std::sin(a)));
      glm::dvec3 toCaster = caster - point;
      double along = glm::dot(toCaster, ray);
      bool hidden = along > 0.0 && glm::length(toCaster - ray * along) < casterRadius;
      seen += !hidden;
    }
  }
  return static_cast<double>(seen) / (kRings * kTurns);
}

struct Scene {
  const char* name;
  double sunDistance, casterDistance, casterRadius;
  double from, to;  // the points' distances from the axis
};

TEST(ShadowPair, LightAtPointsAgreesWithRays) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  glsl::LimbDarkening uniform = limbDarkening(LimbDarkeningLaw::None, {});
  for (const Scene& scene : {Scene{"Moon on Earth", 1.496e11, 3.7e8, 1.7374e6, 0.0, 4.0e6},
                             Scene{"annular", 1.48e11, 4.05e8, 1.7374e6, 0.0, 4.0e6},
                             Scene{"Earth on Moon", 1.496e11, 3.84e8, 6.371e6, 4.0e6, 8.5e6},
                             Scene{"Io on Jupiter", 7.78e11, 4.2e8, 1.8216e6, 1.0e6, 2.4e6},
                             Scene{"low orbit", 1.496e11, 2.4e6, 6.371e6, 6.3e6, 6.42e6}}) {
    glm::dvec3 direction = glm::normalize(glm::dvec3(unit(random), unit(random), unit(random)));
    glm::dvec3 sun = direction * scene.sunDistance;
    glm::dvec3 caster = direction * scene.casterDistance;
    glm::dvec3 side = glm::normalize(glm::cross(direction, glm::dvec3(0.1, 0.9, 0.2)));
    glsl::ShadowPair pair = shadowPairMetres(
        sun, caster, {kSun, scene.casterRadius * metre, scene.casterRadius * metre});
    int partial = 0;
    for (int i = 0; i < 16; ++i) {
      double off = scene.from + (scene.to - scene.from) * (i + 0.5) / 16.0;
      glm::dvec3 point = side * off + direction * (1e5 * unit(random));
      double expected = visibleByRays(point, sun, kSun.si, caster, scene.casterRadius);
      double found = glsl::visibleSunlight(pair, uniform, point).x;
      // The grid of rays errs by 1e-3 at most, five nodes by 2e-4.
      EXPECT_NEAR(found, expected, 1.2e-3) << scene.name << " " << off;
      partial += expected > 0.01 && expected < 0.99;
      EXPECT_TRUE(expected == 1.0 || glsl::mayBeShaded(pair, point, 0.0)) << scene.name;
    }
    EXPECT_GT(partial, 2) << scene.name;
  }
}

TEST(ShadowPair, GapIsExactAtTheConesAndPreciseBetween) {
  glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.7, 0.2));
  glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0.0, 0.0, 1.0)));
  for (double moonDistance : {3.57e8, 3.75e8, 4.05e8}) {
    glm::dvec3 moon = -axis * moonDistance + side * 2.0e6;
    glm::dvec3 sun = -axis * 1.496e11 + side * 2.0e6;
    glsl::ShadowPair pair = shadowPairMetres(sun, moon, {kSun, kMoon, kMoon});
    for (double along : {-6e6, 0.0, 6e6}) {
      double umbra = glsl::umbraRadiusAt(pair, along);
      glsl::DiscPair first = glsl::discsAt(pair, along, glsl::penumbraRadiusAt(pair, along));
      EXPECT_NEAR(first.gap / (2.0 * first.sun), 1.0, 1e-8);
      for (double off : {1.0, 100.0, 1e4, 1e6, 3e6}) {
        double distance = std::fabs(umbra) + off;
        glsl::DiscPair discs = glsl::discsAt(pair, along, distance);
        Extended zMoon = static_cast<Extended>(moonDistance) + along, zSun = 1.496e11L + along;
        Extended m = distance;
        Extended separation = std::atan2(m, zMoon) - std::atan2(m, zSun);
        Extended solar = std::asin(static_cast<Extended>(kSun.si) / std::hypot(m, zSun));
        Extended lunar = std::asin(static_cast<Extended>(kMoon.si) / std::hypot(m, zMoon));
        Extended gap = separation - (lunar - solar);
        // 1e-9 of the gap; rounding of coordinates of 1e8 m (1e-8 m) where it is a metre wide.
        EXPECT_NEAR(discs.gap / static_cast<double>(gap), 1.0, 1e-9 + 1e-6 / off) << off;
        EXPECT_NEAR(discs.sun / static_cast<double>(solar), 1.0, 1e-9);
        // Difference of radii in the plane instead of on the sphere: 3e-6 of it.
        EXPECT_NEAR(discs.excess, static_cast<double>(lunar - solar), 3e-6 * 3e-4);
      }
    }
    // At the umbral cone the eclipse begins or ends; at the antumbral one the ring breaks.
    double umbra = glsl::umbraRadiusAt(pair, 0.0);
    glsl::DiscPair discs = glsl::discsAt(pair, 0.0, std::fabs(umbra));
    EXPECT_NEAR(discs.gap + (umbra > 0.0 ? 0.0 : 2.0 * discs.excess), 0.0, 2e-9);
  }
}

TEST(ShadowPair, RaysCrossTheConesWhereTheirPointsDo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  glsl::ShadowPair pair =
      shadowPairMetres({1.496e11, 0.0, 0.0}, {3.7e8, 1e6, 0.0}, {kSun, kMoon, kMoon});
  int crossed = 0;
  for (int i = 0; i < 4000; ++i) {
    glm::dvec3 target(6.4e6 * unit(random), 1e6 + 4e6 * unit(random), 4e6 * unit(random));
    glm::dvec3 direction = glm::normalize(glm::dvec3(unit(random), unit(random), unit(random)));
    if (i % 5 == 0) direction = glm::normalize(glm::dvec3(1.0, 0.01 * unit(random), 0.0));
    glm::dvec3 origin = target - direction * (i % 3 == 0 ? 1e9 : 2e7);
    for (bool umbra : {true, false}) {
      glsl::ConeCrossing crossing = umbra ? glsl::crossUmbra(pair, origin, direction)
                                          : glsl::crossPenumbra(pair, origin, direction);
      auto outside = [&](double t) {
        glsl::ShadowPlace place = glsl::placeInShadow(pair, origin + direction * t);
        double radius = umbra ? glsl::umbraRadiusAt(pair, place.along)
                              : glsl::penumbraRadiusAt(pair, place.along);
        return place.distance - std::fabs(radius);
      };
      if (crossing.count == 0) {
        for (int k = 0; k < 20; ++k) EXPECT_GT(outside(4e7 * unit(random)), -0.1);
        continue;
      }
      EXPECT_LE(crossing.first, crossing.second);
      for (double t : {crossing.first, crossing.second}) {
        if (std::fabs(t) > 1e10) continue;  // nearly along the flank
        EXPECT_NEAR(outside(t), 0.0, 0.01) << i;
        ++crossed;
      }
      double middle = 0.5 * (crossing.first + crossing.second);
      EXPECT_EQ(outside(middle) < 0.0, crossing.insideBetween > 0.5) << i;
    }
  }
  EXPECT_GT(crossed, 1000);
}

TEST(ShadowPair, ConeTestNeverMissesAShadedSphere) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  glsl::ShadowPair pair =
      shadowPairMetres({1.496e11, 0.0, 0.0}, {3.7e8, 1e6, 0.0}, {kSun, kMoon, kMoon});
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    glm::dvec3 centre = 1e7 * glm::dvec3(unit(random), unit(random), unit(random));
    double radius = 2e6 * std::fabs(unit(random));
    bool may = glsl::mayBeShaded(pair, centre, radius);
    refused += !may;
    for (int k = 0; k < 20 && !may; ++k) {
      glm::dvec3 point =
          centre + radius * glm::normalize(glm::dvec3(unit(random), unit(random), unit(random)));
      glsl::ShadowPlace place = glsl::placeInShadow(pair, point);
      glsl::DiscPair discs = glsl::discsAt(pair, place.along, place.distance);
      EXPECT_GE(discs.gap, 2.0 * discs.sun);
    }
  }
  EXPECT_GT(refused, 300);
  // Sunward of the Moon nothing is shaded.
  EXPECT_FALSE(glsl::mayBeShaded(pair, {4.0e8, 1e6, 0.0}, 1e6));
}

TEST(ShadowPair, OriginMayLieAnywhere) {
  glm::dvec3 sun(1.496e11, 0.0, 0.0), moon(3.7e8, 1e6, 0.0), camera(5e6, 1.2e6, -3e6);
  ShadowRadii radii{kSun, kMoon, kMoon};
  glsl::ShadowPair centred = shadowPairMetres(sun, moon, radii);
  glsl::ShadowPair nearby = shadowPairMetres(sun - camera, moon - camera, radii);
  glsl::LimbDarkening law = limbDarkening(LimbDarkeningLaw::None, {});
  for (double y : {0.0, 9e4, 2e5, 1e6}) {
    glm::dvec3 point(1e5, y, 3e6);
    EXPECT_NEAR(glsl::visibleSunlight(centred, law, point + camera).x,
                glsl::visibleSunlight(nearby, law, point).x, 1e-9);
  }
}

TEST(ShadowPair, RefusesImpossibleBodies) {
  EXPECT_THROW(shadowPairMetres({1e11, 0, 0}, {4e8, 0, 0}, {0.0 * metre, kMoon, kMoon}),
               InputError);
  EXPECT_THROW(shadowPairMetres({1e9, 0, 0}, {9e8, 0, 0}, {kSun, kMoon, kMoon}), InputError);
}

}  // namespace
}  // namespace antumbra
