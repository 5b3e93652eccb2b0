#include "ephemeris/elp_mpp02.h"

#include <cmath>

namespace antumbra {
namespace {

constexpr double kDaysPerCentury = 36525.0;

// Laskar 1986 in the form of ELP/MPP02: P = sin(pi/2) sin Pi, Q = sin(pi/2) cos Pi; centuries.
constexpr double kP[] = {0.0,           0.10180391e-4,  0.47020439e-6,
                         -0.5417367e-9, -0.2507948e-11, 0.463486e-14};
constexpr double kQ[] = {0.0,           -0.113469002e-3, 0.12372674e-6,
                         0.12654170e-8, -0.1371808e-11,  -0.320334e-14};

// Inertial mean ecliptic and equinox J2000 to Icrs: obliquity and offset of the equinox, Chapront
// et al. 2002 (A&A 387, 700), for the frame of DE405, to which the constants are fitted.
constexpr Angle kObliquity{84381.40928 * arcsecond.si};
constexpr Angle kEquinoxOffset{-0.05028 * arcsecond.si};

template <std::size_t N>
SeriesValue polynomial(const double (&c)[N], double t) {
  SeriesValue sum;
  for (std::size_t i = N; i-- > 0;) {
    sum.rate = sum.rate * t + sum.value;
    sum.value = sum.value * t + c[i];
  }
  return sum;
}

glm::dmat3 icrsFromEcliptic() {
  double const ce = cos(kObliquity), se = sin(kObliquity);
  double const cf = cos(kEquinoxOffset), sf = sin(kEquinoxOffset);
  glm::dmat3 const tilt(glm::dvec3(1, 0, 0), glm::dvec3(0, ce, se), glm::dvec3(0, -se, ce));
  glm::dmat3 const turn(glm::dvec3(cf, sf, 0), glm::dvec3(-sf, cf, 0), glm::dvec3(0, 0, 1));
  return turn * tilt;
}

}  // namespace

MoonSeries moonSeries(const SeriesCatalogue& catalogue) {
  MoonSeries m;
  for (const auto& block : catalogue.series("Moon", "W1").blocks)
    if (block.power < 5) m.meanLongitude[block.power] = block.columns[0];
  m.longitude = catalogue.series("Moon", "L");
  m.latitude = catalogue.series("Moon", "B");
  m.distance = catalogue.series("Moon", "R");
  return m;
}

State MoonSeries::state(double tdbDays) const {
  double const t = tdbDays / kDaysPerCentury;
  auto l = longitude.evaluate(t), b = latitude.evaluate(t);
  auto const r = distance.evaluate(t);
  auto const w = polynomial(meanLongitude, t);
  l.value = l.value * arcsecond.si + w.value;
  l.rate = l.rate * arcsecond.si + w.rate;
  b.value *= arcsecond.si;
  b.rate *= arcsecond.si;
  double const cl = std::cos(l.value), sl = std::sin(l.value);
  double const cb = std::cos(b.value), sb = std::sin(b.value);
  glm::dvec3 const p(r.value * cb * cl, r.value * cb * sl, r.value * sb);
  double const planeRate = r.rate * cb - r.value * sb * b.rate;
  glm::dvec3 const v(planeRate * cl - p.y * l.rate, planeRate * sl + p.x * l.rate,
                     r.rate * sb + r.value * cb * b.rate);
  auto const [p1, dp] = polynomial(kP, t);
  auto const [q1, dq] = polynomial(kQ, t);
  double const s = 2.0 * std::sqrt(1.0 - p1 * p1 - q1 * q1);
  double const ds = -4.0 * (p1 * dp + q1 * dq) / s;
  // Rows of the rotation from the ecliptic of date to that of J2000, and their rates.
  glm::dmat3 const m =
      glm::transpose(glm::dmat3(glm::dvec3(1.0 - 2.0 * p1 * p1, 2.0 * p1 * q1, p1 * s),
                                glm::dvec3(2.0 * p1 * q1, 1.0 - 2.0 * q1 * q1, -q1 * s),
                                glm::dvec3(-p1 * s, q1 * s, 1.0 - 2.0 * p1 * p1 - 2.0 * q1 * q1)));
  double const cross = 2.0 * (dp * q1 + p1 * dq);
  double const dps = dp * s + p1 * ds, dqs = dq * s + q1 * ds;
  glm::dmat3 const dm = glm::transpose(
      glm::dmat3(glm::dvec3(-4.0 * p1 * dp, cross, dps), glm::dvec3(cross, -4.0 * q1 * dq, -dqs),
                 glm::dvec3(-dps, dqs, -4.0 * (p1 * dp + q1 * dq))));
  static const glm::dmat3 icrs = icrsFromEcliptic();
  double const perSecond = 1.0 / (kDaysPerCentury * 86400.0);
  return {{1000.0 * (icrs * (m * p))}, {1000.0 * perSecond * (icrs * (m * v + dm * p))}};
}

}  // namespace antumbra
