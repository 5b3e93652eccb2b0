// Geometry of rays in a spherical shell of air, and where its tables are looked up.
//
// Nothing here subtracts two radii: heights above the ground follow from heights, "rises" (r times
// the cosine of the zenith angle, in metres) and products such as h (2 R + h), so that a float keeps
// centimetres at the ground of a planet and relative precision at its horizon. A ray is cut into
// legs along which it only rises; each leg is described from its low end.
//
// Mapping of the optical depth after Bruneton & Neyret 2008 (Comput. Graph. Forum 27, 1079), sect. 4:
// the distance to the top boundary between its least and greatest value at that height, which
// resolves the horizon.
#ifndef SHARED_AIR_GEOMETRY_GLSL
#define SHARED_AIR_GEOMETRY_GLSL
#include "shared/quantities.glsl"

// Forward depth at which the last blurred phase function stands.
const Number kMostBlur = 40.0;

struct AirShell {
  Length radius;  // of the ground
  Length top;     // height of the boundary to empty space
  Length widest;  // from a point of the ground along its horizon to the top
  InverseLength overWidest;
  InverseLength overTop;
};

// Part of a ray along which it rises, seen from its low end.
struct AirLeg {
  Length lowHeight;
  Length lowRise;     // r mu at the low end, not negative
  Length lowSunRise;  // r times the cosine of the Sun's zenith angle there
  Length highHeight;
  Length lowDistance;  // from the start of the ray
  Number sense;        // 1: the light's reversed path rises from the camera; -1: it sinks
};

struct AirPoint {
  Length height;
  Length rise;      // r mu, upward along the leg
  Length sunRise;   // r times the cosine of the Sun's zenith angle
  Length fromLow;   // distance from the leg's low end
  InverseLength overRadius;  // 1 / r
  Number cosine;    // mu upward along the leg
  Number sunCosine; // of the Sun's zenith angle
};

// r^2 - R^2 of a height.
Area squareAboveGround(AirShell shell, Length height) {
  return height * (2.0 * shell.radius + height);
}

// Difference of the squared radii of two heights.
Area squareBetween(AirShell shell, Length low, Length high) {
  return (high - low) * (2.0 * shell.radius + high + low);
}

// Distance along a ray that rises with `rise` to a sphere whose squared radius is larger by `gain`;
// `root` is the rise there.
Length distanceBetweenRises(Length rise, Length root, Area gain) {
  return rise > 0.0 ? gain / (root + rise) : root - rise;
}

// Distance from a point that rises with `rise` to the sphere at `high`.
Length distanceUpTo(AirShell shell, Length height, Length rise, Length high) {
  Area gain = squareBetween(shell, height, high);
  return distanceBetweenRises(rise, sqrt(max(rise * rise + gain, 0.0)), gain);
}

AirPoint pointOnLeg(AirShell shell, AirLeg leg, Number sunAlong, Length height) {
  AirPoint point;
  Area gain = squareBetween(shell, leg.lowHeight, height);
  point.height = height;
  point.overRadius = 1.0 / (shell.radius + height);
  point.rise = sqrt(leg.lowRise * leg.lowRise + gain);
  point.fromLow = gain / max(leg.lowRise + point.rise, 1.0e-9);
  point.cosine = min(point.rise * point.overRadius, 1.0);
  point.sunRise = leg.lowSunRise + leg.sense * point.fromLow * sunAlong;
  point.sunCosine = clamp(point.sunRise * point.overRadius, -1.0, 1.0);
  return point;
}

// Height of the point `fromLow` along a leg.
Length heightOnLeg(AirShell shell, AirLeg leg, Length fromLow) {
  Area gain = fromLow * (2.0 * leg.lowRise + fromLow);
  Length low = shell.radius + leg.lowHeight;
  return leg.lowHeight + gain / (low + sqrt(low * low + gain));
}

// Cosine of the zenith angle of the ground's horizon.
Number horizonCosine(AirShell shell, Length height) {
  return -sqrt(max(squareAboveGround(shell, height), 0.0)) / (shell.radius + height);
}

// The table of optical depths to the top at one height.
struct DepthRow {
  Length across;        // distance to the ground's horizon
  Length least;         // to the top, straight up
  Area gain;            // from the squared radius there to that of the top
  InverseLength scale;  // over the longest distance to the top, less the least
};

// `height` from 0 to the top.
DepthRow depthRow(AirShell shell, Length height) {
  DepthRow row;
  row.across = sqrt(squareAboveGround(shell, height));
  row.least = shell.top - height;
  row.gain = squareBetween(shell, height, shell.top);
  row.scale = 1.0 / max(row.across + shell.widest - row.least, 1.0e-6 * shell.top);
  return row;
}

// Where in [0, 1]^2 the optical depth along a ray lies whose distance to the top is known: x over the
// zenith angle from the zenith to the horizon, y over height.
TableCoordinates depthCoordinatesAt(AirShell shell, DepthRow row, Length distance) {
  TableCoordinates place;
  place.x = clamp((distance - row.least) * row.scale, 0.0, 1.0);
  place.y = row.across * shell.overWidest;
  return place;
}

// The same for a ray that rises with `rise`.
TableCoordinates depthCoordinatesOf(AirShell shell, DepthRow row, Length rise) {
  Length root = sqrt(max(rise * rise + row.gain, 0.0));
  return depthCoordinatesAt(shell, row, distanceBetweenRises(rise, root, row.gain));
}

// The same toward the Sun in air that bends its light: `reach` makes room for one below the
// geometric horizon.
TableCoordinates sunCoordinatesOf(AirShell shell, DepthRow row, Length rise, Number overReach) {
  Length root = sqrt(max(rise * rise + row.gain, 0.0));
  DepthRow wider = row;
  wider.scale = row.scale * overReach;
  return depthCoordinatesAt(shell, wider, distanceBetweenRises(rise, root, row.gain));
}

TableCoordinates depthCoordinates(AirShell shell, Length height, Number cosine) {
  Length h = clamp(height, 0.0, shell.top);
  return depthCoordinatesOf(shell, depthRow(shell, h), (shell.radius + h) * cosine);
}

struct HeightAndCosine {
  Length height;
  Number cosine;
};

HeightAndCosine heightAndCosineAt(AirShell shell, TableCoordinates place) {
  Length across = place.y * shell.widest;
  HeightAndCosine found;
  found.height =
      across * across / (shell.radius + sqrt(shell.radius * shell.radius + across * across));
  Length least = shell.top - found.height;
  Length distance = least + place.x * (across + shell.widest - least);
  Length r = shell.radius + found.height;
  found.cosine =
      distance > 0.0
          ? clamp((squareBetween(shell, found.height, shell.top) - distance * distance) /
                      (2.0 * r * distance), -1.0, 1.0)
          : 1.0;
  return found;
}

// Height as densities and the source table have it, from 0 to 1: dense toward the ground.
Number rootHeight(AirShell shell, Length height) {
  return sqrt(clamp(height * shell.overTop, 0.0, 1.0));
}

// The source table's span of the Sun's zenith angle.
struct SunSpan {
  Number lowest;      // least cosine
  Number overLowest;  // 1 over it
  Number zero;        // where the horizontal Sun lies in [0, 1]
};

SunSpan sunSpan(Number lowest) {
  Number below = sqrt(-lowest);
  SunSpan span;
  span.lowest = lowest;
  span.overLowest = 1.0 / lowest;
  span.zero = below / (1.0 + below);
  return span;
}

// The Sun's zenith angle in the source table.
Number sourceColumn(SunSpan span, Number sunCosine) {
  Number root = sqrt(min(sunCosine > 0.0 ? sunCosine : sunCosine * span.overLowest, 1.0));
  return sunCosine > 0.0 ? span.zero + (1.0 - span.zero) * root : span.zero * (1.0 - root);
}

Number sourceSunCosine(SunSpan span, Number column) {
  Number zero = span.zero;
  Number side = column > zero ? (column - zero) / (1.0 - zero) : (zero - column) / zero;
  return column > zero ? side * side : span.lowest * side * side;
}

// Directions about the local vertical and the Sun's azimuth: harmonics that are symmetric about the
// Sun's plane. z is the vertical component, x the one toward the Sun.
//   H(l, m) = Q(l, m; z) Re (x + i y)^m,  Q(m, m) = 1,
//   (l + 1 - m) Q(l + 1, m) = (2 l + 1) z Q(l, m) - (l + m) Q(l - 1, m):
// 1; z, x; (3 z^2 - 1)/2, 3 x z, x^2 - y^2; ... Walked by order m, and by degree l within it.
struct SunFrame {
  Number z;
  Number x;
};

SunFrame sunFrame(Number cosine, Number sunCosine, Number sunAlong) {
  Number sunSine = sqrt(max(1.0 - sunCosine * sunCosine, 1.0e-8));
  Number sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  SunFrame f;
  f.z = cosine;
  f.x = clamp((sunAlong - cosine * sunCosine) / sunSine, -sine, sine);
  return f;
}

struct SunHarmonic {
  Number value;   // H(l, m)
  Number before;  // H(l - 1, m), 0 for l = m
  Number turn;    // Re (x + i y)^m
  Number turnBefore;
};

SunHarmonic firstHarmonic() {
  SunHarmonic h;
  h.value = 1.0;
  h.before = 0.0;
  h.turn = 1.0;
  h.turnBefore = 0.0;
  return h;
}

// From (l, m) to (l + 1, m).
SunHarmonic higherDegree(SunHarmonic h, SunFrame f, Index l, Index m) {
  SunHarmonic next = h;
  next.value = (Number(2 * l + 1) * f.z * h.value - Number(l + m) * h.before) / Number(l + 1 - m);
  next.before = h.value;
  return next;
}

// From any (l, m) to (m + 1, m + 1).
SunHarmonic higherOrder(SunHarmonic h, SunFrame f, Index m) {
  SunHarmonic next;
  next.turn = m == 0 ? f.x : 2.0 * f.x * h.turn - (1.0 - f.z * f.z) * h.turnBefore;
  next.turnBefore = h.turn;
  next.value = next.turn;
  next.before = 0.0;
  return next;
}

// Integral of H(l, m)^2 over the sphere.
Number harmonicNorm(Index l, Index m) {
  Number norm = 4.0 * kPi / Number(2 * l + 1);
  for (Index k = l - m + 1; k <= l + m; ++k) norm = norm * Number(k);
  for (Index k = 1; k <= m; ++k) norm = norm / Number((2 * k - 1) * (2 * k - 1));
  return m == 0 ? norm : 0.5 * norm;
}

// Rows of the blurred phase functions, 0 to `last`, over the mean depth of forward peaks on the way.
Number blurRow(Number depth, Number last) {
  return last * clamp(log(1.0 + 4.0 * depth) / log(1.0 + 4.0 * kMostBlur), 0.0, 1.0);
}
Number blurDepth(Number row, Number last) {
  return 0.25 * (exp(log(1.0 + 4.0 * kMostBlur) * row / last) - 1.0);
}

// Share of the light before the ground that comes from few samples, the rest from many: few where
// the Sun stands high and the ground is seen from above, many toward the terminator and the limb,
// with a smooth passage between. From the cosines, at the ground, of the zenith angles of the Sun
// and the eye; whatever else a picture shows, a ray has the same share.
Number fewSamplesShare(Number sunCosine, Number viewCosine) {
  return smoothstep(0.12, 0.18, sunCosine) * smoothstep(0.12, 0.25, viewCosine);
}
#endif
