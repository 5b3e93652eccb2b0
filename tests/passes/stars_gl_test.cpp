// Point sources keep their flux and their place in every projection.
#include "passes/stars.h"

#include <gtest/gtest.h>

#include <random>

#include "gl/framebuffer.h"
#include "gl/view_block.h"
#include "shared/as_cpp.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/sky_picture.h"

namespace antumbra {
namespace {

using StarsGlTest = testsupport::GlTest;

struct Measured {
  double lux = 0.0;
  glm::dvec2 centroid{0.0};
};

Measured measure(const Projection& projection, const gl::Texture& image) {
  Measured m;
  std::vector<float> const texels = image.readRgba();
  double values = 0.0;
  for (int y = 0; y < projection.height; ++y)
    for (int x = 0; x < projection.width; ++x) {
      double const value = texels[static_cast<std::size_t>(4 * (y * projection.width + x)) + 1];
      if (value == 0.0) continue;
      double const flux = value * testsupport::pixelSolidAngle(projection, x, y);
      m.lux += flux;
      values += flux;
      m.centroid += flux * glm::dvec2(x + 0.5, y + 0.5);
    }
  m.centroid /= values;
  return m;
}

Measured drawOne(const Projection& projection, StarsPass& pass, glm::dvec3 direction, float lux) {
  auto const target = gl::Texture::plane(GL_RGBA32F, projection.width, projection.height);
  gl::Framebuffer const framebuffer({&target});
  gl::Buffer view;
  view.write(gl::viewBlockOf(projection));
  view.bindUniform(0);
  framebuffer.bind();
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  StarPoint const star{direction, glm::vec3(lux)};
  pass.draw(std::span<const StarPoint>(&star, 1));
  return measure(projection, target);
}

TEST_F(StarsGlTest, FluxAndPlaceSurviveEveryProjection) {
  struct Case {
    Projection projection;
    double fluxTolerance;  // relative
  };
  // The solid angle within a pixel varies most beside an equirectangular pole: 0.5 %.
  Case const cases[] = {
      {{ProjectionKind::Perspective, 60.0 * degree, 320, 180}, 1e-3},
      {{ProjectionKind::Perspective, 140.0 * degree, 320, 180}, 1e-3},
      {{ProjectionKind::Perspective, 0.01 * degree, 320, 320}, 1e-3},
      {{ProjectionKind::Fisheye, 180.0 * degree, 256, 256}, 1e-3},
      {{ProjectionKind::Fisheye, 300.0 * degree, 256, 256}, 1e-3},
      {{ProjectionKind::Equirectangular, 360.0 * degree, 320, 160}, 5e-3},
  };
  std::mt19937 random(3);
  for (auto const& c : cases) {
    StarsPass pass(c.projection.kind);
    std::uniform_real_distribution<double> x(4.0, c.projection.width - 4.0);
    std::uniform_real_distribution<double> y(4.0, c.projection.height - 4.0);
    for (int i = 0; i < 12; ++i) {
      glm::dvec2 const at{x(random), y(random)};
      auto const d = c.projection.directionAt(at.x, at.y);
      // Away from a fisheye's mask, which cuts the footprint.
      if (!d || (c.projection.kind == ProjectionKind::Fisheye &&
                 glm::length(at - glm::dvec2(128.0)) > 122.0))
        continue;
      Measured const m = drawOne(c.projection, pass, d->u, 2.54e-6f);
      EXPECT_NEAR(m.lux / 2.54e-6, 1.0, c.fluxTolerance)
          << nameOf(c.projection.kind) << " at " << at.x << "," << at.y;
      // Pixels; the pixel's own solid angle weighs the centroid, so a hundredth is left.
      EXPECT_NEAR(m.centroid.x, at.x, 0.02) << nameOf(c.projection.kind);
      EXPECT_NEAR(m.centroid.y, at.y, 0.02) << nameOf(c.projection.kind);
    }
  }
}

TEST_F(StarsGlTest, AStarOnTheDateLineLosesNothing) {
  Projection const p{ProjectionKind::Equirectangular, 360.0 * degree, 320, 160};
  StarsPass pass(p.kind);
  for (double longitude : {179.8, -179.8, 178.5}) {
    double const l = longitude * degree.si;
    Measured const m = drawOne(p, pass, {std::sin(l), 0.0, -std::cos(l)}, 1e-6f);
    EXPECT_NEAR(m.lux / 1e-6, 1.0, 1e-3) << longitude;
  }
}

TEST_F(StarsGlTest, NothingIsDrawnBehindAPerspective) {
  Projection const p{ProjectionKind::Perspective, 60.0 * degree, 64, 64};
  StarsPass pass(p.kind);
  EXPECT_EQ(drawOne(p, pass, {0.0, 0.0, 1.0}, 1.0f).lux, 0.0);
}

TEST_F(StarsGlTest, TilesTogetherHoldWhatThePictureHolds) {
  Projection const p{ProjectionKind::Fisheye, 180.0 * degree, 64, 64};
  StarsPass pass(p.kind);
  auto const d = p.directionAt(32.3, 31.2);  // its footprint lies on four tiles
  StarPoint const star{d->u, glm::vec3(1e-6f)};
  Measured const whole = drawOne(p, pass, d->u, 1e-6f);
  double sum = 0.0;
  auto const target = gl::Texture::plane(GL_RGBA32F, 32, 32);
  gl::Framebuffer const framebuffer({&target});
  for (int tile = 0; tile < 4; ++tile) {
    gl::Buffer view;
    glm::ivec2 const origin{32 * (tile % 2), 32 * (tile / 2)};
    view.write(gl::viewBlockOf(p, origin));
    view.bindUniform(0);
    framebuffer.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    pass.draw(std::span<const StarPoint>(&star, 1));
    std::vector<float> const texels = target.readRgba();
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x)
        sum += texels[static_cast<std::size_t>(4 * (y * 32 + x))] *
               testsupport::pixelSolidAngle(p, origin.x + x, origin.y + y);
  }
  EXPECT_NEAR(sum / whole.lux, 1.0, 1e-4);
}

// A halo has the glare function's luminance between the core and its faded edge, and no square
// shows.
TEST_F(StarsGlTest, BrightStarsHaveTheirHalo) {
  Projection const p{ProjectionKind::Perspective, 20.0 * degree, 400, 400};
  StarsPass pass(p.kind);
  testsupport::SkyPicture picture(p);
  StarPoint const venus{{0.0f, 0.0f, -1.0f}, glm::vec3(1e-4f)};
  StarPoint const faint{{0.05f, 0.0f, -1.0f}, glm::vec3(1e-9f)};
  int halos = 0;
  picture.draw([&] { halos = pass.drawHalos(p, {{venus, faint}}); });
  EXPECT_EQ(halos, 1);
  int const x = 200 + 8;  // 0.43 deg
  double const t =
      angleBetween(*p.directionAt(x + 0.5, 200.5), Direction<CameraAxes>{{0, 0, -1}}).si;
  EXPECT_NEAR(picture.at(x, 200).y / (1e-4 * glsl::eyeSpread(t * t, 0.0625, 0.5)), 1.0, 0.12);
  // At its reach, 2.4 deg, it has gone smoothly.
  for (int i = 40; i < 60; ++i) EXPECT_LE(picture.at(200 + i, 200).y, 3e-5) << i;
  EXPECT_EQ(picture.at(260, 200).y, 0.0);
}

TEST_F(StarsGlTest, ThroughATelescopeHalosShrink) {
  StarPoint const venus{{0.0f, 0.0f, -1.0f}, glm::vec3(1e-4f)};
  for (double field : {10.0, 60.0}) {
    Projection const p{ProjectionKind::Perspective, field * degree, 400, 400};
    StarsPass pass(p.kind);
    testsupport::SkyPicture picture(p);
    Eye eye;
    eye.magnification = magnificationOf(p);
    EXPECT_NEAR(eye.magnification, 60.0 / field, 1e-12);
    picture.draw([&] { pass.drawHalos(p, {{venus}}, eye, 1e-6); });
    double const t =
        angleBetween(*p.directionAt(210.5, 200.5), Direction<CameraAxes>{{0, 0, -1}}).si;
    double const m = 60.0 / field;
    EXPECT_NEAR(
        picture.at(210, 200).y / (1e-4 * m * m * glsl::eyeSpread(m * m * t * t, 0.0625, 0.5)), 1.0,
        0.05);
  }
}

// The shared solid angle against Girard's theorem.
TEST(PixelScale, SolidAnglesCoverTheSphere) {
  double sum = 0.0;
  for (int y = 0; y < 400; ++y) {
    glm::dvec3 const ray = glsl::equirectangularRay(0.1, 2.0 * (y + 0.5) / 400.0 - 1.0).direction;
    sum += 800.0 * glsl::equirectangularPixelSolidAngle(ray, 800.0, 400.0);
  }
  EXPECT_NEAR(sum, 4.0 * std::numbers::pi, 1e-4);
  Projection const dome{ProjectionKind::Fisheye, 220.0 * degree, 500, 500};
  Projection const flat{ProjectionKind::Perspective, 100.0 * degree, 500, 300};
  for (double x : {100.5, 250.5, 420.5})
    for (double y : {120.5, 150.5, 260.5}) {
      auto const at = [&](const Projection& p) {
        return testsupport::pixelSolidAngle(p, static_cast<int>(x), static_cast<int>(y));
      };
      double const radius = std::hypot(x - 250.0, y - 250.0) / 250.0;
      EXPECT_NEAR(glsl::fisheyePixelSolidAngle(radius, 110.0 * degree.si, 500.0, 500.0) / at(dome),
                  1.0, 1e-4);
      glm::dvec2 const e = flat.extent();
      glm::dvec3 const ray =
          glsl::perspectiveRay(2.0 * x / 500.0 - 1.0, 2.0 * y / 300.0 - 1.0, e.x, e.y).direction;
      EXPECT_NEAR(glsl::perspectivePixelSolidAngle(ray, e.x, e.y, 500.0, 300.0) / at(flat), 1.0,
                  1e-4);
    }
}

}  // namespace
}  // namespace antumbra
