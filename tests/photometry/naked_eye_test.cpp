// The naked eye's threshold against what observers report.
#include "photometry/naked_eye.h"

#include <gtest/gtest.h>

#include "photometry/magnitude.h"

namespace antumbra {
namespace {

double limit(double luminance) { return magnitudeOfIlluminanceLux(faintestPointLux(luminance)); }

// Dark sites of 21.6 to 22 mag per square arcsecond are those where practised observers reach V 6
// to 6.8 (Crumey 2014, MNRAS 442, 2600); of the day's sky (a few thousand cd/m2) Venus at -4.4 is
// found and Jupiter at -2.5 hardly.
TEST(NakedEye, SeesWhatObserversReport) {
  double const dark = limit(luminanceOfSurfaceBrightness(21.8));
  EXPECT_GT(dark, 6.0);
  EXPECT_LT(dark, 6.8);
  double const day = limit(3000.0);
  EXPECT_GT(day, -4.4);
  EXPECT_LT(day, -2.5);
}

TEST(NakedEye, LosesStarsAsTheSkyBrightens) {
  double last = 99.0;
  for (double l = 1e-6; l < 1e5; l *= 1.5) {
    EXPECT_LT(limit(l), last + 0.15) << l;  // the branches part by 0.1
    last = limit(l);
  }
}

}  // namespace
}  // namespace antumbra
