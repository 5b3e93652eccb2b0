// The corona's light past the body that covers the Sun: against sums over the sky about that body's
// centre, published totals, and through second contact.
#include "eclipse/corona_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "document/input_error.h"
#include "eclipse/shadow_pair.h"
#include "quantity/constants.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

constexpr LimbDarkeningLaw kLaw = LimbDarkeningLaw::Hestroffer;
constexpr double kTurn = 2.0 * std::numbers::pi;

// Rings about the disc's centre, which stands `separation` from the Sun's toward `positionAngle`
// from the solar equator; the drawn profile with its flattening at every point.
double sumAroundDisc(double activity, double ratio, double separation, double positionAngle) {
  glm::dvec4 const unit = glsl::solarBrightness(
      limbDarkening(kLaw,
                    {558.0 * nanometre, 558.0 * nanometre, 558.0 * nanometre, 558.0 * nanometre}),
      1.0);
  double const flattening = glsl::flatteningOfActivity(activity);
  constexpr int kRings = 1500, kSpokes = 360;
  double const outermost = glsl::kCoronaEnd + separation;
  double const step = std::log(outermost / ratio) / kRings;
  double sum = 0.0;
  for (int ring = 0; ring < kRings; ++ring) {
    double const s = ratio * std::exp(step * (ring + 0.5));
    double mean = 0.0;
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      double const turn = kTurn * (spoke + 0.5) / kSpokes;
      double const x = separation * std::cos(positionAngle) + s * std::cos(turn);
      double const y = separation * std::sin(positionAngle) + s * std::sin(turn);
      double const r = std::hypot(x, y);
      if (r < 1.0) continue;
      mean += glsl::coronaBrightness(r, y / r, flattening) * glsl::coronaFade(r) / kSpokes;
    }
    sum += 2.0 * s * s * step * mean;
  }
  return sum * unit.x;
}

// From Moons and from Jupiter's Io (five times the Sun) and the Earth on its Moon, total and
// central or not. The round mean stands for every position angle; at the minimum of the cycle it
// errs most.
TEST(CoronaLight, IsTheSumOverTheSkyAroundTheDisc) {
  struct Case {
    double ratio, separation, tolerance;
  };
  for (double activity : {0.0, 1.0}) {
    CoronaLight const corona(activity, kLaw);
    for (auto const& c : {Case{1.0515, 0.0, 5e-5}, Case{1.0515, 0.03, 1e-3},
                          Case{1.0515, 0.05, 2e-3}, Case{1.08, 0.078, 2e-3}, Case{1.0, 0.0, 1e-3},
                          Case{3.5, 0.0, 1e-4}, Case{3.5, 2.4, 0.15}, Case{6.0, 4.9, 0.15}}) {
      double const found = corona.past(c.ratio, c.separation);
      double worst = 0.0;
      for (double angle : {0.0, 0.5 * std::numbers::pi, 0.7})
        worst = testsupport::larger(
            worst, std::fabs(found / sumAroundDisc(activity, c.ratio, c.separation, angle) - 1.0));
      std::printf("activity %.0f, ratio %.4f, %.3f off: %.4e of the Sun, within %.1e\n", activity,
                  c.ratio, c.separation, found, worst);
      EXPECT_LT(worst, c.tolerance) << activity << " " << c.ratio << " " << c.separation;
    }
  }
}

// Partial and annular discs hide what lies behind them: sums over the sky minus the disc.
TEST(CoronaLight, HoldsWhereTheSunIsPartlySeen) {
  CoronaLight const corona(1.0, kLaw);
  EXPECT_NEAR(corona.past(0.95, 0.02) / corona.whole(), 1.0, 1e-12);
  EXPECT_NEAR(corona.past(1.05, 60.0) / corona.whole(), 1.0, 1e-12);
  for (double separation : {0.5, 1.0, 1.04, 1.06, 2.0}) {
    double const found = corona.past(1.05, separation);
    double const sum = sumAroundDisc(1.0, 1.05, separation, 0.7);
    // Rings cross the Sun's limb, where the profile begins: 0.5 % of the sum.
    EXPECT_NEAR(found / sum, 1.0, 6e-3) << separation;
  }
}

// Allen 1973, section 84: beyond 1.03 radii 1.3e-6 (maximum) to 0.8e-6 (minimum) of the Sun. And
// the closed form of the round profile, with the zodiacal light's end at 37 radii for the fade.
TEST(CoronaLight, HasThePublishedTotal) {
  double const centreOverMean =
      glsl::solarBrightness(limbDarkening(kLaw, {558.0 * nanometre, 558.0 * nanometre,
                                                 558.0 * nanometre, 558.0 * nanometre}),
                            1.0)
          .x;
  for (double activity : {0.0, 0.5, 1.0}) {
    double const share = CoronaLight(activity, kLaw).past(1.03, 0.0);
    std::printf("activity %.1f: %.4e of the Sun beyond 1.03 radii\n", activity, share);
    EXPECT_GT(share, 0.8e-6);
    EXPECT_LT(share, 1.3e-6);
    // The flattened one sends 0.1 to 2.1 % more.
    EXPECT_NEAR(share / glsl::coronaShareBetween(1.03, 37.0, centreOverMean), 1.0, 0.025);
  }
  EXPECT_THROW(CoronaLight(1.5, kLaw), InputError);
  EXPECT_THROW(CoronaLight(std::nan(""), kLaw), InputError);
}

glsl::ShadowPair pairOf(double casterRadius, double casterDistance, double sunDistance) {
  glm::dvec3 const toSun = glm::normalize(glm::dvec3(0.8, 0.1, 0.59));
  glm::dvec3 const foot(0.0, 2.0e6, 1.0e6);
  return shadowPairMetres(foot + toSun * sunDistance, foot + toSun * casterDistance,
                          {kSolarRadiusIau, Length(casterRadius), Length(casterRadius)});
}

double fitted(const glsl::CoronaFit& fit, double along, double reach, double share) {
  return std::exp2(glsl::coronaPastCaster(fit, glsl::shareAlongAxis(along, reach), share * share));
}

TEST(CoronaLight, FitsAllOfAnUmbra) {
  struct Case {
    const char* name;
    double casterRadius, casterDistance, sunDistance, reach, tolerance;
  };
  CoronaLight const corona(0.5, kLaw);
  for (auto const& c : {Case{"Moon near on the Earth", 1737.4e3, 3.57e8, 1.521e11, 6.46e6, 1e-4},
                        Case{"Moon on the Earth", 1737.4e3, 3.66e8, 1.496e11, 6.46e6, 1e-4},
                        Case{"hybrid", 1737.4e3, 3.745e8, 1.496e11, 6.46e6, 0.02},
                        Case{"annular", 1737.4e3, 4.0e8, 1.496e11, 6.46e6, 0.02},
                        Case{"Io on Jupiter", 1821.5e3, 4.2e8, 7.78e11, 7.15e7, 0.25},
                        Case{"Earth on the Moon", 6371.0e3, 3.84e8, 1.496e11, 1.74e6, 0.1}}) {
    auto const pair = pairOf(c.casterRadius, c.casterDistance, c.sunDistance);
    auto const fit = corona.fit(pair, Length(c.reach));
    double worst = 0.0, least = 1.0, most = 0.0;
    for (double along = -c.reach; along <= 0.25 * c.reach; along += c.reach / 16.0)
      for (double share = 0.0; share <= 1.0; share += 1.0 / 32.0) {
        double const umbra = glsl::umbraRadiusAt(pair, along);
        double const exact = corona.past(glsl::discsAt(pair, along, share * std::max(umbra, 0.0)));
        double const found = fitted(fit, along, c.reach, umbra > 0.0 ? share : 1.0);
        worst = testsupport::larger(worst, std::fabs(std::log(found / exact)));
        least = std::min(least, exact), most = std::max(most, exact);
      }
    std::printf("%s: %.3e to %.3e of the Sun, within a factor of 1 + %.1e\n", c.name, least, most,
                std::expm1(worst));
    EXPECT_LT(std::expm1(worst), c.tolerance) << c.name;
  }
}

// Seconds about second contact (the Moon gains about 0.4 arcsec, 4.2e-4 solar radii, a second): the
// light as programs have it, which keeps the umbra's edge value of the corona beyond it.
TEST(CoronaLight, HasNoStepAtSecondContact) {
  CoronaLight const corona(0.5, kLaw);
  auto const pair = pairOf(1737.4e3, 3.66e8, 1.496e11);
  double const reach = 6.46e6, along = -1.0e6;
  auto const fit = corona.fit(pair, Length(reach));
  auto const law = limbDarkening(
      kLaw, {558.0 * nanometre, 558.0 * nanometre, 558.0 * nanometre, 558.0 * nanometre});
  double const umbra = glsl::umbraRadiusAt(pair, along);
  auto const lights = [&](double metresOutside) {
    double const distance = umbra + metresOutside;
    auto const discs = glsl::discsAt(pair, along, distance);
    double const disc = glsl::visibleFraction(discs, law).x;
    double const share = std::min(distance / umbra, 1.0);
    return std::pair(disc + fitted(fit, along, reach, share), disc + corona.past(discs));
  };
  double worst = 0.0, largestStep = 0.0;
  double last = lights(-2000.0).first;
  // 1 m is 1.3 ms of an umbra at 0.75 km/s.
  for (double outside = -2000.0; outside <= 20000.0; outside += 1.0) {
    auto const [drawn, exact] = lights(outside);
    worst = testsupport::larger(worst, std::fabs(drawn / exact - 1.0));
    if (outside < 100.0) largestStep = testsupport::larger(largestStep, std::fabs(drawn - last));
    last = drawn;
  }
  std::printf("light about C2: within %.1e, steps of at most %.1e of the Sun in 1.3 ms\n", worst,
              largestStep);
  EXPECT_LT(worst, 1e-4);
  // Half a hundredth of the corona, which is what the crescent itself grows by.
  EXPECT_LT(largestStep, 5e-9);
  EXPECT_GT(lights(-10.0).first, 0.8e-6);
}

}  // namespace
}  // namespace antumbra
