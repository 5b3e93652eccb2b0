// What a dark-adapted eye makes of a colour: rods take over from cones as light fades.
//
// Scotopic luminance of a colour from its XYZ: Ward Larson, Rushmeier & Piatko 1997 (IEEE TVCG 3,
// 291), V' = Y (1.33 (1 + (Y + Z) / X) - 1.68). Cones and rods share the range of CIE 191:2010 (0.005
// to 5 cd/m2) evenly in the logarithm; rods count as 683/1700 of their scotopic luminance, so that
// both agree at 555 nm. Rods have no hue: their grey is the bluish one that matches night scenes, x =
// y = 0.25 (Jensen et al. 2000, "Night rendering", Univ. of Utah UUCS-00-016). Blue things gain and
// red ones lose (Purkinje). To be honest: loss of acuity is left to the eye that looks.
#ifndef SHARED_NIGHT_VISION_GLSL
#define SHARED_NIGHT_VISION_GLSL
#include "shared/quantities.glsl"

// Luminance that rods give a linear sRGB colour (cd/m^2), comparable with its own.
Number rodLuminance(Colour c) {
  Number x = 0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z;
  Number y = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
  Number z = 0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z;
  Number scotopic = y * (1.33 * (1.0 + (y + z) / max(x, 1.0e-30)) - 1.68);
  return max(scotopic, 0.0) * (683.0 / 1700.0);
}

// Share of the rods in what is seen of a colour. `threshold`: luminance that the rods can just see in
// their present state, cd/m^2.
Number rodShare(Colour c, Number threshold) {
  Number rods = rodLuminance(c);
  Number cones = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
  Number brightest = max(max(rods, cones), 1.0e-30);
  Number photopic = clamp((log2(brightest) - log2(0.005)) / log2(1000.0), 0.0, 1.0);
  return (1.0 - photopic) * rods / (rods + threshold + 1.0e-30);
}

// Seen colour, cd/m^2 in linear sRGB.
Colour nightColour(Colour c, Number threshold) {
  Number share = rodShare(c, threshold);
  Number rods = rodLuminance(c);
  // Linear sRGB of luminance 1 at x = y = 0.25.
  Colour grey = Colour(0.7062 * rods, 0.9899 * rods, 1.9657 * rods);
  return c + (grey - c) * share;
}
#endif
