#include "geodesy/refraction.h"

#include <algorithm>
#include <cmath>

namespace antumbra {

Angle refractionAt(Angle airlessAltitude, SurfaceAir air) {
  double const h = airlessAltitude / degree;
  if (h <= -2.0) return Angle();
  double const used = std::max(h, -1.0);
  double const arcminutes = 1.02 / std::tan((used + 10.3 / (used + 5.11)) * degree.si) + 0.0019279;
  double const scale = air.pressureHectopascal / 1010.0 * 283.0 / (273.0 + air.temperatureCelsius);
  return std::max(arcminutes, 0.0) * scale * std::min(1.0, h + 2.0) * arcminute;
}

}  // namespace antumbra
