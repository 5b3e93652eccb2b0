// Phase functions: how scattered light is spread over directions, in 1/sr, normalised so that the
// integral over the sphere is 1. `cosine` is that of the scattering angle, 1 = straight on.
#ifndef SHARED_PHASE_GLSL
#define SHARED_PHASE_GLSL
#include "shared/quantities.glsl"

// Molecules, without depolarisation (Rayleigh 1871).
Number rayleighPhase(Number cosine) { return 3.0 / (16.0 * kPi) * (1.0 + cosine * cosine); }

// 1 + g^2 - 2 g cosine, written so that it keeps its precision in a narrow peak. Needs |g| < 1.
Number henyeyGreensteinBase(Number cosine, Number g) {
  Number gap = 1.0 - abs(g);
  Number towards = 1.0 - cosine;
  if (g < 0.0) towards = 1.0 + cosine;
  return gap * gap + 2.0 * abs(g) * towards;
}

// Henyey & Greenstein 1941 (ApJ 93, 70); g is the mean cosine, -1 < g < 1.
Number henyeyGreensteinPhase(Number cosine, Number g) {
  Number base = henyeyGreensteinBase(cosine, g);
  return (1.0 - g * g) / (4.0 * kPi * base * sqrt(base));
}

// Cornette & Shanks 1992 (Appl. Opt. 31, 3152, eq. 8): physical for small g, -1 < g < 1. Its mean
// cosine is g (12 + 3 g^2) / (10 + 5 g^2), not g.
Number cornetteShanksPhase(Number cosine, Number g) {
  Number base = henyeyGreensteinBase(cosine, g);
  return 3.0 * (1.0 - g * g) * (1.0 + cosine * cosine) /
         (8.0 * kPi * (2.0 + g * g) * base * sqrt(base));
}

// Two Henyey-Greenstein lobes (Kattawar 1975): `forwardShare` of the light in the first.
Number doubleHenyeyGreensteinPhase(Number cosine, Number forwardG, Number backwardG,
                                   Number forwardShare) {
  return forwardShare * henyeyGreensteinPhase(cosine, forwardG) +
         (1.0 - forwardShare) * henyeyGreensteinPhase(cosine, backwardG);
}
#endif
