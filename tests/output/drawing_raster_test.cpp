// A drawing's pixels have the inks where the drawing puts them.
#include <gtest/gtest.h>

#include "output/image_file.h"

namespace antumbra {
namespace {

using Rgb = std::array<int, 3>;

Rgb at(const Drawing& d, const std::vector<std::uint8_t>& pixels, int x, int y) {
  auto const i = static_cast<std::size_t>(3 * (y * d.width + x));
  return {pixels[i], pixels[i + 1], pixels[i + 2]};
}

Drawing sheet() {
  Drawing d;
  d.width = d.height = 100;
  d.clipCentre = {50.0, 50.0};
  d.clipRadius = 40.0;
  return d;
}

TEST(DrawingRaster, FillsEvenOddAndKeepsToTheCircle) {
  Drawing d = sheet();
  std::vector<glm::dvec2> const all{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  std::vector<glm::dvec2> const hole{{40, 40}, {60, 40}, {60, 60}, {40, 60}};
  DrawnShape frame, square;
  frame.paths = {all, hole};
  frame.fill = Ink{{10, 20, 30}, 1.0};
  d.shapes.push_back(frame);
  // A second shape: what the first left behind must not reach into it.
  square.paths = {{{45, 45}, {55, 45}, {55, 55}, {45, 55}}};
  square.fill = Ink{{200, 0, 0}, 0.5};
  square.clipped = false;
  d.shapes.push_back(square);
  auto const pixels = rasterised(d);
  ASSERT_EQ(pixels.size(), 30000u);
  EXPECT_EQ(at(d, pixels, 20, 50), (Rgb{10, 20, 30}));
  EXPECT_EQ(at(d, pixels, 42, 42), (Rgb{255, 255, 255}));  // in the hole
  EXPECT_EQ(at(d, pixels, 3, 3), (Rgb{255, 255, 255}));    // outside the circle
  Rgb const half = at(d, pixels, 50, 50);
  EXPECT_NEAR(half[0], 227.5, 1.0);
  EXPECT_NEAR(half[1], 127.5, 1.0);
}

TEST(DrawingRaster, WritesWordsFromTheirAnchor) {
  for (auto const anchor :
       {DrawnWords::Anchor::Start, DrawnWords::Anchor::Middle, DrawnWords::Anchor::End}) {
    Drawing d = sheet();
    d.words.push_back({.text = "HHH", .at = {50.0, 60.0}, .size = 12.0, .anchor = anchor});
    auto const pixels = rasterised(d);
    int dark[2] = {0, 0};
    for (int y = 45; y < 62; ++y)
      for (int x = 0; x < 100; ++x) dark[x < 50 ? 0 : 1] += at(d, pixels, x, y)[0] < 128;
    EXPECT_EQ(dark[0] == 0, anchor == DrawnWords::Anchor::Start);
    EXPECT_EQ(dark[1] == 0, anchor == DrawnWords::Anchor::End);
    EXPECT_GT(dark[0] + dark[1], 40);
  }
}

}  // namespace
}  // namespace antumbra
