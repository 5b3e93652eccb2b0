// The query's area against closed forms, for bodies; against the mesh's own area, for meshes.
#include "passes/sun_occlusion.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/passes/sun_scene.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

using testsupport::moonBefore;
using testsupport::sunAt;
using SunOcclusionGlTest = testsupport::GlTest;

// The uncovered area and light by the lune's closed form and Green's theorem (eclipse.glsl).
struct Expected {
  double area, light;
};
Expected expectedFor(const SunInView& sun, double ratio, double separation) {
  double const radius = SunPlane(sun).angularRadius().si;
  glsl::DiscPair const discs = glsl::discsFromAngles(radius, ratio * radius, separation * radius);
  return {glsl::visibleFractionUniform(discs), glsl::visibleFraction(discs, sun.law).y};
}

TEST_F(SunOcclusionGlTest, AreaFollowsAMoonThatCrossesTheSun) {
  SunInView const sun = sunAt(glm::normalize(glm::dvec3{0.2, 0.3, -1.0}));
  SunPlane const plane(sun);
  SunOcclusion occlusion;
  double worstArea = 0.0, worstLight = 0.0, worstThin = 0.0;
  // Annular, hybrid, total, and a small body; central and grazing passages.
  for (double ratio : {0.95, 1.0, 1.06, 0.2})
    for (double miss : {0.0, 0.03, 0.4})
      for (double x = -2.2; x <= 2.2; x += 0.137) {
        SpheroidInView const moon = moonBefore(sun, ratio, {x, miss});
        std::vector<Silhouette> const outlines = plane.silhouettes({{moon}});
        occlusion.ask(sun, plane, outlines);
        VisibleSun const seen = occlusion.wait();
        Expected const want = expectedFor(sun, ratio, std::hypot(x, miss));
        worstArea = testsupport::larger(worstArea, std::fabs(seen.area - want.area));
        worstLight = testsupport::larger(worstLight, std::fabs(seen.light.y - want.light));
        if (want.area > 1e-4 && want.area < 0.05)
          worstThin = testsupport::larger(worstThin, std::fabs(seen.area / want.area - 1.0));
        if (want.area == 0.0) {
          EXPECT_EQ(seen.area, 0.0);
          EXPECT_TRUE(seen.sources.empty());
        }
        VisibleSun const analytic = analyticVisibleSun(plane, sun.law, outlines);
        EXPECT_NEAR(analytic.area, seen.area, 1e-3);
        EXPECT_NEAR(analytic.light.y, seen.light.y, 1e-3);
        EXPECT_FALSE(analytic.fromQuery);
        EXPECT_TRUE(seen.fromQuery);
      }
  RecordProperty("worstArea", std::to_string(worstArea));
  std::printf(
      "area within %.5f of the disc, light within %.5f; crescents below 5 %%: %.4f of "
      "themselves\n",
      worstArea, worstLight, worstThin);
  // The bar is 1 % of the disc; a raster of 256 pixels leaves a tenth of that.
  EXPECT_LT(worstArea, 1e-3);
  EXPECT_LT(worstLight, 2e-3);
  EXPECT_LT(worstThin, 0.01);
}

// Towards second contact the thread of photosphere shrinks without a step: to 1e-6 of the disc.
TEST_F(SunOcclusionGlTest, ThreadsKeepTheirAreaNearTotality) {
  SunInView const sun = sunAt({0.0, 0.0, -1.0});
  SunPlane const plane(sun);
  SunOcclusion occlusion;
  double last = 1.0;
  for (double gap : {3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4}) {
    double const ratio = 1.04;
    std::vector<Silhouette> const outlines =
        plane.silhouettes({{moonBefore(sun, ratio, {ratio - 1.0 + gap, 0.0})}});
    occlusion.ask(sun, plane, outlines);
    VisibleSun const seen = occlusion.wait();
    double const want = expectedFor(sun, ratio, ratio - 1.0 + gap).area;
    EXPECT_NEAR(seen.area / want, 1.0, 0.03) << gap;
    EXPECT_LT(seen.area, last);
    last = seen.area;
    // On the limb opposite the Moon.
    EXPECT_LT(seen.centroid.x, -0.88);
    EXPECT_NEAR(seen.centroid.y, 0.0, 0.01);
  }
}

// A sheet before the Sun, known to the device alone: a strip 0.5 radii wide.
TEST_F(SunOcclusionGlTest, MeshesCountWhereTheOutlinesKnowNothing) {
  SunInView const sun = sunAt(glm::normalize(glm::dvec3{-0.4, 0.1, -1.0}));
  SunPlane const plane(sun);
  SunOcclusion occlusion;
  double worst = 0.0;
  for (double left = -1.3; left < 1.0; left += 0.11) {
    double const right = left + 0.5;
    std::vector<glm::vec3> corners;
    // 30 m away and 4 m high, as four triangles that overlap.
    auto const at = [&](double x, double y) { return glm::vec3(30.0 * plane.directionAt({x, y})); };
    for (double overlap : {0.0, 0.2})
      for (glm::vec3 const& corner :
           {at(left, -14.0), at(right - overlap, -14.0), at(right - overlap, 14.0), at(left, -14.0),
            at(right - overlap, 14.0), at(left, 14.0)})
        corners.push_back(corner);
    gl::Buffer buffer;
    buffer.write(std::span<const glm::vec3>(corners));
    MeshInView const mesh{&buffer, static_cast<int>(corners.size())};
    occlusion.ask(sun, plane, {}, {{mesh}});
    VisibleSun const seen = occlusion.wait();
    // Area of the unit disc left of x: a circular segment.
    auto const leftOf = [](double x) {
      double const c = std::clamp(x, -1.0, 1.0);
      return 0.5 + (std::asin(c) + c * std::sqrt(1.0 - c * c)) / std::numbers::pi;
    };
    double const want = 1.0 - (leftOf(right) - leftOf(left));
    worst = testsupport::larger(worst, std::fabs(seen.area - want));
    EXPECT_EQ(analyticVisibleSun(plane, sun.law, {}).area, 1.0);
  }
  std::printf("mesh: area within %.5f of the disc\n", worst);
  EXPECT_LT(worst, 3e-3);  // the bar is 1 %; a strip's edge steps over whole rows of pixels
}

TEST_F(SunOcclusionGlTest, MoonAndMeshAddUp) {
  SunInView const sun = sunAt({0.0, 0.0, -1.0});
  SunPlane const plane(sun);
  SunOcclusion occlusion;
  // The Moon hides all but a crescent on the left, the mesh its upper half.
  std::vector<Silhouette> const outlines = plane.silhouettes({{moonBefore(sun, 1.03, {0.1, 0.0})}});
  std::vector<glm::vec3> const corners{glm::vec3(5.0 * plane.directionAt({-9.0, 0.0})),
                                       glm::vec3(5.0 * plane.directionAt({9.0, 0.0})),
                                       glm::vec3(5.0 * plane.directionAt({0.0, 9.0}))};
  gl::Buffer buffer;
  buffer.write(std::span<const glm::vec3>(corners));
  occlusion.ask(sun, plane, outlines, {{MeshInView{&buffer, 3}}});
  VisibleSun const half = occlusion.wait();
  occlusion.ask(sun, plane, outlines);
  VisibleSun const all = occlusion.wait();
  EXPECT_NEAR(half.area / all.area, 0.5, 0.01);
  EXPECT_LT(half.centroid.y, -0.1);
  EXPECT_NEAR(all.centroid.y, 0.0, 0.01);
  EXPECT_EQ(occlusion.queriesIssued(), 4);
}

TEST_F(SunOcclusionGlTest, TheWholeDiscSendsAllItsLight) {
  SunInView const sun = sunAt({0.0, 0.0, -1.0});
  SunOcclusion occlusion;
  EXPECT_FALSE(occlusion.newest());
  occlusion.ask(sun, SunPlane(sun), {});
  VisibleSun const seen = occlusion.wait();
  EXPECT_EQ(seen.area, 1.0);
  EXPECT_EQ(seen.visibleSamples, seen.discSamples);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(seen.light[k], 1.0, 1e-3);
  EXPECT_NEAR(glm::length(seen.centroid), 0.0, 1e-4);
  double sum = 0.0;
  for (SunSource const& s : seen.sources) sum += s.share;
  EXPECT_NEAR(sum, 1.0, 1e-5);
}

// Live: an answer comes some frames later, without `wait`, and is that of an earlier question.
TEST_F(SunOcclusionGlTest, AnswersOfEarlierFramesArriveByThemselves) {
  SunInView const sun = sunAt({0.0, 0.0, -1.0});
  SunPlane const plane(sun);
  SunOcclusion occlusion;
  std::optional<VisibleSun> seen;
  for (int frame = 0; frame < 50 && !seen; ++frame) {
    occlusion.ask(sun, plane, plane.silhouettes({{moonBefore(sun, 1.0, {1.0, 0.0})}}));
    glFinish();
    seen = occlusion.newest();
  }
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->area, expectedFor(sun, 1.0, 1.0).area, 1e-3);
}

}  // namespace
}  // namespace antumbra
