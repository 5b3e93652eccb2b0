// The measured errors of simpler shadows, on shipped scenes: what must be exact is, what must err
// does.
#include "plan/shadow_trial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "document/paths.h"
#include "scene/placed_scene.h"

namespace antumbra {
namespace {

std::vector<ShadowTrial> trialsOf(const std::string& name, const std::string& time, int points) {
  Scene scene = readScene(configsFolder() / "scenes" / (name + ".toml"));
  auto const placed =
      placeScene(scene, parseInstant(time.empty() ? scene.time : time, "test"),
                 BodyCatalogue::standard(), Ephemeris::standard(), DeltaT::standard());
  auto const plan = makeRenderPlan(scene, placed);
  std::vector<ShadowTrial> trials;
  for (auto const& receiver : shadowReceivers(plan))
    trials.emplace_back(receiver, plan.picture, LimbDarkeningLaw::Hestroffer, points);
  return trials;
}

// Callisto's and Io's shadows overlap on Jupiter.
TEST(ShadowTrial, UnionIsExactAndShortcutsAreNot) {
  auto const trials = trialsOf("jupiter_triple_shadow", "2015-01-24T05:49:40Z", 150);
  ASSERT_GE(trials.size(), 1u);
  auto const& jupiter = trials[0];
  EXPECT_GT(jupiter.points(), 100u);
  EXPECT_LT(jupiter.errorsOf({}).largestLight, 1e-3);
  auto const minimum = jupiter.errorsOf({.several = SeveralCasters::Minimum});
  auto const product = jupiter.errorsOf({.several = SeveralCasters::Product});
  auto const uniform = jupiter.errorsOf({.limbDarkened = false});
  EXPECT_GT(minimum.largestLight, 0.05);
  EXPECT_GT(product.largestLight, 0.03);
  EXPECT_LT(product.largestLight, minimum.largestLight);
  EXPECT_GT(uniform.largestLight, 0.01);
  EXPECT_LT(*jupiter.errorsOf({}).halfLightEdge / kilometre, 0.1);
  EXPECT_GT(*uniform.halfLightEdge / kilometre, 1.0);
  EXPECT_FALSE(uniform.largestAir);
}

TEST(ShadowTrial, SphereMissesTheEdgeOfAnOblateShadow) {
  auto const trials = trialsOf("saturn", "", 150);
  ASSERT_EQ(trials.size(), 1u);
  auto const exact = trials[0].errorsOf({}), sphere = trials[0].errorsOf({.spheroid = false});
  EXPECT_LT(exact.largestLight, 1e-3);
  EXPECT_LT(*exact.halfLightEdge / kilometre, 0.1);
  // The pole stands 5904 km lower than the equator, and the Sun sees most of that.
  EXPECT_GT(*sphere.halfLightEdge / kilometre, 3000.0);
  EXPECT_LT(*sphere.halfLightEdge / kilometre, 5904.0);
  EXPECT_GT(sphere.largestLight, 0.9);
}

TEST(ShadowTrial, MoreEvaluationsAlongARayErrLess) {
  auto const trials = trialsOf("luxor_dome", "2027-08-02T10:05:17Z", 30);
  ASSERT_EQ(trials.size(), 1u);
  ASSERT_GT(trials[0].airRays(), 50u);
  auto const meanOf = [&](bool split, int evaluations) {
    return *trials[0].errorsOf({.splitAtUmbra = split, .evaluations = evaluations}).meanAir;
  };
  // The ground's own darkness makes the sky black.
  EXPECT_GT(meanOf(false, 1), 0.2);
  EXPECT_LT(meanOf(false, 16), meanOf(false, 4));
  EXPECT_LT(meanOf(true, 4), 0.5 * meanOf(false, 4));
  EXPECT_LT(meanOf(true, 16), 0.5 * meanOf(true, 4));
  EXPECT_LT(meanOf(true, 16), 0.02);
}

}  // namespace
}  // namespace antumbra
