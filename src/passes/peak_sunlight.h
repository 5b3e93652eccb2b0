// Sunlight that the forward peaks of haze have turned, before anything else scattered it.
//
// Scattered light counts forward peaks (medium/forward_peak.h) as no scattering: what they turn
// goes on as if it were sunlight, dimmed by the rest alone. That is right where the Sun stands
// high. Near the horizon light that a peak turns by some degrees has quite another way before it,
// and on the whole a longer one: of a haze of depth 1 (g 0.9) the ground under a Sun 15 degrees up
// would have 11 % too much. Here that light is followed from peak to peak,
//
//   F(n; x) = sum over turns of  Q(n; turn) * integral over the way there of
//             k_peak F(n-1; y) exp(-depth(x, y)) dy,       F(0) = sunlight unscattered,
//
// Q(n) being the peaks' mean over n turns (moments to the power of n: exact for light that has been
// turned little). The sum over n stands for sunlight wherever the rest scatters it or a peak turns
// it to the camera.
#pragma once

#include <vector>

#include "gl/program.h"
#include "gl/texture.h"
#include "medium/forward_peak.h"

namespace antumbra {

// Fills the Sun's depths in haze, and adds to its irradiance of the ground where sunlight is bent:
// what peaks have turned, beside what nothing has. `depths`, `densities`: as interface/air.glsl has
// them, both bound with all else that it needs but the source. `ways`: by wavelength. `reach`:
// BentSunTexels.
void turnSunlight(const gl::Texture& depths, const gl::Texture& densities,
                  const gl::Definitions& air, const std::vector<PeaksOnTheWay>& ways, double reach);

}  // namespace antumbra
