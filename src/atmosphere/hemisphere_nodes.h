// Directions and weights that sum a sky's radiance to the irradiance of a plane.
//
// Polar coordinates about the Sun, or about the point of the horizon below it once it has set: so
// the aureole of any haze is resolved where it is. Gauss-Legendre in the cube root of the way from
// the Sun to the horizon, and a quarter of the turn at a time in the square root of the angle from
// the horizontal, toward which great circles through a low Sun crowd. The area element is the
// sphere's: no approximation but the sum.
//
// Measured: the irradiance by a lobe of Henyey and Greenstein about a Sun from the zenith to the
// horizon within 1e-6 up to g = 0.99, and 1e-4 at 0.999
// (tests/atmosphere/hemisphere_nodes_test.cpp); skies of the presets, by day, in twilight and in
// the Moon's shadow, within 0.06 % of sixteen times as many.
#pragma once

#include <vector>

#include "atmosphere/sunlight.h"

namespace antumbra {

struct HemisphereNode {
  Direction<AirFrame> direction;  // z: the plane's normal, x toward the Sun's azimuth
  double weight;                  // sr, times the cosine of the direction's zenith angle
};

// 3200 of them.
std::vector<HemisphereNode> hemisphereNodes(Angle sunZenith);

}  // namespace antumbra
