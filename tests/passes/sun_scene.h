// The Sun and a Moon for the tests of the passes.
#pragma once

#include "eclipse/limb_darkening.h"
#include "passes/sun_plane.h"

namespace antumbra::testsupport {

// At 1 au with E490 sunlight in linear sRGB (tests/passes/sun_gl_test.cpp integrates the spectrum).
inline SunInView sunAt(glm::dvec3 direction) {
  SunInView sun;
  sun.centre = {glm::normalize(direction) * astronomicalUnit.si};
  sun.north = {{0.0, 1.0, 0.0}};
  sun.illuminanceLux = {146606.0, 130138.0, 125651.0};
  sun.law = limbDarkening(LimbDarkeningLaw::Hestroffer, kSolarChannels);
  return sun;
}

// A sphere 3.7e8 m away whose angular radius is `ratio` times the Sun's, displaced by `offset`
// solar radii (angles) along the plane's axes.
inline SpheroidInView moonBefore(const SunInView& sun, double ratio, glm::dvec2 offset) {
  SunPlane const plane(sun);
  double const radius = plane.angularRadius().si;
  double const away = glm::length(offset) * radius;
  glm::dvec3 const side =
      away > 0.0 ? glm::normalize(offset.x * plane.across().u + offset.y * plane.up().u)
                 : glm::dvec3(0.0);
  glm::dvec3 const direction = std::cos(away) * plane.centre().u + std::sin(away) * side;
  double const distance = 3.7e8;
  Length const r = std::sin(ratio * radius) * distance * metre;
  return {{distance * direction}, {{0.0, 1.0, 0.0}}, r, r};
}

}  // namespace antumbra::testsupport
