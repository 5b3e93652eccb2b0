// The corona's profile against published totals, and its shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/as_cpp.h"

namespace antumbra {
namespace {

// Baumbach's formula, written out with pow.
double baumbach(double r) {
  return 1e-6 *
         (2.565 * std::pow(r, -17.0) + 1.425 * std::pow(r, -7.0) + 0.0532 * std::pow(r, -2.5));
}

TEST(Corona, FollowsBaumbachWhereItIsRound) {
  for (double r : {1.0, 1.03, 1.2, 1.5, 2.0, 3.0, 5.0, 20.0})
    EXPECT_NEAR(glsl::coronaBrightness(r, 0.3, 0.0) / baumbach(r), 1.0, 1e-12) << r;
}

// Allen 1973, section 84: the corona beyond 1.03 radii sends 1.3e-6 (maximum) to 0.8e-6 (minimum)
// of the Sun's light; about half of a full Moon's 2.1e-6. In units of the centre, the Sun sends pi
// times 0.81 (mean over centre at 558 nm).
TEST(Corona, SendsAMillionthOfTheSunsLight) {
  double sum = 0.0;
  double const step = 1e-3;
  for (double r = 1.03 + step / 2; r < 20.0; r += step)
    sum += 2.0 * std::numbers::pi * r * step * glsl::coronaBrightness(r, 0.0, 0.0);
  double const share = sum / (std::numbers::pi * 0.81);
  EXPECT_GT(share, 0.8e-6);
  EXPECT_LT(share, 1.3e-6);
}

TEST(Corona, ShareIsTheProfilesIntegral) {
  for (double from : {1.0, 1.03, 1.5}) {
    double sum = 0.0;
    double const step = 1e-4;
    for (double r = from + step / 2; r < 10.0; r += step)
      sum += 2.0 * r * step * glsl::coronaBrightness(r, 0.0, 0.0) * 1.24;
    EXPECT_NEAR(glsl::coronaShareBetween(from, 10.0, 1.24) / sum, 1.0, 1e-5) << from;
  }
}

// Radius at which the K corona has `level`, by bisection.
double isophote(double level, double sineLatitude, double flattening) {
  double low = 1.0, high = 10.0;
  for (int i = 0; i < 60; ++i) {
    double const middle = 0.5 * (low + high);
    double const k =
        glsl::coronaBrightness(middle, sineLatitude, flattening) - glsl::dustCorona(middle);
    (k > level ? low : high) = middle;
  }
  return low;
}

TEST(Corona, HasLudendorffsFlatteningAtTwoRadii) {
  for (double activity : {0.0, 0.5, 1.0}) {
    double const flattening = glsl::flatteningOfActivity(activity);
    // The isophote that crosses the poles just outside 2 radii.
    double const level = glsl::electronCorona(2.35);
    double const ratio = isophote(level, 0.0, flattening) / isophote(level, 1.0, flattening);
    EXPECT_NEAR(ratio - 1.0, flattening, 1e-9) << activity;
    // At the limb it is round.
    EXPECT_EQ(glsl::coronaBrightness(1.0, 0.0, flattening),
              glsl::coronaBrightness(1.0, 1.0, flattening));
  }
  EXPECT_NEAR(glsl::flatteningOfActivity(0.0), 0.30, 1e-12);
  EXPECT_NEAR(glsl::flatteningOfActivity(1.0), 0.05, 1e-12);
}

TEST(Corona, FallsOutwardEverywhere) {
  for (double sine : {0.0, 0.5, 1.0}) {
    double last = 1.0;
    for (double r = 1.0; r < 45.0; r *= 1.01) {
      double const now = glsl::coronaBrightness(r, sine, 0.30);
      EXPECT_LT(now, last) << r << " " << sine;
      last = now;
    }
  }
}

// Mean over an interval times its width against a sum of thin ones.
TEST(Chromosphere, MeansAddUp) {
  double sum = 0.0;
  for (int i = 0; i < 200; ++i)
    sum += glsl::chromosphereBetween(0.99 + i * 1e-4, 0.99 + (i + 1) * 1e-4) * 1e-4;
  EXPECT_NEAR(sum / (glsl::chromosphereBetween(0.99, 1.01) * 0.02), 1.0, 1e-9);
  EXPECT_NEAR(glsl::chromosphereBetween(1.0, 1.0 + 1e-7), glsl::kChromosphereBase,
              1e-4 * glsl::kChromosphereBase);
  EXPECT_NEAR(glsl::luminanceOfColour(glsl::chromosphereColour()), 1.0, 0.01);
}

// Invented structure leaves the measured mean alone, and light positive.
TEST(Corona, StructureKeepsTheMeanAtEveryDistance) {
  for (double activity : {0.0, 0.5, 1.0})
    for (double r : {1.0, 1.05, 1.3, 2.0, 2.5, 4.0, 10.0}) {
      double sum = 0.0, least = 1.0, most = 1.0;
      constexpr int kSteps = 7200;
      for (int i = 0; i < kSteps; ++i) {
        double const f = glsl::coronaStructure(r, 2.0 * std::numbers::pi * i / kSteps, activity);
        sum += f / kSteps;
        least = std::min(least, f);
        most = std::max(most, f);
      }
      EXPECT_NEAR(sum, 1.0, 1e-3) << r << ", activity " << activity;
      EXPECT_GT(least, 0.0) << r << ", activity " << activity;
      EXPECT_LT(most, 6.0) << r << ", activity " << activity;
    }
}

// Streamers gather at the equator at minimum and lie at all latitudes at maximum.
TEST(Corona, StructureFollowsTheCycle) {
  auto const share = [](double activity) {
    double equator = 0.0, all = 0.0;
    for (double a = 0.0; a < 2.0 * std::numbers::pi; a += 1e-3) {
      double const f = glsl::coronaStructure(2.0, a, activity);
      all += f;
      if (std::fabs(std::sin(a)) < 0.5) equator += f;
    }
    return equator / all;
  };
  EXPECT_GT(share(0.0), share(1.0) + 0.1);
}

TEST(Corona, ProminencesStandOnTheLimb) {
  double brightest = 0.0;
  for (double a = 0.0; a < 2.0 * std::numbers::pi; a += 1e-3) {
    brightest = std::max(brightest, glsl::prominences(0.02, a, 7));
    EXPECT_LT(glsl::prominences(0.2, a, 24), 1e-9);
    EXPECT_EQ(glsl::prominences(0.02, a, 0), 0.0);
  }
  EXPECT_GT(brightest, 0.3 * glsl::kProminence);
  EXPECT_LT(brightest, 3.0 * glsl::kProminence);
}

}  // namespace
}  // namespace antumbra
