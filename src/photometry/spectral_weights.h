// From spectral radiance at a few wavelengths to colour.
//
// A renderer knows a radiance only at N wavelengths, as f_i = L(lambda_i) / E0(lambda_i) in 1/sr.
// Its colour is the linear form  rgb = sum_i w_i f_i  with weights w_i found by least squares over
// a set of spectra that skies have (Rayleigh and aerosol scattering, reddened sunlight, ozone in
// twilight, grey and coloured ground, absorbing dust), each weighted by its own luminance, and held
// near the plain quadrature of linear interpolation. With the default wavelengths the measured
// error over 800 spectra that the fit has not seen (tests/photometry/spectral_weights_test.cpp):
//   N = 4:  CIEDE2000 mean 0.14, 95 % below 0.30, worst 3.8; luminance within 3.5 %
//   N = 8:             mean 0.02, 95 % below 0.05, worst 1.1; luminance within 1.8 %
//   N = 16:            mean 0.01, 95 % below 0.02, worst 0.1; luminance within 0.1 %
// (CIEDE2000 against the integral of 1 nm steps, white at twice the sky's luminance; the worst are
// strongly coloured grounds, not skies).
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "quantity/quantity.h"

namespace antumbra {

// Weights in cd/m2 per unit of f: `linearSrgb = sum_i weights[i] * f_i`, channels in cd/m2, with
// luminance Y exactly as colour.h defines it. `wavelengths`: 1 to 64, ascending, 360 to 830 nm;
// throws InputError otherwise.
std::vector<glm::dvec3> linearSrgbWeights(const std::vector<Length>& wavelengths);
// The same for the scotopic luminance (dark-adapted eye), scotopic cd/m2 per unit of f.
std::vector<double> scotopicWeights(const std::vector<Length>& wavelengths);

// The wavelengths that minimise the colour error: the measured best for 4 and 8, otherwise
// equal steps over 390 to 690 nm. `count` from 1 to 64.
std::vector<Length> defaultWavelengths(int count);

// A sky-like spectrum f(lambda) = L / E0; the fit draws `seed`s below kTestSeed, tests draw others.
using RelativeSpectrum = std::function<double(Length)>;
RelativeSpectrum exampleSkySpectrum(int seed);
inline constexpr int kTestSeed = 100000;

}  // namespace antumbra
