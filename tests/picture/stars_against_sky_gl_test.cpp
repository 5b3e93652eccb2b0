// Stars and planets come out by luminance alone: which stars a displayed picture parts from its
// sky, in twilight and in totality, against the threshold of the naked eye.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "document/paths.h"
#include "photometry/magnitude.h"
#include "photometry/naked_eye.h"
#include "picture/picture_renderer.h"
#include "scene/apparent_stars.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ground_window.h"

namespace antumbra {
namespace {

using StarsAgainstSky = testsupport::GlTest;

double nakedEyeLimit(double luminance) {
  return magnitudeOfIlluminanceLux(faintestPointLux(luminance));
}

struct SeenStar {
  double magnitude;
  int steps;  // of 255, by which it brightens a pixel
};

// Of the catalogue's stars that a picture is asked for.
constexpr double kFaintest = 6.5;

struct SkyWithStars {
  double luminance = 0.0;
  std::vector<SeenStar> stars;
  // The magnitude that parts shown from lost ones with the fewest on the wrong side.
  double limit() const {
    double best = 0.0;
    int fewest = 1 << 30;
    for (double m = -1.5; m <= kFaintest; m += 0.1) {
      int wrong = 0;
      for (auto const& s : stars) wrong += (s.magnitude < m) != (s.steps >= 3);
      if (wrong < fewest) {
        fewest = wrong;
        best = m;
      }
    }
    return best;
  }
  // The same where nothing but the steps hides stars, from all that brighten a pixel by enough to
  // tell and not by so much that the display bends it: the median of where they would brighten it
  // by 2.5, which rounds to three. Of a dozen stars one that is rounded otherwise does not matter.
  double limitBySteps() const {
    std::vector<double> limits;
    for (auto const& s : stars)
      if (s.steps >= 2 && s.steps < 60)
        limits.push_back(s.magnitude + 2.5 * std::log10(s.steps / 2.5));
    if (limits.empty()) return -1.5;
    auto const middle = limits.begin() + static_cast<std::ptrdiff_t>(limits.size() / 2);
    std::nth_element(limits.begin(), middle, limits.end());
    return std::min(*middle, kFaintest);
  }
};

// The zenith of Luxor, 60 degrees wide, in pixels of 4.6 to 6.2 minutes of arc. A star is shown
// where it brightens a pixel of the displayed picture by three steps of 255.
SkyWithStars skyAt(const std::string& time, PictureRenderer& renderer, bool eye = false) {
  Scene scene = readScene(configsFolder() / "scenes" / "luxor_dome.toml");
  scene.quality = "balanced";
  scene.picture = {ProjectionKind::Perspective, 60.0 * degree, 640, 640};
  auto const placed = placeScene(scene, parseInstant(time, "test"), BodyCatalogue::standard(),
                                 Ephemeris::standard(), DeltaT::standard());
  auto const plan = makeRenderPlan(scene, placed);
  scene.display.eye = eye;
  EyeState state;
  if (eye) state = steadyEye(renderer.meter(scene, placed, plan));
  auto const with = renderer.finish(scene, placed, plan, eye ? &state : nullptr);
  Scene empty = scene;
  empty.display.limitingMagnitude = -5.0;
  if (!eye) empty.display.automaticExposure = false;
  empty.display.whiteLuminance = with.whiteLuminance;
  auto const without =
      renderer.finish(empty, placed, makeRenderPlan(empty, placed), eye ? &state : nullptr);

  SkyWithStars sky;
  std::vector<double> luminances;
  for (std::size_t i = 0; i < without.linear.size(); i += 3 * 97)
    luminances.push_back(0.2126 * double{without.linear[i]} +
                         0.7152 * double{without.linear[i + 1]} +
                         0.0722 * double{without.linear[i + 2]});
  std::nth_element(luminances.begin(), luminances.begin() + std::ptrdiff_t(luminances.size() / 2),
                   luminances.end());
  sky.luminance = luminances[luminances.size() / 2];
  auto const catalogue = StarCatalogue::load(catalogsFolder() / "stars");
  for (auto const& star : apparentStars(catalogue, placed.when, placed.velocity, kFaintest)) {
    auto const pixel = scene.picture.pixelOf(placed.cameraFromIcrs(star.direction));
    if (!pixel) continue;
    int const x = static_cast<int>(pixel->x), y = 639 - static_cast<int>(pixel->y);
    if (x < 2 || y < 2 || x > 637 || y > 637) continue;
    int most = 0;
    for (int j = y - 1; j <= y + 1; ++j)
      for (int i = x - 1; i <= x + 1; ++i)
        for (int c = 0; c < 3; ++c) {
          auto const at = static_cast<std::size_t>((j * 640 + i) * 3 + c);
          most = std::max(most, int{with.srgb[at]} - int{without.srgb[at]});
        }
    sky.stars.push_back(
        {-2.5 * std::log10(star.illuminance / illuminanceLuxOfMagnitude(0.0)), most});
  }
  return sky;
}

// The darker the sky, the fainter the stars. On skies as bright as totality's the display's limit
// is the eye's within 1 magnitude (measured: 0.6). On brighter ones a display of 255 steps loses
// stars that an eye finds, on darker ones an exposure shows more than it: within 2.5 magnitudes.
TEST_F(StarsAgainstSky, ComeOutAsTheNakedEyeSeesThem) {
  PictureRenderer renderer(testsupport::greyMap);
  std::vector<std::pair<double, double>> limits;
  int like = 0;
  for (const char* time : {"2027-08-02T16:50:00Z", "2027-08-02T17:00:00Z", "2027-08-02T17:08:00Z",
                           "2027-08-02T17:20:00Z", "2027-08-02T10:05:17Z"}) {
    SkyWithStars const sky = skyAt(time, renderer);
    ASSERT_GT(sky.stars.size(), 300u);
    double const shown = sky.limitBySteps(), eye = nakedEyeLimit(sky.luminance);
    std::printf("%s sky %.3g cd/m2: shown to V %.1f, naked eye to %.1f\n", time, sky.luminance,
                shown, eye);
    bool const likeTotality = sky.luminance > 0.05 && sky.luminance < 1.0;
    like += likeTotality;
    EXPECT_NEAR(shown, eye, likeTotality ? 1.0 : 2.5) << time;
    limits.emplace_back(sky.luminance, shown);
  }
  EXPECT_EQ(like, 3);
  std::sort(limits.begin(), limits.end());
  for (std::size_t i = 1; i < limits.size(); ++i)
    EXPECT_LT(limits[i].second, limits[i - 1].second) << limits[i].first << " cd/m2";
}

// An eye's picture of a dark sky shows no more than the eye sees.
TEST_F(StarsAgainstSky, AnEyeHasItsOwnLimit) {
  PictureRenderer renderer(testsupport::greyMap);
  for (const char* time : {"2027-08-02T17:08:00Z", "2027-08-02T17:20:00Z"}) {
    SkyWithStars const sky = skyAt(time, renderer, true);
    double const shown = sky.limit(), eye = nakedEyeLimit(sky.luminance);
    std::printf("%s sky %.3g cd/m2: an eye's picture shows to V %.1f, naked eye to %.1f\n", time,
                sky.luminance, shown, eye);
    // Light goes within a magnitude of the threshold.
    EXPECT_NEAR(shown, eye, 1.0) << time;
  }
}

}  // namespace
}  // namespace antumbra
