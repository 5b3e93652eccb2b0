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

HeightAndCosine sourcePlace(AirShell shell, Number lowest, TableCoordinates place) {
  Number zero = sunSpan(lowest).zero;
  Number side = place.x > zero ? (place.x - zero) / (1.0 - zero) : (zero - place.x) / zero;
  HeightAndCosine found;
  found.cosine = place.x > zero ? side * side : lowest * side * side;
  found.height = shell.top * place.y * place.y;
  return found;
}

// Directions about the local vertical and the Sun's azimuth: harmonics up to degree 2 that are
// symmetric about the Sun's plane. z is the vertical component, x the one toward the Sun.
// 1; z, x; (3 z^2 - 1)/2, x z, x^2 - y^2.
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
#endif
