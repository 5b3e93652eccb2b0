// The Sun as the passes see it: a plane that touches the sky at the Sun's centre, with the tangent
// of the Sun's angular radius as unit. The solar disc is its unit circle, exactly; the outline of
// any spheroid is a conic, exactly. All differences of nearly equal directions are taken here, in
// double precision, so that shaders evaluate polynomials of order one: an outline is accurate to
// 1e-6 solar radii (0.001 arcsec) in floats, at any field of view.
//
// To be honest: outlines are straight sight lines. Where air bends them, the caller gives apparent
// directions, and a limb within a degree of the horizon is off by the change of refraction.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "eclipse/limb_darkening.h"
#include "quantity/quantity.h"
#include "quantity/vector.h"
#include "shared/as_cpp.h"
#include "view/projection.h"

namespace antumbra {

// The Sun from the camera: apparent place (light time and aberration), camera axes.
struct SunInView {
  Displacement<CameraAxes> centre;
  Length radius{695700e3};
  Direction<CameraAxes> north;     // the Sun's axis of rotation; orients the corona
  glm::dvec3 illuminanceLux{0.0};  // linear sRGB, at the camera, without air
  // Limb darkening at the effective wavelengths of the channels (kSolarChannels): red, green, blue
  // and luminance.
  glsl::LimbDarkening law;
};

// Effective wavelengths of limb darkening in linear sRGB's channels and in luminance: with them one
// power of mu follows the law, integrated over E490 sunlight and the CIE 1931 observer, within 0.3
// % for mu above 0.02 (tests/passes/sun_gl_test.cpp repeats the integral).
inline constexpr std::array<Length, 4> kSolarChannels{638.0 * nanometre, 544.0 * nanometre,
                                                      440.0 * nanometre, kSolarLuminanceWavelength};

// An opaque body from the camera: a sphere or an oblate spheroid.
struct SpheroidInView {
  Displacement<CameraAxes> centre;
  Direction<CameraAxes> pole;
  Length equatorialRadius;
  Length polarRadius;
};

// A body's outline in the Sun's plane. A point p = (x, y, 1) is hidden where p' quadric p > 0 and
// front . p > 0.
struct Silhouette {
  glm::dmat3 quadric{0.0};
  glm::dvec3 front{0.0};
};

class SunPlane {
 public:
  // Throws InputError unless the camera stands outside the Sun.
  explicit SunPlane(const SunInView& sun);

  Angle angularRadius() const { return Angle(std::atan(tangent_)); }
  double tangent() const { return tangent_; }  // of the angular radius
  Direction<CameraAxes> centre() const { return {axis_}; }
  Direction<CameraAxes> across() const { return {x_}; }  // right-handed: across, up, towards us
  Direction<CameraAxes> up() const { return {y_}; }
  // Direction of a point of the plane, not normalised.
  glm::dvec3 directionAt(glm::dvec2 p) const { return axis_ + tangent_ * (p.x * x_ + p.y * y_); }
  // Mean luminance of the disc, cd/m2 in linear sRGB: illuminance / (pi sin^2 of the radius).
  glm::dvec3 meanLuminance() const { return meanLuminance_; }

  Silhouette silhouetteOf(const SpheroidInView& body) const;
  // Outlines of the bodies that are nearer than the Sun and may cover a part of its disc, swollen
  // to `reach` solar radii. Throws InputError if the camera is inside one of them.
  std::vector<Silhouette> silhouettes(std::span<const SpheroidInView> bodies,
                                      double reach = 1.0) const;

 private:
  glm::dvec3 axis_, x_, y_;
  double tangent_ = 0.0;
  double distance_ = 0.0;
  glm::dvec3 meanLuminance_;
};

// What the shaders hold of it (shaders/passes/sun_plane.glsl).
inline constexpr int kMaxSilhouettes = 12;

}  // namespace antumbra

namespace antumbra::gl {
class Program;
}
namespace antumbra {
// Sets the uniforms of sun_plane.glsl in a program of the given projection. Throws
// std::runtime_error for more than kMaxSilhouettes.
void setSunPlane(const gl::Program& program, ProjectionKind kind, const SunPlane& plane,
                 const glsl::LimbDarkening& law, std::span<const Silhouette> silhouettes);
}  // namespace antumbra
