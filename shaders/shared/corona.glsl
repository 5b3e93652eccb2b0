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
// the solar cycle (Pishkalo 2011, Sol. Phys. 270, 347). The F corona stays round. A real eclipse's
// streamers are not predictable: coronaStructure invents some, for scenes that ask for them.
//
// Chromosphere: the light of H alpha, D3, H beta and H gamma above the limb, of the order of
// 1e6 erg cm^-2 s^-1 sr^-1 in H alpha at the base, a factor e less every 1500 km (flash spectra: Dunn et
// al. 1968, ApJS 15, 275): an order of magnitude, spicules smoothed out.
#ifndef SHARED_CORONA_GLSL
#define SHARED_CORONA_GLSL
#include "shared/eclipse_types.glsl"

// Solar radii. Here the F corona has sunk to the zodiacal light, which is not drawn (about 0.02 cd/m^2;
// faded over the last third).
const Number kCoronaEnd = 45.0;

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

// What is left of the corona where it goes over into the zodiacal light.
Number coronaFade(Number radius) {
  return 1.0 - smoothstep(kCoronaEnd * 2.0 / 3.0, kCoronaEnd, radius);
}

// Binary logarithm of the corona's light past a caster, as a share of the whole Sun's. `along`: place
// along the shadow's axis, 0 to 1 over what the fit holds for; `across`: squared distance from the
// axis over the umbra's radius there, 1 at its edge and beyond.
Number coronaPastCaster(CoronaFit fit, Number along, Number across) {
  Coefficients c = fit.constant + along * (fit.linear + along * fit.square);
  return c.x + across * (c.y + across * (c.z + across * c.w));
}

// exp(-x) I0(x), the mean over a turn of exp(x (cos - 1)): Abramowitz & Stegun, 9.8.1 and 9.8.2, within
// 2e-6.
Number meanOfRay(Number x) {
  Number t = x / 3.75;
  if (x < 3.75) {
    Number q = t * t;
    return exp(-x) *
           (1.0 + q * (3.5156229 +
                       q * (3.0899424 +
                            q * (1.2067492 +
                                 q * (0.2659732 + q * (0.0360768 + q * 0.0045813))))));
  }
  Number u = 1.0 / t;
  return (0.39894228 +
          u * (0.01328592 +
               u * (0.00225319 +
                    u * (-0.00157565 +
                         u * (0.00916281 +
                              u * (-0.02057706 +
                                   u * (0.02635537 + u * (-0.01647633 + u * 0.00392377)))))))) /
         sqrt(x);
}

Number between0And1(Number x) {
  return x - floor(x);
}

// Structure of the K corona: a factor whose mean over the position angle is 1 at every distance, so
// that the measured profile stays. Invented, and the same for every eclipse of a like phase: eight
// helmet streamers, broad at the base and narrow from 2.5 radii on, near the equator at minimum and
// at all latitudes at maximum; polar plumes at minimum; faint rays. `angle` counts from the Sun's
// equator in the west (right, north up) toward north.
Number coronaStructure(Number radius, Angle angle, Number activity) {
  Number out1 = clamp((radius - 1.0) / 1.5, 0.0, 1.0);
  Number sum = 0.0;
  Number mean = 0.0;
  for (Index i = 0; i < 8; i = i + 1) {
    Number u = between0And1(0.7548776662 * Number(i) + 0.31);
    Number v = between0And1(0.5698402910 * Number(i) + 0.17);
    Angle centre = 2.0 * kPi * (Number(i) + 0.7 * (u - 0.5)) / 8.0;
    Number sine = sin(centre);
    Number weight = (0.4 + v) * mix(exp(-sine * sine / 0.16), 1.0, activity);
    Number sharp = (5.0 + 45.0 * out1 * out1) * (0.6 + 0.8 * u);
    sum = sum + weight * exp(sharp * (cos(angle - centre) - 1.0));
    mean = mean + weight * meanOfRay(sharp);
  }
  Number contrast = 0.35 + 0.35 * out1;
  Number bend = 2.0 * log(radius);
  Number rays = 0.045 * cos(31.0 * angle + 1.0 + bend) + 0.035 * cos(53.0 * angle + 4.0 - bend) +
                0.03 * cos(89.0 * angle + 2.0 + bend);
  Number fromPole = cos(angle);
  Number plumes = 0.3 * (1.0 - activity) * exp(-fromPole * fromPole / 0.12) *
                  (cos(67.0 * angle + 0.7) + 0.5 * cos(101.0 * angle + 2.1)) / 1.5;
  Number near = clamp((radius - 1.0) / 0.15, 0.0, 1.0);
  return 1.0 + contrast * (sum / mean - 1.0) + near * (rays + plumes * (1.0 - out1));
}

// Corona with its structure.
Number structuredCorona(Number radius, Number sineLatitude, Angle angle, Number flattening,
                        Number activity) {
  Number smooth_ = coronaBrightness(radius, sineLatitude, flattening);
  Number dust = dustCorona(radius);
  return dust + (smooth_ - dust) * coronaStructure(radius, angle, activity);
}

// Quiescent prominences: H alpha of the order of 1e5 erg cm^-2 s^-1 sr^-1 (Gouttebroze, Heinzel & Vial
// 1993, A&AS 99, 513), with the other lines 1e4 cd/m^2 over the disc's centre. Their places and shapes
// are invented: arches with threads, 15 to 60 Mm high.
const Number kProminence = 4.4e-6;

Number prominences(Number height, Angle angle, Index count) {
  Number light = 0.0;
  for (Index i = 0; i < count; i = i + 1) {
    Number u = between0And1(0.6180339887 * Number(i) + 0.42);
    Number v = between0And1(0.7548776662 * Number(i) + 0.11);
    Number w = between0And1(0.5698402910 * Number(i) + 0.77);
    Number off = between0And1((angle / (2.0 * kPi)) - u + 0.5) - 0.5;
    Number along = 2.0 * kPi * off;  // solar radii along the limb
    Number high = 0.022 + 0.064 * v * v;
    Number wide = 0.025 + 0.05 * w;
    Number leaning = along + (w - 0.5) * height;
    Number x = leaning / wide;
    Number y = height / high;
    Number q = sqrt(x * x + y * y);
    if (q < 2.0) {
      Number arch = (q - 0.8) / 0.2;
      Number threads = 0.65 + 0.35 * cos(22.0 * x + 9.0 * y * v) * cos(5.0 * y + 7.0 * w);
      light = light + (exp(-arch * arch) + 0.35 * exp(-3.0 * q * q)) * threads;
    }
  }
  return kProminence * light;
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
