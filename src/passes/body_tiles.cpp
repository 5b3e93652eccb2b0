#include "passes/body_tiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "shared/as_cpp.h"

namespace antumbra {
namespace {

// Tiles across the longer side of the picture, and their least size in pixels.
constexpr int kTilesAcross = 100, kLeastPixels = 8;
// Rectangles of at least so many tiles are sought out first: a software renderer shades the blocks
// of pixels along a diagonal twice, which costs a row of tiles a quarter of its price.
constexpr int kLargeRectangle = 12;
// Widens a tile's cone for edges that bulge beyond its corners (fisheye, poles of a map).
constexpr double kBulge = 1.15;
// About the Sun, where the light of hazes changes from pixel to pixel.
constexpr double kAureole = 4.0 * std::numbers::pi / 180.0;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Angular radius of a sphere of `high` above the ground seen from `low` above it; pi from inside.
double angularRadiusFrom(double radius, double low, double high) {
  if (low <= high) return std::numbers::pi;
  double const tangent = std::sqrt((low - high) * (2.0 * radius + low + high));
  return std::atan2(radius + high, tangent);
}

void addRectangle(std::vector<glm::vec2>& to, int x0, int y0, int x1, int y1) {
  for (auto const& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y0}, {x1, y1}, {x0, y1}})
    to.emplace_back(static_cast<float>(x), static_cast<float>(y));
}

// Parts of tiles, row by row; -1: nothing.
struct TileGrid {
  int columns = 0, rows = 0;
  std::vector<int> parts;
  int& at(int column, int row) { return parts[static_cast<std::size_t>(row * columns + column)]; }
};
struct TileRectangle {
  int part, x0, y0, x1, y1;
  int area() const { return (x1 - x0) * (y1 - y0); }
};

// The largest rectangle of tiles of one part, by the heights of its columns above each row.
TileRectangle largestRectangle(TileGrid& grid, int part) {
  TileRectangle best{part, 0, 0, 0, 0};
  std::vector<int> heights(static_cast<std::size_t>(grid.columns) + 1, 0);
  std::vector<int> open;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      int& height = heights[static_cast<std::size_t>(column)];
      height = grid.at(column, row) == part ? height + 1 : 0;
    }
    auto const heightAt = [&](int column) { return heights[static_cast<std::size_t>(column)]; };
    open.clear();
    for (int column = 0; column <= grid.columns; ++column) {
      while (!open.empty() && heightAt(open.back()) >= heightAt(column)) {
        int const height = heightAt(open.back());
        open.pop_back();
        TileRectangle const found{part, open.empty() ? 0 : open.back() + 1, row + 1 - height,
                                  column, row + 1};
        if (found.area() > best.area()) best = found;
      }
      open.push_back(column);
    }
  }
  return best;
}

// Rectangles that together hold every tile once: large ones first, then what is left row by row.
std::vector<TileRectangle> rectanglesOf(TileGrid grid) {
  std::vector<TileRectangle> list;
  for (int part = 0; part < static_cast<int>(kBodyParts); ++part)
    for (;;) {
      TileRectangle const r = largestRectangle(grid, part);
      if (r.area() < kLargeRectangle || r.y1 - r.y0 < 2) break;
      for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) grid.at(x, y) = -1;
      list.push_back(r);
    }
  for (int y = 0; y < grid.rows; ++y)
    for (int x = 0; x < grid.columns;) {
      int const part = grid.at(x, y), from = x;
      while (x < grid.columns && grid.at(x, y) == part) ++x;
      if (part >= 0) list.push_back({part, from, y, x, y + 1});
    }
  return list;
}

}  // namespace

BodyTiles bodyTiles(const Projection& picture, const PixelBounds& bounds,
                    const glm::dmat3& scaledFromCamera, const glm::dvec3& up, const glm::dvec3& sun,
                    double radius, double height, double reach, double nightSine,
                    CoarseTiles coarse) {
  BodyTiles tiles;
  int const size = std::max(kLeastPixels, std::max(picture.width, picture.height) / kTilesAcross);
  double const ground = angularRadiusFrom(radius, height, 0.0);
  double const air = angularRadiusFrom(radius, height, reach);
  double const pixel = 1.5 * picture.pixelAngle().si;
  auto const off = [&](double x, double y) -> std::optional<glm::dvec3> {
    auto const direction = picture.directionAt(x, y);
    if (!direction) return std::nullopt;
    return scaledFromCamera * direction->u;
  };
  // Sines of the Sun's height at both ends of a ray through the air to the ground, and of the eye's
  // at the ground; -1 where it does not meet any. The Sun's at the upper end is taken as if at the
  // ground, which is higher.
  struct Lighting {
    double ground, start, eye;
  };
  auto const lightingOf = [&](const glm::dvec3& scaled) -> Lighting {
    glm::dvec3 const direction = glm::normalize(scaled);
    glm::dvec3 const camera = up * (radius + height);
    double const rise = glm::dot(camera, direction);
    double const square = height * (2.0 * radius + height);
    double const root = rise * rise - square;
    if (rise >= 0.0 || root <= 0.0) return {-1.0, -1.0, -1.0};
    double const distance = square / (std::sqrt(root) - rise);
    double const outside = (height - reach) * (2.0 * radius + height + reach);
    double const toTop = outside > 0.0 ? outside / (std::sqrt(rise * rise - outside) - rise) : 0.0;
    return {glm::dot(camera + direction * distance, sun) / radius,
            glm::dot(camera + direction * toTop, sun) / (radius + reach), std::sqrt(root) / radius};
  };
  struct Corner {
    std::optional<glm::dvec3> direction;
    Lighting light;
  };
  TileGrid grid;
  grid.columns = (bounds.x1 - bounds.x0 + size - 1) / size;
  grid.rows = (bounds.y1 - bounds.y0 + size - 1) / size;
  std::vector<Corner> corners;
  for (int row = 0; row <= grid.rows; ++row)
    for (int column = 0; column <= grid.columns; ++column) {
      auto const direction = off(std::min(bounds.x0 + column * size, bounds.x1),
                                 std::min(bounds.y0 + row * size, bounds.y1));
      corners.push_back(
          {direction, direction ? lightingOf(*direction) : Lighting{-1.0, -1.0, -1.0}});
    }
  auto const coarsely = [&](bool smooth, BodyPart fine, BodyPart whole) {
    return coarse.scale > 1 && reach > 0.0 && smooth ? whole : fine;
  };
  auto const partOf = [&](int column, int row) -> std::optional<BodyPart> {
    int const x = bounds.x0 + column * size, y = bounds.y0 + row * size;
    std::optional<glm::dvec3> const middle =
        off(0.5 * (x + std::min(x + size, bounds.x1)), 0.5 * (y + std::min(y + size, bounds.y1)));
    double spread = 0.0, lowest = 1.0, highest = -1.0, highestStart = -1.0, lowestStart = 1.0;
    double lowestEye = 1.0, highestEye = -1.0;
    for (auto const& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      Corner const& corner =
          corners[static_cast<std::size_t>((row + dy) * (grid.columns + 1) + column + dx)];
      // On the edge of a fisheye's mask.
      if (!corner.direction || !middle) return BodyPart::Both;
      spread = std::max(spread, angleBetween(*middle, *corner.direction));
      lowest = std::min(lowest, corner.light.ground);
      highest = std::max(highest, corner.light.ground);
      lowestStart = std::min(lowestStart, corner.light.start);
      highestStart = std::max(highestStart, corner.light.start);
      lowestEye = std::min(lowestEye, corner.light.eye);
      highestEye = std::max(highestEye, corner.light.eye);
    }
    spread = kBulge * spread + pixel;
    // With the samples around, whose light is mixed in.
    double const wide = spread + coarse.scale * pixel;
    double const away = angleBetween(*middle, -up);
    if (away - spread > air) return std::nullopt;
    // Beyond the corners' extremes by half of their spread: they hold them but for curvature.
    if (away + spread < ground) {
      double const margin = 0.5 * (highest - lowest);
      double const eyeMargin = 0.5 * (highestEye - lowestEye);
      if (glsl::fewSamplesShare(lowest - margin, lowestEye - eyeMargin) == 1.0)
        return coarsely(away + wide < ground, BodyPart::Sunlit, BodyPart::CoarseSunlit);
      bool const dark = highest + margin < nightSine &&
                        highestStart + 0.5 * (highestStart - lowestStart) < nightSine;
      if (dark) return BodyPart::Night;
      return glsl::fewSamplesShare(highest + margin, highestEye + eyeMargin) == 0.0
                 ? coarsely(away + wide < ground && lowest - margin > 0.0, BodyPart::Dusk,
                            BodyPart::CoarseDusk)
                 : BodyPart::Both;
    }
    if (away - spread > ground) {
      if (reach <= 0.0) return std::nullopt;
      bool const smooth =
          coarse.air && away - wide > ground && angleBetween(*middle, sun) - wide > kAureole;
      return coarsely(smooth, BodyPart::Air, BodyPart::CoarseAir);
    }
    return BodyPart::Both;
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      auto const part = partOf(column, row);
      grid.parts.push_back(part ? static_cast<int>(*part) : -1);
    }
  for (auto const& r : rectanglesOf(grid))
    addRectangle(tiles[static_cast<std::size_t>(r.part)], bounds.x0 + r.x0 * size,
                 bounds.y0 + r.y0 * size, std::min(bounds.x0 + r.x1 * size, bounds.x1),
                 std::min(bounds.y0 + r.y1 * size, bounds.y1));
  return tiles;
}

}  // namespace antumbra
