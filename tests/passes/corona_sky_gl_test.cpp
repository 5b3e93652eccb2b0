// The sky that the corona lights in totality: drawn with it less drawn without, against the same
// difference of the references, whose corona is integrated over the sky at every point of the air.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "atmosphere/path_tracer.h"
#include "atmosphere/single_scattering.h"
#include "passes/sky_sampler.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

using CoronaSky = testsupport::GlTest;

Direction<AirFrame> directionAt(Angle zenith, Angle azimuth) {
  return {{sin(zenith) * cos(azimuth), sin(zenith) * sin(azimuth), cos(zenith)}};
}

// On the axis, the Sun 55 degrees high: at the zenith, 1 to 10 degrees from the Sun (the aureole),
// low opposite, and the ground. In the mean the drawn corona's light lacks what is scattered more
// than once.
TEST_F(CoronaSky, IsTheReferencesCorona) {
  Angle const sunZenith = 35.0 * degree;
  std::vector<Length> const wavelengths{440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre};
  auto const corona = std::make_shared<CoronaLight>(0.5, LimbDarkeningLaw::Hestroffer);
  for (std::string const name : {"reference_bruneton2017", "earth"}) {
    auto const medium = readMedium(mediumFile(name));
    Sunlight sun;
    sun.toSun = directionAt(sunZenith, Angle(0.0));
    Position<AirFrame> const camera{{0.0, 0.0, medium.radius.si}};
    sun.occulters = {occulterByRatio(1.0515, 1737.4 * kilometre, camera, sun)};
    SkyRequest request;
    request.altitude = Length(0.0);
    request.sunZenith = sunZenith;
    request.wavelengths = wavelengths;
    request.casters = SunShadow(sun, wavelengths[0]).pairs();
    request.directions = {{0.0 * degree, Angle(0.0)},
                          {34.0 * degree, Angle(0.0)},
                          {30.0 * degree, Angle(0.0)},
                          {25.0 * degree, Angle(0.0)},
                          {60.0 * degree, 180.0 * degree}};
    SkySampler sampler(medium, wavelengths, AirQuality());
    auto const without = sampler.sample(request);
    request.corona = corona;
    auto const with = sampler.sample(request);
    double once = 0.0, all = 0.0, share = 0.0;  // all: not drawn, of the sky
    for (std::size_t w = 0; w < 3; ++w) {
      Sunlight lit = sun;
      lit.corona = corona;
      SingleScattering const dark(medium, sun, wavelengths[w], medium.radius);
      SingleScattering const bright(medium, lit, wavelengths[w], medium.radius);
      for (std::size_t d = 0; d < request.directions.size(); ++d) {
        auto const& look = request.directions[d];
        auto const direction = directionAt(look.viewZenith, look.relativeAzimuth);
        double const expected =
            bright.radiance(camera, direction) - dark.radiance(camera, direction);
        std::size_t const i = d * 3 + w;
        double const found = with[i] - without[i];
        std::printf("%s %.0f nm, zenith angle %.0f: corona %.3e, %+.1f %%; of the sky %.2f %%\n",
                    name.c_str(), wavelengths[w] / nanometre, look.viewZenith / degree, found,
                    100.0 * (found / expected - 1.0), 100.0 * found / with[i]);
        once = testsupport::larger(once, std::fabs(found / expected - 1.0));
        share = std::max(share, found / with[i]);
      }
      // In all orders the air within the umbra scatters the corona as it scatters the Sun by day,
      // for the corona's light is the same all over it within 2 %.
      if (w != 1) continue;
      PathTracerSettings settings;
      settings.relativeError = 0.02;
      Sunlight day = sun;
      day.occulters.clear();
      PathTracer const paths(medium, day, wavelengths[w], medium.radius);
      for (std::size_t d : {0u, 2u}) {
        auto const& look = request.directions[d];
        auto const direction = directionAt(look.viewZenith, look.relativeAzimuth);
        double const expected =
            corona->past(1.0515, 0.0) * paths.radiance(camera, direction, settings).value;
        std::size_t const i = d * 3 + w;
        double const missing = (expected - (with[i] - without[i])) / with[i];
        std::printf("  all orders: corona %.3e, not drawn %.2f %% of the sky\n", expected,
                    100.0 * missing);
        all = testsupport::larger(all, std::fabs(missing));
      }
    }
    EXPECT_LT(once, 0.05) << name;  // as the drawn single scattering of hazes by day
    EXPECT_LT(all, 0.006) << name;
    EXPECT_GT(share, name == "earth" ? 0.01 : 0.003) << name;
  }
}

}  // namespace
}  // namespace antumbra
