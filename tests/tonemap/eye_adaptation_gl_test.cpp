// The adapting eye: its pigments against a plain integration of their equations, its dark
// adaptation against measured curves, continuity through an eclipse, and what rods do to colours.
#include "tonemap/eye_adaptation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "photometry/colour.h"
#include "photometry/standard_spectra.h"
#include "shared/as_cpp.h"

namespace antumbra {
namespace {

MeterReading uniform(double luminance) {
  MeterReading reading;
  reading.meanLuminance = reading.highLuminance = luminance;
  reading.black = luminance <= kMeterFloor;
  return reading;
}

EyeState inTheDark(EyeState eye, double seconds) {
  return adaptedEye(eye, uniform(kMeterFloor), uniform(kMeterFloor), Duration(seconds));
}

// Euler's steps of 5 ms through light that falls by a factor of a thousand in a minute.
TEST(EyeAdaptation, PigmentsFollowTheirEquations) {
  auto const luminanceAt = [](double t) { return 8000.0 * std::pow(1e-3, t / 60.0); };
  EyeState const eye =
      adaptedEye(steadyEye(uniform(8000.0)), uniform(8000.0), uniform(8.0), Duration(60.0));
  EyeState start = steadyEye(uniform(8000.0));
  double cones = start.conePigment, rods = start.rodPigment;
  for (double t = 0.0; t < 60.0; t += 0.005) {
    double const l = luminanceAt(t);
    double const d = 4.9 - 3.0 * std::tanh(0.4 * std::log10(l * 0.31416));
    double const td = l * M_PI * d * d / 4.0;
    cones += 0.005 * (1.0 - cones - cones * td / 19953.0) / 120.0;
    rods += 0.005 * (1.0 - rods - rods * 2.0 * td / 25119.0) / 400.0;
  }
  EXPECT_NEAR(eye.conePigment, cones, 2e-3);
  EXPECT_NEAR(eye.rodPigment, rods, 2e-3);
}

// Hecht, Haig & Chase 1937 (J. Gen. Physiol. 20, 831): after bright light the threshold falls with
// the cones, rods take over between 3 and 15 minutes and come near their best after 30 to 40.
TEST(EyeAdaptation, DarkensInMinutesAsMeasured) {
  EyeState eye = steadyEye(uniform(10000.0));
  double breakMinutes = 0.0;
  for (int half = 1; half <= 80; ++half) {
    eye = inTheDark(eye, 30.0);
    if (breakMinutes == 0.0 && rodThreshold(eye) < coneThreshold(eye)) breakMinutes = 0.5 * half;
  }
  EXPECT_GT(breakMinutes, 3.0);
  EXPECT_LT(breakMinutes, 15.0);
  EXPECT_LT(rodThreshold(eye), 3e-6);  // after 40 minutes within half a power of ten of 1e-6
  // After dim light there is no break to wait for.
  EyeState const dusk = inTheDark(steadyEye(uniform(1.0)), 60.0);
  EXPECT_LT(rodThreshold(dusk), coneThreshold(dusk));
}

TEST(EyeAdaptation, LightAdaptationTakesSeconds) {
  EyeState const dark = steadyEye(uniform(1e-3));
  EyeState const after = adaptedEye(dark, uniform(3000.0), uniform(3000.0), Duration(3.0));
  double const wanted = steadyEye(uniform(3000.0)).whiteLuminance;
  EXPECT_NEAR(std::log2(after.whiteLuminance / wanted), 0.0, 0.1);
}

// Light as it falls into totality: by a thousand in the last half minute. Nothing pops: a tenth of
// a second changes the white by less than a tenth, and never against the light.
TEST(EyeAdaptation, IsContinuousThroughTheSecondContact) {
  auto const light = [](double t) {  // t seconds to the second contact
    return uniform(t > 0.0 ? 3000.0 * std::pow(1e-3, std::exp(-t / 15.0)) : 3.0);
  };
  EyeState eye = steadyEye(light(300.0));
  for (double t = 300.0; t > -120.0; t -= 0.1) {
    EyeState const next = adaptedEye(eye, light(t), light(t - 0.1), Duration(0.1));
    ASSERT_LT(std::fabs(std::log(next.whiteLuminance / eye.whiteLuminance)), 0.1) << t;
    ASSERT_LE(next.whiteLuminance, eye.whiteLuminance * (1.0 + 1e-9)) << t;
    eye = next;
  }
}

// The state after a track does not depend on how finely it is stepped, to 3 %.
TEST(EyeAdaptation, TracksOfAnySpacingAgree) {
  auto const light = [](double before) { return uniform(3.0 + 3000.0 * (before > 60.0)); };
  auto const stateOf = [&](double step) {
    std::vector<TrackedReading> track;
    for (double t = 1200.0; t > -1e-9; t -= step) track.push_back({Duration(t), light(t)});
    return eyeAfter(track);
  };
  EyeState const coarse = stateOf(5.0), fine = stateOf(0.5);
  EXPECT_NEAR(coarse.conePigment, fine.conePigment, 0.01);
  EXPECT_NEAR(std::log(coarse.whiteLuminance / fine.whiteLuminance), 0.0, 0.03);
}

// Light of the dome into totality: a thin crescent's grows as the 1.5th power of its width, on top
// of 3 cd/m2.
double lightAt(double secondsToContact) {
  return 3.0 + 8000.0 * std::pow(std::clamp(secondsToContact / 4000.0, 0.0, 1.0), 1.5);
}

EyeState trackedEye(const std::vector<double>& times, double contact) {
  std::vector<TrackedReading> track;
  for (double t : times)
    track.push_back({Duration(times.back() - t), uniform(lightAt(contact - t))});
  return eyeAfter(track);
}

// What an off-line picture meters is enough, and changes smoothly from one picture to the next: at
// ten a second the white moves as with a reading every 0.05 s.
TEST(EyeAdaptation, MeteredInstantsAreEnoughAndDoNotPop) {
  double const contact = 86400.0 * 365.0 + 0.37;
  double worst = 0.0, largest = 0.0, before = 0.0, steepest = 0.0, steepBefore = 0.0;
  for (double now = contact - 60.0; now < contact + 40.0; now += 0.1) {
    std::vector<double> dense;
    for (int i = 36000; i >= 0; --i) dense.push_back(now - 0.05 * i);
    double const white = trackedEye(meteredSeconds(now), contact).whiteLuminance;
    // The dense track is lived through once.
    static EyeState eye = trackedEye(dense, contact);
    static double last = now;
    for (double t = last; t < now - 1e-9; t += 0.05)
      eye = adaptedEye(eye, uniform(lightAt(contact - t)), uniform(lightAt(contact - t - 0.05)),
                       Duration(0.05));
    last = now;
    worst = std::max(worst, std::fabs(std::log(white / eye.whiteLuminance)));
    if (before > 0.0) {
      largest = std::max(largest, std::fabs(std::log(white / before)));
      steepest = std::max(steepest, std::fabs(std::log(eye.whiteLuminance / steepBefore)));
    }
    before = white;
    steepBefore = eye.whiteLuminance;
  }
  RecordProperty("worst_percent", std::to_string(100.0 * worst));
  EXPECT_LT(worst, 0.005);
  EXPECT_LT(largest, steepest + 0.01) << steepest;
}

TEST(EyeAdaptation, PicturesNearInTimeShareTheirMeteredInstants) {
  auto const a = meteredSeconds(1000.3), b = meteredSeconds(1001.3);
  EXPECT_DOUBLE_EQ(a.back(), 1000.3);
  EXPECT_LE(a.front(), 1000.3 - 1200.0);
  EXPECT_GE(a.front(), 1000.3 - 1800.0);
  EXPECT_TRUE(std::is_sorted(a.begin(), a.end()));
  EXPECT_LE(a.size(), 26u);
  int fresh = 0;
  for (double t : b) fresh += std::find(a.begin(), a.end(), t) == a.end();
  EXPECT_LE(fresh, 6);
}

TEST(NightVision, RodsSeeSunlightAsTheSpectraSay) {
  glm::dvec3 const xyz = xyzOfRelativeRadiance([](Length) { return 1.0; });
  double const scotopic = scotopicOfRelativeRadiance([](Length) { return 1.0; });
  double const found = glsl::rodLuminance(linearSrgbFromXyz(xyz));
  // The published fit from XYZ: 10 %.
  EXPECT_NEAR(found / (scotopic * 683.0 / 1700.0), 1.0, 0.1);
}

TEST(NightVision, BlueGainsAndRedLosesInTheDarkAlone) {
  auto const luminance = [](glm::dvec3 c) { return glsl::luminanceOfColour(c); };
  glm::dvec3 const red = glm::dvec3(1.0, 0.1, 0.05) / luminance({1.0, 0.1, 0.05});
  glm::dvec3 const blue = glm::dvec3(0.1, 0.3, 1.0) / luminance({0.1, 0.3, 1.0});
  double const dark = 1e-3;
  glm::dvec3 const seenRed = glsl::nightColour(red * dark, 1e-6);
  glm::dvec3 const seenBlue = glsl::nightColour(blue * dark, 1e-6);
  EXPECT_GT(luminance(seenBlue) / luminance(seenRed), 3.0);
  // No colour is left: both have the rods' own.
  EXPECT_NEAR(seenRed.r / seenRed.b, seenBlue.r / seenBlue.b, 0.05);
  // By day nothing changes; nor where the rods are still bleached.
  EXPECT_NEAR(luminance(glsl::nightColour(red * 10.0, 1e-6)), 10.0, 1e-9);
  EXPECT_NEAR(luminance(glsl::nightColour(red * dark, 10.0)) / dark, 1.0, 1e-3);
}

}  // namespace
}  // namespace antumbra
