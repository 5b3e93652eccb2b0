// Pictures of an eclipse 0.1 s apart: where a shadow comes into play, at the contacts, and whatever
// was drawn before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "document/paths.h"
#include "picture/picture_renderer.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ground_window.h"

namespace antumbra {
namespace {

using EclipseContinuity = testsupport::GlTest;

// The sky over Luxor without Sun and Moon, whose edges move by themselves.
Scene domeOf(const std::string& quality) {
  Scene s = readScene(configsFolder() / "scenes" / "luxor_dome.toml");
  s.picture.width = s.picture.height = 48;
  s.quality = quality;
  s.display.automaticExposure = false;
  return s;
}

struct Sky {
  FinishedPicture picture;
  bool eclipsed;
  int width;
  // Mean luminance of a ring of the dome between two zenith angles, degrees, away from the Sun (in
  // the north at this hour: the lower half of a dome whose top is north).
  double ring(double from, double to) const {
    double sum = 0.0;
    int count = 0;
    double const half = 0.5 * width;
    for (int y = 0; y < width; ++y)
      for (int x = 0; x < width; ++x) {
        double const zenith = std::hypot(x + 0.5 - half, y + 0.5 - half) / half * 90.0;
        if (zenith < from || zenith > to) continue;
        sum += luminance(x, y);
        ++count;
      }
    return sum / count;
  }
  double luminance(int x, int y) const {
    auto const* p = &picture.linear[static_cast<std::size_t>(y * width + x) * 3];
    return 0.2126 * static_cast<double>(p[0]) + 0.7152 * static_cast<double>(p[1]) +
           0.0722 * static_cast<double>(p[2]);
  }
};

Sky skyAt(const Scene& scene, const Instant& start, double seconds, PictureRenderer& renderer) {
  auto const placed = placeScene(scene, start + seconds * second, BodyCatalogue::standard(),
                                 Ephemeris::standard(), DeltaT::standard());
  auto const plan = makeRenderPlan(scene, placed);
  return {renderer.finish(scene, placed, plan), !plan.shadows.empty(), scene.picture.width};
}

// Largest relative difference of two skies, pixel by pixel, beyond `hole` degrees from the zenith
// angle of the Sun's disc.
double largestStep(const Sky& a, const Sky& b) {
  double largest = 0.0;
  double const half = 0.5 * a.width;
  for (int y = 0; y < a.width; ++y)
    for (int x = 0; x < a.width; ++x) {
      double const zenith = std::hypot(x + 0.5 - half, y + 0.5 - half) / half * 90.0;
      if (zenith < 30.0 || zenith > 89.0) continue;
      largest = std::max(largest, std::fabs(b.luminance(x, y) / a.luminance(x, y) - 1.0));
    }
  return largest;
}

// From before the shadow is in the plan until after: the grid, the table of the whole turn and the
// programs of an eclipse come in, and nothing may jump. Then first contact over the place itself.
TEST_F(EclipseContinuity, NothingJumpsWhereTheShadowComes) {
  for (std::string const quality : {"balanced", "accurate"}) {
    if (quality == "accurate" && !std::getenv("SKY_ALL_ROWS")) continue;
    Scene const scene = domeOf(quality);
    Instant const day = parseInstant("2027-08-02T06:00:00Z", "test");
    PictureRenderer renderer(testsupport::greyMap);
    auto const planned = [&](double seconds) {
      auto const placed = placeScene(scene, day + seconds * second, BodyCatalogue::standard(),
                                     Ephemeris::standard(), DeltaT::standard());
      return !makeRenderPlan(scene, placed).shadows.empty();
    };
    double before = 0.0, after = 3.0 * 3600.0;
    ASSERT_FALSE(planned(before));
    ASSERT_TRUE(planned(after));
    while (after - before > 0.1) {
      double const middle = 0.5 * (before + after);
      (planned(middle) ? after : before) = middle;
    }
    Sky const off = skyAt(scene, day, before, renderer), on = skyAt(scene, day, after, renderer);
    ASSERT_FALSE(off.eclipsed);
    ASSERT_TRUE(on.eclipsed);
    double const entering = largestStep(off, on);
    // First contact at Luxor: 08:40:17.5 (README).
    double first = 0.0;
    Sky last = skyAt(scene, day, 9617.2, renderer);
    for (double t : {9617.3, 9617.4, 9617.5, 9617.6, 9617.7}) {
      Sky const now = skyAt(scene, day, t, renderer);
      first = std::max(first, largestStep(last, now));
      last = now;
    }
    std::printf("%s: the shadow comes into the plan at %.1f s: %.1e; first contact: %.1e\n",
                quality.c_str(), after, entering, first);
    EXPECT_LT(entering, 1e-3);
    EXPECT_LT(first, 1e-3);
  }
}

// At second and third contact light changes tenfold in a minute; its logarithm in steps of 0.1 s
// has no step beyond its own trend.
TEST_F(EclipseContinuity, TheSkyIsSmoothAtSecondAndThirdContact) {
  Scene const scene = domeOf("draft");
  Instant const day = parseInstant("2027-08-02T10:00:00Z", "test");
  PictureRenderer renderer(testsupport::greyMap);
  for (double contact : {127.8, 508.3}) {
    std::vector<Sky> skies;
    for (int i = -3; i <= 3; ++i) skies.push_back(skyAt(scene, day, contact + 0.1 * i, renderer));
    for (auto const& [from, to] : {std::pair{40.0, 60.0}, {80.0, 89.0}}) {
      double jerk = 0.0, size = 0.0, last = 0.0;
      for (std::size_t i = 1; i < skies.size(); ++i) {
        double const step = std::log(skies[i].ring(from, to) / skies[i - 1].ring(from, to));
        size = std::max(size, std::fabs(step));
        if (i > 1) jerk = std::max(jerk, std::fabs(step - last));
        last = step;
      }
      std::printf("%.0f to %.0f deg, contact %.1f s: %.3g cd/m2, steps up to %.2e, change %.2e\n",
                  from, to, contact, skies[3].ring(from, to), size, jerk);
      EXPECT_LT(size, 0.02);
      EXPECT_LT(jerk, 2e-3);
    }
  }
}

TEST_F(EclipseContinuity, APictureDependsOnNothingDrawnBefore) {
  Scene const scene = domeOf("draft");
  Instant const day = parseInstant("2027-08-02T10:00:00Z", "test");
  PictureRenderer alone(testsupport::greyMap), after(testsupport::greyMap);
  auto const expected = skyAt(scene, day, 300.0, alone);
  for (double t : {-1800.0, 127.0, 900.0}) skyAt(scene, day, t, after);
  auto const found = skyAt(scene, day, 300.0, after);
  EXPECT_EQ(expected.picture.linear, found.picture.linear);
}

}  // namespace
}  // namespace antumbra
