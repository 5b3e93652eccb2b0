#include "passes/body_tiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace antumbra {
namespace {

// Tiles across the longer side of the picture, and their least size in pixels.
constexpr int kTilesAcross = 80, kLeastPixels = 8;
// Widens a tile's cone for edges that bulge beyond its corners (fisheye, poles of a map).
constexpr double kBulge = 1.15;

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

}  // namespace

BodyTiles bodyTiles(const Projection& picture, const PixelBounds& bounds,
                    const glm::dmat3& scaledFromCamera, const glm::dvec3& up, const glm::dvec3& sun,
                    double radius, double height, double reach) {
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
  // Sine of the Sun's height where a ray meets the ground; -1 where it does not.
  auto const sunSine = [&](const glm::dvec3& scaled) {
    glm::dvec3 const direction = glm::normalize(scaled);
    double const rise = (radius + height) * glm::dot(up, direction);
    double const square = height * (2.0 * radius + height);
    double const root = rise * rise - square;
    if (rise >= 0.0 || root <= 0.0) return -1.0;
    double const distance = square / (std::sqrt(root) - rise);
    return glm::dot(up * (radius + height) + direction * distance, sun) / radius;
  };
  auto const partOf = [&](int x0, int y0, int x1, int y1) -> std::optional<BodyPart> {
    std::optional<glm::dvec3> const middle = off(0.5 * (x0 + x1), 0.5 * (y0 + y1));
    double spread = 0.0, lowest = 1.0, highest = -1.0;
    for (auto const& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) {
      auto const corner = off(x, y);
      // On the edge of a fisheye's mask.
      if (!corner || !middle) return BodyPart::Both;
      spread = std::max(spread, angleBetween(*middle, *corner));
      if (reach > 0.0) {
        double const sine = sunSine(*corner);
        lowest = std::min(lowest, sine);
        highest = std::max(highest, sine);
      }
    }
    spread = kBulge * spread + pixel;
    double const away = angleBetween(*middle, -up);
    if (away - spread > air) return std::nullopt;
    // Below the lowest corner by half of their spread: the corners hold the extremes but for
    // curvature.
    if (away + spread < ground)
      return reach > 0.0 && lowest - 0.5 * (highest - lowest) < kSunlitSine ? BodyPart::Both
                                                                            : BodyPart::Ground;
    if (away - spread > ground) return reach > 0.0 ? std::optional(BodyPart::Air) : std::nullopt;
    return BodyPart::Both;
  };
  for (int y = bounds.y0; y < bounds.y1; y += size) {
    int const y1 = std::min(y + size, bounds.y1);
    std::optional<BodyPart> run;
    int from = bounds.x0;
    for (int x = bounds.x0; x < bounds.x1; x += size) {
      auto const part = partOf(x, y, std::min(x + size, bounds.x1), y1);
      if (part == run) continue;
      if (run) addRectangle(tiles[static_cast<std::size_t>(*run)], from, y, x, y1);
      run = part;
      from = x;
    }
    if (run) addRectangle(tiles[static_cast<std::size_t>(*run)], from, y, bounds.x1, y1);
  }
  return tiles;
}

}  // namespace antumbra
