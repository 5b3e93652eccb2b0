// The Sun's limb darkening, I(mu) / I(1) with mu the cosine of the angle from the solar normal, for
// four wavelengths at once. One expression holds every law: mu^alpha times a polynomial of mu
//   hestroffer  Hestroffer & Magnan 1998, A&A 333, 338: alpha = -0.023 + 0.292 / wavelength in um
//   neckel      Neckel 2005, Sol. Phys. 229, 13: alpha = 0, a polynomial of the fifth degree
//   none        alpha = 0, polynomial 1
// What an eclipse needs is the light between the limb and a ring, whose closed form keeps the shape
// mu^2 mu^alpha times a polynomial. src/eclipse/limb_darkening.h fills the structure.
#ifndef SHARED_LIMB_DARKENING_GLSL
#define SHARED_LIMB_DARKENING_GLSL
#include "shared/eclipse_types.glsl"

// Brightness at `cosine` (mu, in [0, 1]) relative to the disc's mean.
Spectrum solarBrightness(LimbDarkening law, Number cosine) {
  Number mu = max(cosine, 1e-9);
  Spectrum polynomial =
      law.brightness0 +
      mu * (law.brightness1 +
            mu * (law.brightness2 +
                  mu * (law.brightness3 + mu * (law.brightness4 + mu * law.brightness5))));
  return exp2(law.exponent * log2(mu)) * polynomial;
}

// Share of the disc's light that comes from outside the ring whose squared cosine is
// `cosineSquared`, that is between that ring and the limb: 0 at the limb, 1 at the centre.
Spectrum lightOutsideRing(LimbDarkening law, Number cosineSquared) {
  Number squared = max(cosineSquared, 1e-18);
  Number mu = sqrt(squared);
  Spectrum polynomial =
      law.ring0 +
      mu * (law.ring1 + mu * (law.ring2 + mu * (law.ring3 + mu * (law.ring4 + mu * law.ring5))));
  return squared * exp2(0.5 * law.exponent * log2(squared)) * polynomial;
}
#endif
