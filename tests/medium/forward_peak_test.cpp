// The separation of forward peaks against moments known in closed form: those of Henyey-Greenstein
// are g^l.
#include "medium/forward_peak.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace antumbra {
namespace {

Length const kWavelength = 550.0 * nanometre;

TEST(ForwardPeak, LeavesMomentsAsDeltaScalingDoes) {
  for (double g : {0.6, 0.8, 0.94}) {
    ForwardPeak const split(PhaseFunction::henyeyGreenstein(Spectrum(g)), kWavelength, 5);
    double const share = std::pow(g, 6);
    EXPECT_NEAR(split.share(), share, 2e-3) << g;
    for (std::size_t l = 0; l <= 5; ++l)
      EXPECT_NEAR(split.restMoments()[l], std::pow(g, static_cast<double>(l)) - share, 2e-3)
          << g << ", degree " << l;
  }
}

TEST(ForwardPeak, PartsAddUpAndHoldTheirShares) {
  auto const phase = PhaseFunction::henyeyGreenstein(Spectrum(0.85));
  ForwardPeak const split(phase, kWavelength, 4);
  double rest = 0.0, peak = 0.0;
  int const steps = 20000;
  for (int i = 0; i < steps; ++i) {
    double const x = (i + 0.5) / steps, cosine = 1.0 - 2.0 * x * x;
    double const area = 2.0 * std::numbers::pi * 4.0 * x / steps;
    EXPECT_NEAR(split.rest(cosine) + split.peak(cosine), phase.at(kWavelength, cosine),
                1e-12 * phase.at(kWavelength, cosine));
    EXPECT_GE(split.peak(cosine), 0.0);
    rest += area * split.rest(cosine);
    peak += area * split.peak(cosine);
  }
  EXPECT_NEAR(peak, split.share(), 1e-4);
  EXPECT_NEAR(rest, 1.0 - split.share(), 1e-4);
}

TEST(ForwardPeak, IsotropicAndThinAirHaveNone) {
  EXPECT_EQ(ForwardPeak(PhaseFunction::rayleigh(), kWavelength, 2).share(), 0.0);
  EXPECT_EQ(
      ForwardPeak(PhaseFunction::henyeyGreenstein(Spectrum(0.8)), kWavelength, 2, false).share(),
      0.0);
}

// All light that has left the Sun's direction in even air, by moments: exp(-T (1 - g^l)) less the
// unscattered exp(-T); of it the tables hold what is scattered twice and more by few moments.
TEST(ForwardPeak, BlurLeavesNothingOutAndCountsNothingTwice) {
  std::vector<double> cosines, areas;
  int const steps = 20000, degree = 5;
  for (int i = 0; i < steps; ++i) {
    double const x = (i + 0.5) / steps;
    cosines.push_back(1.0 - 2.0 * x * x);
    areas.push_back(2.0 * std::numbers::pi * 4.0 * x / steps);
  }
  for (double g : {0.8, 0.9}) {
    ForwardPeak const split(PhaseFunction::henyeyGreenstein(Spectrum(g)), kWavelength, degree);
    PeaksOnTheWay way{1.0, split.peakMoments(), split.allRestMoments()};
    for (double& m : way.rest) m /= split.share();
    for (double depth : {0.01, 0.5, 2.0}) {
      auto const phase = blurredPhase(split, way, depth * split.share(), cosines);
      double const rest = std::exp(-depth * (1.0 - split.share()));
      for (int l : {0, 1, 3, 5, 6, 10, 20}) {
        double once = 0.0;
        for (std::size_t i = 0; i < phase.size(); ++i)
          once += areas[i] * phase[i] * std::legendre(static_cast<unsigned>(l), cosines[i]);
        double const moment =
            l <= degree ? depth * split.restMoments()[static_cast<std::size_t>(l)] : 0.0;
        double const found = rest * (depth * once + std::expm1(moment) - moment);
        double const expected = std::exp(-depth * (1.0 - std::pow(g, l))) - std::exp(-depth);
        EXPECT_NEAR(found, expected, 0.003 * std::expm1(depth)) << g << ", " << depth << ", " << l;
      }
    }
  }
}

}  // namespace
}  // namespace antumbra
