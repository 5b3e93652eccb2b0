// Exposure from a meter: pure functions, and the meter itself on pictures of known luminance.
#include "tonemap/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gl/buffer.h"
#include "gl/view_block.h"
#include "shared/as_cpp.h"
#include "tests/support/gl_fixture.h"
#include "tonemap/tone_map.h"

namespace antumbra {
namespace {

std::vector<MeterCell> uniformCells(double luminance, int count, float solidAngle = 1e-3f) {
  return std::vector<MeterCell>(static_cast<std::size_t>(count),
                                MeterCell{static_cast<float>(std::log2(luminance)), solidAngle});
}

void append(std::vector<MeterCell>& cells, const std::vector<MeterCell>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

// ISO 2720 and the "sunny 16" rule: EV 15 at ISO 100 for a sunlit scene of about 4000 cd/m2.
TEST(Exposure, FollowsTheExposureValue) {
  EXPECT_NEAR(exposureOfEv(15.0).whiteLuminance * 0.18, 4096.0, 1e-9);
  EXPECT_NEAR(evOfExposure(exposureOfEv(-3.25)), -3.25, 1e-12);
}

TEST(Exposure, ReadsAUniformPicture) {
  MeterReading const reading = readMeter(uniformCells(3000.0, 500));
  EXPECT_NEAR(reading.meanLuminance, 3000.0, 0.01);
  EXPECT_FALSE(reading.black);
}

TEST(Exposure, IsNotMovedByATinySun) {
  std::vector<MeterCell> cells = uniformCells(3000.0, 1000);
  append(cells, uniformCells(1.6e9, 10));
  EXPECT_NEAR(readMeter(cells).meanLuminance, 3000.0, 0.01);
}

TEST(Exposure, IsNotMovedByBlackSpaceNorByADomesMask) {
  std::vector<MeterCell> cells = uniformCells(3000.0, 300);
  append(cells, uniformCells(kMeterFloor, 700));
  append(cells, uniformCells(1.0, 500, 0.0f));
  MeterReading const reading = readMeter(cells);
  EXPECT_NEAR(reading.meanLuminance, 3000.0, 0.01);
  EXPECT_NEAR(reading.darkShare, 0.7, 1e-6);
}

TEST(Exposure, OfABlackPictureStaysAtItsLimit) {
  MeterReading const reading = readMeter(uniformCells(kMeterFloor, 100));
  EXPECT_TRUE(reading.black);
  EXPECT_EQ(exposureFor(reading, {0.0, 0.02}).whiteLuminance, 0.02);
  EXPECT_TRUE(readMeter({}).black);
}

TEST(Exposure, ShowsDarkerScenesDarkerButNeverInverted) {
  double lastGrey = 0.0, lastWhite = 0.0;
  for (double l = 1e-4; l < 1e9; l *= 2.0) {
    double const white = exposureFor(readMeter(uniformCells(l, 10))).whiteLuminance;
    EXPECT_GE(l / white, lastGrey - 1e-9) << l;
    EXPECT_GE(white, lastWhite) << l;
    lastGrey = l / white;
    lastWhite = white;
  }
  EXPECT_GT(lastGrey, 0.15);
  EXPECT_LT(lastGrey, 0.42);
}

TEST(Exposure, AdaptsTowardsItsTargetOnly) {
  Exposure const dark{1.0}, bright{1024.0};
  // One time constant leaves 1/e of the ten stops.
  EXPECT_NEAR(std::log2(adaptedExposure(dark, bright, 0.4 * second).whiteLuminance),
              10.0 - 10.0 / std::exp(1.0), 1e-9);
  EXPECT_NEAR(std::log2(adaptedExposure(bright, dark, 1.5 * second).whiteLuminance),
              10.0 / std::exp(1.0), 1e-9);
  EXPECT_EQ(adaptedExposure(dark, bright, 0.0 * second).whiteLuminance, 1.0);
}

using ToneMapGlTest = testsupport::GlTest;

struct Picture {
  Projection projection;
  gl::Texture texture;
  gl::Buffer view;
  template <class Function>
  Picture(const Projection& p, const Function& colourAt)
      : projection(p), texture(gl::Texture::plane(GL_RGBA32F, p.width, p.height)) {
    std::vector<float> texels;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x) {
        glm::vec3 const c = colourAt(x, y);
        texels.insert(texels.end(), {c.x, c.y, c.z, 1.0f});
      }
    texture.upload(texels, 4);
    view.write(gl::viewBlockOf(p));
    view.bindUniform(0);
  }
};

TEST_F(ToneMapGlTest, MetersADomeWithoutItsMask) {
  Projection const dome{ProjectionKind::Fisheye, 180.0 * degree, 300, 300};
  Picture const picture(dome, [&](int x, int y) {
    return glm::vec3(dome.directionAt(x + 0.5, y + 0.5) ? 0.5f : 1e6f);
  });
  ToneMap toneMap(dome.kind);
  MeterReading const reading = toneMap.measure(picture.texture);
  EXPECT_NEAR(reading.meanLuminance, 0.5, 1e-4);
  EXPECT_EQ(reading.darkShare, 0.0);
  // The same without waiting, some frames later.
  std::optional<MeterReading> live;
  for (int i = 0; i < 100 && !live; ++i) {
    glFinish();
    live = toneMap.measureWithoutWaiting(picture.texture);
  }
  ASSERT_TRUE(live);
  EXPECT_EQ(live->meanLuminance, reading.meanLuminance);
}

TEST_F(ToneMapGlTest, MetersPicturesSmallerThanItsCells) {
  Projection const small{ProjectionKind::Perspective, 60.0 * degree, 40, 30};
  Picture const picture(small, [](int, int) { return glm::vec3(7.0f); });
  EXPECT_NEAR(ToneMap(small.kind).measure(picture.texture).meanLuminance, 7.0, 1e-3);
}

TEST_F(ToneMapGlTest, ShowsWhatTheCurveSaysWithinAStep) {
  Projection const p{ProjectionKind::Perspective, 60.0 * degree, 256, 64};
  auto const colourAt = [](int x, int y) {
    float const level = std::exp2(static_cast<float>(x) / 8.0f - 16.0f);
    return level *
           glm::vec3(1.0f, 0.9f - 0.01f * static_cast<float>(y), 0.02f * static_cast<float>(y));
  };
  Picture const picture(p, colourAt);
  auto const shown = gl::Texture::plane(GL_RGBA8, p.width, p.height);
  gl::Framebuffer const target({&shown});
  ToneMap toneMap(p.kind);
  toneMap.setAdaptedWhite(glm::dvec3(1.0));
  for (bool dither : {false, true}) {
    toneMap.apply(picture.texture, {1.0}, &target, {0, 0}, dither);
    std::vector<float> const texels = shown.readRgba();
    double worst = 0.0, sum = 0.0;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x) {
        glm::dvec3 const want = glsl::displayColour(glm::dvec3(colourAt(x, y)), 1.0);
        for (int i = 0; i < 3; ++i) {
          double const got = texels[static_cast<std::size_t>(4 * (y * p.width + x) + i)];
          worst = std::max(worst, std::fabs(got - glsl::srgbEncoded(want[i])) * 255.0);
          sum += (got - glsl::srgbEncoded(want[i])) * 255.0;
        }
      }
    // Rounding is half a step; the dither adds another half and no mean.
    EXPECT_LT(worst, dither ? 1.05 : 0.55);
    EXPECT_LT(std::fabs(sum / (3.0 * p.width * p.height)), 0.01);
  }
}

// Sunlight outside the air (ASTM E490 seen by the CIE 1931 observer) is grey on the display.
TEST_F(ToneMapGlTest, ShowsSunlightWithoutAirAsGrey) {
  Projection const p{ProjectionKind::Perspective, 60.0 * degree, 32, 32};
  Picture const picture(p, [](int, int) { return glm::vec3(146606.0f, 130138.0f, 125651.0f); });
  auto const shown = gl::Texture::plane(GL_RGBA8, p.width, p.height);
  gl::Framebuffer const target({&shown});
  // A fifth of white, below the knee: linear.
  ToneMap(p.kind).apply(picture.texture, {5.0 * 133317.0}, &target, {0, 0}, false);
  std::vector<float> const texels = shown.readRgba();
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(texels[k], glsl::srgbEncoded(0.2), 1.0 / 255.0);
}

TEST_F(ToneMapGlTest, KeepsBlackBlackAndTheSunWhite) {
  Projection const p{ProjectionKind::Perspective, 60.0 * degree, 64, 64};
  Picture const picture(p, [](int x, int) { return glm::vec3(x < 32 ? 0.0f : 1.6e9f); });
  auto const shown = gl::Texture::plane(GL_RGBA8, p.width, p.height);
  gl::Framebuffer const target({&shown});
  ToneMap(p.kind).apply(picture.texture, {0.01}, &target);
  std::vector<float> const texels = shown.readRgba();
  for (std::size_t i = 0; i < texels.size(); ++i) {
    if (i % 4 == 3) continue;
    ASSERT_EQ(texels[i], i / 4 % 64 < 32 ? 0.0f : 1.0f);
  }
}

}  // namespace
}  // namespace antumbra
