// Shadows of oblate planets against rays past the spheroid: light, and the place of the shadow's
// edge.
#include <gtest/gtest.h>

#include <cmath>

#include "document/input_error.h"
#include "eclipse/rays_to_sun.h"
#include "eclipse/shadow_pair.h"
#include "quantity/constants.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

struct Case {
  const char* name;
  double equatorialKm, polarKm;  // IAU WGCCRE 2015
  double sunAu;
  double behindKm;    // of the receiver, from the caster's centre
  double latitude;    // of the Sun over the caster's equator, degrees
  double lightLimit;  // of the whole Sun
};

TEST(OblateCaster, LightAndEdgesAgreeWithRays) {
  constexpr Length kGreen = 550.0 * nanometre;
  // A receiver at every side of the shadow, of a uniform and of a limb-darkened Sun. The last two
  // stand where the caster's disc is about the Sun's or smaller, where the ellipse is a circle only
  // in its mean.
  for (auto const name : {LimbDarkeningLaw::None, LimbDarkeningLaw::Hestroffer})
    for (const Case& c : {Case{"Saturn on its rings", 60268, 54364, 9.5, 9e4, 26.0, 2e-4},
                          Case{"Jupiter on Io", 71492, 66854, 5.2, 4.2e5, 3.0, 2e-4},
                          Case{"Jupiter on Callisto", 71492, 66854, 5.2, 1.88e6, 3.0, 2e-4},
                          Case{"Saturn on Iapetus", 60268, 54364, 9.5, 3.56e6, 15.0, 2e-4},
                          Case{"Earth on the Moon", 6378.1366, 6356.7519, 1.0, 3.84e5, 20.0, 2e-4},
                          Case{"Jupiter, the Sun's size", 71492, 66854, 5.2, 8.0e7, 3.0, 0.02},
                          Case{"Jupiter in transit", 71492, 66854, 5.2, 6.5e8, 3.0, 2e-3}}) {
      double const au = astronomicalUnit.si, tilt = c.latitude * M_PI / 180.0;
      glm::dvec3 const pole(std::sin(tilt), 0.0, std::cos(tilt)), centre(0.0);
      glm::dvec3 const sun(c.sunAu * au, 0.0, 0.0);
      double const flat = c.polarKm / c.equatorialKm, a = c.equatorialKm * 1e3;
      OpaqueSpheroid const body{centre, pole, a, a * flat};
      ShadowRadii const radii{kSolarRadiusIau, Length(a), Length(a)};
      auto const pair = shadowPairMetres(sun, centre, radii, {pole, flat});
      auto const sphere = shadowPairMetres(sun, centre, radii);
      auto const law = limbDarkening(name, {kGreen, kGreen, kGreen, kGreen});
      LimbProfile const profile = limbProfile(name, kGreen);
      bool const uniform = name == LimbDarkeningLaw::None;
      double worst = 0.0, worstSphere = 0.0, edge = 0.0, sphereEdge = 0.0;
      int partial = 0;
      for (int side = 0; side < 8; ++side) {
        double const turn = 2.0 * M_PI * (side + 0.3) / 8.0;
        glm::dvec3 const outward(0.0, std::cos(turn), std::sin(turn));
        glm::dvec3 const start(-c.behindKm * 1e3, 0.0, 0.0);
        auto const exact = [&](double r) {
          return visibleLightByRays(start + outward * r, sun, kSolarRadiusIau.si,
                                    std::span(&body, 1), profile, 3e-5);
        };
        double const width = kSolarRadiusIau.si / sun.x * c.behindKm * 1e3;
        // Where half of the Sun is left.
        auto const half = [&](auto const& light) {
          double low = 0.0, high = a + 2.0 * width;
          for (int i = 0; i < 24; ++i) {
            double const middle = 0.5 * (low + high);
            (light(middle) < 0.5 ? low : high) = middle;
          }
          return 0.5 * (low + high);
        };
        bool const small = width > 0.8 * a;  // there may be no such place
        double const there = small ? a * 0.5 * (1.0 + flat) : half(exact);
        // From one edge of the penumbra to the other.
        for (int i = 0; i < 9; ++i) {
          double const r = std::max(there + width * (i - 4) / 4.0, 0.0);
          double const expected = exact(r);
          double const found = glsl::visibleSunlight(pair, law, start + outward * r).x;
          partial += expected > 0.02 && expected < 0.98;
          worst = testsupport::larger(worst, std::fabs(found - expected));
          worstSphere = std::max(
              worstSphere,
              std::fabs(glsl::visibleSunlight(sphere, law, start + outward * r).x - expected));
          if (expected > 0.0) {
            EXPECT_TRUE(expected > 0.9999 || glsl::mayBeShaded(pair, start + outward * r, 0.0));
          }
        }
        if (small) continue;
        auto const by = [&](const glsl::ShadowPair& p) {
          return half(
              [&](double r) { return glsl::visibleSunlight(p, law, start + outward * r).x; });
        };
        edge = testsupport::larger(edge, std::fabs(by(pair) - there) * 1e-3);
        sphereEdge = testsupport::larger(sphereEdge, std::fabs(by(sphere) - there) * 1e-3);
      }
      std::printf(
          "%-24s %s light %.1e of the Sun (sphere %.2f), half-light edge %.3f km (sphere %.0f)\n",
          c.name, uniform ? "uniform " : "darkened", worst, worstSphere, edge, sphereEdge);
      EXPECT_LT(worst, uniform ? c.lightLimit : 2.0 * c.lightLimit) << c.name;
      EXPECT_GE(partial, 24) << c.name;
      // Bisection of 24 steps ends at 4 m of the giants' penumbras; 2e-4 of the light is 0.6 km of
      // the Earth's.
      EXPECT_LT(edge, uniform ? 0.02 : 0.6) << c.name;
      EXPECT_GT(worstSphere, 2.0 * worst) << c.name;
    }
}

TEST(OblateCaster, ASphereOfAnyPoleIsASphere) {
  ShadowRadii const radii{kSolarRadiusIau, 1e6 * metre, 1e6 * metre};
  glm::dvec3 const sun(1.5e11, 0, 0), caster(3e8, 2e5, 1e5), point(1e5, 1e6, -3e5);
  auto const law = limbDarkening(LimbDarkeningLaw::None, {});
  auto const plain = shadowPairMetres(sun, caster, radii);
  auto const tilted =
      shadowPairMetres(sun, caster, radii, {glm::normalize(glm::dvec3(1, 2, 3)), 1.0});
  EXPECT_EQ(glsl::visibleSunlight(plain, law, point).x,
            glsl::visibleSunlight(tilted, law, point).x);
  EXPECT_THROW(shadowPairMetres(sun, caster, radii, {{0, 0, 1}, 1.1}), InputError);
  EXPECT_THROW(shadowPairMetres(sun, caster, radii, {{0, 0, 1}, 0.0}), InputError);
}

}  // namespace
}  // namespace antumbra
