#include "atmosphere/single_scattering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "atmosphere/hemisphere_nodes.h"
#include "shared/as_cpp.h"

namespace antumbra {
namespace {

constexpr double kTolerance = 1e-5;
constexpr int kDeepest = 14;
// Gauss-Legendre with eight nodes (Abramowitz & Stegun 1972, table 25.4).
constexpr std::array<double, 4> kNode{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                      0.9602898564975363};
constexpr std::array<double, 4> kWeight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                        0.1012285362903763};

using Function = std::function<double(double)>;

double panel(const Function& f, double a, double b) {
  double const middle = (a + b) / 2.0, half = (b - a) / 2.0;
  double sum = 0.0;
  for (size_t i = 0; i < 4; ++i)
    sum += kWeight[i] * (f(middle - half * kNode[i]) + f(middle + half * kNode[i]));
  return sum * half;
}

double refine(const Function& f, double a, double b, double whole, double allowed, int depth) {
  double const middle = (a + b) / 2.0, left = panel(f, a, middle), right = panel(f, middle, b);
  if (depth >= kDeepest || std::abs(left + right - whole) <= allowed) return left + right;
  return refine(f, a, middle, left, allowed / 2.0, depth + 1) +
         refine(f, middle, b, right, allowed / 2.0, depth + 1);
}

// Where a ray crosses the edge of the shadow that a sphere casts along parallel rays.
void addShadowCylinder(std::vector<double>& cuts, const glm::dvec3& start,
                       const glm::dvec3& direction, const glm::dvec3& toSun, double radius) {
  glm::dvec3 const p = start - glm::dot(start, toSun) * toSun;
  glm::dvec3 const d = direction - glm::dot(direction, toSun) * toSun;
  double const a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - radius * radius;
  double const discriminant = b * b - a * c;
  if (!(discriminant > 0.0) || !(a > 0.0)) return;
  cuts.push_back((-b - std::sqrt(discriminant)) / a);
  cuts.push_back((-b + std::sqrt(discriminant)) / a);
}

}  // namespace

double transmittance(const Medium& medium, Position<AirFrame> point, Direction<AirFrame> direction,
                     Length wavelength) {
  SpectralMedium const air(medium, wavelength, Length(glm::length(point.m)));
  AirRay const ray(point.m, direction.u);
  SpectralMedium::Span span;
  if (!air.spanOf(ray, span)) return 1.0;
  if (span.hitsGround) return 0.0;
  return std::exp(-air.depthByQuadrature(ray, span.enter, span.leave));
}

SingleScattering::SingleScattering(const Medium& medium, const Sunlight& sun, Length wavelength,
                                   Length groundRadius)
    : air_(medium, wavelength, groundRadius),
      rays_(sunRays(sun, wavelength, 4, 8)),
      shadow_(sun, wavelength) {
  air_.bendSunlight();
}

double SingleScattering::radiance(Position<AirFrame> camera, Direction<AirFrame> direction) const {
  AirRay const ray(camera.m, direction.u);
  SpectralMedium::Span span;
  if (!air_.spanOf(ray, span)) return 0.0;
  auto const share = [&](const glm::dvec3& x) {
    return shadow_.empty() ? 1.0 : shadow_.visibleShare(x);
  };

  std::vector<double> common{span.enter, span.leave, -ray.along};
  for (double h : air_.breakHeights()) {
    double first, second;
    if (!ray.crossings(air_.ground() + h, first, second)) continue;
    common.push_back(first);
    common.push_back(second);
  }
  for (auto const& pair : shadow_.pairs())
    for (auto const& cone : {glsl::crossUmbra(pair, camera.m, direction.u),
                             glsl::crossPenumbra(pair, camera.m, direction.u)})
      if (cone.count == 2) {
        common.push_back(cone.first);
        common.push_back(cone.second);
      }

  double sum = 0.0;
  std::vector<double> phases(air_.constituents()), each(air_.constituents());
  for (SunRay const& sunRay : rays_) {
    double const cosine = glm::dot(direction.u, sunRay.toSun);
    for (size_t c = 0; c < phases.size(); ++c) phases[c] = air_.phase(c).at(cosine);
    Function const source = [&](double s) {
      double const radius = ray.radiusAt(s);
      glm::dvec3 const x = camera.m + s * direction.u;
      double const toSun = air_.depthToSun(x, radius, sunRay.toSun);
      if (std::isinf(toSun)) return 0.0;
      air_.scattering(ray.heightAt(s, air_.ground()), each.data());
      double scattered = 0.0;
      for (size_t c = 0; c < phases.size(); ++c) scattered += each[c] * phases[c];
      return scattered * std::exp(-toSun - air_.depthBetween(ray, span.enter, s)) * share(x);
    };
    std::vector<double> cuts = common;
    addShadowCylinder(cuts, camera.m, direction.u, sunRay.toSun, air_.ground());
    std::sort(cuts.begin(), cuts.end());
    std::vector<std::array<double, 3>> pieces;  // from, to, first estimate
    double estimate = 0.0;
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
      double const a = std::max(cuts[i], span.enter), b = std::min(cuts[i + 1], span.leave);
      if (!(a < b)) continue;
      pieces.push_back({a, b, panel(source, a, b)});
      estimate += pieces.back()[2];
    }
    double light = 0.0;
    double const allowed =
        kTolerance * estimate / static_cast<double>(std::max<size_t>(1, pieces.size()));
    for (auto const& piece : pieces)
      light += refine(source, piece[0], piece[1], piece[2], allowed, 0);
    sum += sunRay.weight * light;
  }
  if (span.hitsGround) {
    glm::dvec3 const normal = glm::normalize(camera.m + span.leave * direction.u);
    glm::dvec3 const x = air_.ground() * normal;
    double lit = 0.0;
    for (SunRay const& sunRay : rays_) {
      double const cosine = glm::dot(normal, air_.apparentSun(x, air_.ground(), sunRay.toSun));
      if (cosine > 0.0)
        lit += sunRay.weight * cosine * std::exp(-air_.depthToSun(x, air_.ground(), sunRay.toSun));
    }
    sum += air_.groundAlbedo() / std::numbers::pi * lit * share(x) *
           std::exp(-air_.depthBetween(ray, span.enter, span.leave));
  }
  return sum;
}

double SingleScattering::directIrradiance(Position<AirFrame> point,
                                          Direction<AirFrame> normal) const {
  double sum = 0.0;
  double const radius = std::max(glm::length(point.m), air_.ground());
  for (SunRay const& ray : rays_) {
    double const cosine = glm::dot(normal.u, air_.apparentSun(point.m, radius, ray.toSun));
    if (cosine > 0.0)
      sum += ray.weight * cosine * std::exp(-air_.depthToSun(point.m, radius, ray.toSun));
  }
  return sum * (shadow_.empty() ? 1.0 : shadow_.visibleShare(point.m));
}

double SingleScattering::diffuseIrradiance(Position<AirFrame> point,
                                           Direction<AirFrame> normal) const {
  glm::dvec3 const z = normal.u;
  glm::dvec3 sun(0.0);
  for (auto const& ray : rays_) sun += ray.weight * ray.toSun;
  glm::dvec3 const sunward = sun - glm::dot(sun, z) * z;
  double const level = glm::length(sunward);
  glm::dvec3 const other = std::abs(z.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  glm::dvec3 const x = glm::normalize(level > 1e-6 ? sunward : glm::cross(z, other));
  glm::dmat3 const fromPlane(x, glm::cross(z, x), z);
  double sum = 0.0;
  for (auto const& node : hemisphereNodes(arcTangent(level, glm::dot(sun, z))))
    sum += node.weight * radiance(point, {fromPlane * node.direction.u});
  return sum;
}

}  // namespace antumbra
