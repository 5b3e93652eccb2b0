// The shadow of one sphere or oblate spheroid for points near an origin, prepared in double
// precision.
//
// From the apparent places of the Sun and the caster about the receiver's centre (light time and
// aberration of one observer there): the cones are exact for points at rest about that observer.
// The origin of the pair may be any point whose displacement from the receiver's centre is known;
// shaders that work relative to a camera near the ground pass the camera, and lose nothing to the
// size of the planet. With the origin at the centre of the Earth, a float's place is uncertain by
// 0.5 m, which is 1 % of the light at a visible fraction of 1e-6, and less in proportion above.
#pragma once

#include <array>
#include <span>

#include "quantity/quantity.h"
#include "quantity/vector.h"
#include "shared/as_cpp.h"

namespace antumbra {

// Radii of the two bodies. Some canons use a smaller Moon for the umbra than for the penumbra.
struct ShadowRadii {
  Length sun;
  Length casterUmbra;
  Length casterPenumbra;
};

// Figure of a caster: its pole as a unit vector along the axes of the shaded points. Default: a
// sphere.
struct CasterFigure {
  glm::dvec3 pole{0.0, 0.0, 1.0};
  double polarOverEquatorial = 1.0;
};

// `sun` and `caster` are displacements of the centres from the origin, in metres along the axes
// that the shaded points will use; the radii of a spheroid are its equatorial ones. Throws
// InputError unless the radii are positive, the polar radius is not above the equatorial one, and
// the caster stands outside the Sun.
template <class Frame>
glsl::ShadowPair shadowPair(Displacement<Frame> sun, Displacement<Frame> caster,
                            const ShadowRadii& radii, const CasterFigure& figure = {});

glsl::ShadowPair shadowPairMetres(const glm::dvec3& sun, const glm::dvec3& caster,
                                  const ShadowRadii& radii, const CasterFigure& figure = {});

template <class Frame>
glsl::ShadowPair shadowPair(Displacement<Frame> sun, Displacement<Frame> caster,
                            const ShadowRadii& radii, const CasterFigure& figure) {
  return shadowPairMetres(sun.m, caster.m, radii, figure);
}

// Share of sunlight that reaches `point` past every caster, the union of their discs before the
// Sun; the pairs share their origin and axes. Casters beyond the sixth that cover a part of the
// disc multiply.
glm::dvec4 visibleSunlight(std::span<const glsl::ShadowPair> pairs, const glsl::LimbDarkening& law,
                           const glm::dvec3& point);

// The pair as it lies in a uniform block: five vec4 in the order of the structure.
std::array<float, 20> packedForShader(const glsl::ShadowPair& pair);

}  // namespace antumbra
