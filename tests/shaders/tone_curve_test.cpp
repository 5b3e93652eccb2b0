// The tone curve and the colours it leaves: shape, order, hue, limits.
#include <gtest/gtest.h>

#include <cmath>

#include "shared/as_cpp.h"

namespace antumbra {
namespace {

using glm::dvec3;

TEST(ToneCurve, IsTheIdentityBelowItsKneeAndSmoothThere) {
  EXPECT_EQ(glsl::toneCurve(0.0), 0.0);
  EXPECT_NEAR(glsl::toneCurve(0.18), 0.18, 1e-15);
  double const h = 1e-5, knee = glsl::kToneKnee;
  EXPECT_NEAR((glsl::toneCurve(knee + h) - glsl::toneCurve(knee)) / h, 1.0, 1e-3);
}

TEST(ToneCurve, LandsWhereItsCommentSays) {
  EXPECT_NEAR(glsl::toneCurve(1.0), 0.74, 0.005);
  EXPECT_NEAR(glsl::toneCurve(2.0), 0.89, 0.005);
  EXPECT_NEAR(glsl::toneCurve(32.0), 0.997, 0.001);
}

TEST(ToneCurve, RisesOverTwentyDecadesAndStaysBelowOne) {
  double last = -1.0;
  for (double x = 1e-8; x < 1e13; x *= 1.3) {
    double const shown = glsl::toneCurve(x);
    EXPECT_GE(shown, last - 1e-15) << x;  // rounding, where it is 1
    EXPECT_LE(shown, 1.0) << x;
    last = shown;
  }
  EXPECT_NEAR(glsl::toneCurve(1e13), 1.0, 1e-12);
}

TEST(DisplayColour, KeepsLuminanceOnTheCurve) {
  for (dvec3 colour :
       {dvec3(1.0, 0.2, 0.05), dvec3(0.1, 0.3, 1.0), dvec3(1.0), dvec3(0.2, 1.0, 0.1)})
    for (double level = 1e-3; level < 1e4; level *= 2.0) {
      dvec3 const scene = colour * level;
      dvec3 const shown = glsl::displayColour(scene, 1.0);
      EXPECT_NEAR(glsl::luminanceOfColour(shown), glsl::toneCurve(glsl::luminanceOfColour(scene)),
                  1e-12);
      for (int i = 0; i < 3; ++i) {
        EXPECT_GE(shown[i], 0.0);
        EXPECT_LE(shown[i], 1.0);
      }
    }
}

// From one stop to the next no channel falls and none jumps: an orange sky turns yellow, then
// white.
TEST(DisplayColour, HighlightsGoToWhiteWithoutAJump) {
  for (dvec3 colour : {dvec3(1.0, 0.4, 0.1), dvec3(0.3, 0.5, 1.0), dvec3(1.0, 0.02, 0.02)}) {
    dvec3 last = glsl::displayColour(colour * 1e-4, 1.0);
    for (double level = 1e-4; level < 1e6; level *= 1.02) {
      dvec3 const now = glsl::displayColour(colour * level, 1.0);
      for (int i = 0; i < 3; ++i) EXPECT_LT(std::fabs(now[i] - last[i]), 0.02) << level;
      last = now;
    }
    EXPECT_LT(glm::length(last - dvec3(1.0)), 1e-3);
  }
}

TEST(DisplayColour, KeepsTheOrderOfChannels) {
  for (double level = 1e-3; level < 1e5; level *= 1.5) {
    dvec3 const shown = glsl::displayColour(level * dvec3(1.0, 0.6, 0.2), 1.0);
    EXPECT_GE(shown.x, shown.y);
    EXPECT_GE(shown.y, shown.z);
  }
}

TEST(DisplayColour, BringsColoursOutsideSrgbInside) {
  dvec3 const shown = glsl::displayColour(dvec3(-0.05, 0.2, 0.5), 1.0);
  EXPECT_NEAR(shown.x, 0.0, 1e-12);
  EXPECT_GT(shown.y, 0.0);
}

TEST(DisplayColour, SpansTheNightAndTheSun) {
  dvec3 const night = glsl::displayColour(dvec3(1e-5), 1.0 / 0.01);
  EXPECT_NEAR(night.y, 1e-3, 1e-9);
  dvec3 const sun = glsl::displayColour(dvec3(1.6e9), 1.0 / 0.01);
  EXPECT_NEAR(sun.y, 1.0, 1e-9);
  EXPECT_EQ(glsl::displayColour(dvec3(0.0), 100.0), dvec3(0.0));
}

// IEC 61966-2-1: the published samples of the transfer curve.
TEST(SrgbEncoded, MatchesTheStandard) {
  EXPECT_NEAR(glsl::srgbEncoded(0.18), 0.4613561, 1e-6);
  EXPECT_NEAR(glsl::srgbEncoded(1.0), 1.0, 1e-12);
  EXPECT_NEAR(glsl::srgbEncoded(0.002), 0.02584, 1e-12);
  // The pieces meet within the standard's rounding.
  EXPECT_NEAR(glsl::srgbEncoded(0.0031308), glsl::srgbEncoded(0.00313081), 1e-6);
}

}  // namespace
}  // namespace antumbra
