// Besselian elements from the shadow, and their polynomials.
#include "eclipse/besselian.h"

#include <cmath>

#include "quantity/constants.h"

namespace antumbra {

BesselianElements besselianElements(const SunMoonTrack& track, const ShadowRadii& radii,
                                    double seconds) {
  auto const pair = track.shadowAt(seconds, radii);
  double const earth = kEarthEquatorialRadius.si;
  glm::dvec3 const toSun = -pair.axis;
  glm::dvec3 const east = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), toSun));
  glm::dvec3 const north = glm::cross(toSun, east);
  BesselianElements e;
  e.x = glm::dot(pair.foot, east) / earth;
  e.y = glm::dot(pair.foot, north) / earth;
  e.dDegrees = std::asin(toSun.z) * 180.0 / M_PI;
  double const hourAngle = -std::atan2(toSun.y, toSun.x) * 180.0 / M_PI;
  e.muDegrees = hourAngle < 0.0 ? hourAngle + 360.0 : hourAngle;
  e.l1 = pair.penumbraRadius / earth;
  e.l2 = -pair.umbraRadius / earth;
  e.tanF1 = pair.penumbraTangent;
  e.tanF2 = pair.umbraTangent;
  return e;
}

BesselianPolynomials besselianPolynomials(const SolarEvent& event, const ShadowRadii& radii) {
  BesselianPolynomials p;
  auto const tt = event.eclipse.greatest.tt();
  p.reference = Instant::fromTt({tt.whole, std::round(tt.fraction * 24.0) / 24.0});
  p.deltaT = event.eclipse.deltaT;
  double const middle = event.track.secondsAt(p.reference);
  constexpr int kSamples = 25;
  constexpr double kReachHours = 3.0;
  std::array<std::array<double, 6>, kSamples> values{};
  std::array<double, kSamples> hours{};
  for (std::size_t i = 0; i < kSamples; ++i) {
    hours[i] = kReachHours * (2.0 * static_cast<double>(i) / (kSamples - 1) - 1.0);
    auto const e = besselianElements(event.track, radii, middle + 3600.0 * hours[i]);
    double mu = e.muDegrees;
    if (i > 0) mu += 360.0 * std::round((values[i - 1][3] - mu) / 360.0);
    values[i] = {e.x, e.y, e.dDegrees, mu, e.l1, e.l2};
  }
  // Normal equations in the scaled variable hours / reach; symmetric, so even and odd powers part.
  for (std::size_t element = 0; element < 6; ++element) {
    double s[7] = {}, b[4] = {};
    for (std::size_t i = 0; i < kSamples; ++i) {
      double const u = hours[i] / kReachHours;
      double power = 1.0;
      for (int k = 0; k < 7; ++k) {
        s[k] += power;
        if (k < 4) b[k] += power * values[i][element];
        power *= u;
      }
    }
    auto const solve = [&](int k) {  // coefficients of u^k and u^(k+2)
      double const determinant = s[2 * k] * s[2 * k + 4] - s[2 * k + 2] * s[2 * k + 2];
      return std::pair((b[k] * s[2 * k + 4] - b[k + 2] * s[2 * k + 2]) / determinant,
                       (b[k + 2] * s[2 * k] - b[k] * s[2 * k + 2]) / determinant);
    };
    auto const [c0, c2] = solve(0);
    auto const [c1, c3] = solve(1);
    p.coefficients[element] = {c0, c1 / kReachHours, c2 / std::pow(kReachHours, 2),
                               c3 / std::pow(kReachHours, 3)};
    for (std::size_t i = 0; i < kSamples; ++i) {
      double const h = hours[i];
      auto const& c = p.coefficients[element];
      double const fit = c[0] + h * (c[1] + h * (c[2] + h * c[3]));
      p.largestResidual[element] =
          std::max(p.largestResidual[element], std::fabs(fit - values[i][element]));
    }
  }
  auto const e = besselianElements(event.track, radii, middle);
  p.tanF1 = e.tanF1;
  p.tanF2 = e.tanF2;
  double const turns = std::floor(p.coefficients[3][0] / 360.0);
  p.coefficients[3][0] -= 360.0 * turns;
  return p;
}

}  // namespace antumbra
