// The spectra that turn radiance into what an eye sees, from catalogs/spectra.
// Sun: ASTM E490-00a, 1 au, no air, steps of 1 nm in the visible (Fraunhofer lines smoothed).
// Eye: CIE 1931 2 degree colour matching functions (photopic V is its y), CIE 1951 scotopic V'.
#pragma once

#include <glm/glm.hpp>

#include "photometry/spectrum.h"

namespace antumbra {

// Maximum luminous efficacy of radiation, lm/W: photopic by the SI definition of the candela
// (683 lm/W at 540 THz), scotopic 1700 lm/W (CIE 018:2019).
inline constexpr double kPhotopicEfficacy = 683.0;
inline constexpr double kScotopicEfficacy = 1700.0;
// The visible span over which colour is integrated.
inline constexpr Length kVisibleFirst{360e-9};
inline constexpr Length kVisibleLast{830e-9};

// The Sun's spectral irradiance at 1 au, W m^-2 nm^-1; 300 to 1000 nm.
double solarIrradiance(Length wavelength);
const Spectrum& solarSpectrum();
// Colour matching functions x, y, z; zero outside 360 to 830 nm, where the standard ends.
glm::dvec3 colourMatching(Length wavelength);
// V: 1 at 555 nm.
double photopicEfficiency(Length wavelength);
// V': 1 at 507 nm; zero outside 380 to 780 nm, where the standard ends.
double scotopicEfficiency(Length wavelength);
// Absorption cross section of an ozone molecule at 233 K, m^2; 355 to 835 nm.
double ozoneCrossSection(Length wavelength);
// Rayleigh scattering cross section of an air molecule, m^2, Bucholtz 1995 (Appl. Opt. 34, 2765),
// eq. 8 and table 3, standard air, King factor included; 200 to 4000 nm, fit within 0.2 %.
double rayleighCrossSection(Length wavelength);

// Luminance-like integrals of a spectral radiance given relative to the solar irradiance: 683 lm/W
// times the integral of f(wavelength) E0(wavelength) (x, y, z), in cd/m2 when f is in 1/sr (or in
// lux when f is an irradiance ratio). Midpoint sums of 1 nm.
template <class Function>
glm::dvec3 xyzOfRelativeRadiance(const Function& f) {
  glm::dvec3 sum(0.0);
  for (double nm = 360.5; nm < 830.0; nm += 1.0) {
    Length const wavelength = nm * nanometre;
    sum += f(wavelength) * solarIrradiance(wavelength) * colourMatching(wavelength);
  }
  return kPhotopicEfficacy * sum;
}
// The same for the dark-adapted eye: scotopic cd/m2 (or scotopic lux).
template <class Function>
double scotopicOfRelativeRadiance(const Function& f) {
  double sum = 0.0;
  for (double nm = 380.5; nm < 780.0; nm += 1.0) {
    Length const wavelength = nm * nanometre;
    sum += f(wavelength) * solarIrradiance(wavelength) * scotopicEfficiency(wavelength);
  }
  return kScotopicEfficacy * sum;
}

}  // namespace antumbra
