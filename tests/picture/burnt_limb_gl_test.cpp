// The Moon's limb before a corona far above white: as displayed, against the mean of what a picture
// of eight times the size displays.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "document/paths.h"
#include "picture/picture_renderer.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ground_window.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

using BurntLimb = testsupport::GlTest;

double decoded(std::uint8_t value) {
  double const s = value / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

TEST_F(BurntLimb, HasNoStairs) {
  Scene scene = readScene(configsFolder() / "scenes" / "luxor_corona.toml");
  scene.quality = "draft";
  scene.sun = SunSettings();
  scene.display.automaticExposure = false;
  scene.display.whiteLuminance = 300.0;  // the inner corona has thirty times as much
  scene.display.bracketsStops.clear();
  scene.picture.field = 1.0 * degree;
  PictureRenderer renderer(testsupport::greyMap);
  auto const picture = [&](int size) {
    scene.picture.width = scene.picture.height = size;
    auto const placed =
        placeScene(scene, parseInstant("2027-08-02T10:05:18Z", "test"), BodyCatalogue::standard(),
                   Ephemeris::standard(), DeltaT::standard());
    return renderer.finish(scene, placed, makeRenderPlan(scene, placed));
  };
  constexpr int kSize = 48, kFiner = 8;
  auto const coarse = picture(kSize), fine = picture(kSize * kFiner);
  double worst = 0.0, squares = 0.0, burnt = 0.0;
  int edges = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      double mean = 0.0, least = 1.0, most = 0.0, light = 0.0;
      for (int j = 0; j < kFiner; ++j)
        for (int i = 0; i < kFiner; ++i) {
          auto const at =
              static_cast<std::size_t>((y * kFiner + j) * kSize * kFiner + x * kFiner + i) * 3 + 1;
          double const shown = decoded(fine.srgb[at]);
          mean += shown / (kFiner * kFiner);
          light += static_cast<double>(fine.linear[at]) / (kFiner * kFiner);
          least = std::min(least, shown);
          most = std::max(most, shown);
        }
      if (most - least < 0.5) continue;
      ++edges;
      auto const at = static_cast<std::size_t>(y * kSize + x) * 3 + 1;
      double const error = decoded(coarse.srgb[at]) - mean;
      squares += error * error;
      worst = testsupport::larger(worst, std::fabs(error));
      burnt = std::max(burnt, light / scene.display.whiteLuminance - mean);
      // Light itself stays the mean of the pixel.
      EXPECT_NEAR(static_cast<double>(coarse.linear[at]) / light, 1.0, 0.25) << x << " " << y;
    }
  double const rms = std::sqrt(squares / edges);
  std::printf("%d pixels of the limb: displayed within %.3f, rms %.3f of white\n", edges, worst,
              rms);
  EXPECT_GT(edges, 80);
  EXPECT_GT(burnt, 5.0);  // where the mean of the light alone would be shown: white
  // One step of 255, and the outline by its tangent within a sample.
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(rms, 0.01);
}

}  // namespace
}  // namespace antumbra
