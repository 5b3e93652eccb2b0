// The drawn sky at the extremes: any medium, camera, Sun and direction, and a furnace.
//
// The suite takes a few media; a million radiances:
//   ANTUMBRA_FUZZ=800 build/release/test_passes_gl --gtest_filter='SkyExtremes*'
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "passes/sky_sampler.h"
#include "tests/support/any_medium.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using SkyExtremesGlTest = testsupport::GlTest;
using testsupport::AnyMedium;

TEST_F(SkyExtremesGlTest, StaysFiniteForAnyMedium) {
  const char* const given = std::getenv("ANTUMBRA_FUZZ");
  int const media = given ? std::atoi(given) : 8;
  const char* const begin = std::getenv("ANTUMBRA_FUZZ_FIRST");
  const char* const preset = std::getenv("SKY_PRESET");
  AirQuality const quality = AirQuality::preset(preset ? preset : "draft");
  constexpr int kViews = 20, kDirections = 64;
  Length const wavelength = 550.0 * nanometre;
  long bad = 0, count = 0;
  int const first = begin ? std::atoi(begin) : 0;
  for (int i = first; i < first + media; ++i) {
    AnyMedium any(static_cast<unsigned>(i));
    Medium const medium = any.medium();
    double const factor = any.factor();
    Angle const sunRadius(any.oneOf({0.0, 0.00465, 0.05}));
    double brightest = 0.0;
    for (auto const& c : medium.constituents)
      for (double cosine : {-1.0, 1.0})
        brightest = std::max(brightest, c.phase.at(wavelength, cosine));
    SkySampler sampler(medium, {wavelength}, quality, sunRadius);
    for (int view = 0; view < kViews; ++view) {
      SkyRequest request;
      request.altitude = any.altitude(medium);
      request.sunZenith = any.zenithAngle(medium, request.altitude);
      request.sunRadius = sunRadius;
      request.wavelengths = {wavelength};
      for (int d = 0; d < kDirections; ++d)
        request.directions.push_back({any.zenithAngle(medium, request.altitude), any.azimuth()});
      request.directions[0] = {request.sunZenith, Angle(0.0)};
      request.directions[1] = {180.0 * degree - request.sunZenith, 180.0 * degree};
      auto const found = sampler.sample(request);
      for (int d = 0; d < kDirections; ++d, ++count) {
        double const value = found[static_cast<std::size_t>(d)];
        // Nothing outshines the Sun in its own aureole; light scattered more than once stays below
        // that of a white ground.
        if (value >= 0.0 && value <= brightest + 1.0 && std::isfinite(value)) continue;
        if (++bad > 20) continue;
        auto const& look = request.directions[static_cast<std::size_t>(d)];
        ADD_FAILURE() << "medium " << i << ": radiance " << value << " (phase up to " << brightest
                      << "), factor " << factor << ", radius " << medium.radius / metre << ", top "
                      << medium.topHeight / metre << ", altitude " << request.altitude / metre
                      << ", Sun " << request.sunZenith / degree << ", view "
                      << look.viewZenith / degree << " azimuth " << look.relativeAzimuth / degree;
      }
    }
  }
  EXPECT_EQ(bad, 0) << "of " << count << " radiances";
}

}  // namespace
}  // namespace antumbra
