#include "passes/sun_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "document/input_error.h"
#include "eclipse/limb_darkening.h"
#include "gl/program.h"
#include "gl/view_block.h"

namespace antumbra {

SunPlane::SunPlane(const SunInView& sun) {
  distance_ = glm::length(sun.centre.m);
  double const sine = sun.radius.si / distance_;
  if (!(sine > 0.0 && sine < 1.0))
    throw InputError(
        fmt::format("Sun: found radius {} m at a distance of {} m; allowed: a camera outside it",
                    sun.radius.si, distance_));
  tangent_ = sine / std::sqrt(1.0 - sine * sine);
  axis_ = sun.centre.m / distance_;
  // `up` is the projected axis of rotation; any direction where that points at the camera.
  glm::dvec3 up = sun.north.u - glm::dot(sun.north.u, axis_) * axis_;
  if (!(glm::length(up) > 1e-6))
    up = glm::cross(axis_, std::fabs(axis_.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
  y_ = glm::normalize(up);
  x_ = glm::cross(axis_, y_);
  meanLuminance_ = sun.illuminanceLux / (std::numbers::pi * sine * sine);
}

Silhouette SunPlane::silhouetteOf(const SpheroidInView& body) const {
  // |t d - c|^2 = 1 in the body's metric A has a solution where (d A c)^2 > (d A d)(c A c - 1), and
  // it lies ahead where d A c > 0. In units of the equatorial radius, so that nothing overflows.
  double const a = body.equatorialRadius.si;
  double const squash = a / body.polarRadius.si;
  glm::dvec3 const c = body.centre.m / a;
  glm::dvec3 const pole = body.pole.u;
  glm::dmat3 const metric =
      glm::dmat3(1.0) + (squash * squash - 1.0) * glm::outerProduct(pole, pole);
  glm::dvec3 const toward = metric * c;
  double const outside = glm::dot(c, toward) - 1.0;
  glm::dmat3 const basis(tangent_ * x_, tangent_ * y_, axis_);
  // (d A c)^2 - (d A d)(c A c - 1) in the plane. Both terms are large where the body is far and
  // nearly cancel; the Lagrange form |A^(1/2) d|^2 - |A^(1/2) d x A^(1/2) c|^2 does not.
  glm::dmat3 const root = glm::dmat3(1.0) + (squash - 1.0) * glm::outerProduct(pole, pole);
  glm::dmat3 const d = root * basis;
  glm::dvec3 const rc = root * c;
  glm::dmat3 const moment(glm::cross(d[0], rc), glm::cross(d[1], rc), glm::cross(d[2], rc));
  Silhouette s;
  s.quadric = glm::transpose(d) * d - glm::transpose(moment) * moment;
  s.front = glm::transpose(basis) * toward;
  if (!(outside > 0.0))
    throw InputError(fmt::format("camera inside a body of radius {} m; allowed: outside", a));
  double scale = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scale = std::max(scale, std::fabs(s.quadric[i][j]));
  s.quadric /= scale;
  s.front /= glm::length(toward);
  return s;
}

std::vector<Silhouette> SunPlane::silhouettes(std::span<const SpheroidInView> bodies,
                                              double reach) const {
  std::vector<Silhouette> found;
  for (SpheroidInView const& body : bodies) {
    double const distance = glm::length(body.centre.m);
    if (distance > distance_) continue;
    double const separation =
        std::atan2(glm::length(glm::cross(body.centre.m, axis_)), glm::dot(body.centre.m, axis_));
    double const radius = std::asin(std::min(1.0, body.equatorialRadius.si / distance));
    if (separation < radius + reach * std::atan(tangent_)) found.push_back(silhouetteOf(body));
  }
  return found;
}

void setSunPlane(const gl::Program& program, ProjectionKind kind, const SunPlane& plane,
                 const glsl::LimbDarkening& law, std::span<const Silhouette> silhouettes) {
  if (silhouettes.size() > kMaxSilhouettes)
    throw std::runtime_error(fmt::format("{} bodies before the Sun; the shader holds {}",
                                         silhouettes.size(), kMaxSilhouettes));
  program.set("sunPrepared", gl::prepareDirection(kind, plane.centre()))
      .set("sunAxis", glm::vec3(plane.centre().u))
      .set("sunAcross", glm::vec3(plane.across().u / plane.tangent()))
      .set("sunUp", glm::vec3(plane.up().u / plane.tangent()))
      .set("sunTangent", static_cast<float>(plane.tangent()))
      .set("sunMeanLuminance", glm::vec3(plane.meanLuminance()))
      .set("silhouetteCount", static_cast<int>(silhouettes.size()));
  std::array<float, 52> const packed = packedForShader(law);
  glm::vec4 rows[13];
  for (std::size_t i = 0; i < 13; ++i)
    rows[i] = {packed[4 * i], packed[4 * i + 1], packed[4 * i + 2], packed[4 * i + 3]};
  program.setArray("sunLimbDarkening", rows, 13);
  if (silhouettes.empty()) return;
  std::vector<glm::vec4> conics;
  for (Silhouette const& s : silhouettes) {
    glm::dmat3 const& q = s.quadric;
    conics.emplace_back(q[0][0], q[0][1], q[1][1], s.front.x);
    conics.emplace_back(q[0][2], q[1][2], q[2][2], s.front.y);
    conics.emplace_back(s.front.z, 0.0, 0.0, 0.0);
  }
  program.setArray("silhouettes", conics.data(), static_cast<int>(conics.size()));
}

}  // namespace antumbra
