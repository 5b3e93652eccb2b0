// From scene luminance to a display: a curve of luminance, then the colour at that luminance.
//
// The curve is the identity up to kToneKnee and above it approaches 1 like a stop of film,
//   f(x) = knee + (1 - knee) t / (1 + t^p)^(1/p),  t = (x - knee) / (1 - knee),  p = 4/3:
// slope 1 at the knee; white lands at 0.74, one stop above it at 0.89, five at 0.997. Shadows stay
// linear, so that the display shows true ratios up to the knee.
//
// A colour keeps its ratios to grey (the line through white in linear sRGB) and gives up saturation
// only as its largest channel meets the display's white, or its smallest the display's black, by a
// smooth minimum: hue does not jump where a channel saturates, and what is far above white is white.
#ifndef SHARED_TONE_CURVE_GLSL
#define SHARED_TONE_CURVE_GLSL
#include "shared/quantities.glsl"

const Number kToneKnee = 0.35;

// Luminance over that of display white (1 = white where nothing is compressed) to display, [0, 1).
Number toneCurve(Number x) {
  Number t = max((x - kToneKnee) / (1.0 - kToneKnee), 1.0e-12);
  // (1 + t^(4/3))^(-3/4) by one power and two roots; t^(4/3) stays within floats up to 1e28.
  Number grown = 1.0 + t * exp2(log2(t) / 3.0);
  Number root = sqrt(grown);
  return x <= kToneKnee ? x
                        : min(kToneKnee + (1.0 - kToneKnee) * t / (root * sqrt(root)), 1.0);
}

// ITU-R BT.709 / IEC 61966-2-1: luminance of linear sRGB.
Number luminanceOfColour(Colour c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

// The largest s in (0, 1] with s * reach below headroom, rounded off where both are alike.
Number saturationWithin(Number reach, Number headroom) {
  // 1 / (1 + ratio^4)^(1/4) with ratio = reach over headroom; the larger of both is taken out, so
  // that nothing overflows.
  Number r = max(reach, 1.0e-12);
  Number h = max(headroom, 1.0e-12);
  Number larger = max(r, h);
  Number a = (r / larger) * (r / larger);
  Number b = (h / larger) * (h / larger);
  return h / (larger * sqrt(sqrt(a * a + b * b)));
}

// Linear sRGB in [0, 1] for the display. `scene` in cd/m^2 per channel, negative channels allowed
// (colours outside sRGB); `perCandela` is 1 over the luminance of white.
Colour displayColour(Colour scene, Number perCandela) {
  Number luminance = luminanceOfColour(scene);
  Number shown = toneCurve(max(luminance, 0.0) * perCandela);
  Number scale = shown / max(luminance, 1.0e-30);
  Colour colour = scene * scale;
  Number most = max(max(colour.x, colour.y), colour.z) - shown;
  Number least = shown - min(min(colour.x, colour.y), colour.z);
  Number saturation = saturationWithin(most, 1.0 - shown);
  // Inside the gamut black is no limit; outside the channel lands on zero.
  saturation = min(saturation, least > shown ? shown / least : 1.0);
  Colour grey = Colour(shown, shown, shown);
  Colour result = grey + (colour - grey) * saturation;
  return luminance > 0.0 ? result : Colour(0.0, 0.0, 0.0);
}

// IEC 61966-2-1 opto-electronic transfer of one channel.
Number srgbEncoded(Number linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}
#endif
