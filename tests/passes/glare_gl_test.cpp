// The halo: the published function, its flux in every projection, its shape near the Sun.
#include "passes/glare.h"

#include <gtest/gtest.h>

#include <numbers>

#include "document/input_error.h"
#include "shared/as_cpp.h"
#include "tests/passes/sun_scene.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/larger.h"
#include "tests/support/sky_picture.h"

namespace antumbra {
namespace {

using testsupport::moonBefore;
using testsupport::SkyPicture;
using testsupport::sunAt;
using GlareGlTest = testsupport::GlTest;

double square(double x) { return x * x; }

// CIE 135/1: the simpler "general" glare function of the same report, 0.1 to 100 degrees, agrees
// with the "total" one within 25 %: 10/t^3 + [5/t^2 + 0.1 p/t] [1 + (A/62.5)^4] + 2.5e-3 p.
TEST(EyeSpread, AgreesWithTheGeneralGlareFunction) {
  for (double age : {25.0, 50.0, 70.0})
    for (double p : {0.0, 0.5, 1.0})
      for (double t : {0.3, 1.0, 3.0, 10.0, 30.0}) {
        double const general = 10.0 / (t * t * t) +
                               (5.0 / (t * t) + 0.1 * p / t) * (1.0 + std::pow(age / 62.5, 4.0)) +
                               2.5e-3 * p;
        double const total = glsl::eyeSpread(square(t * degree.si), std::pow(age / 70.0, 4.0), p);
        EXPECT_NEAR(total / general, 1.0, 0.45) << age << " " << p << " " << t;
      }
}

// The report: the function integrates to 1 over the field of view.
TEST(EyeSpread, HoldsAllTheLight) {
  for (double p : {0.0, 0.5, 1.0}) {
    double sum = 0.0;
    double const step = 1e-3;
    for (double l = std::log(1e-7); l < std::log(100.0 * degree.si); l += step) {
      double const t = std::exp(l);
      sum += glsl::eyeSpread(t * t, std::pow(35.0 / 70.0, 4.0), p) * 2.0 * std::numbers::pi *
             std::sin(t) * t * step;
    }
    EXPECT_NEAR(sum, 1.0, 0.07) << p;
  }
}

TEST(EyeHalo, LeavesTheFunctionAsItIsBeyondAFewTenthsOfADegree) {
  for (double t : {0.3, 1.0, 20.0})
    EXPECT_NEAR(glsl::eyeHalo(square(t * degree.si), 0.06, 0.5) /
                    glsl::eyeSpread(square(t * degree.si), 0.06, 0.5),
                1.0, 2e-4);
  EXPECT_EQ(glsl::eyeHalo(0.0, 0.06, 0.5), 0.0);
}

TEST(Eye, RefusesWhatTheFunctionDoesNotSpan) {
  EXPECT_THROW((Eye{150.0, 0.5}.check("age")), InputError);
  EXPECT_THROW((Eye{30.0, -1.0}.check("pigmentation")), InputError);
  EXPECT_THROW((Eye{30.0, 0.5, 0.5}.check("magnification")), InputError);
  EXPECT_THROW((Eye{std::nan(""), 0.5}.check("age")), InputError);
  EXPECT_NO_THROW((Eye{}.check("eye")));
}

// Share of a point's light in its halo up to an angle.
double haloShareWithin(double last) {
  double sum = 0.0;
  double const step = 1e-3;
  for (double l = std::log(1e-5); l < std::log(last); l += step) {
    double const t = std::exp(l);
    sum += glsl::eyeHalo(t * t, std::pow(0.5, 4.0), 0.5) * 2.0 * std::numbers::pi * std::sin(t) *
           t * step;
  }
  return sum;
}

TEST_F(GlareGlTest, HaloKeepsItsFlux) {
  EXPECT_NEAR(haloShareWithin(std::numbers::pi) / haloShare({}), 1.0, 2e-3);
  struct Case {
    Projection projection;
    double reach;  // of the picture about the Sun
  };
  for (Case const& c : {Case{{ProjectionKind::Equirectangular, 360.0 * degree, 1440, 720}, 180.0},
                        Case{{ProjectionKind::Fisheye, 180.0 * degree, 900, 900}, 90.0},
                        Case{{ProjectionKind::Fisheye, 20.0 * degree, 256, 256}, 10.0}}) {
    Projection const& p = c.projection;
    GlarePass pass(p.kind);
    SkyPicture picture(p);
    SunInView const sun = sunAt({0.0, 0.0, -1.0});
    SunPlane const plane(sun);
    VisibleSun const visible = analyticVisibleSun(plane, sun.law, {});
    picture.draw([&] { pass.draw(p, plane, visible, sun.illuminanceLux); });
    glm::dvec3 const lux = picture.illuminance();
    // Pixels of 0.25 deg sample a halo smoothed by the Sun's half degree.
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(lux[k] / sun.illuminanceLux[k] / haloShareWithin(c.reach * degree.si), 1.0, 0.02)
          << nameOf(p.kind);
  }
}

// Every projection shows one halo: its value in a direction does not depend on the picture.
TEST_F(GlareGlTest, ProjectionsAgreeOnADirection) {
  SunInView const sun = sunAt(glm::normalize(glm::dvec3{0.1, 0.05, -1.0}));
  SunPlane const plane(sun);
  VisibleSun const visible = analyticVisibleSun(plane, sun.law, {});
  Projection const all[] = {{ProjectionKind::Perspective, 90.0 * degree, 512, 512},
                            {ProjectionKind::Fisheye, 180.0 * degree, 1024, 1024},
                            {ProjectionKind::Equirectangular, 360.0 * degree, 2048, 1024}};
  for (Projection const& p : all) {
    GlarePass pass(p.kind);
    SkyPicture picture(p);
    picture.draw([&] { pass.draw(p, plane, visible, sun.illuminanceLux); });
    for (double off : {3.0, 10.0, 25.0}) {
      double const a = off * degree.si;
      glm::dvec3 const d = std::cos(a) * plane.centre().u - std::sin(a) * plane.across().u;
      auto const pixel = p.pixelOf({d});
      ASSERT_TRUE(pixel);
      int const x = static_cast<int>(pixel->x), y = static_cast<int>(pixel->y);
      double const t = angleBetween(*p.directionAt(x + 0.5, y + 0.5), plane.centre()).si;
      double const want = sun.illuminanceLux.y * glsl::eyeSpread(t * t, std::pow(0.5, 4.0), 0.5);
      // Against the point's function: an extended source adds 1.5 (R/t)^2.
      EXPECT_NEAR(picture.at(x, y).y / want, 1.0, off < 5.0 ? 0.03 : 0.01)
          << nameOf(p.kind) << " at " << off;
    }
  }
}

// Near a crescent, against the sum of point halos over the visible disc in doubles.
TEST_F(GlareGlTest, NearTheSunTheHaloIsThatOfWhatIsVisible) {
  SunInView const sun = sunAt({0.0, 0.0, -1.0});
  SunPlane const plane(sun);
  std::vector<Silhouette> const outlines = plane.silhouettes({{moonBefore(sun, 1.0, {0.8, 0.3})}});
  Projection const p{ProjectionKind::Perspective, 2.0 * degree, 128, 128};
  GlarePass pass(p.kind);
  SkyPicture picture(p);
  VisibleSun const visible = analyticVisibleSun(plane, sun.law, outlines);
  picture.draw([&] { pass.draw(p, plane, visible, sun.illuminanceLux); });
  double worst = 0.0;
  for (int y = 5; y < 128; y += 9)
    for (int x = 5; x < 128; x += 9) {
      Direction<CameraAxes> const d = *p.directionAt(x + 0.5, y + 0.5);
      double sum = 0.0, light = 0.0;
      for (double v = -1.0; v < 1.0; v += 0.02)
        for (double u = -1.0; u < 1.0; u += 0.02) {
          if (u * u + v * v >= 1.0) continue;
          glm::dvec3 const q(u, v, 1.0);
          if (glm::dot(q, outlines[0].quadric * q) > 0.0) continue;
          double const mu = std::sqrt(1.0 - u * u - v * v);
          double const brightness = glsl::solarBrightness(sun.law, mu).w;
          double const t =
              angleBetween(d, Direction<CameraAxes>{glm::normalize(plane.directionAt({u, v}))}).si;
          sum += brightness * glsl::eyeHalo(t * t, std::pow(0.5, 4.0), 0.5);
          light += brightness;
        }
      double const want = sum / light * sun.illuminanceLux.y * visible.light.y;
      worst = testsupport::larger(worst, std::fabs(picture.at(x, y).y / want - 1.0));
    }
  std::printf("halo near a crescent: within %.3f\n", worst);
  EXPECT_LT(worst, 0.06);
}

TEST_F(GlareGlTest, NothingVisibleDrawsNothing) {
  SunInView const sun = sunAt({0.0, 0.0, -1.0});
  SunPlane const plane(sun);
  std::vector<Silhouette> const outlines =
      plane.silhouettes({{moonBefore(sun, 1.05, {0.01, 0.0})}});
  Projection const p{ProjectionKind::Perspective, 20.0 * degree, 64, 64};
  GlarePass pass(p.kind);
  SkyPicture picture(p);
  bool drawn = true;
  picture.draw([&] {
    drawn = pass.draw(p, plane, analyticVisibleSun(plane, sun.law, outlines), sun.illuminanceLux);
  });
  EXPECT_FALSE(drawn);
  EXPECT_EQ(picture.illuminance().y, 0.0);
}

// A Sun just outside the picture still casts its halo into it: no step as it crosses the edge.
TEST_F(GlareGlTest, TheHaloReachesInFromOutsideThePicture) {
  Projection const p{ProjectionKind::Perspective, 20.0 * degree, 64, 64};
  GlarePass pass(p.kind);
  double last = 1e30;
  for (double off : {9.0, 11.0, 60.0, 89.0, 91.0, 170.0}) {
    SunInView const sun = sunAt({std::sin(off * degree.si), 0.0, -std::cos(off * degree.si)});
    SunPlane const plane(sun);
    SkyPicture picture(p);
    picture.draw(
        [&] { pass.draw(p, plane, analyticVisibleSun(plane, sun.law, {}), sun.illuminanceLux); });
    double const middle = picture.at(32, 32).y;
    EXPECT_GT(middle, 0.0) << off;
    if (off <= 91.0) {
      EXPECT_LT(middle, last) << off;
    }
    last = middle;
  }
}

}  // namespace
}  // namespace antumbra
