// Bodies as drawn: finite from the ground to far away, in front of what lies behind.
#include "passes/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "eclipse/shadow_convention.h"
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

// Samples of the air that pixels share change smooth light a little, and no edge: what lies within
// reach of a horizon has its own, and so has everything in an eclipse.
TEST_F(Bodies, ShareSamplesOfTheAirWithoutHalos) {
  BodiesPass pass(noImage, quickQuality());
  Projection const flat{ProjectionKind::Perspective, 60.0 * degree, 320, 180};
  struct View {
    const char* name;
    double height, pitch, sunZenith;  // m, degrees up from the horizontal, degrees
    double mean, worst;               // of the difference that 2 pixels a side make
  };
  for (auto const& view : {View{"ground horizon", 100.0, 5.0, 80.0, 5e-4, 0.03},
                           View{"10 km, dusk", 1e4, 0.0, 91.0, 5e-4, 0.02},
                           View{"limb from orbit", 4e5, -35.0, 60.0, 5e-4, 0.02},
                           View{"terminator", 3e6, -60.0, 90.0, 2e-3, 0.04},
                           View{"whole disc", 1.2e7, -80.0, 40.0, 1e-4, 0.005}}) {
    double const r = kEarthEquatorialRadius.si + view.height, p = view.pitch * degree.si;
    double const z = view.sunZenith * degree.si;
    auto const body =
        earthFrom({r, 0, 0}, {std::sin(p), std::cos(p), 0.0}, {std::cos(p), -std::sin(p), 0},
                  {std::cos(z), std::sin(z), 0.0}, flat);
    glm::vec4 const black(0.0f, 0.0f, 0.0f, 1.0f);
    auto const one = picture(pass, body, flat, black);
    double const brightest = double(*std::max_element(one.begin(), one.end()));
    for (int scale : {2, 4}) {
      pass.useAirScale(scale);
      auto const rgba = picture(pass, body, flat, black);
      double sum = 0.0, worst = 0.0;
      int count = 0, changed = 0;
      for (std::size_t i = 1; i < rgba.size(); i += 4) {
        double const difference = double(rgba[i]) - double(one[i]);
        changed += difference != 0.0;
        if (double(one[i]) < 1e-3 * brightest) continue;
        ++count;
        sum += std::fabs(difference) / double(one[i]);
        worst = std::max(worst, std::fabs(difference) / double(one[i]));
      }
      std::printf("%-16s %d pixels a side: mean %.4f %%, worst %.3f %%, %d %% of the pixels\n",
                  view.name, scale, 100.0 * sum / count, 100.0 * worst,
                  changed * 100 / (flat.width * flat.height));
      // Of second differences: four times as large over twice the distance.
      double const grows = scale == 2 ? 1.0 : 4.0;
      EXPECT_LT(sum / count, grows * view.mean) << view.name;
      EXPECT_LT(worst, grows * view.worst) << view.name;
      EXPECT_GT(changed, flat.width * flat.height / 20) << view.name;
      // Pixels beside the horizon are the same to the last bit.
      double const dip = std::acos(kEarthEquatorialRadius.si / r);
      for (int y = 0; y < flat.height; ++y)
        for (int x = 0; x < flat.width; ++x) {
          auto const look = flat.directionAt(x + 0.5, y + 0.5);
          glm::dvec3 const d = body.bodyFromCamera.matrix * look->u;
          auto const i = static_cast<std::size_t>(4 * (y * flat.width + x) + 1);
          if (std::fabs(std::asin(d.x) + dip) < 2.0 * flat.pixelAngle().si) {
            ASSERT_EQ(rgba[i], one[i]) << view.name;
          }
        }
    }
    pass.useAirScale(1);
  }
}

TEST_F(Bodies, ShareNoSamplesOfTheAirInAnEclipse) {
  BodiesPass pass(noImage, quickQuality());
  Projection const flat{ProjectionKind::Perspective, 60.0 * degree, 160, 90};
  double const r = kEarthEquatorialRadius.si + 1e6;
  auto body = earthFrom({r, 0, 0}, {-1, 0.3, 0}, {0, 0, 1}, {1, 1, 0}, flat);
  body.casters.push_back(
      {"Moon",
       {body.sun.m * (3.844e8 / glm::length(body.sun.m))},
       ShadowConvention::named("iau", "test").radiiOf("Moon", 1737.4 * kilometre),
       {{0.0, 0.0, 1.0}, 1.0},
       ""});
  glm::vec4 const black(0.0f, 0.0f, 0.0f, 1.0f);
  auto const fine = picture(pass, body, flat, black);
  pass.useAirScale(4);
  EXPECT_EQ(picture(pass, body, flat, black), fine);
}

// Parts of a large picture share the samples of the whole.
TEST_F(Bodies, ShareTheSameSamplesInPartsOfAPicture) {
  BodiesPass pass(noImage, quickQuality());
  pass.useAirScale(4);
  Projection const whole{ProjectionKind::Perspective, 60.0 * degree, 320, 180};
  double const r = kEarthEquatorialRadius.si + 1e6;
  auto const body = earthFrom({r, 0, 0}, {-1, 0.3, 0}, {0, 0, 1}, {1, 1, 0}, whole);
  auto const all = picture(pass, body, whole, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
  glm::ivec2 const origin(101, 51), size(97, 63);
  auto const target = gl::Texture::plane(GL_RGBA32F, size.x, size.y);
  gl::Framebuffer const framebuffer({&target});
  framebuffer.bind();
  glClear(GL_COLOR_BUFFER_BIT);
  gl::Buffer view;
  view.write(gl::viewBlockOf(whole, origin));
  view.bindUniform(0);
  pass.draw(body, whole, origin, size);
  auto const part = target.readRgba();
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      float const expected =
          all[static_cast<std::size_t>(4 * ((y + origin.y) * whole.width + x + origin.x) + 1)];
      // Rounding of texture coordinates.
      ASSERT_NEAR(part[static_cast<std::size_t>(4 * (y * size.x + x) + 1)], expected,
                  1e-4f * expected)
          << x << ", " << y;
    }
}

}  // namespace
}  // namespace antumbra
