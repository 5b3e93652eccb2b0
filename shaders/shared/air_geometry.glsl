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
  Length fromLow;   // distance from the leg's low end
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

// Distance from a point that rises with `rise` to the sphere at `high`.
Length distanceUpTo(AirShell shell, Length height, Length rise, Length high) {
  Area gain = squareBetween(shell, height, high);
  Length root = sqrt(max(rise * rise + gain, 0.0));
  return rise > 0.0 ? gain / (root + rise) : root - rise;
}

AirPoint pointOnLeg(AirShell shell, AirLeg leg, Number sunAlong, Length height) {
  AirPoint point;
  Area gain = squareBetween(shell, leg.lowHeight, height);
  Length r = shell.radius + height;
  point.height = height;
  point.rise = sqrt(leg.lowRise * leg.lowRise + gain);
  point.fromLow = gain / max(leg.lowRise + point.rise, 1.0e-9);
  point.cosine = min(point.rise / r, 1.0);
  point.sunCosine =
      clamp((leg.lowSunRise + leg.sense * point.fromLow * sunAlong) / r, -1.0, 1.0);
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

// Where in [0, 1]^2 the optical depth to the top lies: x over the zenith angle from the zenith to the
// horizon, y over height.
TableCoordinates depthCoordinates(AirShell shell, Length height, Number cosine) {
  Length h = clamp(height, 0.0, shell.top);
  Length across = sqrt(squareAboveGround(shell, h));
  Length widest = sqrt(squareAboveGround(shell, shell.top));
  Length distance = distanceUpTo(shell, h, (shell.radius + h) * cosine, shell.top);
  Length least = shell.top - h;
  TableCoordinates place;
  place.x = clamp((distance - least) / max(across + widest - least, 1.0e-6 * shell.top), 0.0, 1.0);
  place.y = across / widest;
  return place;
}

struct HeightAndCosine {
  Length height;
  Number cosine;
};

HeightAndCosine heightAndCosineAt(AirShell shell, TableCoordinates place) {
  Length widest = sqrt(squareAboveGround(shell, shell.top));
  Length across = place.y * widest;
  HeightAndCosine found;
  found.height =
      across * across / (shell.radius + sqrt(shell.radius * shell.radius + across * across));
  Length least = shell.top - found.height;
  Length distance = least + place.x * (across + widest - least);
  Length r = shell.radius + found.height;
  found.cosine =
      distance > 0.0
          ? clamp((squareBetween(shell, found.height, shell.top) - distance * distance) /
                      (2.0 * r * distance), -1.0, 1.0)
          : 1.0;
  return found;
}

// The Sun's zenith angle and height in the source table. `lowest` is the least cosine it holds.
TableCoordinates sourceCoordinates(AirShell shell, Number lowest, Length height, Number sunCosine) {
  Number below = sqrt(-lowest);
  Number zero = below / (1.0 + below);
  TableCoordinates place;
  place.x = sunCosine > 0.0 ? zero + (1.0 - zero) * sqrt(min(sunCosine, 1.0))
                            : zero * (1.0 - sqrt(min(sunCosine / lowest, 1.0)));
  place.y = sqrt(clamp(height / shell.top, 0.0, 1.0));
  return place;
}

HeightAndCosine sourcePlace(AirShell shell, Number lowest, TableCoordinates place) {
  Number below = sqrt(-lowest);
  Number zero = below / (1.0 + below);
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
