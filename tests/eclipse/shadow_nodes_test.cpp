// The lattice of shadows at which eclipsed light is computed ahead.
#include "eclipse/shadow_nodes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "quantity/constants.h"

namespace antumbra {
namespace {

constexpr Length kRadius{6378137.0};

// A shadow whose axis passes `away` metres from the centre, of a Moon at `moonDistance`.
glsl::ShadowPair pairAt(double away, double moonDistance) {
  glm::dvec3 const toSun = glm::normalize(glm::dvec3(0.6, -0.3, 0.2));
  glm::dvec3 const across = glm::normalize(glm::cross(toSun, glm::dvec3(0.0, 0.0, 1.0)));
  return shadowPairMetres(across * away + toSun * 1.0132 * astronomicalUnit.si,
                          across * away + toSun * moonDistance,
                          {kSolarRadiusIau, 1737.4 * kilometre, 1737.4 * kilometre});
}

struct Mean {
  double axisDistance = 0.0, umbra = 0.0, penumbra = 0.0, weight = 0.0;
};

Mean meanOf(const std::vector<ShadowNode>& nodes) {
  Mean m;
  for (auto const& n : nodes) {
    m.weight += n.weight;
    m.axisDistance += n.weight * n.pair.foot.x;
    m.umbra += n.weight * n.pair.umbraRadius;
    m.penumbra += n.weight * n.pair.penumbraRadius;
  }
  return m;
}

TEST(ShadowNodes, SurroundTheShadow) {
  for (double away : {0.0, 1.0e6, 4.0e6, 6.2e6, 6.4e6, 8.0e6})
    for (double moon : {3.56e8, 3.72e8, 4.06e8}) {
      auto const pair = pairAt(away, moon);
      auto const nodes = shadowNodes(pair, Length(away), kRadius, {});
      ASSERT_GE(nodes.size(), 1u);
      ASSERT_LE(nodes.size(), 3u);
      Mean const m = meanOf(nodes);
      EXPECT_NEAR(m.weight, 1.0, 1e-12);
      // What linear interpolation over a step of the lattices misses: 2 % of the body, a tenth
      // of the step of the umbra's radius.
      EXPECT_NEAR(m.axisDistance, away, 0.02 * (kRadius.si + away)) << moon;
      EXPECT_NEAR(m.umbra, pair.umbraRadius, 0.01 * (36e3 + std::fabs(pair.umbraRadius))) << away;
      EXPECT_NEAR(m.penumbra / pair.penumbraRadius, 1.0, 2e-3);
      for (auto const& n : nodes) {
        EXPECT_GE(n.weight, 0.0);
        // Cones of two spheres: both radii grow apart by the caster's.
        double const sum = n.pair.umbraRadius * n.pair.umbraCosine + n.pair.penumbraRadius;
        EXPECT_NEAR(sum / (pair.umbraRadius * pair.umbraCosine + pair.penumbraRadius), 1.0, 0.01);
      }
    }
}

// A node that comes or goes does so with no weight: what is interpolated has no step.
TEST(ShadowNodes, AreContinuous) {
  Mean before;
  double axisStep = 0.0, umbraStep = 0.0;
  for (int i = 0; i <= 20000; ++i) {
    double const away = 7.0e6 * i / 20000.0, moon = 3.6e8 + 4e6 * std::sin(i * 1e-3);
    Mean const now = meanOf(shadowNodes(pairAt(away, moon), Length(away), kRadius, {}));
    if (i > 0) {
      axisStep = std::max(axisStep, std::fabs(now.axisDistance - before.axisDistance));
      umbraStep = std::max(umbraStep, std::fabs(now.umbra - before.umbra));
    }
    before = now;
  }
  // The axis moves by 350 m a step, the umbra by 19 m; at the limb, where the Sun's height goes as
  // the root of the distance, linear steps in height stretch that fivefold.
  EXPECT_LT(axisStep, 2000.0);
  EXPECT_LT(umbraStep, 25.0);
}

TEST(ShadowNodes, DoNotDependOnTheSunsSlowRetreat) {
  // An hour at 0.5 km/s: the nodes stay, but for their weights.
  auto const here = shadowNodes(pairAt(3e6, 3.6e8), Length(3e6), kRadius, {});
  auto pair = pairAt(3e6, 3.6e8);
  pair.sunBehind += 1.8e6;
  auto const later = shadowNodes(pair, Length(3e6), kRadius, {});
  ASSERT_EQ(here.size(), later.size());
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i].key, later[i].key);
}

TEST(ShadowNodes, KeepTheUmbraOnTheGround) {
  auto const pair = pairAt(0.0, 3.6e8);
  double const expected = pair.umbraRadius + kRadius.si * pair.umbraTangent;
  EXPECT_NEAR(umbraOnGround(pair, Length(0.0), kRadius).si, expected, 1e-6);
  EXPECT_NEAR(umbraOnGround(pair, Length(9e6), kRadius).si, pair.umbraRadius, 1e-6);
}

}  // namespace
}  // namespace antumbra
