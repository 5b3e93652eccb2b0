// Light of a plane-parallel layer of particles, scattered once: the radiance factor (pi L over the
// irradiance of a plane that faces the Sun) by Chandrasekhar 1960, Radiative Transfer, ch. III, as for
// planetary rings by Dones, Cuzzi & Showalter 1993, Icarus 105, 184. Exact for single scattering in a
// layer many particles thick.
//
// To be honest: light scattered more than once (a tenth of the B ring's at small phase angles, most of
// its light on the unlit side), the planet's light on the rings and the rings' on the planet, the
// opposition surge within a degree and the clumping of particles into wakes are left out.
#ifndef SHARED_RINGS_GLSL
#define SHARED_RINGS_GLSL
#include "shared/quantities.glsl"

// Phase function (pi - phase angle)^n, whose mean over the sphere is 1 with `norm` of
// src/passes/rings.cpp.
Number ringPhase(Angle phase, Number exponent, Number norm) {
  return norm * pow(max(kPi - phase, 1e-6), exponent);
}

// (1 - exp(-x)) / x for x >= 0.
Number shareOfLayer(Number x) {
  if (x < 1e-2) {
    return 1.0 - x * (0.5 - x / 6.0);
  }
  return (1.0 - exp(-x)) / x;
}

// Radiance factor over albedo and phase function. `sunSine`, `viewSine`: sines, positive, of the
// heights of the Sun and the viewer over the plane; `lit`: both on one side of it.
Number ringScattering(Number depth, Number sunSine, Number viewSine, bool lit) {
  Number sun = depth / sunSine;
  Number view = depth / viewSine;
  if (lit) {
    return 0.25 * view * shareOfLayer(sun + view);
  }
  return 0.25 * view * exp(-min(sun, view)) * shareOfLayer(abs(view - sun));
}
#endif
