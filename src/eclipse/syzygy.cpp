// Mean new and full moons and their eclipse conditions.
#include "eclipse/syzygy.h"

#include <cmath>

namespace antumbra {
namespace {

double radians(double degrees) { return std::fmod(degrees, 360.0) * M_PI / 180.0; }

Syzygy syzygyOf(EclipseKind kind, long lunation) {
  bool const solar = kind == EclipseKind::Solar;
  double const k = static_cast<double>(lunation) + (solar ? 0.0 : 0.5);
  double const T = k / 1236.85;
  double const T2 = T * T, T3 = T2 * T, T4 = T3 * T;
  double const base = 29.530588861 * k + 0.00015437 * T2 - 0.000000150 * T3 + 0.00000000073 * T4;
  double const M = radians(2.5534 + 29.10535670 * k - 0.0000014 * T2 - 0.00000011 * T3);
  double const Mp =
      radians(201.5643 + 385.81693528 * k + 0.0107582 * T2 + 0.00001238 * T3 - 0.000000058 * T4);
  double const F =
      radians(160.7108 + 390.67050284 * k - 0.0016118 * T2 - 0.00000227 * T3 + 0.000000011 * T4);
  double const node = radians(124.7746 - 1.56375588 * k + 0.0020672 * T2 + 0.00000215 * T3);
  double const E = 1.0 - 0.002516 * T - 0.0000074 * T2;
  double const F1 = F - radians(0.02665) * std::sin(node);
  double const A1 = radians(299.77 + 0.107408 * k - 0.009173 * T2);
  using std::cos;
  using std::sin;
  double const correction =
      (solar ? -0.4075 : -0.4065) * sin(Mp) + (solar ? 0.1721 : 0.1727) * E * sin(M) +
      0.0161 * sin(2 * Mp) - 0.0097 * sin(2 * F1) + 0.0073 * E * sin(Mp - M) -
      0.0050 * E * sin(Mp + M) - 0.0023 * sin(Mp - 2 * F1) + 0.0021 * E * sin(2 * M) +
      0.0012 * sin(Mp + 2 * F1) + 0.0006 * E * sin(2 * Mp + M) - 0.0004 * sin(3 * Mp) -
      0.0003 * E * sin(M + 2 * F1) + 0.0003 * sin(A1) - 0.0002 * E * sin(M - 2 * F1) -
      0.0002 * E * sin(2 * Mp - M) - 0.0002 * sin(node);
  double const P = 0.2070 * E * sin(M) + 0.0024 * E * sin(2 * M) - 0.0392 * sin(Mp) +
                   0.0116 * sin(2 * Mp) - 0.0073 * E * sin(Mp + M) + 0.0067 * E * sin(Mp - M) +
                   0.0118 * sin(2 * F1);
  double const Q = 5.2207 - 0.0048 * E * cos(M) + 0.0020 * E * cos(2 * M) - 0.3299 * cos(Mp) -
                   0.0060 * E * cos(Mp + M) + 0.0041 * E * cos(Mp - M);
  double const u =
      0.0059 + 0.0046 * E * cos(M) - 0.0182 * cos(Mp) + 0.0004 * cos(2 * Mp) - 0.0005 * cos(M + Mp);
  Syzygy s;
  s.kind = kind;
  s.lunation = lunation;
  // The fraction apart, so that milliseconds survive at any date.
  s.greatest = Instant::fromTt({2451550.0, 0.09766 + base + correction});
  s.gamma = (P * cos(F1) + Q * sin(F1)) * (1.0 - 0.0048 * std::fabs(cos(F1)));
  s.margin = (solar ? 1.5433 : 1.5573) + u - std::fabs(s.gamma);
  return s;
}

}  // namespace

std::vector<Syzygy> eclipseCandidates(EclipseKind kind, Instant from, Instant to) {
  auto const lunationAt = [](Instant t) {
    return static_cast<long>(
        std::floor((t - Instant::fromTt({2451550.0, 0.09766})) / day / 29.530588861));
  };
  std::vector<Syzygy> found;
  for (long lunation = lunationAt(from) - 1; lunation <= lunationAt(to) + 1; ++lunation) {
    Syzygy const s = syzygyOf(kind, lunation);
    // An hour more on either side: the exact instant decides.
    if (s.margin > -0.06 && s.greatest > from - 1.0 * hour && s.greatest < to + 1.0 * hour)
      found.push_back(s);
  }
  return found;
}

int brownLunation(long lunation) { return static_cast<int>(lunation + 953); }

int sarosNumber(EclipseKind kind, long lunation) {
  // Each lunation adds 38 modulo 223, each Inex one; the turn is chosen so that the series in being
  // are numbered as in the published canons.
  bool const solar = kind == EclipseKind::Solar;
  long const n = lunation + 105;
  double const turns = -61.0 * static_cast<double>(n) / 358.0;
  long const whole = static_cast<long>(std::floor(turns + (solar ? 0.5 : 0.4)));
  return static_cast<int>((solar ? 136 : 148) + 38 * n + 223 * whole);
}

}  // namespace antumbra
