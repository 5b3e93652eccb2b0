// The faintest point of light that a naked eye sees on a uniform sky.
// Hecht 1947 (JOSA 37, 59) as in Schaefer 1990 (PASP 102, 212): with B in nanolamberts the
// threshold in foot-candles is C (1 + sqrt(K B))^2, C = 10^-9.80 and K = 10^-1.90 for rods, C =
// 10^-8.35 and K = 10^-5.90 for cones, from log B = 3.17 on. To be honest: a practised observer
// with both eyes and no hurry; people differ by 1 magnitude. The two branches part by 0.1 magnitude
// where they meet.
#pragma once

#include <algorithm>
#include <cmath>

namespace antumbra {

// Illuminance in lux, on a surface facing the point, for a sky of `luminance` cd/m2.
inline double faintestPointLux(double luminance) {
  constexpr double kNanolambert = 3.183e-6;  // cd/m2: 1e-5 / pi
  constexpr double kFootCandle = 10.764;     // lux
  double const b = std::max(luminance, 0.0) / kNanolambert;
  bool const rods = b < 1479.108;  // 10^3.17
  double const c = rods ? 1.58489e-10 : 4.46684e-9;
  double const k = rods ? 1.258925e-2 : 1.258925e-6;
  double const root = 1.0 + std::sqrt(k * b);
  return kFootCandle * c * root * root;
}

}  // namespace antumbra
