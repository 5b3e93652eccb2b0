// The footprint of a point source in a picture: the cubic B-spline, a near-Gaussian of standard
// deviation 1/sqrt(3) pixel over 4x4 pixels. Its samples at whole steps sum to exactly 1 and keep the
// first moment, wherever the source lies between pixel centres, so that flux and centroid survive
// sampling (Unser 1999, IEEE Signal Process. Mag. 16(6), 22: partition of unity and reproduction of
// polynomials).
#ifndef SHARED_POINT_SPREAD_GLSL
#define SHARED_POINT_SPREAD_GLSL
#include "shared/quantities.glsl"

// Share along one axis of a pixel whose centre lies `offset` pixels from the source.
Number pointSpread(Number offset) {
  Number x = abs(offset);
  Number outer = max(2.0 - x, 0.0);
  Number inner = max(1.0 - x, 0.0);
  return (outer * outer * outer - 4.0 * inner * inner * inner) / 6.0;
}
#endif
