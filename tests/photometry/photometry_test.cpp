// Standard spectra, colour and magnitudes against published values.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/input_error.h"
#include "photometry/colour.h"
#include "photometry/magnitude.h"
#include "photometry/standard_spectra.h"

namespace antumbra {
namespace {

TEST(StandardSpectra, TheSunGivesTheIlluminanceOfTheLiterature) {
  // Solar illuminance constant: 127 to 134 klx (Darula, Kittler & Gueymard 2005, Solar Energy 79,
  // 559: 133.3 klx for the E490 spectrum; sum of the spectrum against V).
  auto const xyz = xyzOfRelativeRadiance([](Length) { return 1.0; });
  EXPECT_NEAR(xyz.y, 133.3e3, 0.01 * 133.3e3);  // 1 %: steps of the published integration
  // Chromaticity of E490 sunlight lies on the daylight locus near 5900 K: x 0.323, y 0.332
  // (Planckian point of 5900 K, Wyszecki & Stiles 1982, +- 0.005).
  auto const c = chromaticityOf(xyz);
  EXPECT_NEAR(c.x, 0.3233, 0.005);
  EXPECT_NEAR(c.y, 0.3324, 0.005);
}

TEST(StandardSpectra, EyeFunctionsPeakWhereTheStandardsSay) {
  EXPECT_DOUBLE_EQ(photopicEfficiency(555 * nanometre), 1.0);   // CIE 1931
  EXPECT_NEAR(scotopicEfficiency(507 * nanometre), 1.0, 0.01);  // CIE 1951; 10 nm table
  EXPECT_EQ(scotopicEfficiency(820 * nanometre), 0.0);
  EXPECT_EQ(photopicEfficiency(850 * nanometre), 0.0);
}

TEST(StandardSpectra, RayleighCrossSectionOfBucholtz) {
  // Bucholtz 1995, table 2: total Rayleigh cross sections of standard air, cm2. Fit within 0.2 %.
  EXPECT_NEAR(rayleighCrossSection(400 * nanometre) / 1e-4, 1.674e-26, 0.004e-26);
  EXPECT_NEAR(rayleighCrossSection(550 * nanometre) / 1e-4, 4.513e-27, 0.013e-27);
  EXPECT_NEAR(rayleighCrossSection(700 * nanometre) / 1e-4, 1.692e-27, 0.008e-27);
}

TEST(StandardSpectra, OutsideTheSpanTheErrorCarriesTheSpan) {
  try {
    solarIrradiance(5000 * nanometre);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("5000 nm"), testing::HasSubstr("298.5"),
                               testing::HasSubstr("1000 nm")));
  }
}

TEST(Colour, SrgbMatrixOfTheStandard) {
  // IEC 61966-2-1, rounded to four decimals there.
  auto const xyz = xyzFromLinearSrgb({1.0, 0.0, 0.0});
  EXPECT_NEAR(xyz.x, 0.4124, 1e-4);
  EXPECT_NEAR(xyz.y, 0.2126, 1e-4);
  EXPECT_NEAR(xyz.z, 0.0193, 1e-4);
  EXPECT_NEAR(luminanceOf({1.0, 1.0, 1.0}), 1.0, 1e-12);
}

// XYZ (white Y = 100, D65 of this file) of a CIE Lab colour.
glm::dvec3 xyzOfLab(double l, double a, double b) {
  auto const inverse = [](double f) {
    return f > 6.0 / 29.0 ? f * f * f : (116.0 * f - 16.0) * 27.0 / 24389.0;
  };
  double const fy = (l + 16.0) / 116.0;
  return glm::dvec3(inverse(fy + a / 500.0), inverse(fy), inverse(fy - b / 200.0)) *
         xyzFromLinearSrgb(glm::dvec3(100.0));
}

TEST(Colour, Ciede2000AgainstTheDataOfSharma) {
  // Sharma, Wu & Dalal 2005, table 1, pairs 1, 7, 14, 17, 20, 25.
  struct Row {
    double l1, a1, b1, l2, a2, b2, expected;
  };
  for (Row r :
       {Row{50, 2.6772, -79.7751, 50, 0, -82.7485, 2.0425}, Row{50, 0, 0, 50, -1, 2, 2.3669},
        Row{50, 2.4900, -0.0010, 50, -2.4900, 0.0011, 7.2195},
        Row{50, 2.5, 0, 73, 25, -18, 27.1492}, Row{50, 2.5, 0, 50, 3.1736, 0.5854, 1.0},
        Row{60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644}})
    EXPECT_NEAR(deltaE2000(xyzOfLab(r.l1, r.a1, r.b1), xyzOfLab(r.l2, r.a2, r.b2), 100.0),
                r.expected, 1e-4);
}

TEST(Colour, StarsFromBlueToRed) {
  // Ballesteros 2012: the Sun (B-V 0.653) at 5778 K, within 1 %.
  EXPECT_NEAR(starTemperatureKelvin(0.653), 5778.0, 58.0);
  auto const rigel = starColour(-0.03), betelgeuse = starColour(1.85);
  EXPECT_GT(rigel.b, rigel.r);
  EXPECT_GT(betelgeuse.r, 2.0 * betelgeuse.b);
  EXPECT_NEAR(luminanceOf(rigel), 1.0, 1e-9);
  EXPECT_THROW(starColour(9.0), InputError);
  // Planckian locus at 5000 K: x 0.3451, y 0.3516 (Wyszecki & Stiles 1982, table I(3.11)).
  auto const c = chromaticityOf(xyzFromLinearSrgb(blackBodyColour(5000.0)));
  EXPECT_NEAR(c.x, 0.3451, 2e-4);
  EXPECT_NEAR(c.y, 0.3516, 2e-4);
}

TEST(Magnitude, FullMoonAndNightSky) {
  // V -12.74 gives 0.32 lx (Krisciunas & Schaefer 1991, PASP 103, 1033: 0.1 footcandle-scale; here
  // the zero point of Allen 2000 alone).
  EXPECT_NEAR(illuminanceLuxOfMagnitude(-12.74), 0.317, 0.003);
  // The relation of the twilight data: 12.58 mag/arcsec2 is 1 cd/m2, within 0.01 mag.
  EXPECT_NEAR(surfaceBrightnessOfLuminance(1.0), 12.58, 0.01);
  EXPECT_NEAR(luminanceOfSurfaceBrightness(surfaceBrightnessOfLuminance(3e-4)), 3e-4, 1e-12);
  EXPECT_NEAR(magnitudeOfIlluminanceLux(illuminanceLuxOfMagnitude(-26.7)), -26.7, 1e-12);
}

}  // namespace
}  // namespace antumbra
