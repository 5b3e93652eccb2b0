// Tiles of a body against its rays, pixel by pixel. A tile of air may hold pixels that miss it.
#include "passes/body_tiles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace antumbra {
namespace {

// 0 nothing, 1 ground, 2 air for a ray from `height` above a unit sphere's pole.
int seen(const glm::dvec3& direction, double height, double reach) {
  double const rise = (1.0 + height) * direction.z;
  double const nearest = rise * rise - height * (2.0 + height);
  if (rise < 0.0 && nearest > 0.0) return 1;
  if (height <= reach) return reach > 0.0 ? 2 : 0;
  double const top = rise * rise - (height - reach) * (2.0 + height + reach);
  return rise < 0.0 && top > 0.0 ? 2 : 0;
}

TEST(BodyTiles, HoldEveryPixelInAPartThatDrawsIt) {
  glm::dvec3 const up(0.0, 0.0, 1.0);
  for (auto kind :
       {ProjectionKind::Perspective, ProjectionKind::Fisheye, ProjectionKind::Equirectangular})
    for (double height : {1e-6, 0.01, 0.3, 4.0, 100.0})
      for (double reach : {0.0, 0.02})
        for (double tilt : {0.0, 0.6, 1.5, 2.6}) {
          Projection const picture{
              kind, (kind == ProjectionKind::Perspective ? 70.0 : 200.0) * degree, 240, 160};
          // The camera looks along -z: turned about x, toward the body at tilt 0.
          glm::dmat3 const turn(glm::dvec3(1, 0, 0), glm::dvec3(0, std::cos(tilt), std::sin(tilt)),
                                glm::dvec3(0, -std::sin(tilt), std::cos(tilt)));
          auto const tiles = bodyTiles(picture, {0, 0, picture.width, picture.height}, turn, up, up,
                                       1.0, height, reach);
          std::vector<int> part(static_cast<std::size_t>(picture.width * picture.height), -1);
          for (std::size_t p = 0; p < 3; ++p)
            for (std::size_t i = 0; i < tiles[p].size(); i += 6)
              for (int y = int(tiles[p][i].y); y < int(tiles[p][i + 2].y); ++y)
                for (int x = int(tiles[p][i].x); x < int(tiles[p][i + 2].x); ++x) {
                  auto& slot = part[static_cast<std::size_t>(y * picture.width + x)];
                  EXPECT_EQ(slot, -1);
                  slot = static_cast<int>(p);
                }
          for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
              auto const direction = picture.directionAt(x + 0.5, y + 0.5);
              if (!direction) continue;
              int const what = seen(turn * direction->u, height, reach);
              int const drawn = part[static_cast<std::size_t>(y * picture.width + x)];
              bool const both = drawn == int(BodyPart::Both);
              bool const right = what == 1   ? drawn == int(BodyPart::Ground)
                                 : what == 2 ? drawn == int(BodyPart::Air)
                                             : drawn != int(BodyPart::Ground);
              ASSERT_TRUE(both || right)
                  << "pixel " << x << ", " << y << " shows " << what << ", drawn as " << drawn;
            }
        }
}

}  // namespace
}  // namespace antumbra
