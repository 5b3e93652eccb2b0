// Tabulated optical depths against quadrature and closed forms, and rays in awkward places.
#include "atmosphere/spectral_medium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "atmosphere/single_scattering.h"

namespace antumbra {
namespace {

Medium bruneton() { return readMedium(mediumFile("reference_bruneton2017")); }
constexpr Length kGreen{550e-9};

TEST(SpectralMedium, TabulatedDepthsAgreeWithQuadrature) {
  Medium const m = bruneton();
  SpectralMedium const air(m, kGreen, m.radius);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    double const height = 60e3 * std::pow(uniform(random), 2.0);
    double const cosine = 2.0 * uniform(random) - 1.0;
    AirRay const ray({0.0, 0.0, air.ground() + height},
                     {std::sqrt(1.0 - cosine * cosine), 0.0, cosine});
    SpectralMedium::Span span;
    ASSERT_TRUE(air.spanOf(ray, span));
    double const a = span.enter + 0.3 * uniform(random) * (span.leave - span.enter);
    double const b = span.leave - 0.3 * uniform(random) * (span.leave - span.enter);
    worst =
        std::max(worst, std::abs(air.depthBetween(ray, a, b) - air.depthByQuadrature(ray, a, b)));
  }
  EXPECT_LT(worst, 8e-5);  // two look-ups of 4e-5 each
}

TEST(SpectralMedium, QuadratureAgreesWithClosedForms) {
  Medium const m = bruneton();
  SpectralMedium const air(m, kGreen, m.radius);
  // Vertically: the columns of the profiles.
  double const column =
      m.opticalDepth(0, kGreen) + m.opticalDepth(1, kGreen) + m.opticalDepth(2, kGreen);
  AirRay const vertical({0.0, 0.0, air.ground()}, {0.0, 0.0, 1.0});
  EXPECT_NEAR(air.depthByQuadrature(vertical, 0.0, 60e3) / column, 1.0, 1e-7);
  EXPECT_NEAR(air.depthToTop(air.ground(), 1.0) / column, 1.0, 1e-5);
  // Horizontally through a homogeneous shell: density times the chord.
  Medium shell;
  shell.radius = 1000.0 * kilometre;
  shell.topHeight = 100.0 * kilometre;
  shell.constituents.push_back({"slab",
                                DensityProfile::table({Length(0.0), shell.topHeight}, {1.0, 1.0}),
                                Spectrum(1e-6), Spectrum(0.0), PhaseFunction::isotropic()});
  SpectralMedium const uniform(shell, kGreen, shell.radius);
  double const chord = std::sqrt(1100e3 * 1100e3 - 1000e3 * 1000e3);
  EXPECT_NEAR(uniform.depthToTop(1000e3, 0.0), 1e-6 * chord, 1e-6 * 1e-6 * chord);
}

TEST(Transmittance, EdgesAndBeyond) {
  Medium const m = bruneton();
  Direction<AirFrame> const up{{0.0, 0.0, 1.0}}, level{{1.0, 0.0, 0.0}}, down{{0.0, 0.0, -1.0}};
  auto const at = [](double metresAboveGround) {
    return Position<AirFrame>{{0.0, 0.0, 6360e3 + metresAboveGround}};
  };
  double const zenith = transmittance(m, at(0.0), up, kGreen);
  EXPECT_NEAR(zenith, std::exp(-0.141868), 2e-4);  // columns of params_bruneton2017_earth.csv
  for (double h : {1e-6, 1e-3}) EXPECT_NEAR(transmittance(m, at(h), up, kGreen), zenith, 1e-7);
  EXPECT_EQ(transmittance(m, at(0.0), down, kGreen), 0.0);
  EXPECT_EQ(transmittance(m, at(60e3), up, kGreen), 1.0);
  EXPECT_EQ(transmittance(m, at(60001.0), up, kGreen), 1.0);
  EXPECT_EQ(transmittance(m, at(1e9), down, kGreen), 0.0);
  EXPECT_EQ(transmittance(m, at(1e9), level, kGreen), 1.0);
  // Horizon rays: a millimetre does not matter, and the level ray from the top is nearly free.
  EXPECT_NEAR(transmittance(m, at(1e-3), level, kGreen) / transmittance(m, at(0.0), level, kGreen),
              1.0, 1e-4);
  EXPECT_GT(transmittance(m, at(59999.0), level, kGreen), 0.999);
  // Through the limb from afar and from the tangent point: the same air twice.
  double const half = transmittance(m, at(20e3), level, kGreen);
  EXPECT_NEAR(transmittance(m, {{-1e9, 0.0, 6380e3}}, level, kGreen) / (half * half), 1.0, 1e-6);
  // Below the ground's sphere (the Dead Sea): the ground lies at the point.
  double const below = transmittance(m, at(-430.0), up, kGreen);
  EXPECT_GT(below, 0.98 * zenith);
  EXPECT_LT(below, zenith);
}

}  // namespace
}  // namespace antumbra
