// How the light in the shadow of a body with air is laid out in a table: over the distance from the
// axis, dense on both sides of the umbra's rim, where light changes by a factor of three in 100 km
// (the Earth's at the Moon). 0 on the axis, 0.5 at the rim, 1 at the penumbra's outer edge.
#ifndef SHARED_REFRACTED_SHADOW_GLSL
#define SHARED_REFRACTED_SHADOW_GLSL
#include "shared/quantities.glsl"

Number placeOfDistance(Length distance, Length rim, Length reach) {
  if (distance < rim) {
    return 0.5 - 0.5 * sqrt(1.0 - distance / rim);
  }
  return 0.5 + 0.5 * sqrt(min((distance - rim) / (reach - rim), 1.0));
}

Length distanceOfPlace(Number place, Length rim, Length reach) {
  Number from = 2.0 * place - 1.0;
  if (from < 0.0) {
    return rim * (1.0 - from * from);
  }
  return rim + (reach - rim) * from * from;
}
#endif
