// Tangent planes of cones against the support function of the ellipsoid.
#include "eclipse/ellipsoid_contact.h"

#include <cmath>

#include "quantity/constants.h"

namespace antumbra {
namespace {

constexpr double kEquatorial = kEarthEquatorialRadius.si;
constexpr double kPolar = kEarthEquatorialRadius.si * (1.0 - kEarthFlattening);

// The point of the ellipsoid that lies farthest along `normal`.
glm::dvec3 supportPoint(const glm::dvec3& normal) {
  glm::dvec3 const q(kEquatorial * kEquatorial * normal.x, kEquatorial * kEquatorial * normal.y,
                     kPolar * kPolar * normal.z);
  return q / std::sqrt(glm::dot(q, normal));
}

}  // namespace

ConeClearance coneClearance(const glsl::ShadowPair& pair, double radius, double gain) {
  double const cosine = 1.0 / std::sqrt(1.0 + gain * gain);
  double const offset = glm::length(pair.foot);
  // Towards the geocentre, then the direction of the widest gap by Newton's method; the second
  // derivative is that of a sphere, so that each step leaves a few thousandths of the error.
  glm::dvec3 outward = offset > 1.0
                           ? -pair.foot / offset
                           : glm::normalize(glm::cross(pair.axis, glm::dvec3(0.6, 0.8, 0.1)));
  glm::dvec3 normal;
  for (int i = 0; i < 4; ++i) {
    normal = (outward - gain * pair.axis) * cosine;
    glm::dvec3 const around = glm::cross(pair.axis, outward);
    double const slope = -cosine * glm::dot(around, pair.foot + supportPoint(normal));
    double const turn = offset > 1e4 ? slope / (offset * cosine) : 0.0;
    outward = glm::normalize(outward + around * turn);
  }
  normal = (outward - gain * pair.axis) * cosine;
  glm::dvec3 const touch = -supportPoint(normal);
  return {glm::dot(normal, touch - pair.foot) - radius * cosine, touch};
}

ConeClearance penumbraClearance(const glsl::ShadowPair& pair) {
  return coneClearance(pair, pair.penumbraRadius, pair.penumbraTangent);
}

ConeClearance umbraClearance(const glsl::ShadowPair& pair) {
  if (pair.umbraRadius >= 0.0) return coneClearance(pair, pair.umbraRadius, -pair.umbraTangent);
  return coneClearance(pair, -pair.umbraRadius, pair.umbraTangent);
}

ConeClearance axisClearance(const glsl::ShadowPair& pair) { return coneClearance(pair, 0.0, 0.0); }

std::optional<glm::dvec3> axisOnEllipsoid(const glsl::ShadowPair& pair) {
  glm::dvec3 const scale(1.0 / kEquatorial, 1.0 / kEquatorial, 1.0 / kPolar);
  glm::dvec3 const p = pair.foot * scale, d = pair.axis * scale;
  double const a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - 1.0;
  double const discriminant = b * b - a * c;
  if (discriminant < 0.0) return std::nullopt;
  return pair.foot + pair.axis * ((-b - std::sqrt(discriminant)) / a);
}

Site siteOf(const glm::dvec3& itrs) { return siteFromItrs(Position<Itrs>{itrs}); }

glm::dvec3 itrsMetres(const Site& site) { return itrsFromSite(site).m; }

HorizontalDirection horizontalOf(const glm::dvec3& displacement, const Site& site) {
  auto const enu = enuFromItrs(site);
  return horizontalFromEnu(enu(directionOf(Displacement<Itrs>{displacement})));
}

}  // namespace antumbra
