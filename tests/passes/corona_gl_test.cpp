// The corona as drawn: absolute luminance, nothing on the disc or behind the Moon.
#include "passes/corona.h"

#include <gtest/gtest.h>

#include "plan/render_plan.h"
#include "shared/as_cpp.h"
#include "tests/passes/sun_scene.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/sky_picture.h"

namespace antumbra {
namespace {

using testsupport::SkyPicture;
using testsupport::sunAt;
using CoronaGlTest = testsupport::GlTest;

TEST_F(CoronaGlTest, HasItsLuminanceFromLimbToFourRadii) {
  Projection const p{ProjectionKind::Perspective, 2.4 * degree, 512, 512};
  SunInView const sun = sunAt({0, 0, -1});
  SunPlane const plane(sun);
  SkyPicture picture(p);
  CoronaPass pass(p.kind);
  picture.draw([&] { pass.draw(p, sun, plane, {}, {0.3}); });
  double const centreOverMean = 1.0 + (-0.023 + 0.292 / 0.558) / 2.0;
  double const flattening = glsl::flatteningOfActivity(0.3);
  for (int x = 316; x < 500; x += 8) {
    Direction<CameraAxes> const d = *p.directionAt(x + 0.5, 256.5);
    double const r = sin(angleBetween(d, plane.centre())) / sin(plane.angularRadius());
    double const want =
        plane.meanLuminance().y * centreOverMean * glsl::coronaBrightness(r, 0.0, flattening);
    // Pixels of 0.018 radii average a profile that falls as r^-17.
    EXPECT_NEAR(picture.at(x, 256).y / want, 1.0, r < 1.3 ? 0.02 : 0.004) << r;
  }
  EXPECT_EQ(picture.at(256, 256).y, 0.0);
}

// The light beyond 1.03 radii as a share of the Sun's, on a dome where the Sun is 6 pixels wide.
TEST_F(CoronaGlTest, KeepsItsLightOnADome) {
  double const centreOverMean = 1.0 + (-0.023 + 0.292 / 0.558) / 2.0;
  SunInView const sun = sunAt(glm::normalize(glm::dvec3{0.2, 0.1, -1.0}));
  SunPlane const plane(sun);
  SpheroidInView const moon = testsupport::moonBefore(sun, 1.03, {0.0, 0.0});
  std::vector<Silhouette> const silhouettes = plane.silhouettes({{moon}}, glsl::kCoronaEnd);
  double const want = glsl::coronaShareBetween(1.03, 37.0, centreOverMean);
  for (int size : {1024, 2048}) {
    Projection const p{ProjectionKind::Fisheye, 180.0 * degree, size, size};
    SkyPicture picture(p);
    CoronaPass pass(p.kind);
    // Round: the sum then has no latitude. Activity 1.2 makes the flattening 0.
    picture.draw([&] { pass.draw(p, sun, plane, silhouettes, {1.2}); });
    EXPECT_NEAR(picture.illuminance().y / sun.illuminanceLux.y / want, 1.0, 0.03) << size;
  }
}

// The plane that touches the sky at the Sun ends a right angle from it.
TEST_F(CoronaGlTest, ThereIsNoneARightAngleAway) {
  Projection const p{ProjectionKind::Perspective, 100.0 * degree, 256, 256};
  SunInView const sun = sunAt(glm::normalize(glm::dvec3{0.003, 1.0, -0.002}));
  SunPlane const plane(sun);
  SkyPicture picture(p);
  CoronaPass pass(p.kind);
  picture.draw([&] { pass.draw(p, sun, plane, {}, {0.3}); });
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) EXPECT_EQ(picture.at(x, y).y, 0.0) << x << " " << y;
}

TEST_F(CoronaGlTest, TheMoonIsBlackAgainstIt) {
  Projection const p{ProjectionKind::Perspective, 1.2 * degree, 256, 256};
  SunInView const sun = sunAt({0, 0, -1});
  SunPlane const plane(sun);
  SpheroidInView const moon = testsupport::moonBefore(sun, 1.05, {0.02, 0.0});
  SkyPicture picture(p);
  CoronaPass pass(p.kind);
  picture.draw(
      [&] { pass.draw(p, sun, plane, plane.silhouettes({{moon}}, glsl::kCoronaEnd), {0.5}); });
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) {
      double const off = angleBetween(*p.directionAt(x + 0.5, y + 0.5), directionOf(moon.centre)) /
                         plane.angularRadius();
      if (off < 1.03) {
        EXPECT_EQ(picture.at(x, y).y, 0.0);
      }
      if (off > 1.07 && off < 1.5) {
        EXPECT_GT(picture.at(x, y).y, 100.0);
      }
    }
}

}  // namespace
}  // namespace antumbra
