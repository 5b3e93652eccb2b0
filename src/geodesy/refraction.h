// Refraction of a ray from outside the air, by altitude: Saemundsson's formula (Sky & Telescope 72,
// 70, 1986; the inverse of Bennett 1982), accurate to 0.07' against a standard atmosphere above the
// horizon. For quick work on positions; light paths inside the rendered air are traced there.
#pragma once

#include "quantity/quantity.h"

namespace antumbra {

struct SurfaceAir {
  double pressureHectopascal = 1010.0;
  double temperatureCelsius = 10.0;
};

// What to add to the airless altitude. Zero below -2 degrees, where no such ray meets the ground
// from space; between -2 and -1 degrees it falls to zero.
Angle refractionAt(Angle airlessAltitude, SurfaceAir air = {});

}  // namespace antumbra
