// How much of a translucent cone of shadow a line of sight passes: the illustration of umbra, antumbra
// and penumbra as bodies in space.
//
// A cone's substance is as dense as it is narrow, 1/radius per metre, so that a crossing through the
// axis has the depth 2 anywhere along it. With the radius linear along the ray the integral is a
// logarithm, evaluated as 2 atanh(x)/x over the sum of the radii: exact also where the ray runs along
// the cone. A cone narrower than a pixel is widened to one and thinned in proportion, so that it fades
// instead of breaking into dots. Against quadrature in doubles: 1e-6 where nothing is widened.
#ifndef SHARED_SHADOW_CONE_GLSL
#define SHARED_SHADOW_CONE_GLSL
#include "shared/eclipse.glsl"

// A piece of a cone: `radius` at the foot (the point of the axis nearest the camera), growing by `gain`
// per metre along the axis, from `start` to `end` along it; positive between them.
struct ConePiece {
  Length radius;
  Number gain;
  Length start;
  Length end;
};

Number atanhOverX(Number x) {
  Number square = x * x;
  if (square < 0.04) {
    return 1.0 + square * (1.0 / 3.0 + square * (0.2 + square * (1.0 / 7.0 + square / 9.0)));
  }
  return 0.5 * log((1.0 + x) / (1.0 - x)) / x;
}

// The camera is the origin; `ray` is a unit vector, followed to `farthest`; `pixel` the angle of a
// pixel.
Number depthInCone(Position foot, Direction axis, ConePiece piece, Direction ray, Length farthest,
                   Angle pixel) {
  Number slide = dot(ray, axis);
  // The stretch of the ray between the planes that end the piece.
  Length from = 0.0;
  Length to = farthest;
  if (abs(slide) > 1e-9) {
    Length a = piece.start / slide;
    Length b = piece.end / slide;
    from = max(from, min(a, b));
    to = min(to, max(a, b));
  } else if (piece.start > 0.0 || piece.end < 0.0) {
    return 0.0;
  }
  if (to <= from) {
    return 0.0;
  }
  // Where the ray comes closest to the axis.
  Direction sideways = ray - axis * slide;
  Number sidewaysSquared = dot(sideways, sideways);
  Length nearest = from;
  if (sidewaysSquared > 1e-12) {
    nearest = clamp(dot(foot, sideways) / sidewaysSquared, from, to);
  }
  Length radiusThere = max(piece.radius + piece.gain * slide * nearest, 0.0);
  Length wide = 0.5 * pixel * nearest;
  Length radius = piece.radius + wide;
  Number thinned = radiusThere / max(radiusThere + wide, 1e-3);
  ConeCrossing crossing = crossCone(foot, axis, radius, -piece.gain, Position(0.0), ray);
  Number growth = piece.gain * slide;
  if (crossing.count == 0) {
    // All of it inside or all outside.
    Length middle = 0.5 * (from + to);
    Length away = length(sideways * middle - foot);
    if (away > radius + growth * middle) {
      return 0.0;
    }
  } else if (crossing.insideBetween > 0.5) {
    from = max(from, crossing.first);
    to = min(to, crossing.second);
  } else if (growth > 0.0) {
    // Steeper than the flank: inside the double cone before and after; this piece is where it widens.
    from = max(from, crossing.second);
  } else {
    to = min(to, crossing.first);
  }
  if (to <= from) {
    return 0.0;
  }
  Length first = max(radius + growth * from, 1e-3);
  Length second = max(radius + growth * to, 1e-3);
  Number x = (second - first) / (second + first);
  return thinned * 2.0 * (to - from) / (first + second) * atanhOverX(x);
}
#endif
