// The Sun's disc: flux, profile, edge, and what bodies leave of it.
#include "passes/sun.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "document/input_error.h"
#include "eclipse/limb_darkening.h"
#include "photometry/colour.h"
#include "photometry/standard_spectra.h"
#include "tests/passes/sun_scene.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/sky_picture.h"

namespace antumbra {
namespace {

using testsupport::SkyPicture;
using testsupport::sunAt;
using SunGlTest = testsupport::GlTest;

glm::dvec3 drawnIlluminance(SunPass& pass, SkyPicture& picture, const SunInView& sun,
                            std::span<const SpheroidInView> bodies = {}) {
  SunPlane const plane(sun);
  picture.draw([&] { pass.draw(picture.projection, sun, plane, plane.silhouettes(bodies)); });
  return picture.illuminance();
}

TEST_F(SunGlTest, DiscKeepsItsFluxInEveryProjection) {
  struct Case {
    Projection projection;
    double tolerance;  // relative; a tenth of a pixel of the edge of a small disc
  };
  Case const cases[] = {
      {{ProjectionKind::Perspective, 1.0 * degree, 300, 200}, 1e-3},
      {{ProjectionKind::Perspective, 100.0 * degree, 400, 300}, 1e-2},  // 2 pixels across
      {{ProjectionKind::Fisheye, 180.0 * degree, 340, 340}, 1e-2},      // 1 pixel
      {{ProjectionKind::Fisheye, 180.0 * degree, 1024, 1024}, 5e-3},    // 3 pixels
      {{ProjectionKind::Fisheye, 180.0 * degree, 2048, 2048}, 5e-3},    // 6 pixels
      {{ProjectionKind::Equirectangular, 360.0 * degree, 2048, 1024}, 5e-3},
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(0.0, 1.0);
  for (Case const& c : cases) {
    SunPass pass(c.projection.kind);
    SkyPicture picture(c.projection);
    for (int i = 0; i < 4; ++i) {
      double const off =
          0.003 * turn(random) + (c.projection.field / degree > 10.0 ? 0.7 * turn(random) : 0.0);
      double const side = 6.283 * turn(random);
      SunInView const sun =
          sunAt({std::sin(off) * std::cos(side), std::sin(off) * std::sin(side), -std::cos(off)});
      glm::dvec3 const lux = drawnIlluminance(pass, picture, sun);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(lux[k] / sun.illuminanceLux[k], 1.0, c.tolerance)
            << nameOf(c.projection.kind) << " " << c.projection.width << " channel " << k;
    }
  }
}

// Hestroffer & Magnan 1998: I / mean = mu^alpha (1 + alpha / 2), alpha = -0.023 + 0.292 um /
// lambda.
TEST_F(SunGlTest, ProfileFollowsThePublishedLaw) {
  Projection const p{ProjectionKind::Perspective, 0.6 * degree, 512, 512};
  SunInView const sun = sunAt({0.0, 0.0, -1.0});
  SunPass pass(p.kind);
  SkyPicture picture(p);
  drawnIlluminance(pass, picture, sun);
  SunPlane const plane(sun);
  double const wavelengths[] = {0.638, 0.544, 0.440};
  double const radius = plane.angularRadius().si;
  for (int x = 256; x < 500; x += 6) {
    Direction<CameraAxes> const d = *p.directionAt(x + 0.5, 256.5);
    double const r = std::sin(angleBetween(d, plane.centre()).si) / std::sin(radius);
    if (r > 0.98) continue;
    for (int k = 0; k < 3; ++k) {
      double const alpha = -0.023 + 0.292 / wavelengths[k];
      double const want = std::pow(1.0 - r * r, alpha / 2.0) * (1.0 + alpha / 2.0) *
                          sun.illuminanceLux[k] /
                          (std::numbers::pi * std::sin(radius) * std::sin(radius));
      EXPECT_NEAR(picture.at(x, 256)[k] / want, 1.0, 2e-3) << "r " << r << " channel " << k;
    }
  }
}

// A picture 0.01 deg wide at the limb: a pixel is 0.14 arcsec.
TEST_F(SunGlTest, LimbIsWhereItShouldBeInAFieldOfAHundredthOfADegree) {
  Projection const p{ProjectionKind::Perspective, 0.01 * degree, 256, 64};
  double const radius = SunPlane(sunAt({0, 0, -1})).angularRadius().si;
  // The limb 0.3 pixel right of the middle.
  double const off = radius - 0.3 * p.pixelAngle().si;
  SunInView const sun = sunAt({-std::sin(off), 0.0, -std::cos(off)});
  SunPass pass(p.kind);
  SkyPicture picture(p);
  drawnIlluminance(pass, picture, sun);
  // In the middle row the disc ends within the pixel 128, of which 0.3 lies inside.
  EXPECT_GT(picture.at(127, 32).y, 0.0);
  EXPECT_GT(picture.at(128, 32).y, 0.0);
  EXPECT_EQ(picture.at(129, 32).y, 0.0);
  // Close to the limb I ~ h^(alpha/2) with h the depth: the mean over the last 1.3 pixels compared
  // with that over the last 41.3 gives the edge within a few hundredths of a pixel.
  double const alpha = -0.023 + 0.292 / 0.544;
  double const power = 1.0 + alpha / 2.0;
  double narrow = 0.0, wide = 0.0;
  for (int x = 88; x <= 128; ++x) {
    wide += picture.at(x, 32).y;
    if (x >= 127) narrow += picture.at(x, 32).y;
  }
  double const edge = 1.0;
  double const expected = std::pow((edge + 0.3) / (40.0 + 0.3), power);
  EXPECT_NEAR(narrow / wide, expected, 0.06 * expected);
}

TEST_F(SunGlTest, CoveredDiscLeaksNothingAtAnyResolution) {
  for (Projection const& p : {Projection{ProjectionKind::Fisheye, 180.0 * degree, 512, 512},
                              Projection{ProjectionKind::Fisheye, 180.0 * degree, 2048, 2048},
                              Projection{ProjectionKind::Perspective, 1.0 * degree, 256, 256}}) {
    SunPass pass(p.kind);
    SkyPicture picture(p);
    SunInView const sun = sunAt(glm::normalize(glm::dvec3{0.1, 0.05, -1.0}));
    // 1.002 of the Sun's radius and 0.0015 off the centre.
    SpheroidInView const moon = testsupport::moonBefore(sun, 1.002, {0.0015, 0.0});
    EXPECT_EQ(glm::length(drawnIlluminance(pass, picture, sun, {{moon}})), 0.0) << p.width;
  }
}

// What is left of the Sun against the lune's closed form (eclipse.glsl).
TEST_F(SunGlTest, CrescentKeepsItsFlux) {
  SunInView const sun = sunAt(glm::normalize(glm::dvec3{0.02, -0.05, -1.0}));
  double const radius = SunPlane(sun).angularRadius().si;
  for (Projection const& p : {Projection{ProjectionKind::Fisheye, 180.0 * degree, 2048, 2048},
                              Projection{ProjectionKind::Perspective, 10.0 * degree, 640, 640}}) {
    SunPass pass(p.kind);
    SkyPicture picture(p);
    for (double ratio : {0.95, 1.05})
      for (double separation : {0.2, 0.6, 1.0, 1.5, 1.9}) {
        SpheroidInView const moon = testsupport::moonBefore(sun, ratio, {0.0, separation});
        glm::dvec4 const visible = glsl::visibleFraction(
            glsl::discsFromAngles(radius, ratio * radius, separation * radius), sun.law);
        glm::dvec3 const lux = drawnIlluminance(pass, picture, sun, {{moon}});
        // 1 % of what is visible, and a 2000th of the Sun for pixels of 1/3 of its radius.
        EXPECT_NEAR(lux.y / sun.illuminanceLux.y, visible.y, 0.01 * visible.y + 5e-4)
            << p.width << " ratio " << ratio << " separation " << separation;
      }
  }
}

TEST_F(SunGlTest, IsNotDrawnOutsideThePicture) {
  Projection const p{ProjectionKind::Perspective, 20.0 * degree, 64, 64};
  SunPass pass(p.kind);
  SkyPicture picture(p);
  SunInView const sun = sunAt({0.0, 0.0, 1.0});
  bool drawn = true;
  picture.draw([&] { drawn = pass.draw(p, sun, SunPlane(sun), {}); });
  EXPECT_FALSE(drawn);
}

TEST(SunPlane, OutlinesAreThoseOfRaysAgainstSpheroids) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  SunInView const sun = sunAt(glm::normalize(glm::dvec3{0.3, 0.2, -1.0}));
  SunPlane const plane(sun);
  int hidden = 0;
  for (int i = 0; i < 300; ++i) {
    double const a = 7.1e7;
    // From touching the camera to a tenth of the Sun's size, oblate like Saturn.
    double const distance = a * std::pow(10.0, 0.02 + 3.0 * (i % 100) / 100.0);
    glm::dvec3 const aim = glm::normalize(plane.centre().u * 1.0 +
                                          std::min(0.9, a / distance) *
                                              glm::dvec3(normal(random), normal(random), 0.0));
    SpheroidInView const body{
        {distance * aim},
        {glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)))},
        a * metre,
        0.902 * a * metre};
    Silhouette const s = plane.silhouetteOf(body);
    for (int j = 0; j < 40; ++j) {
      glm::dvec2 const p(normal(random), normal(random));
      // Direct: scale space along the pole so that the body is a sphere, then the distance of the
      // ray to its centre.
      glm::dvec3 const pole = body.pole.u;
      auto const stretched = [&](glm::dvec3 v) {
        return v + (1.0 / 0.902 - 1.0) * glm::dot(v, pole) * pole;
      };
      glm::dvec3 const d = glm::normalize(stretched(plane.directionAt(p)));
      glm::dvec3 const c = stretched(body.centre.m);
      double const miss = glm::length(glm::cross(d, c)) / a;
      if (std::fabs(miss - 1.0) < 1e-9) continue;
      bool const hit = miss < 1.0 && glm::dot(d, c) > 0.0;
      glm::dvec3 const q(p, 1.0);
      EXPECT_EQ(glm::dot(q, s.quadric * q) > 0.0 && glm::dot(s.front, q) > 0.0, hit)
          << "distance " << distance / a << " miss " << miss;
      hidden += hit;
    }
  }
  EXPECT_GT(hidden, 1000);
  EXPECT_LT(hidden, 11000);
}

TEST(SunPlane, RefusesACameraInsideTheSunOrABody) {
  SunInView sun = sunAt({0, 0, -1});
  SunPlane const plane(sun);
  SpheroidInView const around{{{0, 0, -100.0}}, {{0, 1, 0}}, 1000.0 * metre, 1000.0 * metre};
  EXPECT_THROW(plane.silhouettes({{around}}), InputError);
  sun.centre.m *= 1e-3;
  EXPECT_THROW(SunPlane{sun}, InputError);
}

TEST(SunPlane, ABodyBeyondTheSunHidesNothing) {
  SunInView const sun = sunAt({0, 0, -1});
  SpheroidInView jupiter = testsupport::moonBefore(sun, 0.1, {0.0, 0.0});
  jupiter.centre.m = 2.0 * sun.centre.m;
  EXPECT_TRUE(SunPlane(sun).silhouettes({{jupiter}}).empty());
}

// One wavelength per channel stands for the integral over the spectrum.
TEST(SolarChannels, FollowTheSpectralIntegral) {
  glsl::LimbDarkening const law = limbDarkening(LimbDarkeningLaw::Hestroffer, kSolarChannels);
  glm::dvec3 const mean = linearSrgbFromXyz(xyzOfRelativeRadiance([](Length) { return 1.0; }));
  for (double mu = 0.02; mu <= 1.0; mu += 0.07) {
    glm::dvec3 const xyz = xyzOfRelativeRadiance([&](Length wavelength) {
      double const nm = wavelength / nanometre;
      double const alpha = -0.023 + 292.0 / nm;
      return std::pow(mu, alpha) * (1.0 + alpha / 2.0);
    });
    glm::dvec3 const want = linearSrgbFromXyz(xyz) / mean;
    glm::dvec4 const got = glsl::solarBrightness(law, mu);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k] / want[k], 1.0, 3e-3) << mu << " " << k;
    EXPECT_NEAR(got.w / (luminanceOf(want * mean) / luminanceOf(mean)), 1.0, 3e-3) << mu;
  }
}

}  // namespace
}  // namespace antumbra
