// Sunlight as it arrives at the camera: through the air and the rings of every body that the line
// of sight crosses.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "medium/medium.h"
#include "plan/render_plan.h"

namespace antumbra {

// At 1 au without air, lx in linear sRGB (ASTM E490, CIE 1931).
glm::dvec3 solarIlluminanceAtOneAu();

// What the airs of the planned bodies let through to the camera. Keeps the media it has read and
// the colour weights, which no picture changes.
class SunlightThroughAir {
 public:
  SunlightThroughAir();
  // Share of sunlight, in linear sRGB: optical depths by quadrature at 16 wavelengths, in the space
  // in which each body is a sphere. What bodies hide takes no part: the ground hides by its
  // silhouette. To be honest: along the ray to the Sun's centre, without refraction; near the
  // horizon the disc's two edges differ by a factor of two.
  glm::dvec3 share(const RenderPlan& plan);

 private:
  std::vector<Length> wavelengths_;
  std::vector<glm::dvec3> weights_;
  std::map<std::string, Medium> media_;  // by the stem of their file
};

}  // namespace antumbra
