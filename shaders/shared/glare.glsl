// Light scattered in the human eye: the CIE total glare function,
//   CIE 135/1 (1999), "Disability glare"; Vos & van den Berg 1999: veiling luminance over illuminance at the
//   eye, in 1/sr, for theta in degrees, age A in years, pigmentation p (0 dark, 0.5 brown, 1 light blue,
//   1.2 very light eyes):
//   [1 - 0.08 (A/70)^4] [9.2e6 / (1 + (t/0.0046)^2)^1.5 + 1.5e5 / (1 + (t/0.045)^2)^1.5]
//   + [1 + 1.6 (A/70)^4] {400 / (1 + (t/0.1)^2) + 3e-8 t^2
//                         + p [1300 / (1 + (t/0.1)^2)^1.5 + 0.8 / (1 + (t/0.1)^2)^0.5]} + 2.5e-3 p
// Stated to hold from 0 to 100 degrees, where it integrates to 1; beyond, extrapolated.
//
// What a picture adds is the halo: the function without its core, which is the eye's blur of a point
// and left to the eye that looks at the picture. The core is faded out inside kGlareCore.
#ifndef SHARED_GLARE_GLSL
#define SHARED_GLARE_GLSL
#include "shared/quantities.glsl"

const Number kGlareDegree = 57.29577951308232;  // degrees in a radian
const Angle kGlareCore = 1.7453292519943295e-3;  // 0.1 degree

// The whole function, 1/sr, of the squared angle. `agingFourth` is (A/70)^4. Through an instrument of
// magnification m the eye sees m times the angle, and the halo of a point at angle t of the sky is
// m^2 times the function at m t: the callers scale.
Number eyeSpread(Number angleSquared, Number agingFourth, Number pigment) {
  Number t2 = angleSquared * (kGlareDegree * kGlareDegree);
  Number sharp = 1.0 + t2 / (0.0046 * 0.0046);
  Number middle = 1.0 + t2 / (0.045 * 0.045);
  Number wide = 1.0 + t2 / (0.1 * 0.1);
  Number core = 9.2e6 / (sharp * sqrt(sharp)) + 1.5e5 / (middle * sqrt(middle));
  Number wideRoot = sqrt(wide);
  Number scattered =
      400.0 / wide + 3.0e-8 * t2 + pigment * (1300.0 / (wide * wideRoot) + 0.8 / wideRoot);
  return (1.0 - 0.08 * agingFourth) * core + (1.0 + 1.6 * agingFourth) * scattered +
         2.5e-3 * pigment;
}

// The halo of a point, 1/sr.
Number eyeHalo(Number angleSquared, Number agingFourth, Number pigment) {
  Number faded = 1.0 - exp(-angleSquared / (kGlareCore * kGlareCore));
  return eyeSpread(angleSquared, agingFourth, pigment) * faded;
}
#endif
