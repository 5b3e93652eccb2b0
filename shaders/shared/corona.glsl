// Brightness of the solar corona and chromosphere on the sky, in units of the luminance of the
// disc's centre, against the distance from the Sun's centre in solar radii.
//
// Corona: Baumbach 1937, Astron. Nachr. 263, 121, the mean of the eclipses of 1905-1929 (also Allen,
// Astrophysical Quantities, 3rd ed., section 84):
//   1e-6 (2.565 r^-17 + 1.425 r^-7 + 0.0532 r^-2.5)
// The two steep terms are the K corona (sunlight scattered by electrons), the last the F corona
// (by dust), as van de Hulst 1950 (Bull. Astron. Inst. Netherlands 11, 135) parts them. Accurate to
// about 20 % between 1 and 4 radii for the average corona; the K corona of one day differs by a
// factor of two. White: electrons scatter without colour; the slight reddening of F is left out.
//
// Shape: isophotes of the K corona are flattened by Ludendorff's index, epsilon = equatorial over
// polar diameter - 1 at 2 radii, rising from 0 at the limb: about 0.3 at minimum and 0.05 at maximum of
// the solar cycle (Pishkalo 2011, Sol. Phys. 270, 347). The F corona stays round. No streamers: a real
// eclipse's are not predictable, and inventing them would not be a measurement.
//
// Chromosphere: the light of H alpha, D3, H beta and H gamma above the limb, of the order of
// 1e6 erg cm^-2 s^-1 sr^-1 in H alpha at the base, a factor e less every 1500 km (flash spectra: Dunn et
// al. 1968, ApJS 15, 275): an order of magnitude, spicules smoothed out.
#ifndef SHARED_CORONA_GLSL
#define SHARED_CORONA_GLSL
#include "shared/quantities.glsl"

const Number kChromosphereScale = 0.002156;  // 1500 km in solar radii
// 1e5 cd/m^2 at the base over the 2.3e9 cd/m^2 of the disc's centre.
const Number kChromosphereBase = 4.4e-5;

// Line intensities to H alpha 1, H beta 0.18, D3 0.05, H gamma 0.06 (Dunn et al. 1968, rounded) by the
// CIE 1931 observer: linear sRGB of luminance 1, a magenta red.
Colour chromosphereColour() {
  return Colour(3.97, 0.083, 1.32);
}

// K corona at `radius` >= 1 on a circle.
Number electronCorona(Number radius) {
  Number inverse = 1.0 / max(radius, 1.0);
  Number second = inverse * inverse;
  Number fourth = second * second;
  Number seventh = fourth * second * inverse;
  Number seventeenth = seventh * seventh * second * inverse;
  return 1.0e-6 * (2.565 * seventeenth + 1.425 * seventh);
}

// F corona at `radius` >= 1.
Number dustCorona(Number radius) {
  Number inverse = 1.0 / max(radius, 1.0);
  return 0.0532e-6 * inverse * inverse * sqrt(inverse);
}

// Ludendorff's flattening index from the phase of the solar cycle: 0 at minimum, 1 at maximum.
Number flatteningOfActivity(Number activity) {
  return 0.30 - 0.25 * activity;
}

// Corona at `radius` where `sineLatitude` is the sine of the position angle from the Sun's equator.
Number coronaBrightness(Number radius, Number sineLatitude, Number flattening) {
  Number index = flattening * clamp(radius - 1.0, 0.0, 1.0);
  // Isophotes r0 (1 + e cos 2 latitude) whose axes differ by the index.
  Number e = index / (2.0 + index);
  Number cosDouble = 1.0 - 2.0 * sineLatitude * sineLatitude;
  return electronCorona(radius / (1.0 + e * cosDouble)) + dustCorona(radius);
}

// Light of the round corona from beyond `radius` as a share of the whole Sun's: the profile's integral
// in closed form, up to `last` radii. `centreOverMean` is the disc's central brightness over its mean
// (solarBrightness at 1).
Number coronaShareBetween(Number radius, Number last, Number centreOverMean) {
  Number inverse = 1.0 / max(radius, 1.0);
  Number fifth = inverse * inverse * inverse * inverse * inverse;
  Number inverseLast = 1.0 / last;
  Number fifthLast = inverseLast * inverseLast * inverseLast * inverseLast * inverseLast;
  Number steep = 2.565 / 15.0 * (fifth * fifth * fifth - fifthLast * fifthLast * fifthLast) +
                 1.425 / 5.0 * (fifth - fifthLast);
  Number dust = 0.0532 / 0.5 * (sqrt(inverse) - sqrt(inverseLast));
  return 2.0e-6 * centreOverMean * (steep + dust);
}

// Mean of the chromosphere between two distances from the centre, inner < outer: a pixel is mostly
// wider than it.
Number chromosphereBetween(Number inner, Number outer) {
  Number low = max(inner - 1.0, 0.0) / kChromosphereScale;
  Number high = max(outer - 1.0, 0.0) / kChromosphereScale;
  return kChromosphereBase * kChromosphereScale * (exp(-low) - exp(-high)) / (outer - inner);
}
#endif
