// Sunlight bent by the air, against rays followed through their differential equation.
#include "atmosphere/bent_sunlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/ray_equation.h"

namespace antumbra {
namespace {

using testsupport::RayEquation;

Medium catalogue(const std::string& name) { return readMedium(mediumFile(name)); }

BentSunlight tableOf(const Medium& medium, Length wavelength) {
  BentColour colour{medium.refractivity.at(wavelength), {}};
  for (auto const& c : medium.constituents)
    colour.extinction.push_back(c.scattering.at(wavelength) + c.absorption.at(wavelength));
  return BentSunlight(medium, medium.radius, Length(0.0), {colour});
}

// Mean over 20' of apparent zenith angle, two thirds of the Sun: profiles of straight pieces have
// thinning with peaks of some arc seconds at their ends, real for them but no matter for a disc.
TEST(BentSunlight, FollowsTheRayEquation) {
  constexpr double span = 20.0 * M_PI / 10800.0;
  constexpr int pieces = 8, points = 200;
  for (std::string const name : {"earth", "earth_high_site", "mars"})
    for (Length const wavelength : {450.0 * nanometre, 680.0 * nanometre}) {
      Medium const medium = catalogue(name);
      RayEquation const rays(medium, wavelength);
      BentSunlight const table = tableOf(medium, wavelength);
      double worst = 0.0, sum = 0.0, worstLift = 0.0;
      int count = 0;
      for (double height : {0.0, 1.1e3, 4.7e3, 12.3e3, 21e3, 38e3, 77e3}) {
        double const n = rays.index(height);
        double const end =
            0.5 * M_PI + std::acos(medium.radius.si / (medium.radius.si + height)) - 1.02 * span;
        for (double x = 0.0; x <= 1.0; x += 0.1) {
          // From 70 degrees to the ground's horizon, densest there.
          double const from = end - (1.0 - x) * (1.0 - x) * (end - 70.0 * degree.si);
          double energy = 0.0, first = 0.0, last = 0.0;
          bool clear = true;
          for (int k = 0; k <= pieces && clear; ++k) {
            double const i = from + span * k / pieces, half = 0.5 * span / pieces;
            auto const edge = rays.from(height, i);
            auto const middle = k < pieces ? rays.from(height, i + half) : edge;
            clear = edge && middle;
            if (!clear) break;
            (k == 0 ? first : last) = edge->trueZenith;
            worstLift =
                std::max(worstLift, std::fabs(edge->trueZenith - i -
                                              table.lift(0, height, std::cos(edge->trueZenith))));
            if (k < pieces)
              energy += n * n * (std::cos(i) - std::cos(i + 2.0 * half)) * std::exp(-middle->depth);
          }
          if (!clear) continue;
          double const expected = energy / (std::cos(first) - std::cos(last));
          if (expected < 1e-4) continue;
          double found = 0.0;
          for (int k = 0; k < points; ++k)
            found += std::exp(-table.depth(0, height,
                                           std::cos(first + (last - first) * (k + 0.5) / points))) /
                     points;
          worst = std::max(worst, std::fabs(found - expected));
          sum += std::fabs(found / expected - 1.0);
          ++count;
        }
      }
      std::printf(
          "%-16s %3.0f nm: mean %.3f %%, worst %.4f of the free Sun's light, direction %.3f'\n",
          name.c_str(), wavelength / nanometre, 100.0 * sum / count, worst,
          worstLift * 10800.0 / M_PI);
      ASSERT_GT(count, 50);
      // The two methods differ by their steps; of light down to 1e-4.
      EXPECT_LT(sum / count, 0.002) << name;
      EXPECT_LT(worst, 0.004) << name;
      EXPECT_LT(worstLift, 0.25 * arcminute.si) << name;
    }
}

// Where the horizon's ray comes from: 34' by almanacs (Meeus, Astronomical Algorithms, ch. 16) at
// 10 degrees and 1010 hPa; the standard air at 15 degrees is 2 % thinner.
TEST(BentSunlight, LiftsTheHorizonAsAlmanacsSay) {
  Medium const medium = catalogue("earth");
  BentSunlight const table = tableOf(medium, 550.0 * nanometre);
  double const lift = (std::acos(table.horizonCosine(0, 0.0)) - 0.5 * M_PI) * 10800.0 / M_PI;
  std::printf("refraction at the horizon %.2f'\n", lift);
  EXPECT_NEAR(lift, 34.0, 1.5);
}

TEST(BentSunlight, LeavesMediaWithoutRefractionAlone) {
  for (std::string const name : {"reference_bruneton2017", "reference_kider2013", "titan", "venus"})
    EXPECT_FALSE(BentSunlight::bends(catalogue(name), catalogue(name).radius)) << name;
  Medium venus = catalogue("venus");
  // n - 1 of 93 bar of carbon dioxide: rays circle, so that none is followed.
  venus.refractivity = Spectrum(0.015);
  venus.refractingConstituent = venus.constituents.front().name;
  EXPECT_FALSE(BentSunlight::bends(venus, venus.radius));
}

}  // namespace
}  // namespace antumbra
