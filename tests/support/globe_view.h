// A camera above the Earth and where it sees places, written out in doubles on GeographicLib alone:
// the independent projection that drawn lines are held against. The camera looks straight down with
// north up, or over the ground at an azimuth and altitude.
#pragma once

#include <GeographicLib/Geocentric.hpp>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace antumbra::testsupport {

struct GlobeView {
  double latitude, longitude, height;      // degrees, m
  double azimuth = 0.0, altitude = -90.0;  // of the axis, degrees; north or zenith up
  int width = 640, pixelsHigh = 480;
  double fieldDegrees = 60.0;

  static glm::dvec3 itrs(double lat, double lon, double h) {
    double x = 0, y = 0, z = 0;
    GeographicLib::Geocentric::WGS84().Forward(lat, lon, h, x, y, z);
    return {x, y, z};
  }
  glm::dvec3 camera() const { return itrs(latitude, longitude, height); }

  // Components of a displacement to the right, up, and forward.
  glm::dvec3 components(glm::dvec3 d) const {
    double const rad = 3.14159265358979323846 / 180.0;
    double const lat = latitude * rad, lon = longitude * rad;
    glm::dvec3 const east(-std::sin(lon), std::cos(lon), 0.0);
    glm::dvec3 const north(-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon),
                           std::cos(lat));
    glm::dvec3 const zenith(std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon),
                            std::sin(lat));
    double const a = azimuth * rad, h = altitude * rad;
    glm::dvec3 const level = std::sin(a) * east + std::cos(a) * north;
    glm::dvec3 const forward = std::cos(h) * level + std::sin(h) * zenith;
    glm::dvec3 const up = -std::sin(h) * level + std::cos(h) * zenith;
    return {glm::dot(d, glm::cross(forward, up)), glm::dot(d, up), glm::dot(d, forward)};
  }

  // In front of the ground, by the distance along the sight line to the ellipsoid.
  bool visible(double lat, double lon) const {
    double const a = 6378137.0, c = a * (1.0 - 1.0 / 298.257223563);
    glm::dvec3 const shape(1.0 / a, 1.0 / a, 1.0 / c);
    glm::dvec3 const o = camera() * shape, d = (itrs(lat, lon, 0.0) - camera()) * shape;
    double const half = glm::dot(o, d), square = glm::dot(d, d);
    double const root = half * half - square * (glm::dot(o, o) - 1.0);
    return root >= 0.0 && (-half - std::sqrt(std::max(root, 0.0))) / square > 1.0 - 1e-7;
  }

  // Gnomonic, in pixels from the upper left corner; nothing behind the camera.
  std::optional<glm::dvec2> pixel(double lat, double lon) const {
    glm::dvec3 const v = components(itrs(lat, lon, 0.0) - camera());
    if (v.z <= 0.0) return std::nullopt;
    double const scale =
        0.5 * width / std::tan(0.5 * fieldDegrees * 3.14159265358979323846 / 180.0);
    return glm::dvec2(0.5 * width + scale * v.x / v.z, 0.5 * pixelsHigh - scale * v.y / v.z);
  }
};

inline double distanceTo(const std::vector<std::vector<glm::dvec2>>& paths, glm::dvec2 p) {
  double least = 1e9;
  for (auto const& path : paths)
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      glm::dvec2 const a = path[i], along = path[i + 1] - a;
      double const square = glm::dot(along, along);
      double const t =
          square > 0.0 ? std::min(std::max(glm::dot(p - a, along) / square, 0.0), 1.0) : 0.0;
      least = std::min(least, glm::length(p - a - t * along));
    }
  return least;
}

}  // namespace antumbra::testsupport
