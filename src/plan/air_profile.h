// Scattering and extinction of a medium at one wavelength over height, and what straight ways to
// the Sun let pass: enough air to weigh the places of a ray by what they scatter.
//
// Straight lines between 400 heights that are dense near the ground; a way's depth by the midpoint
// rule, dense at its lowest point: within 1 % of the depth (tests/plan/air_profile_test.cpp).
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "medium/medium.h"

namespace antumbra {

class AirProfile {
 public:
  AirProfile(const Medium& medium, Length wavelength);
  double topMetres() const { return top_; }
  // x: scattering, y: extinction, 1/m; at the ends' values beyond ground and top.
  glm::dvec2 at(double heightMetres) const;
  // Transmittance from a place at `radius` (m, not beyond the top) above a sphere of radius
  // `ground`, toward a Sun at `cosine` from the vertical; 0 where that sphere is in the way.
  double passed(double radius, double cosine, double ground) const;

 private:
  double top_;
  std::vector<glm::dvec2> both_;
};

}  // namespace antumbra
