// The table of the halo near its source: the sum over the source's parts, over the halo of a soft point
// at their centroid. Its coordinates squeeze the plane (in units of nearScale) into a square:
// q = u / (1 - |u|) in both directions, so that the table reaches to the horizon of the plane, where it
// is 1.
#include "shared/glare.glsl"

uniform float agingFourth;
uniform float pigmentation;
uniform float nearScale;      // tangent of the unit's angle
uniform float magnification;  // the eye's angle over the sky's

// Halo of a point, per steradian of sky.
float pointHalo(float angleSquared) {
  float m2 = magnification * magnification;
  return m2 * eyeHalo(m2 * angleSquared, agingFourth, pigmentation);
}

// The same blurred over nearScale: smooth at its centre, where the sum is compared with it.
float softHalo(float angleSquared) {
  float m2 = magnification * magnification;
  return m2 * eyeSpread(m2 * (angleSquared + nearScale * nearScale), agingFourth, pigmentation);
}
