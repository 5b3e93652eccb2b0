// Colour out of a few wavelengths, against the integral of 1 nm steps, over spectra unseen by the
// fit.
#include "photometry/spectral_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "document/input_error.h"
#include "photometry/colour.h"
#include "photometry/standard_spectra.h"

namespace antumbra {
namespace {

struct Errors {
  double mean, percentile95, worst, worstLuminance;
};

Errors errorsOf(int count) {
  auto const wavelengths = defaultWavelengths(count);
  auto const weights = linearSrgbWeights(wavelengths);
  std::vector<double> deltas;
  double worstLuminance = 0.0;
  for (int seed = kTestSeed; seed < kTestSeed + 800; ++seed) {
    auto const f = exampleSkySpectrum(seed);
    auto const exact = xyzOfRelativeRadiance(f);
    glm::dvec3 rgb(0.0);
    for (size_t i = 0; i < wavelengths.size(); ++i) rgb += weights[i] * f(wavelengths[i]);
    auto const found = xyzFromLinearSrgb(rgb);
    deltas.push_back(deltaE2000(exact, found, 2.0 * exact.y));
    worstLuminance = std::max(worstLuminance, std::abs(found.y / exact.y - 1.0));
  }
  std::sort(deltas.begin(), deltas.end());
  return {std::accumulate(deltas.begin(), deltas.end(), 0.0) / 800.0, deltas[760], deltas.back(),
          worstLuminance};
}

// The bounds are the figures of spectral_weights.h.
TEST(SpectralWeights, FourWavelengthsGiveTheColourOfTheSky) {
  Errors const e = errorsOf(4);
  EXPECT_LT(e.mean, 0.15);
  EXPECT_LT(e.percentile95, 0.31);
  EXPECT_LT(e.worst, 3.9);
  EXPECT_LT(e.worstLuminance, 0.035);
}

TEST(SpectralWeights, EightAndSixteen) {
  Errors const eight = errorsOf(8), sixteen = errorsOf(16);
  EXPECT_LT(eight.mean, 0.025);
  EXPECT_LT(eight.worst, 1.1);
  EXPECT_LT(eight.worstLuminance, 0.018);
  EXPECT_LT(sixteen.mean, 0.01);
  EXPECT_LT(sixteen.worst, 0.1);
  EXPECT_LT(sixteen.worstLuminance, 0.001);
}

TEST(SpectralWeights, AnyNumberKeepsTheLuminanceOfSunlight) {
  auto const sun = xyzOfRelativeRadiance([](Length) { return 1.0; });
  for (int count : {3, 4, 6, 12, 24, 40, 64}) {
    auto const weights = linearSrgbWeights(defaultWavelengths(count));
    auto const sum = std::accumulate(weights.begin(), weights.end(), glm::dvec3(0.0));
    EXPECT_NEAR(luminanceOf(sum) / sun.y, 1.0, 0.004) << count;
  }
}

TEST(SpectralWeights, ScotopicLuminanceOfSunlight) {
  double const exact = scotopicOfRelativeRadiance([](Length) { return 1.0; });
  auto const weights = scotopicWeights(defaultWavelengths(8));
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0) / exact, 1.0, 0.005);
  // Scotopic to photopic ratio of sunlight near 5900 K is 2.4 to 2.5 (CIE 191:2010, D55-D65).
  EXPECT_NEAR(exact / xyzOfRelativeRadiance([](Length) { return 1.0; }).y, 2.45, 0.1);
}

TEST(SpectralWeights, RefusesWhatIsNoListOfWavelengths) {
  EXPECT_THROW(linearSrgbWeights({}), InputError);
  EXPECT_THROW(linearSrgbWeights({600 * nanometre, 500 * nanometre}), InputError);
  EXPECT_THROW(linearSrgbWeights({200 * nanometre}), InputError);
  EXPECT_THROW(defaultWavelengths(0), InputError);
}

}  // namespace
}  // namespace antumbra
