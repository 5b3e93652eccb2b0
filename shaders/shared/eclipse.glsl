// Eclipses: how much of the Sun a sphere or an oblate spheroid leaves visible. The same functions
// shade pixels (floats) and predict contacts, magnitudes and paths (doubles).
//
// Cones of spheres are exact. A spheroid is a sphere in the space stretched along its pole, where the
// Sun is an ellipse: of it counts the reach toward the axis, and the limb's curvature is scaled to
// match. Measured (tests/eclipse/oblate_caster_test.cpp): within 3e-4 of the whole Sun for shadows of
// planets on moons and rings, edges within 10 m (the Earth's on the Moon 0.5 km with a limb-darkened
// Sun); within 0.013 of the Sun where the spheroid looks as large as it.
//
// The discs in the sky are circles in a plane, the occulter's with the curvature of its true outline
// where it crosses the Sun; relative error of the visible light: the square of the Sun's angular
// radius, 2e-5 at 1 au.
//
// Everything near totality is a function of the *gap*, the width of the crescent, which comes from
// the distance to the umbral cone, never from the difference of two directions or of two radii.
// Measured (tests/eclipse, tests/shaders): see the functions.
#ifndef SHARED_ECLIPSE_GLSL
#define SHARED_ECLIPSE_GLSL
#include "shared/eclipse_types.glsl"
#include "shared/limb_darkening.glsl"

// Sine of the half-angle of the umbral cone, from the distance between the centres.
Number umbralSine(Length sunRadius, Length casterRadius, Length sunDistance) {
  return (sunRadius - casterRadius) / sunDistance;
}

Number penumbralSine(Length sunRadius, Length casterRadius, Length sunDistance) {
  return (sunRadius + casterRadius) / sunDistance;
}

// Radius of the umbral cone across the axis at `behind` the caster's centre; negative beyond its
// apex.
Length umbraRadiusBehind(Length casterRadius, Number sine, Length behind) {
  return (casterRadius - behind * sine) / sqrt(1.0 - sine * sine);
}

Length penumbraRadiusBehind(Length casterRadius, Number sine, Length behind) {
  return (casterRadius + behind * sine) / sqrt(1.0 - sine * sine);
}

// A point, or a ray's direction, in the caster's space; and back.
Position inCasterSpace(ShadowPair pair, Position point) {
  return point + pair.pole * (pair.squash * dot(pair.pole, point));
}

Position fromCasterSpace(ShadowPair pair, Position point) {
  return point - pair.pole * (pair.squash / (1.0 + pair.squash) * dot(pair.pole, point));
}

ShadowPlace placeInShadow(ShadowPair pair, Position point) {
  Position p = inCasterSpace(pair, point) - pair.foot;
  ShadowPlace place;
  place.along = dot(p, pair.axis);
  Position across = p - pair.axis * place.along;
  place.distance = length(across);
  place.away = across / max(place.distance, 1e-6);
  Number poleward = dot(pair.pole, place.away);
  place.stretch = sqrt(1.0 + pair.squash * (2.0 + pair.squash) * poleward * poleward);
  return place;
}

// Radii of the cones across the axis at `along` from the foot.
Length umbraRadiusAt(ShadowPair pair, Length along) {
  return pair.umbraRadius - along * pair.umbraTangent;
}

Length penumbraRadiusAt(ShadowPair pair, Length along) {
  return pair.penumbraRadius + along * pair.penumbraTangent;
}

// What a Sun of `stretch` its radius adds to the penumbra and takes from the umbra at `along`.
Length stretchedSunAt(ShadowPair pair, Length along, Number stretch) {
  return (pair.casterBehind + along) * (pair.sunRadius * (stretch - 1.0)) /
         ((pair.sunBehind - pair.casterBehind) * pair.umbraCosine);
}

// Radii of the cones across the axis on the side of a place.
Length umbraRadiusAt(ShadowPair pair, ShadowPlace place) {
  return umbraRadiusAt(pair, place.along) - stretchedSunAt(pair, place.along, place.stretch);
}

Length penumbraRadiusAt(ShadowPair pair, ShadowPlace place) {
  return penumbraRadiusAt(pair, place.along) + stretchedSunAt(pair, place.along, place.stretch);
}

// Tables of a shadow on a body run along its axis over the sunlit side and a quarter of `reach`, the
// greatest distance from the centre, beyond: the share of that way at a distance from the foot, and
// back.
Number shareAlongAxis(Length along, Length reach) {
  return clamp((1.0 + along / reach) / 1.25, 0.0, 1.0);
}

Length alongAxisAt(Number share, Length reach) { return reach * (1.25 * share - 1.0); }

// Whether any point of a sphere may lose sunlight: never false where some does. A sphere of radius
// 0 asks for a point.
bool mayBeShaded(ShadowPair pair, Position centre, Length radius) {
  ShadowPlace place = placeInShadow(pair, centre);
  Length most = radius * (1.0 + pair.squash);
  Length reach = most * (1.0 + pair.penumbraTangent);
  bool behindCaster = pair.casterBehind + place.along > -(pair.casterRadius + most);
  Length widest = penumbraRadiusAt(pair, place.along) +
                  max(stretchedSunAt(pair, place.along + most, 1.0 + pair.squash), 0.0);
  return behindCaster && place.distance - reach < widest + 1.0;
}

// Where the ray origin + t direction (t in metres) crosses the double cone of radius |radius| that
// has `radius` at `foot` and loses `tangent` per metre along `axis`; pass a negative tangent for a
// penumbra. Rays along the axis that never cross, or parallel to the flank, have no crossing. The
// closest approach to the axis is taken as origin of t, which keeps floats accurate: within 10 m
// for rays that start 1e9 m away.
ConeCrossing crossCone(Position foot, Direction axis, Length radius, Number tangent,
                       Position origin, Direction direction) {
  ConeCrossing crossing;
  crossing.count = 0;
  crossing.first = 0.0;
  crossing.second = 0.0;
  crossing.insideBetween = 1.0;
  Number slide = dot(direction, axis);
  Direction sideways = direction - axis * slide;
  Number sidewaysSquared = dot(sideways, sideways);
  Position p = origin - foot;
  Length along = dot(p, axis);
  Position across = p - axis * along;
  Length nearest = 0.0;
  if (sidewaysSquared > 1e-12) {
    nearest = -dot(across, sideways) / sidewaysSquared;
  }
  Length distance = length(across + sideways * nearest);
  // Radius at the closest approach, and its change along the ray.
  Length there = radius - tangent * (along + slide * nearest);
  Number growth = -tangent * slide;
  Number a = sidewaysSquared - growth * growth;
  Area discriminant = sidewaysSquared * (there - distance) * (there + distance) +
                      growth * growth * distance * distance;
  if (discriminant <= 0.0 || abs(a) < 1e-12) {
    return crossing;
  }
  Length root = sqrt(discriminant);
  Length middle = growth * there;
  crossing.count = 2;
  if (a > 0.0) {
    crossing.first = nearest + (middle - root) / a;
    crossing.second = nearest + (middle + root) / a;
  } else {
    crossing.first = nearest + (middle + root) / a;
    crossing.second = nearest + (middle - root) / a;
    crossing.insideBetween = 0.0;
  }
  return crossing;
}

// Of the circular cones: for an oblate caster the umbra's is the widest, the penumbra's the narrowest.
ConeCrossing crossUmbra(ShadowPair pair, Position origin, Direction direction) {
  return crossCone(pair.foot, pair.axis, pair.umbraRadius, pair.umbraTangent,
                   inCasterSpace(pair, origin), inCasterSpace(pair, direction));
}

ConeCrossing crossPenumbra(ShadowPair pair, Position origin, Direction direction) {
  return crossCone(pair.foot, pair.axis, pair.penumbraRadius, -pair.penumbraTangent,
                   inCasterSpace(pair, origin), inCasterSpace(pair, direction));
}

// Tangent of half the angle by which the limb of a ball rises above the flank of a cone that
// touches the ball. `outside` is the point's distance from the flank, `alongFlank` from the point's
// foot on the flank to the tangent point, `tangentLength` from the point to the ball along a
// tangent.
Number halfTangentAboveFlank(Length outside, Length alongFlank, Length tangentLength,
                             Length ballRadius) {
  if (alongFlank > 0.0) {
    return outside / (alongFlank + tangentLength);
  }
  return (tangentLength - alongFlank) / max(outside + 2.0 * ballRadius, 1e-3 * ballRadius);
}

// The discs of the Sun and the caster at `distance` from the axis, `along` it from the foot.
// Angular distances of the limbs follow from the distances to the umbral cone's flanks on either
// side of the axis, so that the gap is as accurate, relatively, as (distance - umbra radius).
DiscPair discsAt(ShadowPair pair, Length along, Length distance) {
  Length casterBehind = pair.casterBehind + along;
  Length sunBehind = pair.sunBehind + along;
  Length umbra = umbraRadiusAt(pair, along);
  Length casterRadius = pair.casterRadius;
  Length sunRadius = pair.sunRadius;
  Length casterTangent = sqrt(
      max(casterBehind * casterBehind + distance * distance - casterRadius * casterRadius, 1.0));
  Length sunTangent =
      sqrt(max(sunBehind * sunBehind + distance * distance - sunRadius * sunRadius, 1.0));
  Number tanSun = sunRadius / sunTangent;
  Number tanCaster = casterRadius / casterTangent;

  // Between the tangent points lies the same length of flank, whatever the point.
  Length betweenTangents = (sunBehind - casterBehind) * pair.umbraCosine;
  Length nearOutside = (distance - umbra) * pair.umbraCosine;
  Length nearAlong = casterBehind * pair.umbraCosine - distance * pair.umbraSine;
  Number nearCaster = halfTangentAboveFlank(nearOutside, nearAlong, casterTangent, casterRadius);
  Number nearSun =
      halfTangentAboveFlank(nearOutside, nearAlong + betweenTangents, sunTangent, sunRadius);
  Number nearGap = (nearCaster - nearSun) / (1.0 + nearCaster * nearSun);
  Length farOutside = (-distance - umbra) * pair.umbraCosine;
  Length farAlong = casterBehind * pair.umbraCosine + distance * pair.umbraSine;
  Number farCaster = halfTangentAboveFlank(farOutside, farAlong, casterTangent, casterRadius);
  Number farSun =
      halfTangentAboveFlank(farOutside, farAlong + betweenTangents, sunTangent, sunRadius);
  Number farGap = (farCaster - farSun) / (1.0 + farCaster * farSun);

  DiscPair discs;
  // 2 atan and atan as rational functions: within 1e-6 of themselves below 0.1 rad.
  Number q = clamp(nearGap, -1.0, 1.0);
  discs.gap = 2.0 * q / (1.0 + q * q / 3.0);
  discs.sun = tanSun / (1.0 + tanSun * tanSun / 3.0);
  // Curvature of a circle on the sphere is the cotangent of its radius: the plane's circles have
  // the tangents of the angles as radii.
  Number tanExcess = -(nearGap + farGap) / max(1.0 - nearGap * farGap, 1e-6);
  discs.excess = tanExcess * (1.0 + tanSun * tanCaster) / (1.0 + tanSun * tanSun);
  if (casterBehind < -casterRadius || sunBehind < sunRadius) {
    discs.gap = 4.0 * discs.sun;
  }
  return discs;
}

// The discs at a place. Before an oblate caster the Sun counts with its reach toward the axis (what
// turns the ellipse into that circle, keeping the axis' direction, scales the limb's curvature too; a
// caster smaller than the Sun keeps its area instead).
DiscPair discsAt(ShadowPair pair, ShadowPlace place) {
  if (pair.squash == 0.0) {
    return discsAt(pair, place.along, place.distance);
  }
  ShadowPair toward = pair;
  toward.sunRadius = pair.sunRadius * place.stretch;
  Number sine = pair.umbraSine + pair.sunRadius * (place.stretch - 1.0) /
                                     (pair.sunBehind - pair.casterBehind);
  toward.umbraSine = sine;
  toward.umbraCosine = sqrt(1.0 - sine * sine);
  toward.umbraTangent = sine / toward.umbraCosine;
  toward.umbraRadius = pair.umbraRadius - stretchedSunAt(pair, 0.0, place.stretch);
  DiscPair discs = discsAt(toward, place.along, place.distance);
  Number poleAlong = dot(pair.pole, pair.axis);
  Number across =
      sqrt(1.0 + pair.squash * (2.0 + pair.squash) * (1.0 - poleAlong * poleAlong));
  Number area = place.stretch * place.stretch / across;
  Number share = clamp(discs.excess / discs.sun, 0.0, 1.0);
  discs.excess =
      (discs.excess + discs.sun) * mix(sqrt(area), area * area, share) - discs.sun;
  return discs;
}

// The discs from angles: for occulters whose directions are known well enough, and for tests.
DiscPair discsFromAngles(Angle sun, Angle occulter, Angle separation) {
  DiscPair discs;
  discs.sun = sun;
  discs.excess = occulter - sun;
  discs.gap = separation - discs.excess;
  return discs;
}

// The caps of both circles cut off by their common chord, as 2/3 + 1/5 x + ...: area of a cap of
// unit radius and half-chord h, divided by h^3, with x = h^2; and its divided difference between x
// and y. Truncation: below 2e-7 relative for x < 0.2.
Number capAreaOverCube(Number x) {
  return 2.0 / 3.0 +
         x * (0.2 + x * (3.0 / 28.0 +
                         x * (5.0 / 72.0 +
                              x * (35.0 / 704.0 +
                                   x * (63.0 / 1664.0 +
                                        x * (77.0 / 2560.0 +
                                             x * (429.0 / 17408.0 + x * 6435.0 / 311296.0)))))));
}

Number capAreaDifference(Number x, Number y) {
  Number power = y;
  Number sum = 0.2;
  Number symmetric = x + y;  // x^k + x^(k-1) y + ... + y^k, here k = 1
  sum = sum + symmetric * 3.0 / 28.0;
  power = power * y;
  symmetric = symmetric * x + power;
  sum = sum + symmetric * 5.0 / 72.0;
  power = power * y;
  symmetric = symmetric * x + power;
  sum = sum + symmetric * 35.0 / 704.0;
  power = power * y;
  symmetric = symmetric * x + power;
  sum = sum + symmetric * 63.0 / 1664.0;
  power = power * y;
  symmetric = symmetric * x + power;
  sum = sum + symmetric * 77.0 / 2560.0;
  power = power * y;
  symmetric = symmetric * x + power;
  sum = sum + symmetric * 429.0 / 17408.0;
  power = power * y;
  symmetric = symmetric * x + power;
  return sum + symmetric * 6435.0 / 311296.0;
}

// Visible area of the solar disc over its whole area. Relative error: in doubles below 1e-6 down to
// a visible fraction of 1e-8; in floats below 1e-3 down to 1e-6. Lune between two circles of radii
// 1 and o, centres d apart, from the half-angles that the chord subtends: a thin crescent as a
// difference of caps by series, any other from atan half-angle forms (of Heron's kind), for acos is
// inaccurate on some devices.
Number visibleFractionUniform(DiscPair discs) {
  Number excess = clamp(discs.excess / discs.sun, -1.0, 1e6);
  Number gap = discs.gap / discs.sun;
  if (gap >= 2.0 || excess <= -1.0) {
    return 1.0;
  }
  if (gap <= 0.0) {
    return 0.0;
  }
  Number occulter = 1.0 + excess;
  Number separation = max(gap + excess, 0.0);
  Number inner = gap + 2.0 * excess;  // o + d - 1: negative or zero where a ring is left
  if (inner <= 0.0) {
    return -excess * (2.0 + excess);
  }
  Number outer = 2.0 + 2.0 * excess + gap;  // o + d + 1
  Number other = 2.0 - gap;                 // o + 1 - d
  Number heron = gap * other * inner * outer;
  Number halfChord = 0.5 * sqrt(heron) / max(separation, 1e-12);
  Number x = halfChord * halfChord;
  if (x < 0.2 && gap * outer < inner * other) {
    Number y = x / (occulter * occulter);
    Number caps =
        capAreaOverCube(x) + x * (2.0 + excess) / (occulter * occulter) * capAreaDifference(x, y);
    return x * halfChord * excess / occulter * caps / kPi;
  }
  if (occulter > 2.0) {
    Angle sunHalf = 2.0 * atan(sqrt(gap * outer), sqrt(inner * other));
    Number chordDistance = ((1.0 - gap) * (occulter + separation) - 1.0) / (2.0 * separation);
    Number hiddenCap = x * halfChord / occulter * capAreaOverCube(x / (occulter * occulter));
    return (sunHalf - halfChord * chordDistance - hiddenCap) / kPi;
  }
  Angle between = 2.0 * atan(sqrt(gap * inner), sqrt(outer * other));
  Angle occulterHalf = 2.0 * atan(sqrt(gap * other), sqrt(outer * inner));
  return (between + 0.5 * sqrt(heron) - excess * (2.0 + excess) * occulterHalf) / kPi;
}

// One node of the integral along the occulter's limb in visibleFraction.
struct LimbNode {
  Number cosineSquared;  // of the solar disc there
  Number sweep;  // share of the turn that the node's piece of limb makes about the Sun's centre,
                 // times the square of its distance from it
};

LimbNode limbNode(Number occulter, Number separation, Number gap, Number outerRing,
                  Number innerRing, Number reach, Number cosine, Number weight) {
  Number cosineSquared = cosine * cosine;
  Number sineSquared = 1.0 - cosineSquared;
  LimbNode node;
  node.cosineSquared = innerRing + (outerRing - innerRing) * cosineSquared;
  Number facing = 1.0 - gap + 2.0 * separation * reach * sineSquared;
  Number stretch = cosine / sqrt(cosineSquared + (1.0 - reach) * sineSquared);
  node.sweep = weight * occulter * facing * sqrt(reach) * stretch;
  return node;
}

// Visible light of the limb-darkened disc over its whole light, at four wavelengths.
//
// By Green's theorem it is an integral along the occulter's limb inside the Sun: of the light
// between limb and ring (lightOutsideRing, a closed form) over the angle swept about the Sun's
// centre. Thin crescents are summed directly, without cancellation; wide ones as the uniform disc
// plus the integral of the difference. Gauss-Legendre with five nodes in the angle t with mu
// proportional to cos t (mu^2 linear in cos^2 t for a ring). Relative error against adaptive
// quadrature: below 2e-4.
Spectrum visibleFraction(DiscPair discs, LimbDarkening law) {
  Number excess = clamp(discs.excess / discs.sun, -1.0, 1e6);
  Number gap = discs.gap / discs.sun;
  if (gap >= 2.0 || excess <= -1.0) {
    return Spectrum(1.0);
  }
  if (gap <= 0.0) {
    return Spectrum(0.0);
  }
  Number occulter = 1.0 + excess;
  Number separation = max(gap + excess, 0.0);
  // mu^2 where the occulter's limb comes nearest the Sun's centre, and where it is farthest.
  Number outerRing = gap * (2.0 - gap);
  Number span = 4.0 * separation * occulter;
  Number reach = 1.0;
  if (span > outerRing) {
    reach = outerRing / span;
  }
  Number innerRing = max(outerRing - span, 0.0);
  bool thin = gap < 0.3;
  Spectrum light = Spectrum(0.0);
  for (Index i = 0; i < 5; i = i + 1) {
    // cos(pi/2 (1 + x) / 2) and half the weight for the nodes x of the five-point rule.
    Number cosine = 0.997286401840468;
    Number weight = 0.118463442528095;
    if (i == 1) {
      cosine = 0.935018407117731;
      weight = 0.239314335249683;
    } else if (i == 2) {
      cosine = 0.707106781186548;
      weight = 0.284444444444444;
    } else if (i == 3) {
      cosine = 0.354599179851027;
      weight = 0.239314335249683;
    } else if (i == 4) {
      cosine = 0.073619513066123;
      weight = 0.118463442528095;
    }
    LimbNode node =
        limbNode(occulter, separation, gap, outerRing, innerRing, reach, cosine, weight);
    Spectrum outside = lightOutsideRing(law, node.cosineSquared);
    Number radiusSquared = max(1.0 - node.cosineSquared, 1e-6);
    if (thin) {
      light = light + outside * (node.sweep / radiusSquared);
    } else {
      light = light + (outside - Spectrum(node.cosineSquared)) * (node.sweep / radiusSquared);
    }
  }
  if (thin) {
    return light;
  }
  return clamp(light + Spectrum(visibleFractionUniform(discs)), 0.0, 1.0);
}

// Share of sunlight that reaches `point` (metres from the pair's origin) past the caster.
Spectrum visibleSunlight(ShadowPair pair, LimbDarkening law, Position point) {
  return visibleFraction(discsAt(pair, placeInShadow(pair, point)), law);
}
#endif
