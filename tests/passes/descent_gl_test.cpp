// From 1 m above the ground to 1e8 m: the programs' change of radiance from height to height
// against the deterministic single-scattering integrator, straight down, straight up and along the
// horizon.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "atmosphere/single_scattering.h"
#include "passes/sky_sampler.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using Descent = testsupport::GlTest;

// The bar: ln L changes from one of 200 heights to the next as in the integrator, within 0.02.
// Single scattering on both sides (no source of higher orders); the Sun 35 degrees from the zenith.
// The tangent ray passes 20 km (at most half the camera's height) above the ground, sideways to the
// Sun.
TEST_F(Descent, FollowsTheIntegratorFromHeightToHeight) {
  auto const medium = readMedium(mediumFile("reference_bruneton2017"));
  Length const wavelength = 550.0 * nanometre;
  AirQuality quality;
  quality.orders = 0;
  SkySampler sampler(medium, {wavelength}, quality);
  SkyRequest request;
  request.sunZenith = 35.0 * degree;
  Sunlight sun;
  sun.toSun.u = {sin(request.sunZenith), 0.0, cos(request.sunZenith)};
  SingleScattering const integrator(medium, sun, wavelength, medium.radius);
  double const radius = medium.radius.si;
  const char* const names[] = {"nadir", "zenith", "tangent"};
  double before[3] = {}, expectedBefore[3] = {}, worst[3] = {}, error[3] = {};
  int compared[3] = {};
  constexpr int heights = 200;
  for (int i = 0; i < heights; ++i) {
    double const height = std::pow(10.0, 8.0 * i / (heights - 1));
    request.altitude = Length(height);
    // The ray that passes `low` above the ground.
    double const low = std::min(20e3, 0.5 * height);
    double const sine = (radius + low) / (radius + height);
    double const down = std::atan2(
        sine, -std::sqrt((height - low) * (2.0 * radius + height + low)) / (radius + height));
    request.directions = {
        {180.0 * degree, Angle(0.0)}, {Angle(0.0), Angle(0.0)}, {Angle(down), 90.0 * degree}};
    auto const found = sampler.sample(request);
    for (std::size_t ray = 0; ray < 3; ++ray) {
      double const expected = integrator.radiance({{0.0, 0.0, radius + height}},
                                                  airDirectionOf(request.directions[ray]));
      ASSERT_TRUE(std::isfinite(found[ray]) && found[ray] >= 0.0) << names[ray] << height;
      if (expected <= 0.0) {
        EXPECT_EQ(found[ray], 0.0) << names[ray] << height;
        before[ray] = 0.0;
        continue;
      }
      double const change = std::log(found[ray] / before[ray]);
      double const wanted = std::log(expected / expectedBefore[ray]);
      if (before[ray] > 0.0) {
        worst[ray] = std::max(worst[ray], std::fabs(change - wanted));
        EXPECT_NEAR(change, wanted, 0.02) << names[ray] << " at " << height << " m";
        ++compared[ray];
      }
      error[ray] = std::max(error[ray], std::fabs(found[ray] / expected - 1.0));
      before[ray] = found[ray];
      expectedBefore[ray] = expected;
    }
  }
  for (int ray = 0; ray < 3; ++ray) {
    std::printf("%s: %d steps, change of ln L within %.4f, radiance within %.2f %%\n", names[ray],
                compared[ray], worst[ray], 100.0 * error[ray]);
    EXPECT_GT(compared[ray], 100);
  }
}

}  // namespace
}  // namespace antumbra
