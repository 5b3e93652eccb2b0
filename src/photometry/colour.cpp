#include "photometry/colour.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "document/input_error.h"
#include "photometry/standard_spectra.h"

namespace antumbra {
namespace {

// IEC 61966-2-1 primaries and white as chromaticities.
glm::dmat3 makeXyzFromLinearSrgb() {
  auto const column = [](double x, double y) { return glm::dvec3(x / y, 1.0, (1.0 - x - y) / y); };
  glm::dmat3 const primaries(column(0.64, 0.33), column(0.30, 0.60), column(0.15, 0.06));
  glm::dvec3 const scale = glm::inverse(primaries) * column(0.3127, 0.3290);
  return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}
const glm::dmat3 kXyzFromRgb = makeXyzFromLinearSrgb();
const glm::dmat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);

struct Lab {
  double l, a, b;
};

// CIE 15:2004, 8.2.1.
Lab labOf(glm::dvec3 xyz, double whiteLuminance) {
  glm::dvec3 const white = xyzFromLinearSrgb(glm::dvec3(whiteLuminance));
  auto const f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  double const fx = f(xyz.x / white.x), fy = f(xyz.y / white.y), fz = f(xyz.z / white.z);
  return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

double sinDegrees(double a) { return std::sin(a * std::numbers::pi / 180.0); }
double cosDegrees(double a) { return std::cos(a * std::numbers::pi / 180.0); }
double hueDegrees(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  double const h = std::atan2(b, a) * 180.0 / std::numbers::pi;
  return h < 0.0 ? h + 360.0 : h;
}

}  // namespace

glm::dvec3 linearSrgbFromXyz(glm::dvec3 xyz) { return kRgbFromXyz * xyz; }
glm::dvec3 xyzFromLinearSrgb(glm::dvec3 rgb) { return kXyzFromRgb * rgb; }
double luminanceOf(glm::dvec3 linearSrgb) { return (kXyzFromRgb * linearSrgb).y; }

Chromaticity chromaticityOf(glm::dvec3 xyz) {
  double const sum = xyz.x + xyz.y + xyz.z;
  if (sum == 0.0) return {1.0 / 3.0, 1.0 / 3.0};
  return {xyz.x / sum, xyz.y / sum};
}

double deltaE2000(glm::dvec3 xyz, glm::dvec3 otherXyz, double whiteLuminance) {
  // Sharma et al. 2005, eqs. 2-22.
  Lab const p = labOf(xyz, whiteLuminance), q = labOf(otherXyz, whiteLuminance);
  double const meanChroma = (std::hypot(p.a, p.b) + std::hypot(q.a, q.b)) / 2.0;
  double const chroma7 = std::pow(meanChroma, 7.0), pow25to7 = 6103515625.0;
  double const g = 0.5 * (1.0 - std::sqrt(chroma7 / (chroma7 + pow25to7)));
  double const a1 = (1.0 + g) * p.a, a2 = (1.0 + g) * q.a;
  double const c1 = std::hypot(a1, p.b), c2 = std::hypot(a2, q.b);
  double const h1 = hueDegrees(a1, p.b), h2 = hueDegrees(a2, q.b);
  double dHue = 0.0;
  if (c1 * c2 != 0.0) {
    dHue = h2 - h1;
    if (dHue > 180.0) dHue -= 360.0;
    if (dHue < -180.0) dHue += 360.0;
  }
  double const dL = q.l - p.l, dC = c2 - c1;
  double const dH = 2.0 * std::sqrt(c1 * c2) * sinDegrees(dHue / 2.0);
  double const l = (p.l + q.l) / 2.0, c = (c1 + c2) / 2.0;
  double h = h1 + h2;
  if (c1 * c2 != 0.0) {
    if (std::abs(h1 - h2) > 180.0) h += h < 360.0 ? 360.0 : -360.0;
    h /= 2.0;
  }
  double const t = 1.0 - 0.17 * cosDegrees(h - 30.0) + 0.24 * cosDegrees(2.0 * h) +
                   0.32 * cosDegrees(3.0 * h + 6.0) - 0.20 * cosDegrees(4.0 * h - 63.0);
  double const dTheta = 30.0 * std::exp(-std::pow((h - 275.0) / 25.0, 2.0));
  double const c7 = std::pow(c, 7.0);
  double const rotation = -2.0 * std::sqrt(c7 / (c7 + pow25to7)) * sinDegrees(2.0 * dTheta);
  double const l50 = (l - 50.0) * (l - 50.0);
  double const sl = 1.0 + 0.015 * l50 / std::sqrt(20.0 + l50);
  double const sc = 1.0 + 0.045 * c, sh = 1.0 + 0.015 * c * t;
  double const x = dL / sl, y = dC / sc, z = dH / sh;
  return std::sqrt(std::max(0.0, x * x + y * y + z * z + rotation * y * z));
}

double starTemperatureKelvin(double bMinusV) {
  if (!(bMinusV >= -0.4 && bMinusV <= 4.0))
    throw InputError(fmt::format("colour index B-V: found {}; allowed: -0.4 to 4", bMinusV));
  return 4600.0 * (1.0 / (0.92 * bMinusV + 1.7) + 1.0 / (0.92 * bMinusV + 0.62));
}

glm::dvec3 blackBodyColour(double kelvin) {
  if (!(kelvin >= 500.0 && std::isfinite(kelvin)))
    throw InputError(fmt::format("temperature: found {} K; allowed: 500 K or more", kelvin));
  // Second radiation constant h c / k from the exact SI constants, m K.
  double const c2 = 1.438776877e-2;
  glm::dvec3 xyz(0.0);
  for (double nm = 360.0; nm <= 830.0; nm += 5.0) {
    double const m = nm * 1e-9;
    xyz += colourMatching(nm * nanometre) / (std::pow(nm, 5.0) * std::expm1(c2 / (m * kelvin)));
  }
  return linearSrgbFromXyz(xyz / xyz.y);
}

glm::dvec3 starColour(double bMinusV) { return blackBodyColour(starTemperatureKelvin(bMinusV)); }

}  // namespace antumbra
