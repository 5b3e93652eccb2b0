// Whole pictures: what was really computed agrees with what was planned, tiles join, and the
// picture is finite from the ground to deep space.
#include "picture/picture_renderer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "document/input_error.h"
#include "document/paths.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/globe_view.h"
#include "tests/support/ground_window.h"

namespace antumbra {
namespace {

using GlTest = testsupport::GlTest;
using testsupport::greyMap;

struct Drawn {
  RenderPlan plan;
  FinishedPicture picture;
  PictureCounters counters;
};

Drawn draw(const Scene& scene, const std::string& time, PictureRenderer& renderer) {
  auto const placed = placeScene(scene, parseInstant(time, "test"), BodyCatalogue::standard(),
                                 Ephemeris::standard(), DeltaT::standard());
  Drawn drawn;
  drawn.plan = makeRenderPlan(scene, placed);
  drawn.picture = renderer.finish(scene, placed, drawn.plan);
  drawn.counters = renderer.counters();
  return drawn;
}

Drawn draw(const Scene& scene, const std::string& time) {
  PictureRenderer renderer(greyMap);
  return draw(scene, time, renderer);
}

Scene smallDome() {
  Scene s = readScene(configsFolder() / "scenes" / "luxor_dome.toml");
  s.picture.width = s.picture.height = 64;
  s.quality = "draft";
  return s;
}

void expectFinite(const FinishedPicture& picture) {
  for (float v : picture.linear) {
    ASSERT_TRUE(std::isfinite(v));
    ASSERT_GE(v, 0.0f);
  }
}

TEST_F(GlTest, TotalityUsesOneMediumOneShadowPairAndItsQueries) {
  Drawn const d = draw(smallDome(), "2027-08-02T10:05:06Z");
  expectFinite(d.picture);
  EXPECT_EQ(d.counters.tablesBuilt, 1);
  EXPECT_EQ(d.counters.shadowPairs, 1);
  EXPECT_EQ(d.counters.shadowPairs, static_cast<int>(d.plan.shadows.size()));
  EXPECT_GT(d.counters.occlusionQueries, 0);
}

TEST_F(GlTest, AnAirlessSceneBuildsNoTable) {
  Scene scene = smallDome();
  scene.bodies = {"Moon"};
  scene.camera.body = "Moon";
  scene.camera.height = 2.0 * metre;
  Drawn const d = draw(scene, "2027-08-02T10:05:06Z");
  expectFinite(d.picture);
  EXPECT_EQ(d.counters.tablesBuilt, 0);
  EXPECT_EQ(d.counters.shadowPairs, 0);
}

TEST_F(GlTest, NoQueryWithoutTheSunAndNoPairWithoutAnEclipse) {
  Drawn const night = draw(smallDome(), "2027-07-20T22:05:06Z");
  EXPECT_EQ(night.counters.occlusionQueries, 0);
  EXPECT_EQ(night.counters.shadowPairs, 0);
  Drawn const day = draw(smallDome(), "2027-07-20T10:05:06Z");
  EXPECT_EQ(day.counters.shadowPairs, 0);
  EXPECT_GT(day.counters.occlusionQueries, 0);
}

TEST_F(GlTest, TilesJoinWithoutASeam) {
  Scene scene = smallDome();
  scene.picture = {ProjectionKind::Equirectangular, 360.0 * degree, 4400, 16};
  scene.display.automaticExposure = false;
  Drawn const d = draw(scene, "2027-07-20T06:00:00Z");
  expectFinite(d.picture);
  // The second tile begins at column 4096: no step there larger than the largest among the columns
  // around it.
  auto const luminance = [&](int x, int y) {
    return d.picture.linear[static_cast<std::size_t>(y * 4400 + x) * 3 + 1];
  };
  for (int y = 0; y < 16; ++y) {
    float around = 1e-6f * luminance(4096, y);
    for (int x = 4066; x < 4126; ++x)
      if (x != 4095) around = std::max(around, std::fabs(luminance(x + 1, y) - luminance(x, y)));
    EXPECT_LE(std::fabs(luminance(4096, y) - luminance(4095, y)), 1.01f * around) << y;
  }
}

TEST_F(GlTest, FiniteAtEveryHeightAndRefusedBeyondTheLargestSize) {
  Scene scene = smallDome();
  scene.picture = {ProjectionKind::Perspective, 90.0 * degree, 48, 27};
  scene.camera.target = "";
  scene.camera.altitude = -20.0 * degree;
  PictureRenderer renderer(greyMap);
  for (double height : {-400.0, 0.001, 1.0, 1e3, 59e3, 60e3, 61e3, 1e6, 1e8, 1e9, 1e11}) {
    scene.camera.height = Length(height);
    SCOPED_TRACE(height);
    expectFinite(draw(scene, "2027-08-02T09:05:06Z", renderer).picture);
  }
  scene.picture.width = scene.picture.height = 20000;
  EXPECT_THROW(draw(scene, "2027-08-02T09:05:06Z"), InputError);
}

// The central line of 2 August 2027 where the authority's place of greatest eclipse lies: overlays
// stand in the displayed picture and leave the light alone.
TEST_F(GlTest, OverlaysAreDrawnOverTheDisplayedPictureOnly) {
  Scene scene = readScene(configsFolder() / "scenes" / "from_space.toml");
  scene.picture.width = 320;
  scene.picture.height = 180;
  scene.quality = "draft";
  scene.bodies = {"Sun", "Earth", "Moon"};
  PictureRenderer renderer(greyMap);
  std::string const when = "2027-08-02T08:40:00Z";
  Drawn const plain = draw(scene, when, renderer);
  scene.overlays.centralLine = true;
  scene.overlays.lineWidth = 2.0;
  Drawn const lined = draw(scene, when, renderer);
  EXPECT_EQ(plain.picture.linear, lined.picture.linear);
  // Greatest eclipse at 25.5030 N 33.1829 E (Espenak & Meeus give 25.5 N 33.2 E); a pixel is 60 km.
  testsupport::GlobeView view{8.0, 12.0, 12e6};
  view.width = 320;
  view.pixelsHigh = 180;
  view.fieldDegrees = 78.0;
  glm::dvec2 const at = *view.pixel(25.503, 33.183);
  int changed = 0;
  double nearest = 1e9;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 320; ++x) {
      auto const i = static_cast<std::size_t>(3 * (y * 320 + x));
      int const more = lined.picture.srgb[i] - plain.picture.srgb[i];
      if (more < 60) continue;  // the line is red and bright
      ++changed;
      nearest = std::min(nearest, glm::length(glm::dvec2(x + 0.5, y + 0.5) - at));
    }
  EXPECT_LT(nearest, 1.0);
  EXPECT_GT(changed, 100);
  EXPECT_LT(changed, 1200);
}

// The meter's readings, and so the eye's state, are the same in whatever order they are taken.
TEST_F(GlTest, MeterReadingsDoNotDependOnTheirOrder) {
  Scene const scene = smallDome();
  auto const read = [&](PictureRenderer& renderer, const char* time) {
    auto const placed = placeScene(scene, parseInstant(time, "test"), BodyCatalogue::standard(),
                                   Ephemeris::standard(), DeltaT::standard());
    return renderer.meter(scene, placed, makeRenderPlan(scene, placed)).meanLuminance;
  };
  const char *const first = "2027-08-02T10:01:30Z", *const second = "2027-08-02T10:05:06Z";
  PictureRenderer forwards(greyMap), backwards(greyMap);
  double const a = read(forwards, first), b = read(forwards, second);
  double const d = read(backwards, second), c = read(backwards, first);
  EXPECT_EQ(a, c);  // the thin crescent's halo is there after a picture of totality, too
  EXPECT_EQ(b, d);
  EXPECT_GT(a, 3.0 * b);
}

// Planets and stars by luminance: Venus stands out of totality's sky and not of day's.
TEST_F(GlTest, VenusComesOutInTotality) {
  Scene scene = smallDome();
  scene.camera.target = "Venus";
  scene.camera.up = CameraPlacement::Up::Zenith;
  scene.picture = {ProjectionKind::Perspective, 4.0 * degree, 65, 65};
  PictureRenderer renderer(greyMap);
  auto const contrast = [&](const char* time) {
    Drawn const d = draw(scene, time, renderer);
    double centre = 0.0, sky = 0.0;
    for (int y = 31; y <= 33; ++y)
      for (int x = 31; x <= 33; ++x)
        centre += d.picture.linear[static_cast<std::size_t>(y * 65 + x) * 3 + 1] / 9.0;
    for (int x = 20; x < 29; ++x)
      sky += d.picture.linear[static_cast<std::size_t>(33 * 65 + x) * 3 + 1] / 9.0;
    return centre / sky;
  };
  EXPECT_GT(contrast("2027-08-02T10:05:06Z"), 2.0);
  EXPECT_LT(contrast("2027-08-02T09:00:00Z"), 1.05);
}

// The halo of a Sun that has just left the picture goes on where it was.
TEST_F(GlTest, GlareGoesOnWhenTheSunLeavesThePicture) {
  Scene scene = smallDome();
  scene.bodies = {"Moon"};
  scene.camera.body = "Moon";
  scene.camera.latitude = 0.0 * degree;
  scene.camera.longitude = 0.0 * degree;
  scene.camera.height = 2.0 * metre;
  scene.camera.target = "Sun";
  scene.picture = {ProjectionKind::Perspective, 60.0 * degree, 61, 61};
  std::string const day = "2027-08-17T10:05:06Z";
  PictureRenderer renderer(greyMap);
  // The same direction of the sky, 8 degrees below the upper edge, with the Sun just inside the
  // picture and just outside.
  auto const near = [&](double tilt) {
    scene.camera.tilt = tilt * degree;
    Drawn const d = draw(scene, day, renderer);
    double const t = std::tan((tilt - 8.0) * M_PI / 180.0) / std::tan(M_PI / 6.0);
    int const row = static_cast<int>(std::lround(30.0 - 30.5 * t));
    return double{d.picture.linear[static_cast<std::size_t>(row * 61 + 30) * 3 + 1]};
  };
  double const inside = near(29.0), outside = near(31.0);
  EXPECT_GT(inside, 0.0);
  // Half a pixel of the halo's own slope there.
  EXPECT_NEAR(outside / inside, 1.0, 0.15);
}

}  // namespace
}  // namespace antumbra
