// Single scattering in a layer against the integral through it, and the phase function's mean.
#include <gtest/gtest.h>

#include <cmath>

#include "passes/rings.h"
#include "tests/support/larger.h"

#define GLSL_AS_CPP
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace antumbra::glsl {
namespace {
#include "shared/rings.glsl"
}  // namespace
}  // namespace antumbra::glsl
#pragma GCC diagnostic pop

namespace antumbra {
namespace {

TEST(Rings, ScatterOnceAsTheIntegralThroughTheLayer) {
  double worst = 0.0;
  for (double depth : {1e-4, 0.05, 0.4, 1.0, 3.6, 20.0})
    for (double sun : {0.02, 0.2, 0.45, 0.9})
      for (double view : {0.02, 0.2, 0.201, 0.6, 1.0})
        for (bool lit : {true, false}) {
          // Depth t from the lit face: dimmed on the way in and on the way out.
          double sum = 0.0;
          constexpr int kSteps = 20000;
          double const reach = std::min(depth, 40.0 * std::max(sun, view));
          for (int i = 0; i < kSteps; ++i) {
            double const t = reach * (i + 0.5) / kSteps;
            // On the unlit side what lies deep counts; beyond 40 free paths nothing is left.
            sum += std::exp(-t / sun - (lit ? t : depth - t) / view) / view * reach / kSteps;
          }
          double const found = glsl::ringScattering(depth, sun, view, lit);
          if (sum < 1e-9) {
            EXPECT_LT(found, 1e-8);
            continue;
          }
          worst = testsupport::larger(worst, std::fabs(found / (0.25 * sum) - 1.0));
        }
  std::printf("single scattering within %.1e\n", worst);
  // The midpoint rule's own error in the deepest layer.
  EXPECT_LT(worst, 2e-4);
}

TEST(Rings, PhaseFunctionConservesLight) {
  for (double exponent : {0.0, 1.0, 3.092, 6.0}) {
    double const norm = ringPhaseNorm(exponent);
    double sum = 0.0;
    constexpr int kSteps = 100000;
    for (int i = 0; i < kSteps; ++i) {
      double const phase = M_PI * (i + 0.5) / kSteps;
      sum += 0.5 * glsl::ringPhase(phase, exponent, norm) * std::sin(phase) * M_PI / kSteps;
    }
    EXPECT_NEAR(sum, 1.0, 1e-6) << exponent;
  }
}

}  // namespace
}  // namespace antumbra
