// Where a table of phase functions holds a cosine, from 0 to 1: dense toward straight on and straight
// back, quartic on either side of a right angle. Only the air's tables include it.
#ifndef SHARED_PHASE_PLACE_GLSL
#define SHARED_PHASE_PLACE_GLSL
#include "shared/quantities.glsl"

const Number kForwardShare = 0.72;  // the place of a right angle

Number phasePlace(Number cosine) {
  Number root = sqrt(sqrt(clamp(1.0 - abs(cosine), 0.0, 1.0)));
  return cosine > 0.0 ? kForwardShare * root : 1.0 - (1.0 - kForwardShare) * root;
}

Number phaseCosine(Number place) {
  Number root =
      place < kForwardShare ? place / kForwardShare : (1.0 - place) / (1.0 - kForwardShare);
  Number gap = 1.0 - root * root * root * root;
  return place < kForwardShare ? gap : -gap;
}
#endif
