// Several bodies before the Sun at once, against rays past all of them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "eclipse/rays_to_sun.h"
#include "eclipse/shadow_pair.h"
#include "quantity/constants.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

constexpr double kSun = kSolarRadiusIau.si, kSunDistance = 7.78e11;

struct Sky {
  std::vector<OpaqueSpheroid> bodies;
  std::vector<glsl::ShadowPair> pairs;
};

// Moons of a giant planet whose discs lie about the Sun as seen from its surface, at every mutual
// distance; sizes from a tenth to three times the Sun's.
Sky randomSky(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Sky sky;
  for (int i = 0; i < count; ++i) {
    double const distance = (4.0 + 15.0 * unit(random)) * 1e8,
                 beam = distance * kSun / kSunDistance;
    double const radius =
        beam * (unit(random) < 0.7 ? 0.1 + 0.9 * unit(random) : 1.0 + 2.0 * unit(random));
    double const off = (beam + radius) * std::sqrt(unit(random)), turn = 2.0 * M_PI * unit(random);
    glm::dvec3 const centre(distance, off * std::cos(turn), off * std::sin(turn));
    sky.bodies.push_back({centre, {0, 0, 1}, radius, radius});
    sky.pairs.push_back(shadowPairMetres({kSunDistance, 0, 0}, centre,
                                         {kSolarRadiusIau, Length(radius), Length(radius)}));
  }
  return sky;
}

double worstOver(int count, int skies, LimbDarkeningLaw named, double* worstMinimum,
                 double* worstProduct) {
  std::mt19937 random(static_cast<unsigned>(100 * count + 7));
  auto const law = limbDarkening(
      named, {400.0 * nanometre, 550.0 * nanometre, 700.0 * nanometre, 900.0 * nanometre});
  LimbProfile const profile = limbProfile(named, 400.0 * nanometre);
  double worst = 0.0;
  for (int i = 0; i < skies; ++i) {
    Sky const sky = randomSky(random, count);
    double const expected =
        visibleLightByRays({0, 0, 0}, {kSunDistance, 0, 0}, kSun, sky.bodies, profile, 3e-5);
    double const found = visibleSunlight(sky.pairs, law, {0, 0, 0}).x;
    double least = 1.0, product = 1.0;
    for (auto const& pair : sky.pairs) {
      double const one = glsl::visibleSunlight(pair, law, glm::dvec3(0.0)).x;
      least = std::min(least, one);
      product *= one;
    }
    worst = testsupport::larger(worst, std::fabs(found - expected));
    *worstMinimum = std::max(*worstMinimum, std::fabs(least - expected));
    *worstProduct = std::max(*worstProduct, std::fabs(product - expected));
  }
  return worst;
}

TEST(SeveralCasters, HideTheUnionOfTheirDiscs) {
  for (auto law : {LimbDarkeningLaw::None, LimbDarkeningLaw::Hestroffer})
    for (int count : {2, 3, 4, 6}) {
      double minimum = 0.0, product = 0.0;
      double const worst = worstOver(count, 150, law, &minimum, &product);
      std::printf("%d casters, %s: union %.1e of the Sun, minimum %.2f, product %.2f\n", count,
                  law == LimbDarkeningLaw::None ? "uniform" : "limb-darkened", worst, minimum,
                  product);
      // The reference's own 2e-4 with these few rings, and 1e-4 of limb darkening along the arcs.
      EXPECT_LT(worst, 5e-4) << count;
      // The shortcuts are wrong by more than can be overlooked, or this test tests nothing.
      EXPECT_GT(minimum, 0.05);
      EXPECT_GT(product, 0.02);
    }
}

TEST(SeveralCasters, ClosedFormsOfTheUniformDisc) {
  // Exact: nested, equal, disjoint, and the lens of two halves.
  auto const none = limbDarkening(LimbDarkeningLaw::None, {});
  auto disc = [](glsl::SunCover cover, double radius, double away, double turn) {
    glsl::DiscPair d;
    d.sun = 1e-3;
    d.excess = (radius - 1.0) * 1e-3;
    d.gap = (away - (radius - 1.0)) * 1e-3;
    return glsl::withDisc(cover, d, turn);
  };
  auto light = [&](const glsl::SunCover& cover) {
    return glsl::visibleFractionOfUnion(cover, none).x;
  };
  auto const one = disc(glsl::noCover(), 0.5, 0.1, 0.3);
  EXPECT_NEAR(light(disc(one, 0.2, 0.1, 0.3)), 0.75, 1e-12);  // inside the first
  EXPECT_NEAR(light(disc(one, 0.5, 0.1, 0.3)), 0.75, 1e-12);  // the same disc twice
  EXPECT_NEAR(light(disc(disc(glsl::noCover(), 0.3, 0.5, 0.0), 0.3, 0.5, 2.5)), 1.0 - 0.18, 1e-12);
  // Three quarters of the Sun behind two straight limbs at right angles through its centre.
  EXPECT_NEAR(light(disc(disc(glsl::noCover(), 1000.0, 1000.0, 0.0), 1000.0, 1000.0, M_PI / 2)),
              0.25, 1e-3);
  EXPECT_EQ(light(disc(one, 1.3, 0.1, 2.0)), 0.0);  // total behind the second
}

TEST(SeveralCasters, FollowTheSingleCasterWhereOnlyOneCovers) {
  auto const law =
      limbDarkening(LimbDarkeningLaw::Hestroffer,
                    {400.0 * nanometre, 500.0 * nanometre, 600.0 * nanometre, 700.0 * nanometre});
  for (double radius : {0.05, 0.3, 0.9, 1.0, 1.5, 40.0})
    for (double gap : {0.02, 0.1, 0.4, 0.9, 1.5, 1.98}) {
      glsl::DiscPair d;
      d.sun = 1e-3;
      d.excess = (radius - 1.0) * 1e-3;
      d.gap = gap * 1e-3;
      if (d.gap + d.excess < 0.0) continue;
      auto const cover = glsl::withDisc(glsl::noCover(), d, 1.0);
      auto const expected = glsl::visibleFraction(d, law);
      auto const found = glsl::visibleFractionOfUnion(cover, law);
      for (int c = 0; c < 4; ++c) EXPECT_NEAR(found[c], expected[c], 2e-4) << radius << " " << gap;
    }
}

}  // namespace
}  // namespace antumbra
