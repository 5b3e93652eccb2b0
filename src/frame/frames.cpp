#include "frame/frames.h"

#include <erfa.h>
#include <cmath>

namespace antumbra {
namespace {

using Matrix = double[3][3];

glm::dmat3 fromErfa(const Matrix& m) {
  glm::dmat3 r;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) r[column][row] = m[row][column];
  return r;
}

// IAU 2006 precession is a polynomial made for a few centuries about J2000; at 1800 and 2200 it and
// the long-term model agree to 0.0001" (tests/frame), so that the change between them shows
// nowhere.
bool inIau2006Span(Instant t) { return std::fabs(t.ttCenturiesSinceJ2000()) <= 2.0; }

void biasPrecession(Instant t, Matrix& m) {
  auto const tt = t.tt();
  if (inIau2006Span(t)) {
    eraPmat06(tt.whole, tt.fraction, m);
  } else {
    eraLtpb(t.julianYear(), m);
  }
}

double meanObliquityRadians(Instant t) {
  auto const tt = t.tt();
  if (inIau2006Span(t)) return eraObl06(tt.whole, tt.fraction);
  double ecliptic[3], equator[3], cross[3];
  eraLtpecl(t.julianYear(), ecliptic);
  eraLtpequ(t.julianYear(), equator);
  eraPxp(ecliptic, equator, cross);
  return std::atan2(eraPm(cross), eraPdp(ecliptic, equator));
}

struct Reduction {
  Matrix trueFromIcrs;
  double longitude, obliquity, mean;
};

Reduction reduce(Instant t) {
  Reduction r;
  auto const tt = t.tt();
  eraNut06a(tt.whole, tt.fraction, &r.longitude, &r.obliquity);
  r.mean = meanObliquityRadians(t);
  Matrix precession, nutation;
  biasPrecession(t, precession);
  eraNumat(r.mean, r.longitude, r.obliquity, nutation);
  eraRxr(nutation, precession, r.trueFromIcrs);
  return r;
}

double siderealTime(Instant t, const DeltaT& deltaT, const Reduction& r) {
  auto const tt = t.tt();
  auto const ut1 = t.ut1(deltaT);
  if (inIau2006Span(t)) {
    Matrix m;
    eraCr(const_cast<Matrix&>(r.trueFromIcrs), m);
    return eraGst06(ut1.whole, ut1.fraction, tt.whole, tt.fraction, m);
  }
  // The polynomial of the sidereal time in IAU 2006 diverges with its precession; the accumulated
  // precession in right ascension comes from the long-term model instead: the rate of turn of the
  // mean equinox along the moving equator, integrated from the edge of the span.
  double const edge = t.ttCenturiesSinceJ2000() > 0.0 ? 2.0 : -2.0;
  double const end = t.ttCenturiesSinceJ2000();
  int const steps = 2 * (1 + static_cast<int>(std::fabs(end - edge) * 8.0));
  double const h = (end - edge) / steps;
  auto const rateOfEquinox = [](double centuries) {
    // About the pole: -(dx/dT . y) of the frame's x axis, by central difference over 0.02 century.
    constexpr double kStep = 0.01;
    Matrix before, after, at;
    double const epoch = 2000.0 + 100.0 * centuries;
    eraLtp(epoch - 100.0 * kStep, before);
    eraLtp(epoch + 100.0 * kStep, after);
    eraLtp(epoch, at);
    double rate = 0.0;
    for (int k = 0; k < 3; ++k) rate -= (after[0][k] - before[0][k]) / (2.0 * kStep) * at[1][k];
    return rate;
  };
  double integral = rateOfEquinox(edge) + rateOfEquinox(end);
  for (int i = 1; i < steps; ++i) integral += (i % 2 ? 4.0 : 2.0) * rateOfEquinox(edge + i * h);
  integral *= h / 3.0;
  double const edgeTt = 2451545.0 + 36525.0 * edge;
  double const edgeOffset = eraGmst06(2451545.0, 36525.0 * edge, 2451545.0, 36525.0 * edge) -
                            eraEra00(2451545.0, edgeTt - 2451545.0);
  double const complementary = eraEect00(tt.whole, tt.fraction);
  return eraAnp(eraEra00(ut1.whole, ut1.fraction) + edgeOffset + integral +
                r.longitude * std::cos(r.mean) + complementary);
}

}  // namespace

Rotation<EquatorJ2000, Icrs> equatorJ2000FromIcrs() {
  Matrix bias, precession, both;
  eraBp06(2451545.0, 0.0, bias, precession, both);
  return {fromErfa(bias)};
}

Rotation<EclipticJ2000, Icrs> eclipticJ2000FromIcrs() {
  Matrix m;
  eraEcm06(2451545.0, 0.0, m);
  return {fromErfa(m)};
}

Rotation<MeanEquatorOfDate, Icrs> meanEquatorOfDateFromIcrs(Instant t) {
  Matrix m;
  biasPrecession(t, m);
  return {fromErfa(m)};
}

Rotation<TrueEquatorOfDate, Icrs> trueEquatorOfDateFromIcrs(Instant t) {
  return {fromErfa(reduce(t).trueFromIcrs)};
}

Rotation<TrueEclipticOfDate, Icrs> trueEclipticOfDateFromIcrs(Instant t) {
  auto r = reduce(t);
  eraRx(r.mean + r.obliquity, r.trueFromIcrs);
  return {fromErfa(r.trueFromIcrs)};
}

Angle greenwichApparentSiderealTime(Instant t, const DeltaT& deltaT) {
  return siderealTime(t, deltaT, reduce(t)) * radian;
}

namespace {
Rotation<Itrs, TrueEquatorOfDate> spin(Instant t, const DeltaT& deltaT, const Reduction& r) {
  Matrix m;
  eraIr(m);
  eraRz(siderealTime(t, deltaT, r), m);
  auto const [x, y] = deltaT.pole(t);
  if (x.si != 0.0 || y.si != 0.0) {
    auto const tt = t.tt();
    Matrix pole, both;
    eraPom00(x / radian, y / radian, eraSp00(tt.whole, tt.fraction), pole);
    eraRxr(pole, m, both);
    eraCr(both, m);
  }
  return {fromErfa(m)};
}
}  // namespace

Rotation<Itrs, TrueEquatorOfDate> itrsFromTrueEquatorOfDate(Instant t, const DeltaT& deltaT) {
  return spin(t, deltaT, reduce(t));
}

Rotation<Itrs, Icrs> itrsFromIcrs(Instant t, const DeltaT& deltaT) {
  auto const r = reduce(t);
  return spin(t, deltaT, r) * Rotation<TrueEquatorOfDate, Icrs>{fromErfa(r.trueFromIcrs)};
}

NutationAndObliquity nutationAndObliquity(Instant t) {
  auto const r = reduce(t);
  return {r.longitude * radian, r.obliquity * radian, r.mean * radian};
}

}  // namespace antumbra
