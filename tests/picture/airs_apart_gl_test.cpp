// Two bodies with air in one picture against each of them alone: what one body's air is made of
// must not show in the other's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "document/paths.h"
#include "picture/picture_renderer.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ground_window.h"

namespace antumbra {
namespace {

using AirsApart = testsupport::GlTest;
using testsupport::greyMap;

// The Earth from 12 000 km, and Mars moved before or behind its limb, under the same Sun.
struct TwoBodies {
  Scene scene = readScene(configsFolder() / "scenes" / "whole_earth.toml");
  PlacedScene placed;

  TwoBodies(double distanceMetres, double angle) {
    scene.bodies = {"Sun", "Earth", "Mars"};
    scene.picture.width = 320;
    scene.picture.height = 180;
    scene.quality = "draft";
    scene.display.limitingMagnitude = -10.0;
    placed = placeScene(scene, parseInstant(scene.time, "test"), BodyCatalogue::standard(),
                        Ephemeris::standard(), DeltaT::standard());
    auto const find = [&](const std::string& name) {
      return std::find_if(placed.bodies.begin(), placed.bodies.end(),
                          [&](const PlacedBody& b) { return b.body->name == name; });
    };
    auto const earth = find("Earth"), other = find("Mars");
    glm::dvec3 const forward = glm::normalize(earth->fromCamera.m);
    glm::dvec3 const side = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 0.0, 1.0)));
    glm::dvec3 const from = distanceMetres * (std::cos(angle) * forward + std::sin(angle) * side);
    other->fromAnchor.m += from - other->fromCamera.m;
    other->fromCamera.m = from;
    other->sunFromBody.m = glm::normalize(earth->sunFromBody.m) * glm::length(other->sunFromBody.m);
    for (auto& body : placed.bodies) body.neighbours.clear();
  }

  // Without the body named.
  std::vector<float> light(const std::string& without, PictureRenderer& renderer) const {
    auto plan = makeRenderPlan(scene, placed);
    std::erase_if(plan.bodies, [&](const PlannedBody& b) { return b.name == without; });
    return renderer.finish(scene, placed, plan).linear;
  }
};

// In front is the one named.
void expectApart(double distanceMetres, double angle, const std::string& front,
                 const std::string& behind) {
  TwoBodies const view(distanceMetres, angle);
  PictureRenderer one(greyMap), other(greyMap), both(greyMap);
  auto const near = view.light(behind, one), far = view.light(front, other);
  auto const together = view.light("", both);
  EXPECT_EQ(both.counters().tablesBuilt, 2);
  int nearAlone = 0, farAlone = 0, hidden = 0, through = 0;
  for (std::size_t i = 0; i < together.size(); ++i) {
    float const f = far[i], n = near[i], found = together[i], slack = 2e-6f * (f + n);
    if (f > 0.0f && n > 0.0f) {
      // The nearer body's light, and what its air or its ground leaves of the farther one's.
      ASSERT_GE(found, n - slack) << "value " << i;
      ASSERT_LE(found, n + f + slack) << "value " << i;
      ++(found > n + 0.01f * f ? through : hidden);
    } else {
      ASSERT_NEAR(found, f + n, slack) << "value " << i;
      farAlone += f > 0.0f;
      nearAlone += n > 0.0f;
    }
  }
  EXPECT_GT(nearAlone, 1000);
  EXPECT_GT(farAlone, 1000);
  EXPECT_GT(hidden, 100);
  EXPECT_GT(through, 3) << "the nearer body's air is not seen against the farther one";
  // Nor does it matter whose tables were made first, or which pictures were drawn before.
  EXPECT_EQ(view.light("", one), together);
  EXPECT_EQ(view.light("", other), together);
  EXPECT_EQ(view.light(behind, both), near);
}

TEST_F(AirsApart, MarsBeforeTheEarth) { expectApart(12e6, 0.5, "Mars", "Earth"); }

TEST_F(AirsApart, MarsBehindTheEarth) { expectApart(30e6, 0.38, "Earth", "Mars"); }

}  // namespace
}  // namespace antumbra
