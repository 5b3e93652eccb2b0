// The light that falls on an atmosphere: the Sun's direction, the size and darkening of its disc,
// and bodies that pass before it. The Sun is at infinity for the directions of its rays (its
// parallax across the Earth is 8.8"); an occulter is a sphere at its true place.
#pragma once

#include <memory>
#include <vector>

#include "eclipse/corona_light.h"
#include "eclipse/limb_darkening.h"
#include "quantity/quantity.h"
#include "quantity/vector.h"

namespace antumbra {

// Centred on the body that wears the air; the directions of the axes are the caller's choice.
// To be honest: the ground is a sphere here, which osculates the true ellipsoid below the camera.
struct AirFrame {};

// Solar angular radius at 1 au of the reference data, rad.
inline constexpr Angle kReferenceSolarRadius{0.004653};

struct Occulter {
  Position<AirFrame> centre;
  Length radius;
};

struct Sunlight {
  Direction<AirFrame> toSun{{0.0, 0.0, 1.0}};
  // Radius of the disc that rays come from; zero: a point. Occulters always see the disc of
  // `occultedRadius`, whose visible light scales a ray's.
  Angle discRadius{0.0};
  Angle occultedRadius = kReferenceSolarRadius;
  LimbDarkeningLaw law = LimbDarkeningLaw::Hestroffer;
  std::vector<Occulter> occulters;
  // What shines past the occulters besides, from the Sun's direction; none: nothing.
  std::shared_ptr<const CoronaLight> corona;
};

// The occulter of an eclipse by angles: seen from `axisPoint`, through which the shadow's axis
// passes, its radius is `ratio` times that of the Sun. Throws InputError unless ratio and radius
// are positive and the angle is below 90 degrees.
Occulter occulterByRatio(double ratio, Length radius, Position<AirFrame> axisPoint,
                         const Sunlight& sun);

// Share of the Sun's light at one wavelength that passes all occulters: what the union of their
// discs leaves (eclipse/shadow_pair.h), and the corona past the one that leaves least of it.
class SunShadow {
 public:
  SunShadow(const Sunlight& sun, Length wavelength);
  bool empty() const { return pairs_.empty(); }
  // `metres`: a point of AirFrame.
  double visibleShare(const glm::dvec3& metres) const;
  const std::vector<glsl::ShadowPair>& pairs() const { return pairs_; }

 private:
  std::vector<glsl::ShadowPair> pairs_;
  glsl::LimbDarkening law_;
  std::shared_ptr<const CoronaLight> corona_;
};

// Directions over the disc with weights that sum to 1: a quadrature of `rings` by `spokes` nodes,
// or the centre alone for a point Sun.
struct SunRay {
  glm::dvec3 toSun;
  double weight;
};
std::vector<SunRay> sunRays(const Sunlight& sun, Length wavelength, int rings, int spokes);

// Intensity at `cosine` (mu, from the limb 0 to the centre 1) over the mean of the disc.
class DiscProfile {
 public:
  DiscProfile(LimbDarkeningLaw law, Length wavelength);
  double at(double cosine) const;

 private:
  LimbProfile profile_;
  double mean_;
};

}  // namespace antumbra
