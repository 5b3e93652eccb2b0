// How surfaces return sunlight.
//
// seaGlint: sunlight mirrored by wind waves, slope statistics of Cox & Munk 1954 (J. Opt. Soc. Am. 44,
// 838): isotropic mean square slope 0.003 + 0.00512 W; Fresnel reflectance by Schlick's fit with
// 0.02 at normal incidence (within 0.01 of the exact value for water below 85 deg).
// lunarReflection: Lommel-Seeliger scattering, 2 mu0 / (mu0 + mu), times a function of phase that is 1
// at full Moon: the disc is uniform then, as the real one is.
#ifndef SHARED_SURFACE_GLSL
#define SHARED_SURFACE_GLSL
#include "shared/quantities.glsl"

// Cosine-weighted share of a uniform solar disc of angular radius `size` above the horizon whose
// centre stands at `cosine` from the zenith; within 2 % of the peak at the horizon itself.
Number sunOnHorizontal(Number cosine, Angle size) {
  if (cosine >= size) {  // also where a point stands on the horizon
    return cosine;
  }
  if (cosine <= -size) {
    return 0.0;
  }
  Number up = cosine + size;
  return up * up / (4.0 * size);
}

// Radiance over the irradiance on a surface facing the Sun, 1/sr. `wind` in m/s at 12 m height.
Number seaGlint(Direction normal, Direction toCamera, Direction toSun, Number wind) {
  Direction middle = normalize(toCamera + toSun);
  Number tilt = max(dot(middle, normal), 1.0e-3);
  Number slopeSquare = 0.003 + 0.00512 * wind;
  Number tiltSquare = tilt * tilt;
  Number probability =
      exp(-(1.0 - tiltSquare) / (tiltSquare * slopeSquare)) / (kPi * slopeSquare);
  Number facing = 1.0 - max(dot(middle, toCamera), 0.0);
  Number facingSquare = facing * facing;
  Number mirrored = 0.02 + 0.98 * facingSquare * facingSquare * facing;
  Number view = max(dot(normal, toCamera), 0.05);
  return mirrored * probability / (4.0 * view * tiltSquare * tiltSquare);
}

Number lunarReflection(Number sunCosine, Number viewCosine, Number phase) {
  return phase * 2.0 * sunCosine / max(sunCosine + viewCosine, 1.0e-4);
}
#endif
