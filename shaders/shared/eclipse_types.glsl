// What the shadow functions (eclipse.glsl, limb_darkening.glsl) pass around. Apart from them, so
// that in C++ the types belong to the program while the functions are compiled into each user.
#ifndef SHARED_ECLIPSE_TYPES_GLSL
#define SHARED_ECLIPSE_TYPES_GLSL
#include "shared/quantities.glsl"

// A law of limb darkening at four wavelengths (limb_darkening.glsl; eclipse/limb_darkening.h).
struct LimbDarkening {
  Spectrum exponent;     // alpha of mu^alpha
  Spectrum brightness0;  // polynomial of mu: brightness relative to the disc's mean
  Spectrum brightness1;
  Spectrum brightness2;
  Spectrum brightness3;
  Spectrum brightness4;
  Spectrum brightness5;
  Spectrum ring0;  // polynomial of mu: light between a ring and the limb, over mu^(2 + alpha)
  Spectrum ring1;
  Spectrum ring2;
  Spectrum ring3;
  Spectrum ring4;
  Spectrum ring5;
};

// The Sun and one occulter in the sky of a point, as circles in a plane.
struct DiscPair {
  Angle sun;     // radius of the Sun
  Angle excess;  // radius of the occulter minus that of the Sun
  Angle gap;  // widest part of the visible crescent: separation minus excess. Total eclipse where
              // gap <= 0; nothing hidden where gap >= 2 sun
};

// The shadow that a sphere or an oblate spheroid casts, prepared in double precision on the CPU for
// points near an origin (eclipse/shadow_pair.h). Fills five vec4 in this order. All of it holds in
// the caster's space: axes stretched along its pole about the origin, so that the caster is a sphere
// of its equatorial radius (the same space for a sphere). Radii are measured across the axis, toward
// the caster's equator; elsewhere the Sun, a spheroid there, reaches farther (ShadowPlace).
struct ShadowPair {
  Position foot;          // point of the shadow axis nearest the origin
  Length umbraRadius;     // at the foot; negative beyond the apex (antumbra)
  Direction axis;         // away from the Sun
  Length penumbraRadius;  // at the foot
  Length casterBehind;    // from the caster's centre to the foot along the axis
  Length sunBehind;       // from the Sun's centre to the foot along the axis
  Length casterRadius;
  Length sunRadius;
  Number umbraTangent;  // loss of umbral radius per metre along the axis
  Number umbraSine;     // of the umbral cone's half-angle
  Number umbraCosine;
  Number penumbraTangent;  // gain of penumbral radius per metre along the axis
  Direction pole;          // of the caster
  Number squash;           // its equatorial over its polar radius, minus 1
};

// Where a point lies in a shadow, in the caster's space.
struct ShadowPlace {
  Length along;     // along the axis from the foot, away from the Sun
  Length distance;  // from the axis
  Direction away;   // unit vector from the axis to the point; any unit vector on the axis
  Number stretch;   // reach of the Sun toward `away` over its radius: 1 for a spherical caster
};

// What a caster leaves of the corona's light about one receiver (corona.glsl; eclipse/corona_light.h
// fills it): of each power of the place along the axis a polynomial of the place across it.
struct CoronaFit {
  Coefficients constant;
  Coefficients linear;
  Coefficients square;
};

// Discs before the Sun, in its radii and about its centre.
const Index kMostDiscs = 6;
struct SunCover {
  Index count;
  Number radius[6];
  Number away[6];  // of the centre from the Sun's
  Angle turn[6];   // direction of the centre about the Sun's
};

// Where a ray crosses a cone. `count` is 0 or 2; between `first` and `second` the ray is inside the
// cone if `insideBetween` is 1, and outside if it is 0 (a ray steeper than the cone's flank).
struct ConeCrossing {
  Index count;
  Length first;
  Length second;
  Number insideBetween;
};
#endif
