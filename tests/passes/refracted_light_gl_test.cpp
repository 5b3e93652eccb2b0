// Light in the Earth's shadow as the programs look it up, against the integral in doubles; and the
// join of a shadow with air to free sunlight.
#include "passes/refracted_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "passes/body_shadows.h"
#include "quantity/constants.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shadow_probe.h"

namespace antumbra {
namespace {

using RefractedLightGlTest = testsupport::GlTest;

TEST_F(RefractedLightGlTest, ProgramsReadTheLightOfTheShadow) {
  std::vector<Length> const four{444.0 * nanometre, 521.0 * nanometre, 571.0 * nanometre,
                                 632.0 * nanometre};
  Length const earth = 6371.0 * kilometre;
  // The Moon 2000 km off the axis, which runs through its own centre's neighbourhood.
  glm::dvec3 const toSun = glm::normalize(glm::dvec3(0.8, 0.1, 0.59));
  glm::dvec3 const foot(0.0, 1.2e6, -1.6e6);
  double const distance = 3.8e8;
  auto const pair = shadowPairMetres(foot + toSun * (astronomicalUnit.si + distance),
                                     foot + toSun * distance, {kSolarRadiusIau, earth, earth});
  Length const reach = 1737.4 * kilometre;
  BodyShadows const shadows({pair}, 1.0, LimbDarkeningLaw::Hestroffer, four, reach);
  Medium const medium = readMedium(mediumFile("earth"));
  auto const table = std::make_shared<RefractedShadowTable>(medium, earth, kSolarRadiusIau, four,
                                                            LimbDarkeningLaw::Hestroffer);
  RefractedLight light({table}, 4, reach);
  light.update({pair});
  auto const probe =
      gl::Program::compute("bench/shadow_probe.comp",
                           {{"SHADOW_PAIRS", "1"}, {"AIR_LAYERS", "1"}, {"REFRACTED_LIGHT", ""}});
  RefractedShadow const exact(medium, earth, four, LimbDarkeningLaw::Hestroffer);
  std::vector<glm::vec4> places;
  std::vector<std::array<double, 2>> stations;
  glm::dvec3 const side = glm::normalize(glm::cross(pair.axis, glm::dvec3(0.0, 0.0, 1.0)));
  for (double along : {-1.5e6, 0.0, 1.2e6})
    for (double rho = 10e3; rho < 9e6; rho += 150e3) {
      places.emplace_back(glm::vec3(pair.foot + pair.axis * along + side * rho), 0.0f);
      stations.push_back({along, rho});
    }
  light.bind();
  auto const found = testsupport::lightAt(shadows, probe, places);
  double worst = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ShadowStation const at{kSolarRadiusIau, astronomicalUnit,
                           Length(pair.casterBehind + stations[i][0])};
    auto const expected = exact.lightAt(at, Length(stations[i][1]));
    for (std::size_t k = 0; k < 4; ++k)
      worst = std::max(
          worst, std::fabs(static_cast<double>(found[i][static_cast<int>(k)]) / expected[k] - 1.0));
  }
  std::printf("within %.2e of the light from the axis to free sunlight\n", worst);
  // Straight lines between places 16 km apart where light falls by a factor of three in 100 km.
  EXPECT_LT(worst, 0.02);
}

}  // namespace
}  // namespace antumbra
