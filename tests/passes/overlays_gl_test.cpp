// Overlays in pixels: lines and letters where they are told, cones where geometry puts them.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "passes/cone_pass.h"
#include "passes/drawing_pass.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/sky_picture.h"

namespace antumbra {
namespace {

using testsupport::SkyPicture;
using OverlaysGlTest = testsupport::GlTest;

Drawing blank(int width, int height) {
  Drawing drawing;
  drawing.width = width;
  drawing.height = height;
  return drawing;
}

DrawnShape whiteLine(std::vector<glm::dvec2> path, double width) {
  DrawnShape shape;
  shape.paths = {std::move(path)};
  shape.line = Ink{{255, 255, 255}, 1.0};
  shape.lineWidth = width;
  return shape;
}

TEST_F(OverlaysGlTest, ALineHasItsPlaceAndWidth) {
  Projection const p{ProjectionKind::Perspective, 60.0 * degree, 200, 100};
  SkyPicture picture(p);
  DrawingPass pass;
  for (double const width : {1.0, 1.5, 3.0, 8.0}) {
    Drawing drawing = blank(200, 100);
    drawing.shapes.push_back(whiteLine({{10.0, 20.0}, {190.0, 70.0}}, width));
    pass.prepare(drawing);
    picture.draw([&] { pass.draw({0, 0}, {200, 100}); });
    double const slope = 50.0 / 180.0, stretch = std::hypot(1.0, slope);
    for (int x = 40; x < 160; x += 7) {
      double sum = 0.0, moment = 0.0;
      for (int y = 0; y < 100; ++y) {  // rows from the bottom up
        sum += picture.at(x, y).x;
        moment += picture.at(x, y).x * (100.0 - (y + 0.5));
      }
      EXPECT_NEAR(moment / sum, 20.0 + slope * (x + 0.5 - 10.0), 0.1) << width << " at " << x;
      // A column cuts the line aslant.
      EXPECT_NEAR(sum, width * stretch, 0.08) << width << " at " << x;
    }
  }
}

TEST_F(OverlaysGlTest, TilesJoin) {
  Drawing drawing = blank(200, 100);
  drawing.shapes.push_back(whiteLine({{10.0, 20.0}, {100.0, 80.0}, {190.0, 30.0}}, 2.5));
  DrawnWords words;
  words.text = "10:06 UT";
  words.at = {60.0, 60.0};
  words.ink = {{255, 255, 255}, 1.0};
  words.halo = true;
  drawing.words.push_back(words);
  DrawingPass pass;
  pass.prepare(drawing);
  SkyPicture whole({ProjectionKind::Perspective, 60.0 * degree, 200, 100});
  whole.draw([&] { pass.draw({0, 0}, {200, 100}); });
  SkyPicture tile({ProjectionKind::Perspective, 60.0 * degree, 70, 50});
  tile.draw([&] { pass.draw({50, 30}, {70, 50}); });
  double light = 0.0;
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 70; ++x) {
      EXPECT_NEAR(tile.at(x, y).x, whole.at(x + 50, y + 30).x, 1e-5);
      light += tile.at(x, y).x;
    }
  EXPECT_GT(light, 100.0);
}

TEST_F(OverlaysGlTest, LettersStandOnTheirBaseline) {
  Drawing drawing = blank(120, 60);
  DrawnWords words;
  words.text = "HHHH";
  words.at = {60.0, 40.0};
  words.size = 20.0;
  words.anchor = DrawnWords::Anchor::Middle;
  words.ink = {{255, 255, 255}, 1.0};
  drawing.words.push_back(words);
  DrawingPass pass;
  pass.prepare(drawing);
  SkyPicture picture({ProjectionKind::Perspective, 60.0 * degree, 120, 60});
  picture.draw([&] { pass.draw({0, 0}, {120, 60}); });
  int low = 1000, high = -1, left = 1000, right = -1;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 120; ++x)
      if (picture.at(x, y).x > 0.5) {
        low = std::min(low, y), high = std::max(high, y);
        left = std::min(left, x), right = std::max(right, x);
      }
  EXPECT_EQ(low, 20);                              // 40 from the upper edge
  EXPECT_NEAR(high - low + 1, 0.729 * 20.0, 1.0);  // DejaVu Sans' capitals
  EXPECT_NEAR(0.5 * (left + right + 1), 60.0, 1.0);
}

// As many and as large as the words of a dome master of 8192 pixels.
TEST_F(OverlaysGlTest, NoLetterOfLargeWordsIsMissing) {
  std::string const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
  constexpr int kSize = 200;
  auto const inkOf = [&](DrawingPass& pass, const std::vector<DrawnWords>& words, std::size_t i) {
    // One letter's window of the drawing.
    Drawing drawing = blank(2 * kSize, 2 * kSize * static_cast<int>(letters.size()));
    drawing.words = words;
    pass.prepare(drawing);
    SkyPicture picture({ProjectionKind::Perspective, 60.0 * degree, 2 * kSize, 2 * kSize});
    int const fromBottom = static_cast<int>(letters.size() - 1 - i) * 2 * kSize;
    picture.draw([&] { pass.draw({0, fromBottom}, {2 * kSize, 2 * kSize}); });
    double sum = 0.0;
    for (int y = 0; y < 2 * kSize; ++y)
      for (int x = 0; x < 2 * kSize; ++x) sum += picture.at(x, y).x;
    return sum;
  };
  std::vector<DrawnWords> all;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    DrawnWords words;
    words.text = letters[i];
    words.at = {0.5 * kSize, 2.0 * kSize * static_cast<double>(i) + 1.4 * kSize};
    words.size = kSize;
    words.ink = {{255, 255, 255}, 1.0};
    words.halo = true;
    all.push_back(words);
  }
  DrawingPass pass;
  for (std::size_t const i : {std::size_t{0}, letters.size() / 2, letters.size() - 1}) {
    DrawingPass alone;
    double const expected = inkOf(alone, {all[i]}, i);
    EXPECT_GT(expected, 1000.0) << letters[i];
    EXPECT_NEAR(inkOf(pass, all, i), expected, 1e-3 * expected) << letters[i];
  }
}

// A cone along x, seen from the side: Sun and Moon at round distances.
PlannedCone coneAlong(double cameraAside, double ahead) {
  PlannedCone cone;
  cone.caster = "Moon";
  double const sunAt = -1.5e11, casterAt = 0.0;
  // The camera looks along -z; the axis runs to the right at `cameraAside` before it.
  glm::dvec3 const shift(-ahead, 0.0, -cameraAside);
  cone.pair = shadowPairMetres(glm::dvec3(sunAt, 0, 0) + shift, glm::dvec3(casterAt, 0, 0) + shift,
                               {695700.0 * kilometre, 1738.0 * kilometre, 1738.0 * kilometre});
  cone.base = Length(-cone.pair.casterBehind);
  cone.apex = Length(cone.pair.umbraRadius / cone.pair.umbraTangent);
  cone.end = Length(cone.apex.si + 1e8);
  return cone;
}

TEST_F(OverlaysGlTest, ConesHaveTheirSilhouetteFromTheSide) {
  // From 50 000 km aside of the point 200 000 km behind the Moon: 1 pixel is 24 km.
  Projection const p{ProjectionKind::Perspective, 20.0 * degree, 200, 720};
  double const aside = 5e7, behind = 2e8;
  SkyPicture picture(p);
  ConePass pass(p.kind);
  pass.prepare({coneAlong(aside, behind)}, {});
  picture.draw([&] { pass.draw(); });
  double const scale = 100.0 / std::tan(std::numbers::pi / 18.0);
  // Flanks by similar triangles: half-angle asin((Rs -+ Rm) / distance).
  for (int x = 20; x < 180; x += 20) {
    double const along = behind + aside * (x + 0.5 - 100.0) / scale;
    double const sineUmbra = (695.7e6 - 1.738e6) / 1.5e11,
                 sinePenumbra = (695.7e6 + 1.738e6) / 1.5e11;
    double const umbra =
        1.738e6 / std::sqrt(1 - sineUmbra * sineUmbra) - along * std::tan(std::asin(sineUmbra));
    double const penumbra = 1.738e6 / std::sqrt(1 - sinePenumbra * sinePenumbra) +
                            along * std::tan(std::asin(sinePenumbra));
    auto const rows = [&](double radius) {
      // The outline of a cone that is nearly a cylinder: the tangent ray's slope r / sqrt(d^2 -
      // r^2).
      return scale * radius / std::sqrt(aside * aside - radius * radius);
    };
    // Blue less red tells the umbra from the pale penumbra.
    double umbraRows = 0.0, penumbraRows = 0.0;
    for (int y = 0; y < 720; ++y) {
      auto const c = picture.at(x, y);
      if (c.z > 0.0) penumbraRows += 1.0;
      if (c.z - 1.6 * c.x > 0.02 && c.z > 0.0) umbraRows += 1.0;
    }
    EXPECT_NEAR(0.5 * penumbraRows, rows(penumbra), 1.6) << x;
    EXPECT_NEAR(0.5 * umbraRows, rows(umbra), 2.5) << x;
  }
}

TEST_F(OverlaysGlTest, NothingJumpsWhereTheCameraEntersACone) {
  Projection const p{ProjectionKind::Fisheye, 360.0 * degree, 96, 96};
  SkyPicture picture(p);
  ConePass pass(p.kind);
  double const behind = 2e8;
  double const sine = (695.7e6 - 1.738e6) / 1.5e11;
  double const surface = 1.738e6 / std::sqrt(1 - sine * sine) - behind * std::tan(std::asin(sine));
  auto const meanAt = [&](double aside) {
    pass.prepare({coneAlong(aside, behind)}, {});
    picture.draw([&] { pass.draw(); });
    double sum = 0.0, worst = 0.0;
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 96; ++x) {
        EXPECT_TRUE(std::isfinite(picture.at(x, y).z));
        sum += picture.at(x, y).z;
        worst = std::max<double>(worst, picture.at(x, y).z);
      }
    EXPECT_LE(worst, 1.0);
    return sum / (96.0 * 96.0);
  };
  double before = meanAt(0.90 * surface);
  for (double share = 0.92; share < 1.11; share += 0.02) {
    double const now = meanAt(share * surface);
    EXPECT_NEAR(now, before, 0.03) << share;
    before = now;
  }
  // On the surface itself, a metre in and a metre out.
  EXPECT_NEAR(meanAt(surface - 1.0), meanAt(surface + 1.0), 0.005);
  EXPECT_GT(meanAt(0.5 * surface), 1.2 * meanAt(1.5 * surface));
}

TEST_F(OverlaysGlTest, ABodyInFrontHidesACone) {
  Projection const p{ProjectionKind::Perspective, 20.0 * degree, 100, 100};
  SkyPicture picture(p);
  ConePass pass(p.kind);
  PlannedBody ball;
  ball.name = "ball";
  ball.equatorialRadius = ball.polarRadius = 300.0 * kilometre;
  ball.centre = {{0.0, 0.0, -1e7}};
  ball.cameraHeight = Length(1e7 - 3e5);
  ball.diameterPixels = 17.0;
  pass.prepare({coneAlong(5e7, 2e8)}, {ball});
  picture.draw([&] { pass.draw(); });
  EXPECT_EQ(picture.at(50, 50).z, 0.0);
  EXPECT_GT(picture.at(80, 50).z, 0.1);
  // Behind the cone it hides nothing of it.
  ball.centre = {{0.0, 0.0, -9e7}};
  ball.cameraHeight = Length(9e7 - 3e5);
  pass.prepare({coneAlong(5e7, 2e8)}, {ball});
  picture.draw([&] { pass.draw(); });
  EXPECT_NEAR(picture.at(50, 50).z, picture.at(51, 50).z, 0.01);
  EXPECT_GT(picture.at(50, 50).z, 0.1);
}

}  // namespace
}  // namespace antumbra
