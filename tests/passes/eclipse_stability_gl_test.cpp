// Light by the drawing programs in random eclipses, places and directions: never NaN, never
// negative. ECLIPSE_CASES=100000 tries a hundred thousand directions (250 a shadow) instead of two
// thousand.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "passes/body_shadows.h"
#include "passes/sky_sampler.h"
#include "quantity/constants.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shadow_probe.h"

namespace antumbra {
namespace {

using EclipseStability = testsupport::GlTest;

std::size_t wantedCases() {
  const char* const given = std::getenv("ECLIPSE_CASES");
  return given ? std::strtoul(given, nullptr, 10) : 2000u;
}

// A total, annular or partial shadow whose axis passes anywhere within the reach of the penumbra.
glsl::ShadowPair randomPair(std::mt19937_64& random, const glm::dvec3& toSun, double radius) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double const reach = std::pow(unit(random), 2.0) * 9e6,
               turn = 2.0 * std::numbers::pi * unit(random);
  glm::dvec3 const x = glm::normalize(glm::cross(toSun, glm::dvec3(0.1, 1.0, 0.0)));
  glm::dvec3 const y = glm::cross(toSun, x);
  glm::dvec3 const place =
      glm::dvec3(0.0, 0.0, radius) + reach * (std::cos(turn) * x + std::sin(turn) * y);
  double const moon = 3.5e8 + 6e7 * unit(random);
  return shadowPairMetres(place + astronomicalUnit.si * toSun, place + moon * toSun,
                          {kSolarRadiusIau, 1737.4 * kilometre, 1737.4 * kilometre});
}

TEST_F(EclipseStability, LightIsFiniteAndNeverNegative) {
  auto const medium = readMedium(mediumFile("earth"));
  SkySampler sampler(medium, {440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre},
                     AirQuality::preset("draft"));
  std::mt19937_64 random(20270802);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::size_t tried = 0, dark = 0;
  double largest = 0.0;
  for (std::size_t const wanted = wantedCases(); tried < wanted;) {
    SkyRequest request;
    double const place = unit(random);
    // On the ground, in the air, at its top and far outside.
    request.altitude = place < 0.3   ? Length(2.0)
                       : place < 0.6 ? Length(12e3 * unit(random))
                       : place < 0.8 ? medium.topHeight * unit(random)
                                     : Length(1e5 * std::pow(10.0, 3.5 * unit(random)));
    request.sunZenith = std::acos(1.0 - 1.3 * unit(random)) * radian;
    request.wavelengths = {440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre};
    glm::dvec3 const toSun(sin(request.sunZenith), 0.0, cos(request.sunZenith));
    request.casters = {randomPair(random, toSun, medium.radius.si)};
    if (unit(random) < 0.1) request.casters.push_back(randomPair(random, toSun, medium.radius.si));
    double const horizon =
        std::numbers::pi / 2.0 + std::acos(medium.radius / (medium.radius + request.altitude));
    for (int i = 0; i < 250; ++i) {
      // A half of them about the horizon.
      double const z = i % 2 ? std::acos(1.0 - 2.0 * unit(random))
                             : horizon + 1e-3 * (unit(random) - 0.5) * (i % 4 ? 1.0 : 100.0);
      request.directions.push_back({Angle(std::clamp(z, 0.0, std::numbers::pi)),
                                    Angle(2.0 * std::numbers::pi * unit(random))});
    }
    for (double light : sampler.sample(request)) {
      ASSERT_TRUE(std::isfinite(light)) << "after " << tried;
      ASSERT_GE(light, 0.0) << "after " << tried;
      largest = std::max(largest, light);
      dark += light == 0.0 ? 1 : 0;
    }
    tried += request.directions.size();
  }
  std::printf("%zu directions: none brighter than %.3g of E0 per sr, %zu values dark\n", tried,
              largest, dark);
  // The aureole's peak by aerosol, by far the brightest.
  EXPECT_LT(largest, 10.0);
}

// In a sealed umbra without air there is no light at all, up to the edge of the cone.
TEST_F(EclipseStability, NoLightInASealedUmbraWithoutAir) {
  std::vector<Length> const four{440.0 * nanometre, 500.0 * nanometre, 550.0 * nanometre,
                                 680.0 * nanometre};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  auto const probe =
      gl::Program::compute("bench/shadow_probe.comp", {{"SHADOW_PAIRS", "1"}, {"AIR_LAYERS", "1"}});
  int const eclipses = static_cast<int>(std::max<std::size_t>(wantedCases() / 500, 4));
  for (int eclipse = 0; eclipse < eclipses; ++eclipse) {
    glm::dvec3 const toSun = glm::normalize(glm::dvec3(unit(random), unit(random), 0.1));
    auto const pair =
        shadowPairMetres(toSun * astronomicalUnit.si, toSun * 3.6e8 * (1.0 + 0.02 * unit(random)),
                         {kSolarRadiusIau, 1737.4 * kilometre, 1737.4 * kilometre});
    BodyShadows const shadows({pair}, 1.0, LimbDarkeningLaw::Hestroffer, four, Length(6.4e6));
    glm::dvec3 const side = glm::normalize(glm::cross(pair.axis, glm::dvec3(0.0, 0.0, 1.0)));
    std::vector<glm::vec4> places;
    for (int i = 0; i < 500; ++i) {
      double const along = -6.3e6 * unit(random);
      double const umbra = pair.umbraRadius - along * pair.umbraTangent;
      // A float's place is uncertain by half a metre.
      double const distance = (umbra - 2.0) * std::sqrt(unit(random));
      places.emplace_back(glm::vec3(pair.foot + pair.axis * along + side * distance), 0.0f);
    }
    for (auto const& l : testsupport::lightAt(shadows, probe, places))
      ASSERT_EQ(l, glm::vec4(0.0f));
  }
}

}  // namespace
}  // namespace antumbra
