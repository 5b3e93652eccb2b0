// The direct light of the Sun's disc through air that bends it, as texels for shaders: what
// atmosphere/bent_sunlight.h gives for a point of the Sun, summed over the part of a uniform disc
// that stands above the ground's horizon.
//
// Optical depths lie where those of straight rays do (shared/air_geometry.glsl, depthCoordinates),
// but for a common factor on the first coordinate, `reach`, which makes room for the Sun below the
// geometric horizon: a look-up costs what it costs along straight rays.
#pragma once

#include <vector>

#include "atmosphere/bent_sunlight.h"

namespace antumbra {

struct BentSunTexels {
  double reach = 1.0;
  double lowestCosine = -1.0;  // of the Sun's zenith angle at the ground, where its light ends
  // Negative logarithm of the light across its way, over that outside the air: width by height by
  // groups of four colours; kDarkDepth where there is none.
  std::vector<float> depths;
  // Irradiance of the horizontal ground over that outside the air: over the root of the Sun's
  // cosine above the lowest, a row for each of four colours.
  std::vector<float> ground;
};

// Exponents of half floats hold it, and its light is below any star's.
inline constexpr double kDarkDepth = 60.0;

// `colours`: a multiple of four. `sunRadius` 0: a point. Precondition: BentSunlight::bends().
BentSunTexels bentSunTexels(const Medium& medium, Length groundRadius, Angle sunRadius,
                            const std::vector<BentColour>& colours, int width, int height,
                            int groundTexels);

}  // namespace antumbra
