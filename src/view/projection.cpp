#include "view/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "document/input_error.h"
#include "shared/as_cpp.h"

namespace antumbra {

void Projection::check(const std::string& where) const {
  if (width < 1 || height < 1 || width > 65536 || height > 65536)
    throw InputError(
        fmt::format("{}: found size {}x{}; allowed: 1x1 to 65536x65536", where, width, height));
  double const limit = kind == ProjectionKind::Perspective ? 179.0 : 360.0;
  double const found = field / degree;
  if (kind == ProjectionKind::Equirectangular) return;
  bool const fits = std::isfinite(found) && found > 0.0 && found <= limit;
  if (!fits)
    throw InputError(fmt::format("{}: found a field of {} deg; allowed for {}: above 0 to {} deg",
                                 where, found, nameOf(kind), limit));
}

const char* nameOf(ProjectionKind kind) {
  switch (kind) {
    case ProjectionKind::Perspective:
      return "perspective";
    case ProjectionKind::Fisheye:
      return "fisheye";
    case ProjectionKind::Equirectangular:
      return "equirectangular";
  }
  return "?";
}

glm::dvec2 Projection::extent() const {
  if (kind == ProjectionKind::Fisheye) return {field.si / 2.0, field.si / 2.0};
  if (kind == ProjectionKind::Equirectangular) return {1.0, 1.0};
  double const x = std::tan(field.si / 2.0);
  return {x, x * height / width};
}

Angle Projection::pixelAngle() const {
  switch (kind) {
    case ProjectionKind::Perspective:
      return Angle(2.0 * extent().x / width);
    case ProjectionKind::Fisheye:
      return Angle(field.si / width);
    case ProjectionKind::Equirectangular:
      return Angle(2.0 * std::numbers::pi / width);
  }
  return {};
}

std::optional<Direction<CameraAxes>> Projection::directionAt(double px, double py) const {
  double const x = 2.0 * px / width - 1.0;
  double const y = 2.0 * py / height - 1.0;
  glm::dvec2 const e = extent();
  glsl::ViewRay ray{};
  switch (kind) {
    case ProjectionKind::Perspective:
      ray = glsl::perspectiveRay(x, y, e.x, e.y);
      break;
    case ProjectionKind::Fisheye:
      ray = glsl::fisheyeRay(x, y, e.x);
      break;
    case ProjectionKind::Equirectangular:
      ray = glsl::equirectangularRay(x, y);
      break;
  }
  if (ray.inside == 0.0) return std::nullopt;
  return Direction<CameraAxes>{glm::normalize(ray.direction)};
}

std::optional<glm::dvec2> Projection::pixelOf(Direction<CameraAxes> d) const {
  glm::dvec2 const e = extent();
  glsl::ImagePoint p{};
  switch (kind) {
    case ProjectionKind::Perspective:
      p = glsl::perspectivePoint(d.u, e.x, e.y);
      break;
    case ProjectionKind::Fisheye:
      p = glsl::fisheyePoint(d.u, e.x);
      break;
    case ProjectionKind::Equirectangular:
      p = glsl::equirectangularPoint(d.u);
      break;
  }
  if (p.inside == 0.0) return std::nullopt;
  return glm::dvec2{(p.x + 1.0) * 0.5 * width, (p.y + 1.0) * 0.5 * height};
}

PixelBounds boundsOfCap(const Projection& projection, Direction<CameraAxes> centre, Angle radius) {
  PixelBounds const whole{0, 0, projection.width, projection.height};
  double const off = std::atan2(std::hypot(centre.u.x, centre.u.y), -centre.u.z);
  double const r = radius.si;
  // Where the rim is no closed curve in the picture (behind a perspective, around a fisheye's edge
  // point, over the date line or a pole of an equirectangular picture), take all of it.
  switch (projection.kind) {
    case ProjectionKind::Perspective:
      if (off - r > std::atan(glm::length(projection.extent()))) return {};  // beyond the corners
      if (off + r > 1.5) return whole;
      break;
    case ProjectionKind::Fisheye:
      if (off - r > projection.field.si / 2.0) return {};
      if (off + r > 3.1) return whole;
      break;
    case ProjectionKind::Equirectangular: {
      double const latitude = std::asin(std::clamp(centre.u.y, -1.0, 1.0));
      double const longitude = std::atan2(centre.u.x, -centre.u.z);
      if (std::fabs(latitude) + r > 1.5) return whole;
      double const reach = std::asin(std::min(1.0, std::sin(r) / std::cos(latitude)));
      if (std::fabs(longitude) + reach > 3.1) return whole;
      break;
    }
  }
  glm::dvec3 const axis = centre.u;
  glm::dvec3 const aside = glm::normalize(
      glm::cross(axis, std::fabs(axis.x) < 0.7 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0}));
  glm::dvec3 const along = glm::cross(axis, aside);
  glm::dvec2 low{1e30}, high{-1e30};
  Projection open = projection;  // the rim may pass a fisheye's mask
  if (open.kind == ProjectionKind::Fisheye) open.field = Angle(2.0 * std::numbers::pi);
  double const rescale =
      open.kind == ProjectionKind::Fisheye ? open.field.si / projection.field.si : 1.0;
  glm::dvec2 const middle{projection.width / 2.0, projection.height / 2.0};
  constexpr int kRim = 64;
  for (int i = 0; i < kRim; ++i) {
    double const a = 2.0 * std::numbers::pi * i / kRim;
    glm::dvec3 const d =
        std::cos(r) * axis + std::sin(r) * (std::cos(a) * aside + std::sin(a) * along);
    if (auto const pixel = open.pixelOf({d})) {
      glm::dvec2 const p = middle + (*pixel - middle) * rescale;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  // A polygon of 64 corners lies inside its curve by at most 1 - cos(pi/64) of its radius.
  glm::dvec2 const margin = 0.002 * (high - low) + 2.0;
  PixelBounds bounds;
  bounds.x0 = static_cast<int>(std::floor(std::clamp(low.x - margin.x, 0.0, 1.0 * whole.x1)));
  bounds.y0 = static_cast<int>(std::floor(std::clamp(low.y - margin.y, 0.0, 1.0 * whole.y1)));
  bounds.x1 = static_cast<int>(std::ceil(std::clamp(high.x + margin.x, 0.0, 1.0 * whole.x1)));
  bounds.y1 = static_cast<int>(std::ceil(std::clamp(high.y + margin.y, 0.0, 1.0 * whole.y1)));
  return bounds;
}

}  // namespace antumbra
