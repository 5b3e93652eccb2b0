// Light scattered toward the camera along a ray through air. Per sample: the Sun's light through the
// air above (and past what eclipses it) scattered once, and the light that has been scattered
// before, from the source table. Compiled with AIR_SINGLE and/or AIR_SOURCE; with AIR_SEPARATE the
// peaked constituents' single scattering is kept apart without its phase function.
//
// Samples are Gauss-Legendre nodes in u with height = low + (high - low) u^3 along each leg: dense
// where air is dense and where a ray is tangent.
#ifndef INTERFACE_AIR_MARCH_GLSL
#define INTERFACE_AIR_MARCH_GLSL
#include "interface/air.glsl"
#include "interface/shadows.glsl"

#if defined(SHADOW_PAIRS) && !defined(UNECLIPSED)
#define AIR_ECLIPSED
#ifdef ECLIPSED_SOURCE
#define AIR_ECLIPSED_SOURCE
#endif
#endif

// Sparse look-ups of the source: at the low end and at this share of the top's height; beyond, it is
// held on up to kSparseReach times the root of that height.
const float kSparseHeight = 0.15;
const float kSparseReach = 2.0;

struct AirRay {
  float height;      // of its start, inside the air
  float rise;        // r mu at the start, m
  float sunRise;     // r times the Sun's cosine at the start, m
  float sunAlong;    // cosine between ray and Sun
  float groundRoot;  // (r mu)^2 - (r^2 - R^2): positive and rise < 0 where the ray meets the ground
  vec3 start;        // scaled space, from the centre, m
  vec3 direction;    // scaled space, unit
};

struct AirLight {
  vec4 joint[AIR_LAYERS];
#ifdef AIR_SEPARATE
  vec4 peaked[AIR_LAYERS * AIR_PEAKED + 1];
#endif
};

struct AirWay {
  AirLeg legs[2];
  int legCount;
  bool hitsGround;
  float length;  // from the start to the ground or the top
};

AirLight darkAir() {
  AirLight light;
  for (int layer = 0; layer < AIR_LAYERS; ++layer) light.joint[layer] = vec4(0.0);
#ifdef AIR_SEPARATE
  for (int i = 0; i <= AIR_LAYERS * AIR_PEAKED; ++i) light.peaked[i] = vec4(0.0);
#endif
  return light;
}

AirWay wayOf(AirRay ray) {
  AirShell shell = airShell();
  AirWay way;
#if defined(BODY_GROUND)
  way.hitsGround = true;
#elif defined(BODY_SKY)
  way.hitsGround = false;
#else
  way.hitsGround = ray.rise < 0.0 && ray.groundRoot > 0.0;
#endif
  way.legCount = 1;
  AirLeg leg;
  if (ray.rise >= 0.0 && !way.hitsGround) {
    leg.lowHeight = ray.height;
    leg.lowRise = ray.rise;
    leg.lowSunRise = ray.sunRise;
    leg.highHeight = shell.top;
    leg.lowDistance = 0.0;
    leg.sense = 1.0;
    way.length = distanceUpTo(shell, ray.height, ray.rise, shell.top);
    way.legs[1] = leg;
  } else if (way.hitsGround) {
    leg.lowHeight = 0.0;
    leg.lowRise = sqrt(ray.groundRoot);
    way.length = squareAboveGround(shell, ray.height) / (leg.lowRise - ray.rise);
    leg.lowSunRise = ray.sunRise + way.length * ray.sunAlong;
    leg.highHeight = ray.height;
    leg.lowDistance = way.length;
    leg.sense = -1.0;
    way.legs[1] = leg;
  } else {
    float nearest = sqrt(max(shell.radius * shell.radius - ray.groundRoot, 0.0));
    leg.lowHeight = max(-ray.groundRoot / (nearest + shell.radius), 0.0);
    leg.lowRise = 0.0;
    leg.lowSunRise = ray.sunRise - ray.rise * ray.sunAlong;
    leg.highHeight = ray.height;
    leg.lowDistance = -ray.rise;
    leg.sense = -1.0;
    way.legs[1] = leg;
    way.legs[1].highHeight = shell.top;
    way.legs[1].sense = 1.0;
    way.legCount = 2;
    way.length = leg.lowDistance + distanceUpTo(shell, leg.lowHeight, 0.0, shell.top);
  }
  way.legs[0] = leg;
  return way;
}

// Optical depth from the start of a way to its end.
vec4 depthOfWay(AirRay ray, AirWay way, int layer) {
  AirShell shell = airShell();
  float r = shell.radius + ray.height;
  if (way.legCount == 2) {
    float low = shell.radius + way.legs[0].lowHeight;
    vec4 tangent = depthAt(depthPlace(way.legs[0].lowHeight, 0.0), layer);
    return max(2.0 * tangent - depthAt(depthPlace(ray.height, -ray.rise / r), layer), vec4(0.0));
  }
  if (!way.hitsGround) return depthAt(depthPlace(ray.height, ray.rise / r), layer);
  return max(depthAt(depthPlace(0.0, way.legs[0].lowRise / shell.radius), layer) -
                 depthAt(depthPlace(ray.height, -ray.rise / r), layer), vec4(0.0));
}

#ifdef AIR_SOURCE
// Radiance that has been scattered (or reflected by the ground) before, as the parts of it that meet
// the moments 0, 1 and 2 of a phase function in one direction, 1/sr.
struct SourceParts {
  vec4 even;
  vec4 first;
  vec4 second;
};

SourceParts sourcePartsAt(AirPoint p, float sense, float sunAlong, vec3 where, vec3 direction,
                          int layer) {
  AirShell shell = airShell();
  vec2 at = onTexels(sourceCoordinates(shell, airShape.z, p.height, p.sunCosine),
                     textureSize(airSource, 0).xy);
  SunFrame f = sunFrame(sense * p.cosine, p.sunCosine, sunAlong);
  float first = float(layer * 7);
  SourceParts parts;
  parts.even = textureLod(airSource, vec3(at, first), 0.0);
  parts.first = f.z * textureLod(airSource, vec3(at, first + 1.0), 0.0) +
                f.x * textureLod(airSource, vec3(at, first + 2.0), 0.0);
  parts.second =
      (1.5 * f.z * f.z - 0.5) * textureLod(airSource, vec3(at, first + 3.0), 0.0) +
      f.x * f.z * textureLod(airSource, vec3(at, first + 4.0), 0.0) +
      (2.0 * f.x * f.x + f.z * f.z - 1.0) * textureLod(airSource, vec3(at, first + 5.0), 0.0);
#ifdef AIR_ECLIPSED_SOURCE
  EclipsedPlace place = eclipsedPlace(where, p.height);
#ifdef ECLIPSED_HARMONICS
  vec3 left = cross(normalize(where), eclipsedSun.xyz);
  float sideways = place.side * dot(direction, left) / max(length(left), 1e-6);
  vec4 even = parts.even * eclipsedQuantity(place, 0, layer);
  vec4 one = even * (f.z * eclipsedQuantity(place, 2, layer) + f.x * eclipsedQuantity(place, 3, layer) +
                     sideways * eclipsedQuantity(place, 4, layer));
  vec4 two = even * ((1.5 * f.z * f.z - 0.5) * eclipsedQuantity(place, 5, layer) +
                     f.x * f.z * eclipsedQuantity(place, 6, layer) +
                     (f.x * f.x - sideways * sideways) * eclipsedQuantity(place, 7, layer) +
                     sideways * f.z * eclipsedQuantity(place, 8, layer) +
                     f.x * sideways * eclipsedQuantity(place, 9, layer));
  parts.even = mix(parts.even, even, place.inside);
  parts.first = mix(parts.first, one, place.inside);
  parts.second = mix(parts.second, two, place.inside);
#else
  vec4 share = eclipsedShare(place, 0, layer);
  parts.even *= share;
  parts.first *= share;
  parts.second *= share;
#endif
#endif
  return parts;
}

// Averaged with the phase functions and times the scattering coefficients: 1/(m sr).
vec4 scatteredSource(AirDensities d, SourceParts parts, int layer) {
  vec4 sum = vec4(0.0);
  for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
    int i = layer * AIR_CONSTITUENTS + c;
    sum += airScattering[i] * d.of[c] *
           (parts.even + airPhaseMoment1[i] * parts.first + airPhaseMoment2[i] * parts.second);
  }
  return max(sum, vec4(0.0));
}
#endif

vec3 placeOnLeg(AirRay ray, AirLeg leg, float fromLow) {
  return ray.start + ray.direction * (leg.lowDistance + leg.sense * fromLow);
}

// Adds the light of the part u0..u1 of a leg. `before`: optical depth from the camera to a point is
// before - sense times the point's depth to the top along the leg. Where `sparse`, the source is
// looked up at two heights only and is linear in the root of height between them.
void marchLeg(AirRay ray, AirLeg leg, float u0, float u1, bool sparse, vec4 before[AIR_LAYERS],
              vec4 phases[AIR_LAYERS * AIR_CONSTITUENTS], inout AirLight light) {
  AirShell shell = airShell();
  float span = leg.highHeight - leg.lowHeight;
#ifdef AIR_SOURCE
  SourceParts low[AIR_LAYERS], high[AIR_LAYERS];
  float highRoot = 1.0;
  if (sparse) {
    AirPoint a = pointOnLeg(shell, leg, ray.sunAlong, leg.lowHeight);
    AirPoint b = pointOnLeg(shell, leg, ray.sunAlong, min(kSparseHeight * shell.top, leg.highHeight));
    highRoot = 1.0 / max(sqrt(b.height), 1e-3);
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
      low[layer] = sourcePartsAt(a, leg.sense, ray.sunAlong, placeOnLeg(ray, leg, 0.0), ray.direction, layer);
      high[layer] = sourcePartsAt(b, leg.sense, ray.sunAlong, placeOnLeg(ray, leg, b.fromLow), ray.direction, layer);
    }
  }
#endif
  // Loops test at their end: a software renderer runs the body once more where they test before it.
  int i = 0;
  do {
    float u = mix(u0, u1, nodes[i].x);
    AirPoint p = pointOnLeg(shell, leg, ray.sunAlong, leg.lowHeight + span * u * u * u);
    float distance = (u1 - u0) * nodes[i].y * 3.0 * u * u * span / max(p.cosine, 1e-9);
    AirDensities d = densitiesAt(p.height);
    vec2 viewPlace = depthPlace(p.height, p.cosine);
#ifdef AIR_SINGLE
    float above = sunAboveHorizon(p.height, p.sunCosine);
    vec2 toSun = depthPlace(p.height, p.sunCosine);
#endif
    vec3 where = placeOnLeg(ray, leg, p.fromLow);
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
      vec4 depth = max(before[layer] - leg.sense * depthAt(viewPlace, layer), vec4(0.0));
      vec4 weight = distance * exp(-depth);
      vec4 joint = vec4(0.0);
#ifdef AIR_SINGLE
      vec4 sun = weight * above * exp(-depthAt(toSun, layer));
#ifdef AIR_ECLIPSED
      sun *= visibleSunlight(where, layer);
#endif
      for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
        int k = layer * AIR_CONSTITUENTS + c;
        vec4 scattered = airScattering[k] * d.of[c];
#ifdef AIR_SEPARATE
        if (c >= AIR_SMOOTH)
          light.peaked[layer * AIR_PEAKED + c - AIR_SMOOTH] += sun * scattered;
        else
#endif
          joint += scattered * phases[k];
      }
      joint *= sun;
#endif
#ifdef AIR_SOURCE
      SourceParts parts;
      if (sparse) {
        float share = min(sqrt(p.height) * highRoot, kSparseReach);
        parts.even = max(mix(low[layer].even, high[layer].even, share), vec4(0.0));
        parts.first = mix(low[layer].first, high[layer].first, share);
        parts.second = mix(low[layer].second, high[layer].second, share);
      } else {
        parts = sourcePartsAt(p, leg.sense, ray.sunAlong, where, ray.direction, layer);
      }
      joint += weight * scatteredSource(d, parts, layer);
#endif
      light.joint[layer] += joint;
    }
  } while (++i < nodeCount.x);
}

// Distances along a ray at which to begin a new set of samples; negative: none.
struct AirCuts {
  float at[4];
};

AirCuts noCuts() {
  AirCuts cuts;
  for (int i = 0; i < 4; ++i) cuts.at[i] = -1.0;
  return cuts;
}

// The light of the whole way.
AirLight lightAlong(AirRay ray, AirWay way, AirCuts cuts) {
  AirShell shell = airShell();
  AirLight light = darkAir();
  vec4 phases[AIR_LAYERS * AIR_CONSTITUENTS];
#ifdef AIR_SINGLE
  for (int layer = 0; layer < AIR_LAYERS; ++layer)
    for (int c = 0; c < AIR_CONSTITUENTS; ++c)
      phases[layer * AIR_CONSTITUENTS + c] = phaseOf(c, layer, ray.sunAlong);
#endif
  float r = shell.radius + ray.height;
  vec2 startPlace = depthPlace(ray.height, abs(ray.rise) / r);
#ifdef BODY_GROUND
  {
    vec4 before[AIR_LAYERS];
    for (int layer = 0; layer < AIR_LAYERS; ++layer) before[layer] = -depthAt(startPlace, layer);
    marchLeg(ray, way.legs[0], 0.0, 1.0, true, before, phases, light);
    return light;
  }
#else
  vec2 lowPlace = depthPlace(way.legs[0].lowHeight, 0.0);
  int n = 0;
  do {
    AirLeg leg = way.legs[0];
    if (n == 1) leg = way.legs[1];
    vec4 before[AIR_LAYERS];
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
      vec4 start = depthAt(startPlace, layer);
      if (way.legCount == 2 && n == 1)
        before[layer] = 2.0 * depthAt(lowPlace, layer) - start;
      else
        before[layer] = leg.sense * start;
    }
    float span = max(leg.highHeight - leg.lowHeight, 1e-6);
#ifdef AIR_CUTS
    // Distances of the cuts as positions u on this leg, ascending.
    float at[4];
    for (int i = 0; i < 4; ++i) {
      float fromLow = (cuts.at[i] - leg.lowDistance) * leg.sense;
      at[i] = cuts.at[i] > 0.0 && fromLow > 0.0
                  ? clamp(pow((heightOnLeg(shell, leg, fromLow) - leg.lowHeight) / span, 1.0 / 3.0),
                          0.0, 1.0)
                  : 0.0;
    }
    for (int i = 1; i < 4; ++i)
      for (int k = i; k > 0; --k) {
        float low = min(at[k - 1], at[k]);
        at[k] = max(at[k - 1], at[k]);
        at[k - 1] = low;
      }
    float from = 0.0;
    for (int i = 0; i <= 4; ++i) {
      float to = i < 4 ? at[i] : 1.0;
      if (to > from) marchLeg(ray, leg, from, to, false, before, phases, light);
      from = to;
    }
#else
    marchLeg(ray, leg, 0.0, 1.0, false, before, phases, light);
#endif
  } while (++n < way.legCount);
  return light;
#endif
}

// Where the ray crosses the edge of the body's own shadow and of the first caster's umbra.
AirCuts shadowCuts(AirRay ray) {
  AirShell shell = airShell();
  AirCuts cuts = noCuts();
  float a = 1.0 - ray.sunAlong * ray.sunAlong;
  float b = ray.rise - ray.sunRise * ray.sunAlong;
  float c = squareAboveGround(shell, ray.height) - ray.sunRise * ray.sunRise;
  float root = b * b - a * c;
  if (root > 0.0 && a > 1e-9) {
    root = sqrt(root);
    float first = b > 0.0 ? (-b - root) / a : c / (-b + root);
    float second = b > 0.0 ? c / (-b - root) : (-b + root) / a;
    if (ray.sunRise + first * ray.sunAlong < 0.0) cuts.at[0] = first;
    if (ray.sunRise + second * ray.sunAlong < 0.0) cuts.at[1] = second;
  }
#ifdef SHADOW_PAIRS
  vec3 toTrue = vec3(1.0, 1.0, shadowScale.x);
  ConeCrossing crossing = crossUmbra(shadowPairs[0], ray.start * toTrue, ray.direction * toTrue);
  if (crossing.count == 2) {
    cuts.at[2] = crossing.first;
    cuts.at[3] = crossing.second;
  }
#endif
  return cuts;
}
#endif
