// Rays of sunlight that graze a body and cross its air from limb to limb: bending and extinction.
//
// In spherical air n r sin z = b is constant along a ray (Bouguer), b being the distance of its
// straight parts from the body's centre. With r0 the radius of its lowest point, b = n(r0) r0, and
//   bending  = -2 b integral of (dn/dr)/n   dr / sqrt(n^2 r^2 - b^2)
//   column_c =  2   integral of density_c n r dr / sqrt(n^2 r^2 - b^2),  r from r0 to the top
// (e.g. Born & Wolf, Principles of Optics, 3.2.2), by Gauss-Legendre quadrature in sqrt(r - r0)
// between the kinks of the densities: relative error below 1e-6 for smooth pieces
// (tests/atmosphere/refracted_shadow_test.cpp integrates the rays' differential equation instead).
// Rays below which n r no longer grows with r (Venus) circle the body and never leave: they count
// as lost, like those that meet the ground.
#pragma once

#include <vector>

#include "medium/medium.h"

namespace antumbra {

struct LimbRay {
  Length impact;                // b
  Angle bending;                // toward the body's axis
  std::vector<Length> columns;  // of each constituent, at its density 1
};

// `ground`: radius of the body's sphere, which carries the medium's heights. `refractivity`: n - 1
// at density 1. Precondition: tangentHeight from limbFloor to the medium's top.
LimbRay limbRay(const Medium& medium, Length ground, Length tangentHeight, double refractivity);

// Height of the lowest tangent of a ray that leaves the air again: 0, or above what traps light.
Length limbFloor(const Medium& medium, Length ground, double refractivity);

// One node of a quadrature over the impact parameter from the ground to the top.
struct LimbNode {
  double impactMetres = 0.0;
  double stepMetres = 0.0;  // weight: its piece of b
  double bendingRadians = 0.0;
  double transmittance = 0.0;  // extinction and clouds
};

// For each wavelength, nodes in ascending order of b. Bending follows refractivity by a parabola
// through three values over the span of the wavelengths (relative error below 1e-5 of the bending).
std::vector<std::vector<LimbNode>> limbNodes(const Medium& medium, Length ground,
                                             const std::vector<Length>& wavelengths);

}  // namespace antumbra
