// Astronomical magnitudes and photometric units.
// Zero point: V = 0 above the air gives 2.54e-6 lx (Cox, Allen's Astrophysical Quantities, 4th ed.
// 2000, section 2.7). Hence L = 10^((12.58 - mag/arcsec2)/2.5) cd/m2, the relation of the twilight
// literature (Patat et al. 2006). To be honest: V is not quite the eye's V(lambda); up to 0.1 mag
// for red sources.
#pragma once

#include <cmath>
#include <numbers>

namespace antumbra {

inline constexpr double kLuxAtMagnitudeZero = 2.54e-6;
// The solid angle of a square arcsecond, sr.
inline constexpr double kSquareArcsecondSteradians =
    (std::numbers::pi / 648000.0) * (std::numbers::pi / 648000.0);

// Illuminance, in lux on a surface facing the source, of a source of visual magnitude V.
inline double illuminanceLuxOfMagnitude(double magnitude) {
  return kLuxAtMagnitudeZero * std::pow(10.0, -0.4 * magnitude);
}
inline double magnitudeOfIlluminanceLux(double lux) {
  return -2.5 * std::log10(lux / kLuxAtMagnitudeZero);
}
// Luminance in cd/m2 of a surface brightness in mag/arcsec2.
inline double luminanceOfSurfaceBrightness(double magnitudePerSquareArcsecond) {
  return illuminanceLuxOfMagnitude(magnitudePerSquareArcsecond) / kSquareArcsecondSteradians;
}
inline double surfaceBrightnessOfLuminance(double candelasPerSquareMetre) {
  return magnitudeOfIlluminanceLux(candelasPerSquareMetre * kSquareArcsecondSteradians);
}

}  // namespace antumbra
