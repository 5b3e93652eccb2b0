// Where light inside a shadow is computed ahead. It changes slowly with the Sun's height where the
// axis meets the body and with the umbra's radius; both are laid on fixed lattices, and what is
// found at the three nodes around a shadow is interpolated linearly. The nodes depend on nothing
// but the shadow in hand, so neither does a picture that uses them.
//
// A node's shadow is that of the same two spheres in axes of its own (z to the Sun, x from the
// body's centre to the axis), with the Sun's distance rounded to 0.2 % and the penumbra to 0.05 %;
// an oblate caster is the sphere of its equator.
#pragma once

#include <array>
#include <vector>

#include "eclipse/shadow_pair.h"

namespace antumbra {

struct ShadowNode {
  // Identifies the node among those of one pair of bodies and one receiver.
  std::array<long, 4> key;
  double weight;  // of the three, summing to 1
  glsl::ShadowPair pair;
};

// Spacing of the lattices. In height: of asinh(p / 0.1), p the Sun's height in radians (below the
// horizon: acosh of the axis' distance over the radius, negative). In the umbra's radius at the
// axis' foot: of asinh(radius / umbraScale).
struct ShadowLattice {
  double heightStep = 0.3450787;  // asinh(5 pi) / 10: the zenith is a node
  double umbraStep = 0.3;
  Length umbraScale{36e3};
};

// `axisDistance`: of the shadow's axis from the receiver's centre, where the receiver is a sphere
// of `radius` (an oblate one: in the space in which it is one). Nodes of weight 0 are left out.
std::vector<ShadowNode> shadowNodes(const glsl::ShadowPair& pair, Length axisDistance,
                                    Length radius, const ShadowLattice& lattice);

// The shadow itself in a node's axes.
glsl::ShadowPair shadowAlone(const glsl::ShadowPair& pair, Length axisDistance);

// Radius of the umbral cone where the axis meets a sphere of `radius`; at the foot if it misses.
Length umbraOnGround(const glsl::ShadowPair& pair, Length axisDistance, Length radius);

}  // namespace antumbra
