#include "plan/surface_lines.h"

#include <algorithm>
#include <cmath>

namespace antumbra {
namespace {

// No chord of a shown line spans more than this share of its distance from the camera.
constexpr double kLargestSpan = 0.1;
constexpr double kStrayPixels = 0.1;
constexpr double kEndPixels = 0.02;
constexpr int kDeepest = 40;

glm::dmat3 scaling(double x, double y, double z) {
  return glm::dmat3(x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z);
}

// By Barry & Goldman's pyramid, with knots at the square roots of the chords (no loops, no cusps).
glm::dvec3 cubicThrough(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2,
                        const glm::dvec3& p3, double share) {
  auto const knot = [](double t, const glm::dvec3& a, const glm::dvec3& b) {
    return t + std::max(std::sqrt(glm::length(b - a)), 1e-9);
  };
  double const t0 = 0.0, t1 = knot(t0, p0, p1), t2 = knot(t1, p1, p2), t3 = knot(t2, p2, p3);
  double const t = t1 + share * (t2 - t1);
  auto const mix = [t](const glm::dvec3& a, double ta, const glm::dvec3& b, double tb) {
    return (a * (tb - t) + b * (t - ta)) / (tb - ta);
  };
  auto const a1 = mix(p0, t0, p1, t1), a2 = mix(p1, t1, p2, t2), a3 = mix(p2, t2, p3, t3);
  auto const b1 = mix(a1, t0, a2, t2), b2 = mix(a2, t1, a3, t3);
  return mix(b1, t1, b2, t2);
}

double distanceFromChord(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  glm::dvec2 const along = b - a;
  double const square = glm::dot(along, along);
  double const t = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + t * along));
}

}  // namespace

glm::dvec3 SurfaceCurve::at(double place) const {
  auto const last = static_cast<double>(points.size() - 1);
  auto const i = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last - 1.0));
  double const share = place - static_cast<double>(i);
  auto const &a = points[i], &b = points[i + 1];
  if (!smooth) return glm::normalize(a + share * (b - a));
  glm::dvec3 const before = i > 0 ? points[i - 1] : 2.0 * a - b;
  glm::dvec3 const after = i + 2 < points.size() ? points[i + 2] : 2.0 * b - a;
  return glm::normalize(cubicThrough(before, a, b, after, share));
}

SurfaceLines::SurfaceLines(const Projection& picture, const PlannedBody& body,
                           const std::vector<PlannedBody>& bodies)
    : picture_(picture), radius_(body.equatorialRadius.si) {
  flat_ = body.polarRadius / body.equatorialRadius;
  auto const& turn = body.bodyFromCamera.matrix;
  cameraFromUnit_ = glm::transpose(turn) * scaling(radius_, radius_, radius_ * flat_);
  camera_ =
      scaling(1.0 / radius_, 1.0 / radius_, 1.0 / (radius_ * flat_)) * (turn * -body.centre.m);
  // Below the spheroid a picture is drawn from its surface.
  double const least = 1.0 + 0.01 / radius_;
  if (glm::length(camera_) < least) camera_ *= least / glm::length(camera_);
  for (auto const& other : bodies) {
    if (other.name == body.name) continue;
    double const a = other.equatorialRadius.si, c = other.polarRadius.si;
    glm::dmat3 const unit = scaling(1.0 / a, 1.0 / a, 1.0 / c) * other.bodyFromCamera.matrix;
    occluders_.push_back({unit, unit * -other.centre.m});
  }
}

glm::dvec3 SurfaceLines::unitOf(const Site& site) const {
  // The surface's normal is n scaled by the inverse of the spheroid's axes, once more than the
  // point is.
  double const latitude = site.latitude.si, longitude = site.longitude.si;
  glm::dvec3 const normal(std::cos(latitude) * std::cos(longitude),
                          std::cos(latitude) * std::sin(longitude), std::sin(latitude));
  return glm::normalize(glm::dvec3(normal.x, normal.y, normal.z * flat_));
}

SurfaceCurve SurfaceLines::curveOf(const std::vector<Site>& sites, bool smooth) const {
  SurfaceCurve curve;
  curve.smooth = smooth;
  for (auto const& site : sites) {
    glm::dvec3 const point = unitOf(site);
    // Two points of one place have no direction between them.
    if (curve.points.empty() || glm::length(point - curve.points.back()) > 1e-9)
      curve.points.push_back(point);
  }
  return curve;
}

SurfaceLines::Seen SurfaceLines::see(const glm::dvec3& unit) const {
  Seen seen;
  seen.unit = unit;
  seen.fromCamera = cameraFromUnit_ * (unit - camera_);
  seen.rise = glm::dot(unit, camera_) - 1.0;
  if (seen.rise <= 0.0) return seen;
  auto const pixel = picture_.pixelOf({glm::normalize(seen.fromCamera)});
  if (!pixel) return seen;
  seen.pixel = {pixel->x, picture_.height - pixel->y};
  double const w = picture_.width, h = picture_.height;
  if (seen.pixel.x < -0.5 * w || seen.pixel.x > 1.5 * w || seen.pixel.y < -0.5 * h ||
      seen.pixel.y > 1.5 * h)
    return seen;
  for (auto const& o : occluders_) {
    glm::dvec3 const ray = o.unitFromCamera * seen.fromCamera;
    double const square = glm::dot(ray, ray), half = glm::dot(o.camera, ray);
    double const root = half * half - square * (glm::dot(o.camera, o.camera) - 1.0);
    if (root <= 0.0) continue;
    double const first = (-half - std::sqrt(root)) / square;
    if (first > 0.0 && first < 1.0) return seen;
  }
  seen.visible = true;
  return seen;
}

std::optional<glm::dvec2> SurfaceLines::shownPoint(const glm::dvec3& unit) const {
  Seen const seen = see(unit);
  if (!seen.visible) return std::nullopt;
  return seen.pixel;
}

std::vector<std::vector<glm::dvec2>> SurfaceLines::shown(const SurfaceCurve& curve) const {
  std::vector<std::vector<glm::dvec2>> strips(1);
  if (curve.points.size() < 2) return {};
  Seen last = see(curve.points.front());
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    Seen const next = see(curve.points[i + 1]);
    trace(curve, static_cast<double>(i), last, static_cast<double>(i + 1), next, 0, strips);
    last = next;
  }
  std::erase_if(strips, [](auto const& strip) { return strip.size() < 2; });
  return strips;
}

void SurfaceLines::trace(const SurfaceCurve& curve, double from, const Seen& a, double to,
                         const Seen& b, int depth,
                         std::vector<std::vector<glm::dvec2>>& strips) const {
  auto const part = [&] {
    if (!strips.back().empty()) strips.emplace_back();
  };
  double const span = glm::length(b.fromCamera - a.fromCamera);
  // No place between the two can rise above the horizon: along an arc n . c changes by at most the
  // arc's length times |c|.
  double const arc = 0.6 * glm::length(b.unit - a.unit) * glm::length(camera_);
  if (std::max(a.rise, b.rise) + arc < 0.0) return part();

  double const middle = 0.5 * (from + to);
  Seen const m = see(curve.at(middle));
  double const near =
      std::min({glm::length(a.fromCamera), glm::length(b.fromCamera), glm::length(m.fromCamera)});
  bool const alike = a.visible == b.visible && a.visible == m.visible;
  double const width = picture_.width;
  auto const beside =
      [&](glm::dvec2 p) {  // as close to a as an equirectangular picture's turns let
        if (picture_.kind == ProjectionKind::Equirectangular)
          p.x -= width * std::round((p.x - a.pixel.x) / width);
        return p;
      };
  bool split = span > kLargestSpan * near;
  if (alike && a.visible)
    split = split || distanceFromChord(beside(m.pixel), a.pixel, beside(b.pixel)) > kStrayPixels;
  if (!alike && a.visible != b.visible)
    split = split || span > kEndPixels * picture_.pixelAngle().si * near;
  else if (!alike)
    split = true;
  if (split && depth < kDeepest) {
    trace(curve, from, a, middle, m, depth + 1, strips);
    trace(curve, middle, m, to, b, depth + 1, strips);
    return;
  }
  if (!a.visible || !b.visible) return part();
  if (strips.back().empty()) strips.back().push_back(a.pixel);
  glm::dvec2 const next = beside(b.pixel);
  // A chord of a few degrees that leaps over the picture crosses the rim behind a fisheye.
  if (picture_.kind == ProjectionKind::Fisheye && glm::length(next - a.pixel) > 0.25 * width)
    return part();
  strips.back().push_back(next);
  if (next != b.pixel) {
    part();
    strips.back() = {a.pixel + (b.pixel - next), b.pixel};
  }
}

}  // namespace antumbra
