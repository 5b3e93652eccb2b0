// Bodies as drawn: finite from the ground to far away, in front of what lies behind.
#include "passes/bodies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/view_block.h"
#include "quantity/constants.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using Bodies = testsupport::GlTest;

DecodedImage noImage(const std::string& file, const std::string&) {
  throw std::logic_error("no image wanted: " + file);
}

// Camera axes straight: body-fixed axes turned so that the camera at `position` (body-fixed metres)
// looks along `forward`.
PlannedBody earthFrom(glm::dvec3 position, glm::dvec3 forward, glm::dvec3 up,
                      glm::dvec3 sunDirection, const Projection& picture) {
  PlannedBody b;
  b.name = "Earth";
  glm::dvec3 const z = -glm::normalize(forward);
  glm::dvec3 const x = glm::normalize(glm::cross(up, z));
  glm::dvec3 const y = glm::cross(z, x);
  b.bodyFromCamera.matrix = glm::dmat3(x, y, z);
  b.centre.m = glm::transpose(b.bodyFromCamera.matrix) * -position;
  b.equatorialRadius = kEarthEquatorialRadius;
  b.polarRadius = (1.0 - kEarthFlattening) * kEarthEquatorialRadius;
  b.sun.m = astronomicalUnit.si * glm::normalize(sunDirection);
  glm::dvec3 scaled = position;
  scaled.z /= 1.0 - kEarthFlattening;
  b.cameraHeight = Length(glm::length(scaled) - kEarthEquatorialRadius.si);
  b.bounds = {0, 0, picture.width, picture.height};
  b.albedo = glm::vec3(0.1f, 0.12f, 0.15f);
  b.atmosphere = "earth";
  return b;
}

std::vector<float> picture(BodiesPass& pass, const PlannedBody& body, const Projection& projection,
                           glm::vec4 behind) {
  auto const target = gl::Texture::plane(GL_RGBA32F, projection.width, projection.height);
  gl::Framebuffer const framebuffer({&target});
  pass.prepare(body, projection, {});
  framebuffer.bind();
  gl::Buffer view;
  view.write(gl::viewBlockOf(projection));
  view.bindUniform(0);
  glClearColor(behind.x, behind.y, behind.z, behind.w);
  glClear(GL_COLOR_BUFFER_BIT);
  pass.draw(body, projection, {0, 0}, {projection.width, projection.height});
  return target.readRgba();
}

AirQuality quickQuality() {
  AirQuality q;
  q.orders = 2;
  q.sourceWidth = 32;
  q.sourceHeight = 8;
  q.skyHeight = 64;
  q.skyWidth = 16;
  return q;
}

// From 1 mm above the ground to 1e9 m, up, down and along the horizon: finite, never negative, and
// what lies behind is never amplified.
TEST_F(Bodies, IsFiniteFromTheGroundToFarAway) {
  BodiesPass pass(noImage, quickQuality());
  Projection const all{ProjectionKind::Equirectangular, 360.0 * degree, 64, 32};
  for (double height = 1e-3; height < 2e9; height *= 7.0) {
    double const r = kEarthEquatorialRadius.si + height;
    for (double sunZenith : {0.0, 90.0, 110.0, 180.0}) {
      double const z = sunZenith * degree.si;
      auto const body =
          earthFrom({r, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {std::cos(z), std::sin(z), 0.0}, all);
      auto const rgba = picture(pass, body, all, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
      auto const lit = picture(pass, body, all, glm::vec4(1e6f, 1e6f, 1e6f, 1.0f));
      for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        ASSERT_TRUE(std::isfinite(rgba[i]) && rgba[i] >= 0.0f) << height << " m, " << sunZenith;
        ASSERT_LE(lit[i] - rgba[i], 1.0001e6f) << height << " m, " << sunZenith;
      }
    }
  }
}

// Straight down from space the ground hides what lies behind; straight away from it nothing is
// dimmed.
TEST_F(Bodies, HidesWhatLiesBehindIt) {
  BodiesPass pass(noImage, quickQuality());
  Projection const narrow{ProjectionKind::Perspective, 10.0 * degree, 16, 16};
  double const r = kEarthEquatorialRadius.si + 4e7;
  glm::vec4 const behind(1e6f, 1e6f, 1e6f, 1.0f);
  auto const down = picture(pass, earthFrom({r, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, narrow),
                            narrow, behind);
  EXPECT_LT(down[(8 * 16 + 8) * 4], 1.0f);
  auto const away =
      picture(pass, earthFrom({r, 0, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, narrow), narrow, behind);
  EXPECT_EQ(away[(8 * 16 + 8) * 4], 1e6f);
}

}  // namespace
}  // namespace antumbra
