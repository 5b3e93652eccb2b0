// The eclipsed Moon in pictures: its magnitude under clean, ordinary and volcanic air, and the
// light that fades over it without a step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "document/paths.h"
#include "picture/picture_renderer.h"
#include "tests/support/csv.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ground_window.h"

namespace antumbra {
namespace {

using LunarEclipse = testsupport::GlTest;

double published(const std::string& quantity, std::size_t which) {
  for (auto const& row : readCsv("tests/authorities/eclipse_lunar_published.csv"))
    if (row.text("quantity") == quantity && which-- == 0) return row.number("value");
  throw std::runtime_error(quantity + ": not in the authority file");
}

// The Moon from above the Earth's air.
Scene moonFromAbove(double latitude, double longitude, const std::string& medium) {
  Scene s = readScene(configsFolder() / "scenes" / "lunar_eclipse.toml");
  s.camera.latitude = latitude * degree;
  s.camera.longitude = longitude * degree;
  s.camera.height = 1000.0 * kilometre;
  s.picture = {ProjectionKind::Perspective, 0.7 * degree, 96, 96};
  s.display.limitingMagnitude = -3.0;
  s.quality = "draft";
  s.air["Earth"] = medium;
  return s;
}

struct Moon {
  double lux = 0.0, phaseDegrees = 0.0;
  std::vector<float> linear;
};

Moon moonAt(const Scene& scene, Instant when, PictureRenderer& renderer) {
  auto const placed =
      placeScene(scene, when, BodyCatalogue::standard(), Ephemeris::standard(), DeltaT::standard());
  auto const plan = makeRenderPlan(scene, placed);
  Moon moon;
  moon.linear = renderer.finish(scene, placed, plan).linear;
  double const pixel = scene.picture.pixelAngle().si;
  for (std::size_t i = 0; i < moon.linear.size(); i += 3)
    moon.lux += (0.2126 * double{moon.linear[i]} + 0.7152 * double{moon.linear[i + 1]} +
                 0.0722 * double{moon.linear[i + 2]}) *
                pixel * pixel;
  for (auto const& b : placed.bodies)
    if (b.body->name == "Moon")
      moon.phaseDegrees = angleBetween(b.sunFromBody, -b.fromCamera) / degree;
  return moon;
}

// V in mid-eclipse: that of the same Moon four hours earlier, full but for its phase (0.026 mag a
// degree, Krisciunas & Schaefer 1991), dimmed as the picture is; V of the full Moon at its mean
// distance is -12.73 (Allen).
double eclipsedMagnitude(const Scene& scene, const char* middle, PictureRenderer& renderer) {
  Instant const when = parseInstant(middle, "test");
  Moon const dark = moonAt(scene, when, renderer);
  Moon const bright = moonAt(scene, when - 4.0 * hour, renderer);
  EXPECT_GT(bright.phaseDegrees, 1.0);
  return -12.73 + 0.026 * bright.phaseDegrees - 2.5 * std::log10(dark.lux / bright.lux);
}

// Mid-eclipse of 1990-02-09, 2007-03-03, 2022-11-08, seen from near the point below the Moon.
TEST_F(LunarEclipse, PicturesOfTheMoonAreAsBrightAsMeasured) {
  struct Row {
    const char* middle;
    double latitude, longitude;
    std::size_t which;
  };
  PictureRenderer renderer(testsupport::greyMap);
  double const brightest = published("eclipsed Moon minimum visual magnitude", 0);
  double const faintest = published("eclipsed Moon minimum visual magnitude", 1);
  for (auto const& [middle, latitude, longitude, which] :
       {Row{"1990-02-09T19:11:00Z", 15.0, 75.0, 0}, Row{"2007-03-03T23:21:00Z", 7.0, 13.0, 1},
        Row{"2022-11-08T10:59:00Z", 17.0, -168.0, 2}}) {
    double const v =
        eclipsedMagnitude(moonFromAbove(latitude, longitude, "earth"), middle, renderer);
    std::printf("%s V %.2f (measured %.1f)\n", middle, v,
                published("eclipsed Moon minimum visual magnitude", which));
    EXPECT_GT(v, brightest) << middle;
    EXPECT_LT(v, faintest) << middle;
  }
  // The air's presets, 2028-12-31.
  double last = -9.0;
  for (const char* air : {"earth_molecular", "earth", "earth_volcanic"}) {
    double const v =
        eclipsedMagnitude(moonFromAbove(20.0, 107.0, air), "2028-12-31T16:52:00Z", renderer);
    std::printf("2028-12-31 %s V %.2f\n", air, v);
    EXPECT_GT(v, last + 1.0) << air;
    last = v;
  }
}

// Over half an hour the umbra's edge crosses the disc. A step of the light in time would stay as
// large when the interval is halved; a continuous one halves.
TEST_F(LunarEclipse, LightFadesWithoutAStepAcrossTheEdgeOfTheUmbra) {
  PictureRenderer renderer(testsupport::greyMap);
  Scene scene = moonFromAbove(20.0, 107.0, "earth");
  scene.picture.width = scene.picture.height = 48;
  Instant const start = parseInstant("2028-12-31T15:10:00Z", "test");
  constexpr double kStep = 15.0;
  constexpr int kCount = 80;
  std::vector<std::vector<float>> pictures;
  for (int i = 0; i <= kCount; ++i)
    pictures.push_back(moonAt(scene, start + Duration(kStep * i), renderer).linear);
  auto const largest = [&](int every) {
    double most = 0.0;
    for (int i = 0; i + every <= kCount; i += every)
      for (int y = 12; y < 36; ++y)
        for (int x = 12; x < 36; ++x) {
          auto const at = static_cast<std::size_t>((y * 48 + x) * 3 + 1);
          double const a = double{pictures[static_cast<std::size_t>(i)][at]},
                       b = double{pictures[static_cast<std::size_t>(i + every)][at]};
          most = std::max(most, std::fabs(std::log(a / b)));
        }
    return most;
  };
  double const coarse = largest(4), fine = largest(1);
  std::printf("largest change of ln(luminance): %.4f in 60 s, %.4f in 15 s\n", coarse, fine);
  EXPECT_GT(coarse, 0.1);
  EXPECT_LT(fine, 0.35 * coarse);
}

}  // namespace
}  // namespace antumbra
