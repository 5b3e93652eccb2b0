// How much of the Sun's light reaches a point past opaque spheroids, by rays from the point to the
// disc: no cones, no discs, no overlap formula. The reference that the shared functions
// (shaders/shared/eclipse.glsl, several_casters.glsl) and their shortcuts are measured against.
//
// Rings of the disc by adaptive Simpson over the root of mu, each ring's hidden arcs by ray casting
// with their ends bisected to 1e-9 rad. Error: below 1e-4 of the whole Sun
// (tests/eclipse/rays_to_sun_test.cpp); an arc shorter than the sampling step may be missed.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "eclipse/limb_darkening.h"

namespace antumbra {

// Metres, in any axes common to all; the pole is a unit vector.
struct OpaqueSpheroid {
  glm::dvec3 centre;
  glm::dvec3 pole{0.0, 0.0, 1.0};
  double equatorialRadius = 0.0;
  double polarRadius = 0.0;
};

// Whether a ray from `point` along `direction` meets the spheroid ahead.
bool meets(const OpaqueSpheroid& body, const glm::dvec3& point, const glm::dvec3& direction);

// Share of the disc's light, 0 to 1. `tolerance` of the integral over rings, `samples` rays to a
// ring before bisection.
double visibleLightByRays(const glm::dvec3& point, const glm::dvec3& sunCentre, double sunRadius,
                          std::span<const OpaqueSpheroid> bodies, const LimbProfile& law,
                          double tolerance = 1e-5, int samples = 180);

}  // namespace antumbra
