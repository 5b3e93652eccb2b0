// Laws of solar limb darkening for the shared functions (shaders/shared/limb_darkening.glsl).
//   hestroffer  Hestroffer & Magnan 1998, A&A 333, 338, from measurements at 303-1099 nm. The
//   default. neckel      Neckel 2005, Sol. Phys. 229, 13, Table I: 300-372.98, 385-422.57,
//   422.57-1100 nm none        a uniform disc
// The first two differ by up to 17 % in the light of a thin crescent, where both extrapolate to the
// limb; over the disc they agree within 2 %.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "quantity/quantity.h"
#include "shared/as_cpp.h"

namespace antumbra {

enum class LimbDarkeningLaw { Hestroffer, Neckel, None };

// "hestroffer", "neckel" or "none". Throws InputError naming `where` and what is allowed.
LimbDarkeningLaw parseLimbDarkeningLaw(std::string_view name, const std::string& where);

// Effective wavelength of limb darkening in luminance (passes/sun_plane.h says how it was found).
inline constexpr Length kSolarLuminanceWavelength = 558.0 * nanometre;

// Intensity over that of the disc's centre: mu^exponent times the polynomial, at one wavelength.
struct LimbProfile {
  double exponent = 0.0;
  std::array<double, 6> polynomial{1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
};

// Throws InputError for a wavelength outside the law's span (hestroffer: 0.3-1.1 um).
LimbProfile limbProfile(LimbDarkeningLaw law, Length wavelength);

// The law at four wavelengths, normalised to the mean of the disc.
glsl::LimbDarkening limbDarkening(LimbDarkeningLaw law, const std::array<Length, 4>& wavelengths);

// The same as it lies in a uniform block: thirteen vec4 in the order of the structure.
std::array<float, 52> packedForShader(const glsl::LimbDarkening& law);

}  // namespace antumbra
