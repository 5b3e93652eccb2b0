#include "eclipse/azimuthal_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra {

AzimuthalMap::AzimuthalMap(const Site& centre, Angle reach, glm::dvec2 pixelCentre, double radius)
    : centre_(centre),
      pixelCentre_(pixelCentre),
      radius_(radius),
      scale_(radius / (2.0 * std::sin(0.5 * (reach / radian)))) {}

AzimuthalMap::Polar AzimuthalMap::polar(double latitudeDegrees, double longitudeDegrees) const {
  double const y = latitudeDegrees * M_PI / 180.0, y0 = centre_.latitude / radian;
  double const x = longitudeDegrees * M_PI / 180.0 - centre_.longitude / radian;
  double const east = std::cos(y) * std::sin(x);
  double const north = std::cos(y0) * std::sin(y) - std::sin(y0) * std::cos(y) * std::cos(x);
  double const up = std::sin(y0) * std::sin(y) + std::cos(y0) * std::cos(y) * std::cos(x);
  double const away = std::atan2(std::hypot(east, north), up);
  return {scale_ * 2.0 * std::sin(0.5 * away), std::atan2(east, north)};
}

glm::dvec2 AzimuthalMap::pixel(const Polar& p) const {
  return pixelCentre_ + p.radius * glm::dvec2(std::sin(p.bearing), -std::cos(p.bearing));
}
glm::dvec2 AzimuthalMap::pixel(const Site& s) const {
  return pixel(polar(s.latitude / degree, s.longitude / degree));
}
bool AzimuthalMap::shows(const Site& s) const {
  return polar(s.latitude / degree, s.longitude / degree).radius < radius_;
}

std::vector<glm::dvec2> AzimuthalMap::circle(double radius) const {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 180; ++i) points.push_back(pixel({radius, M_PI * i / 90.0}));
  return points;
}

namespace {

using Ring = std::vector<glm::dvec2>;  // longitude, latitude in degrees

std::vector<Ring> landRings() {
  std::filesystem::path const file = catalogsFolder() / "eclipse" / "coastline.txt";
  std::ifstream in(file);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file.string()));
  std::vector<Ring> rings;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream numbers(line);
    Ring ring;
    for (double x = 0.0, y = 0.0; numbers >> x >> y;) ring.emplace_back(x / 100.0, y / 100.0);
    if (ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

// Longitudes made continuous, so that a ring may cross the antimeridian; one that goes round a pole
// is closed along it.
Ring unwrapped(const Ring& ring) {
  Ring out{ring.front()};
  for (std::size_t i = 1; i <= ring.size(); ++i) {
    glm::dvec2 const next = ring[i % ring.size()];
    out.emplace_back(out.back().x + std::remainder(next.x - out.back().x, 360.0), next.y);
  }
  if (std::fabs(out.back().x - out.front().x) > 180.0) {
    double const pole = ring.front().y < 0.0 ? -90.0 : 90.0;
    out.emplace_back(out.back().x, pole);
    out.emplace_back(out.front().x, pole);
  }
  return out;
}

bool holds(const Ring& ring, glm::dvec2 point) {
  Ring const closed = unwrapped(ring);
  bool inside = false;
  for (double const turn : {-720.0, -360.0, 0.0, 360.0, 720.0}) {
    double const x = point.x + turn;
    for (std::size_t i = 0, j = closed.size() - 1; i < closed.size(); j = i++) {
      auto const &a = closed[i], &b = closed[j];
      if ((a.y > point.y) != (b.y > point.y) &&
          x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
        inside = !inside;
    }
  }
  return inside;
}

// Edges are cut to pieces of a degree. Beyond the map's edge points are drawn in to a circle
// outside it, along which the outline then runs, so that nothing crosses the map near the antipode.
std::vector<glm::dvec2> landOutline(const AzimuthalMap& map, const Ring& ring, bool& visible) {
  double const outside = 1.1 * map.radius();
  std::vector<glm::dvec2> points;
  AzimuthalMap::Polar last;
  bool first = true;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    auto const a = ring[i];
    auto b = ring[(i + 1) % ring.size()];
    b.x = a.x + std::remainder(b.x - a.x, 360.0);
    int const pieces = 1 + static_cast<int>(std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y)));
    for (int k = 0; k < pieces; ++k) {
      glm::dvec2 const p = a + (b - a) * (static_cast<double>(k) / pieces);
      AzimuthalMap::Polar at = map.polar(p.y, p.x);
      visible = visible || at.radius < map.radius();
      at.radius = std::min(at.radius, outside);
      if (!first && last.radius == outside && at.radius == outside) {
        double const turn = std::remainder(at.bearing - last.bearing, 2.0 * M_PI);
        int const steps = static_cast<int>(std::fabs(turn) / 0.1);
        for (int s = 1; s <= steps; ++s)
          points.push_back(map.pixel({outside, last.bearing + turn * s / (steps + 1.0)}));
        if (std::fabs(turn) < 0.02) continue;
      }
      points.push_back(map.pixel(at));
      last = at;
      first = false;
    }
  }
  return points;
}

}  // namespace

void addLand(Drawing& drawing, const AzimuthalMap& map) {
  Site const& centre = map.centre();
  DrawnShape land;
  land.fill = Ink{{238, 232, 214}, 1.0};
  DrawnShape coast;
  coast.line = Ink{{120, 118, 108}, 1.0};
  coast.lineWidth = 0.7;
  glm::dvec2 antipode(centre.longitude / degree + 180.0, -(centre.latitude / degree));
  if (antipode.x > 180.0) antipode.x -= 360.0;
  bool inverted = false;
  for (auto const& ring : landRings()) {
    bool visible = false;
    auto outline = landOutline(map, ring, visible);
    bool const around = holds(ring, antipode);
    if (around) inverted = !inverted;
    if (visible || around) land.paths.push_back(std::move(outline));
    if (!visible) continue;
    std::vector<glm::dvec2> piece;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      auto const a = ring[i % ring.size()], before = ring[(i + ring.size() - 1) % ring.size()];
      // The cuts along the antimeridian and at the pole are no coast.
      bool const cut = (std::fabs(a.x) > 179.98 && std::fabs(before.x) > 179.98) ||
                       (a.y < -89.9 && before.y < -89.9);
      bool const shown = map.polar(a.y, a.x).radius < 1.05 * map.radius();
      if (cut || !shown) {
        if (piece.size() > 1) coast.paths.push_back(piece);
        piece.clear();
      }
      if (shown) piece.push_back(map.pixel(map.polar(a.y, a.x)));
    }
    if (piece.size() > 1) coast.paths.push_back(piece);
  }
  if (inverted) land.paths.push_back(map.circle(1.2 * map.radius()));
  drawing.shapes.push_back(std::move(land));
  drawing.shapes.push_back(std::move(coast));
}

void addGraticule(Drawing& drawing, const AzimuthalMap& map) {
  DrawnShape lines;
  lines.line = Ink{{96, 120, 140}, 0.35};
  lines.lineWidth = 0.6;
  auto const add = [&](auto&& pointAt, int steps) {
    std::vector<glm::dvec2> piece;
    for (int i = 0; i <= steps; ++i) {
      auto const [latitude, longitude] = pointAt(i);
      AzimuthalMap::Polar const p = map.polar(latitude, longitude);
      if (p.radius < 1.05 * map.radius()) {
        piece.push_back(map.pixel(p));
      } else {
        if (piece.size() > 1) lines.paths.push_back(piece);
        piece.clear();
      }
    }
    if (piece.size() > 1) lines.paths.push_back(piece);
  };
  for (int longitude = -180; longitude < 180; longitude += 15)
    add([&](int i) { return std::pair(-85.0 + 2.0 * i, static_cast<double>(longitude)); }, 85);
  for (int latitude = -75; latitude <= 75; latitude += 15)
    add([&](int i) { return std::pair(static_cast<double>(latitude), -180.0 + 2.0 * i); }, 180);
  drawing.shapes.push_back(std::move(lines));
}

void labelGraticule(DrawnLabels& labels, const AzimuthalMap& map) {
  auto const label = [&](double latitude, double longitude, std::string text) {
    auto const p = map.polar(latitude, longitude);
    if (p.radius > map.radius()) return;
    labels.place({.text = std::move(text), .size = 10.0, .ink = Ink{{96, 120, 140}, 1.0}},
                 {{map.pixel(p) + glm::dvec2(3.0, -3.0)}});
  };
  for (int longitude = -180; longitude < 180; longitude += 30)
    label(0.0, longitude,
          fmt::format("{}°{}", std::abs(longitude),
                      longitude == 0 || longitude == -180 ? "" : (longitude > 0 ? "E" : "W")));
  for (int latitude = -60; latitude <= 60; latitude += 30)
    for (int longitude : {-90, 0, 90, 180})
      if (latitude != 0)
        label(latitude, longitude,
              fmt::format("{}°{}", std::abs(latitude), latitude > 0 ? "N" : "S"));
}

}  // namespace antumbra
