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
  way.hitsGround = ray.rise < 0.0 && ray.groundRoot > 0.0;
  way.legCount = 1;
  AirLeg leg;
  if (ray.rise >= 0.0) {
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
// Radiance that has been scattered (or reflected by the ground) before, averaged over directions with
// the phase functions, times the scattering coefficients: 1/(m sr).
vec4 sourceAt(AirDensities d, vec3 place[6], SunFrame f, int layer) {
  vec4 w0 = vec4(0.0), w1 = vec4(0.0), w2 = vec4(0.0);
  for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
    int i = layer * AIR_CONSTITUENTS + c;
    vec4 s = airScattering[i] * d.of[c];
    w0 += s;
    w1 += s * airPhaseMoment1[i];
    w2 += s * airPhaseMoment2[i];
  }
  vec2 at = place[0].xy;
  float first = float(layer * 7);
  vec4 sum = w0 * textureLod(airSource, vec3(at, first), 0.0);
  sum += w1 * (f.z * textureLod(airSource, vec3(at, first + 1.0), 0.0) +
               f.x * textureLod(airSource, vec3(at, first + 2.0), 0.0));
  float sineSquared = 1.0 - f.z * f.z;
  sum += w2 * ((1.5 * f.z * f.z - 0.5) * textureLod(airSource, vec3(at, first + 3.0), 0.0) +
               f.x * f.z * textureLod(airSource, vec3(at, first + 4.0), 0.0) +
               (2.0 * f.x * f.x - sineSquared) * textureLod(airSource, vec3(at, first + 5.0), 0.0));
  return max(sum, vec4(0.0));
}
#endif

#if defined(ECLIPSED_HARMONICS) && defined(AIR_ECLIPSED_SOURCE)
// The same inside a shadow. `sideways`: component of the ray along up x Sun, mirrored with the place.
vec4 eclipsedSourceAt(AirDensities d, EclipsedPlace at, SunFrame f, float sideways, vec2 place,
                      int layer) {
  vec4 w0 = vec4(0.0), w1 = vec4(0.0), w2 = vec4(0.0);
  for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
    int i = layer * AIR_CONSTITUENTS + c;
    vec4 s = airScattering[i] * d.of[c];
    w0 += s;
    w1 += s * airPhaseMoment1[i];
    w2 += s * airPhaseMoment2[i];
  }
  vec4 mean = textureLod(airSource, vec3(place, float(layer * 7)), 0.0) *
              eclipsedQuantity(at, 0, layer);
  vec4 sum = w0;
  sum += w1 * (f.z * eclipsedQuantity(at, 2, layer) + f.x * eclipsedQuantity(at, 3, layer) +
               sideways * eclipsedQuantity(at, 4, layer));
  sum += w2 * ((1.5 * f.z * f.z - 0.5) * eclipsedQuantity(at, 5, layer) +
               f.x * f.z * eclipsedQuantity(at, 6, layer) +
               (f.x * f.x - sideways * sideways) * eclipsedQuantity(at, 7, layer) +
               sideways * f.z * eclipsedQuantity(at, 8, layer) +
               f.x * sideways * eclipsedQuantity(at, 9, layer));
  return max(sum * mean, vec4(0.0));
}
#endif

// Adds the light of the part u0..u1 of a leg. `before`: optical depth from the camera to a point is
// before - sense times the point's depth to the top along the leg.
void marchLeg(AirRay ray, AirLeg leg, float u0, float u1, vec4 before[AIR_LAYERS],
              vec4 phases[AIR_LAYERS * AIR_CONSTITUENTS], inout AirLight light) {
  AirShell shell = airShell();
  float span = leg.highHeight - leg.lowHeight;
  for (int i = 0; i < nodeCount.x; ++i) {
    float u = mix(u0, u1, nodes[i].x);
    AirPoint p = pointOnLeg(shell, leg, ray.sunAlong, leg.lowHeight + span * u * u * u);
    float distance = (u1 - u0) * nodes[i].y * 3.0 * u * u * span / max(p.cosine, 1e-9);
    AirDensities d = densitiesAt(p.height);
    vec2 viewPlace = depthPlace(p.height, p.cosine);
#ifdef AIR_SINGLE
    float above = sunAboveHorizon(p.height, p.sunCosine);
    vec2 toSun = sunPlace(p.height, p.sunCosine);
#endif
#ifdef AIR_ECLIPSED
    vec3 where = ray.start + ray.direction * (leg.lowDistance + leg.sense * p.fromLow);
#endif
#ifdef AIR_SOURCE
    vec3 place[6];
    place[0].xy = onTexels(sourceCoordinates(shell, airShape.z, p.height, p.sunCosine),
                           textureSize(airSource, 0).xy);
    SunFrame f = sunFrame(leg.sense * p.cosine, p.sunCosine, ray.sunAlong);
#ifdef AIR_ECLIPSED_SOURCE
    EclipsedPlace eclipsed = eclipsedPlace(where, p.height);
#if defined(ECLIPSED_HARMONICS) && defined(AIR_ECLIPSED_SOURCE)
    vec3 up = normalize(where);
    vec3 left = cross(up, eclipsedSun.xyz);
    float sideways = eclipsed.side * dot(ray.direction, left) / max(length(left), 1e-6);
#endif
#endif
#endif
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
      vec4 source = sourceAt(d, place, f, layer);
#ifdef AIR_ECLIPSED_SOURCE
#if defined(ECLIPSED_HARMONICS) && defined(AIR_ECLIPSED_SOURCE)
      source = mix(source, eclipsedSourceAt(d, eclipsed, f, sideways, place[0].xy, layer),
                   eclipsed.inside);
#else
      source *= eclipsedShare(eclipsed, 0, layer);
#endif
#endif
      joint += weight * source;
#endif
      light.joint[layer] += joint;
    }
  }
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
  vec2 lowPlace = depthPlace(way.legs[0].lowHeight, 0.0);
  for (int n = 0; n < way.legCount; ++n) {
    AirLeg leg = way.legs[n];
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
      if (to > from) marchLeg(ray, leg, from, to, before, phases, light);
      from = to;
    }
#else
    marchLeg(ray, leg, 0.0, 1.0, before, phases, light);
#endif
  }
  return light;
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
