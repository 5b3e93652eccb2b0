// Tiles of a body against its rays, pixel by pixel. A tile of air may hold pixels that miss it.
#include "passes/body_tiles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/as_cpp.h"

namespace antumbra {
namespace {

constexpr double kNightSine = -0.3;

// 0 nothing, 1 ground, 2 air for a ray from `height` above a unit sphere's pole.
int seen(const glm::dvec3& direction, double height, double reach) {
  double const rise = (1.0 + height) * direction.z;
  double const nearest = rise * rise - height * (2.0 + height);
  if (rise < 0.0 && nearest > 0.0) return 1;
  if (height <= reach) return reach > 0.0 ? 2 : 0;
  double const top = rise * rise - (height - reach) * (2.0 + height + reach);
  return rise < 0.0 && top > 0.0 ? 2 : 0;
}

// The Sun's sine at the ground that a ray meets, and the highest along its way through the air.
std::pair<double, double> sunSines(const glm::dvec3& ray, double height, double reach,
                                   const glm::dvec3& sun) {
  glm::dvec3 const direction = glm::normalize(ray), camera(0.0, 0.0, 1.0 + height);
  double const rise = glm::dot(camera, direction);
  double const end = -rise - std::sqrt(rise * rise - height * (2.0 + height));
  double highest = -1.0;
  for (int i = 0; i <= 100; ++i) {
    glm::dvec3 const point = camera + direction * (end * i / 100.0);
    if (glm::length(point) > 1.0 + reach + 1e-9) continue;
    highest = std::max(highest, glm::dot(point, sun) / glm::length(point));
  }
  return {glm::dot(glm::normalize(camera + direction * end), sun), highest};
}

// Sine of the eye's height above the horizon of the ground that a ray meets.
double eyeSine(const glm::dvec3& ray, double height) {
  double const rise = (1.0 + height) * glm::normalize(ray).z;
  return std::sqrt(rise * rise - height * (2.0 + height));
}

TEST(BodyTiles, HoldEveryPixelInAPartThatDrawsIt) {
  glm::dvec3 const up(0.0, 0.0, 1.0);
  int night = 0, shared = 0;
  for (CoarseTiles const coarse : {CoarseTiles{}, CoarseTiles{4, true}})
    for (auto kind :
         {ProjectionKind::Perspective, ProjectionKind::Fisheye, ProjectionKind::Equirectangular})
      for (double height : {1e-6, 0.01, 0.3, 4.0, 100.0})
        for (double reach : {0.0, 0.02})
          for (double tilt : {0.0, 0.6, 1.5, 2.6}) {
            Projection const picture{
                kind, (kind == ProjectionKind::Perspective ? 70.0 : 200.0) * degree, 240, 160};
            // The camera looks along -z: turned about x, toward the body at tilt 0.
            glm::dmat3 const turn(glm::dvec3(1, 0, 0),
                                  glm::dvec3(0, std::cos(tilt), std::sin(tilt)),
                                  glm::dvec3(0, -std::sin(tilt), std::cos(tilt)));
            for (glm::dvec3 const& sun :
                 {up, glm::dvec3(0.6, 0.0, -0.8), glm::dvec3(0.0, 1.0, 0.0)}) {
              auto const tiles = bodyTiles(picture, {0, 0, picture.width, picture.height}, turn, up,
                                           sun, 1.0, height, reach, kNightSine, coarse);
              std::vector<int> part(static_cast<std::size_t>(picture.width * picture.height), -1);
              for (std::size_t p = 0; p < kBodyParts; ++p)
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
                  bool const ground = (drawn >= 0 && drawn <= int(BodyPart::Night)) ||
                                      drawn == int(BodyPart::CoarseSunlit) ||
                                      drawn == int(BodyPart::CoarseDusk);
                  if (drawn >= int(BodyPart::CoarseSunlit)) {
                    ++shared;
                    // So do the pixels around, which share its samples.
                    for (auto const& [dx, dy] : {std::pair{-4, -4}, {4, -4}, {4, 4}, {-4, 4}})
                      if (auto const beside = picture.directionAt(x + dx + 0.5, y + dy + 0.5)) {
                        ASSERT_EQ(seen(turn * beside->u, height, reach), what) << x << ", " << y;
                      }
                  }
                  bool const right =
                      what == 1   ? ground
                      : what == 2 ? drawn == int(BodyPart::Air) || drawn == int(BodyPart::CoarseAir)
                                  : !ground;
                  ASSERT_TRUE(both || right)
                      << "pixel " << x << ", " << y << " shows " << what << ", drawn as " << drawn;
                  if (what != 1) continue;
                  auto const [low, high] = sunSines(turn * direction->u, height, reach, sun);
                  double const few =
                      glsl::fewSamplesShare(low, eyeSine(turn * direction->u, height));
                  if (drawn == int(BodyPart::Sunlit) || drawn == int(BodyPart::CoarseSunlit)) {
                    ASSERT_EQ(few, 1.0) << "pixel " << x << ", " << y;
                  }
                  if (drawn == int(BodyPart::Dusk) || drawn == int(BodyPart::CoarseDusk)) {
                    ASSERT_EQ(few, 0.0) << "pixel " << x << ", " << y;
                  }
                  if (drawn == int(BodyPart::Night)) {
                    ASSERT_LT(high, kNightSine) << "pixel " << x << ", " << y;
                    ++night;
                  }
                }
            }
          }
  EXPECT_GT(night, 1000);
  EXPECT_GT(shared, 100000);
}

}  // namespace
}  // namespace antumbra
