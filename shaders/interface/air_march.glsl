// Light scattered toward the camera along a ray through air. Per sample: the Sun's light through the
// air above (and past what eclipses it) scattered once, and the light that has been scattered
// before, from the source table. Compiled with AIR_SINGLE, AIR_SOURCE or AIR_VOLUME; with AIR_SEPARATE the
// peaked constituents' single scattering is kept apart without its phase function.
//
// Samples are Gauss-Legendre nodes in u (air.glsl, nodeOnLeg) along each leg: dense where air is dense
// and where a ray is tangent. In air thicker than light reaches (AIR_THICK) they lie on the part of the
// leg that is seen, dense toward the camera, and between them the source over the extinction is linear
// in the optical depth or, of light scattered before, exponential: exact where light diffuses, whether
// air absorbs or not, however coarse the steps are.
//   BODY_SUNLIT, BODY_DUSK, BODY_NIGHT  every ray meets the ground; with the Sun above 7 degrees
//   BODY_SKY                            none does
#ifndef INTERFACE_AIR_MARCH_GLSL
#define INTERFACE_AIR_MARCH_GLSL
#if defined(BODY_SUNLIT) || defined(BODY_DUSK) || defined(BODY_NIGHT)
#define BODY_GROUND
#endif
#include "interface/air.glsl"
#include "interface/shadows.glsl"

#if defined(SHADOW_PAIRS) && !defined(UNECLIPSED)
#define AIR_ECLIPSED
#ifdef ECLIPSED_SOURCE
#define AIR_ECLIPSED_SOURCE
#include "interface/eclipsed_air.glsl"
#endif
#endif

// Sparse look-ups of the source: at the low end and at this share of the top's height; beyond, it is
// held on up to kSparseReach times the root of that height.
const float kSparseHeight = 0.15;
const float kSparseReach = 2.0;
const int kSparseDegree = 2;
// Of the harmonics of clear air, rays drawn by themselves take the first two degrees: from space
// the rest changes them by 0.01 %, and it would double their time.
#if defined(AIR_FEW_HARMONICS) && !defined(AIR_HAZY)
const int kDrawnDegree = 2;
#else
const int kDrawnDegree = AIR_DEGREE;
#endif

// In haze the peaked constituents' phase functions vary by what lies on the way: applied at its end.
#if defined(AIR_HAZY) && defined(AIR_SINGLE) && !defined(AIR_BY_MOMENTS)
#define AIR_BLURRED
#ifndef AIR_SEPARATE
#define AIR_SEPARATE
#define AIR_JOINED
#endif
#endif

#if defined(AIR_HAZY) && !defined(AIR_VOLUME) && !defined(AIR_NORMALISED)
#define AIR_NORMALISED
#endif
#ifdef AIR_THICK  // weighs its samples by what they take away
#undef AIR_NORMALISED
#endif
// Optical depth beyond which thick air is not marched, and steps on the way for each sample of a leg.
const float kReach = 20.0;
const int kThickSteps = 2;

// One program for rays that take few samples, many, or some of both (air_geometry.glsl).
#if defined(AIR_FEW_HARMONICS) && !defined(AIR_HAZY) && !defined(AIR_THICK) && !defined(BODY_GROUND) && !defined(BODY_SKY)
#define AIR_PASSAGE
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
  vec4 peaked[AIR_LAYERS * AIR_PEAKED + 1];  // sunlight scattered once, without the phase functions
#endif
#ifdef AIR_BLURRED
  float forward;  // depth of the forward peaks on the Sun's way and the camera's: mean over `peaked`,
  float forwardWeight;  // whose sum over four wavelengths this is
#endif
#ifdef AIR_NORMALISED
  vec4 taken[AIR_LAYERS];  // share of light from behind that the samples take away
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
#ifdef AIR_BLURRED
  light.forward = 0.0;
  light.forwardWeight = 0.0;
#endif
#ifdef AIR_NORMALISED
  for (int layer = 0; layer < AIR_LAYERS; ++layer) light.taken[layer] = vec4(0.0);
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
    // A ray that sinks by less than a float resolves has its lowest point at its start.
    leg.lowHeight = clamp(-ray.groundRoot / (nearest + shell.radius), 0.0, ray.height);
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

// Where a way's start and low end lie in the table of optical depths, both looking up along it; the
// optical depth of the way is `starts` times the one and `lows` times the other.
struct WayEnds {
  vec2 start;
  vec2 low;
  float starts;
  float lows;
};

WayEnds endsOf(AirRay ray, AirWay way) {
  AirShell shell = airShell();
  vec4 texels = depthTexels();
  AirLeg leg = way.legs[0];
  WayEnds ends;
  ends.start = onTexels(depthCoordinatesOf(shell, depthRow(shell, ray.height), abs(ray.rise)), texels);
  ends.low = onTexels(depthCoordinatesOf(shell, depthRow(shell, leg.lowHeight), leg.lowRise), texels);
  ends.starts = leg.sense;
  ends.lows = way.legCount == 2 ? 2.0 : way.hitsGround ? 1.0 : 0.0;
  return ends;
}

// Optical depth from the start of a way to its end.
vec4 depthOfWay(WayEnds ends, int layer) {
  return max(ends.starts * depthAt(ends.start, layer) + ends.lows * depthAt(ends.low, layer), vec4(0.0));
}

#ifdef AIR_VOLUME
// Light scattered before in the direction in hand, averaged over the constituents by what each
// scatters: the including program has it in a volume.
struct VolumePlace {
  vec3 at;
  float slab;
  vec2 uneclipsed;
};
VolumePlace volumePlace(vec3 where, float height);
vec4 volumeLight(VolumePlace place, int layer);
#endif

#ifdef AIR_SOURCE
#ifdef AIR_THICK
// Light falls exponentially where air absorbs: its mean by the cubic through four levels over that
// between two, by which all degrees are corrected.
vec4 cubicOverLinear(vec2 place, ivec2 size, int layer) {
  float row = place.y * float(size.y) - 0.5;
  float low = clamp(floor(row), 0.0, float(size.y - 2)), t = clamp(row - low, 0.0, 1.0);
  vec4 at[4];
  for (int i = 0; i < 4; ++i)
    at[i] = sourceAt(vec2(place.x, (clamp(low + float(i - 1), 0.0, float(size.y - 1)) + 0.5) / float(size.y)),
                     harmonicSlice(layer, 0));
  if (low < 0.5) at[0] = 2.0 * at[1] - at[2];
  if (low > float(size.y) - 2.5) at[3] = 2.0 * at[2] - at[1];
  vec4 linear = mix(at[1], at[2], t);
  // Lagrange's polynomial less the line.
  vec4 bend = t * (1.0 - t) * ((2.0 - t) * (at[1] - 0.5 * (at[0] + at[2])) + (1.0 + t) * (at[2] - 0.5 * (at[1] + at[3]))) / 3.0;
  vec4 most = 0.25 * min(abs(at[1]), abs(at[2]));
  bend = clamp(bend, -most, most);
  return mix(vec4(1.0), 1.0 + bend / linear, greaterThan(at[1] * at[2], vec4(0.0)));
}
#endif
// Radiance that has been scattered (or reflected by the ground) before, as its parts of each degree
// in one direction, 1/sr.
struct SourceParts {
  vec4 of[AIR_DEGREE + 1];
};

// `at`: its place in the source table; up to `degree`.
SourceParts sourcePartsAt(vec2 at, AirPoint p, float sense, float sunAlong, vec3 where,
                          vec3 direction, int degree, int layer) {
  SunFrame f = sunFrame(sense * p.cosine, p.sunCosine, sunAlong);
  SourceParts parts;
  parts.of[0] = sourceMean(at, layer);
  parts.of[1] = f.z * sourceAt(at, harmonicSlice(layer, 1)) +
                f.x * sourceAt(at, harmonicSlice(layer, 2));
  parts.of[2] = (1.5 * f.z * f.z - 0.5) * sourceAt(at, harmonicSlice(layer, 3)) +
                3.0 * f.x * f.z * sourceAt(at, harmonicSlice(layer, 4)) +
                (2.0 * f.x * f.x + f.z * f.z - 1.0) * sourceAt(at, harmonicSlice(layer, 5));
#if AIR_DEGREE > 2
  for (int l = 3; l <= AIR_DEGREE; ++l) parts.of[l] = vec4(0.0);
  SunHarmonic h = firstHarmonic();
  for (int m = 0; degree > 2 && m <= degree; ++m) {
    for (int l = m; l <= degree; ++l) {
      if (l > 2) parts.of[l] += h.value * sourceAt(at, harmonicSlice(layer, l * (l + 1) / 2 + m));
      h = higherDegree(h, f, l, m);
    }
    h = higherOrder(h, f, m);
  }
#endif
#ifdef AIR_THICK
  vec4 mean = vec4(airReach.w);
#else
  vec4 mean = parts.of[0];
#endif
  for (int l = 1; l <= AIR_DEGREE; ++l) parts.of[l] *= mean;
#ifdef AIR_ECLIPSED_SOURCE
#ifdef ECLIPSED_DIRECTIONS
  vec4 share = eclipsedShareToward(where, p.height, direction, layer);
#else
  vec4 share = eclipsedShare(where, p.height, 0, layer);
#endif
  for (int l = 0; l <= AIR_DEGREE; ++l) parts.of[l] *= share;
#endif
  return parts;
}

// Averaged with the phase function of a constituent and times its scattering coefficient: 1/(m sr).
vec4 sourceOf(SourceParts parts, int degree, int i) {
  vec4 averaged = vec4(0.0);
  for (int l = 0; l <= degree; ++l)
    averaged += airPhaseMoments[l * AIR_LAYERS * AIR_CONSTITUENTS + i] * parts.of[l];
  return airScattering[i] * averaged;
}
#endif

#ifdef AIR_THICK
// Optical depth from the camera to u on a leg; `before` and `topRise` as in marchLeg.
vec4 depthOnLeg(AirLeg leg, LegSpan span, float topRise, float u, vec4 texels, vec4 before, int layer) {
  AirShell shell = airShell();
  AirPoint p = pointOnLeg(shell, leg, 0.0, nodeOnLeg(leg, span, u).height);
  DepthRow row = depthRow(shell, p.height);
  vec2 place = onTexels(depthCoordinatesAt(shell, row, row.gain / max(topRise + p.rise, 1e-9)), texels);
  return max(before - leg.sense * depthAt(place, layer), vec4(0.0));
}

// Where on the way from u = `from` to `to` the thinnest wavelength is kReach deep.
float seenTo(AirLeg leg, LegSpan span, float topRise, float from, float to, vec4 texels,
             vec4 before[AIR_LAYERS]) {
  float near = from, far = to;
  for (int i = 0; i < 8; ++i) {
    float u = i == 0 ? to : 0.5 * (near + far);
    float least = 1e30;
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
      vec4 depth = depthOnLeg(leg, span, topRise, u, texels, before[layer], layer);
      least = min(least, min(min(depth.x, depth.y), min(depth.z, depth.w)));
    }
    if (least <= kReach) near = u; else far = u;
    if (near == to) break;
  }
  return far;
}

// Share of light from a step of optical depth d in which the source is linear, by its near end and its
// far end.
float placeOfNode(AirLeg leg, float t) { return leg.sense > 0.0 ? t : t * t; }
struct StepShares {
  vec4 near;
  vec4 far;
};
StepShares stepShares(vec4 d) {
  vec4 left = exp(-d);
  vec4 mean = (1.0 - left) / max(d, vec4(1e-3));
  bvec4 thick = greaterThan(d, vec4(0.05));
  StepShares shares;  // series where the difference of close numbers would tell nothing
  shares.near = mix(d * (0.5 - d * (1.0 / 6.0 - d * (1.0 / 24.0 - d / 120.0))), 1.0 - mean, thick);
  shares.far = mix(d * (0.5 - d * (1.0 / 3.0 - d * (0.125 - d / 30.0))), mean - left, thick);
  return shares;
}

// Light from a step of optical depth d on which the source over the extinction falls or grows
// exponentially from `near` to `far`, as light does that diffuses in air that absorbs; linearly where
// the two are not of one kind.
vec4 exponentialStep(vec4 near, vec4 far, vec4 d) {
  const float most = 64.0;  // of one to the other
  StepShares shares = stepShares(d);
  vec4 linear = near * shares.near + far * shares.far;
  vec4 ratio = far / mix(vec4(1.0), near, greaterThan(abs(near), vec4(0.0)));
  vec4 x = d - log(clamp(ratio, 1.0 / most, most));
  bvec4 steep = greaterThan(abs(x), vec4(0.05));
  vec4 mean = mix(1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0)), (1.0 - exp(-x)) / mix(vec4(1.0), x, steep), steep);
  bvec4 alike = greaterThan(min(ratio - 1.0 / most, most - ratio), vec4(0.0));
  return mix(linear, near * d * mean, alike);
}
#endif

vec3 placeOnLeg(AirRay ray, AirLeg leg, float fromLow) {
  return ray.start + ray.direction * (leg.lowDistance + leg.sense * fromLow);
}

// Adds the light of the part u0..u1 of a leg, by the nodes from `first` to before `end`. `before`: optical depth from the camera to a point is
// before - sense times the point's depth to the top along the leg. Where `sparse`, the source is
// looked up at two heights only and is linear in the root of height between them.
void marchLeg(AirRay ray, AirLeg leg, float u0, float u1, int first, int end, bool sparse, vec4 before[AIR_LAYERS],
              vec4 beforeTrue, vec4 phases[AIR_LAYERS * AIR_CONSTITUENTS], inout AirLight light) {
  AirShell shell = airShell();
  LegSpan span = legSpan(leg);
  float topRise = sqrt(leg.lowRise * leg.lowRise + squareBetween(shell, leg.lowHeight, shell.top));
  vec4 depths = depthTexels();
  vec2 densities = densityTexels();
#ifdef AIR_SOURCE
  vec4 sources = sourceTexels();
  SunSpan suns = sunSpan(airShape.z);
  vec4 low[AIR_LAYERS * AIR_CONSTITUENTS], rise[AIR_LAYERS * AIR_CONSTITUENTS];
  float overHigh = 1.0;
  if (sparse) {
    AirPoint a = pointOnLeg(shell, leg, ray.sunAlong, leg.lowHeight);
    AirPoint b = pointOnLeg(shell, leg, ray.sunAlong, min(kSparseHeight * shell.top, leg.highHeight));
    overHigh = 1.0 / max(rootHeight(shell, b.height), 1e-6);
    vec2 placeA = onTexels(vec2(sourceColumn(suns, a.sunCosine), sourceLevel(rootHeight(shell, a.height))), sources);
    vec2 placeB = onTexels(vec2(sourceColumn(suns, b.sunCosine), sourceLevel(rootHeight(shell, b.height))), sources);
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
      SourceParts lower = sourcePartsAt(placeA, a, leg.sense, ray.sunAlong, placeOnLeg(ray, leg, 0.0),
                                        ray.direction, kSparseDegree, layer);
      SourceParts upper = sourcePartsAt(placeB, b, leg.sense, ray.sunAlong,
                                        placeOnLeg(ray, leg, b.fromLow), ray.direction, kSparseDegree, layer);
      for (int c = AIR_DARK; c < AIR_CONSTITUENTS; ++c) {
        int i = layer * AIR_CONSTITUENTS + c;
        low[i] = sourceOf(lower, kSparseDegree, i);
        rise[i] = sourceOf(upper, kSparseDegree, i) - low[i];
      }
    }
  }
#endif
#ifdef AIR_THICK
  float from = leg.sense > 0.0 ? u0 : u1, to = leg.sense > 0.0 ? u1 : u0;
  to = seenTo(leg, span, topRise, from, to, depths, before);
  vec4 here[AIR_LAYERS], left[AIR_LAYERS];  // depth of this node; what the step before leaves to it
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    here[layer] = depthOnLeg(leg, span, topRise, from, depths, before[layer], layer);
    left[layer] = vec4(0.0);
  }
  int last = kThickSteps * (end - first);
  float overLast = 1.0 / float(last);
#ifdef AIR_SOURCE
  ivec2 sourceSize = textureSize(airSource, 0).xy;
  // Of the node before: source over extinction, depth of the step from it, light that reaches the camera.
  vec4 nearSource[AIR_LAYERS], nearStep[AIR_LAYERS], nearReaches[AIR_LAYERS];
#endif
#endif
  // Loops test at their end: a software renderer runs the body once more where they test before it.
#ifdef AIR_THICK
  int n = 0;
#else
  int n = first;
#endif
  do {
#ifdef AIR_THICK
    float u = mix(from, to, placeOfNode(leg, float(n) * overLast));
    float uNext = mix(from, to, placeOfNode(leg, min(float(n + 1) * overLast, 1.0)));
#else
    float u = mix(u0, u1, nodes[n].x);
#endif
    LegNode node = nodeOnLeg(leg, span, u);
    AirPoint p = pointOnLeg(shell, leg, ray.sunAlong, node.height);
#ifndef AIR_THICK
    float distance = (u1 - u0) * nodes[n].y * node.step / max(p.cosine, 1e-9);
#endif
    float root = rootHeight(shell, p.height);
    AirDensities d = densitiesAt(root * densities.x + densities.y);
    DepthRow row = depthRow(shell, p.height);
    float toTop = row.gain / max(topRise + p.rise, 1e-9);
    vec2 viewPlace = onTexels(depthCoordinatesAt(shell, row, toTop), depths);
#ifdef AIR_SINGLE
    vec2 sunPlace = sunDepthPlace(shell, row, p.sunRise, depths);
#if defined(BODY_SUNLIT) || defined(AIR_BENT)
    const float above = 1.0;
#else
    float above = sunAboveHorizon((p.sunRise + row.across) * p.overRadius);
#endif
#endif
#ifdef AIR_SOURCE
    vec2 sourcePlace = onTexels(vec2(sourceColumn(suns, p.sunCosine), sourceLevel(root)), sources);
    float share = min(root * overHigh, kSparseReach);
#endif
    vec3 where = placeOnLeg(ray, leg, p.fromLow);
#ifdef AIR_VOLUME
    VolumePlace inVolume = volumePlace(where, p.height);
#endif
#ifdef AIR_BLURRED
    float peakedHere = 0.0;
#endif
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
#if defined(AIR_NORMALISED) || defined(AIR_THICK)
      vec4 takes = vec4(0.0);
      for (int c = 0; c < AIR_CONSTITUENTS; ++c)
        takes += restExtinction(layer * AIR_CONSTITUENTS + c) * d.of[c];
#endif
#ifdef AIR_THICK
      vec4 next = max(depthOnLeg(leg, span, topRise, uNext, depths, before[layer], layer), here[layer]);
      vec4 step = next - here[layer];
      StepShares shares = stepShares(step);
      vec4 reaches = exp(-here[layer]);
      vec4 weight = (left[layer] + reaches * shares.near) / max(takes, vec4(1e-20));
      left[layer] = reaches * shares.far;
      here[layer] = next;
#else
      vec4 depth = max(before[layer] - leg.sense * depthAt(viewPlace, layer), vec4(0.0));
      vec4 weight = distance * exp(-depth);
#endif
#ifdef AIR_NORMALISED
      light.taken[layer] += weight * takes;
#endif
#ifdef AIR_SINGLE
      vec4 sun = weight * above * exp(-sunDepthAt(sunPlace, layer));
#ifdef AIR_ECLIPSED
      sun *= visibleSunlight(where, layer);
#endif
      vec4 once = vec4(0.0);
#endif
#ifdef AIR_SOURCE
      SourceParts parts;
      if (!sparse)
        parts = sourcePartsAt(sourcePlace, p, leg.sense, ray.sunAlong, where, ray.direction, kDrawnDegree, layer);
      vec4 more = vec4(0.0);
#endif
      for (int c = AIR_DARK; c < AIR_CONSTITUENTS; ++c) {
        int i = layer * AIR_CONSTITUENTS + c;
#ifdef AIR_SINGLE
        vec4 scattered = airScattering[i] * d.of[c];
#ifdef AIR_SEPARATE
        if (c >= AIR_SMOOTH) {
          light.peaked[layer * AIR_PEAKED + c - AIR_SMOOTH] += sun * scattered;
#ifdef AIR_BLURRED
          if (layer == 0) peakedHere += dot(sun * scattered, vec4(1.0));
#endif
        } else
#endif
          once += scattered * phases[i];
#endif
#ifdef AIR_SOURCE
        more += d.of[c] * (sparse ? low[i] + share * rise[i] : sourceOf(parts, kDrawnDegree, i));
#endif
      }
#ifdef AIR_SINGLE
      light.joint[layer] += sun * once;
#endif
#ifdef AIR_SOURCE
#ifdef AIR_THICK
      more *= cubicOverLinear(sourcePlace, sourceSize, layer) / max(takes, vec4(1e-20));
#ifndef AIR_BY_MOMENTS  // there also of differences
      more = max(more, vec4(0.0));
#endif
      if (n > 0)
        light.joint[layer] += nearReaches[layer] * exponentialStep(nearSource[layer], more, nearStep[layer]);
      nearSource[layer] = more;
      nearStep[layer] = step;
      nearReaches[layer] = reaches;
#else
      light.joint[layer] += weight * max(more, vec4(0.0));
#endif
#endif
#ifdef AIR_VOLUME
      vec4 scatters = vec4(0.0);
      for (int c = 0; c < AIR_CONSTITUENTS; ++c)
        scatters += airScattering[layer * AIR_CONSTITUENTS + c] * d.of[c];
      light.joint[layer] += weight * scatters * volumeLight(inVolume, layer);
#endif
    }
#ifdef AIR_BLURRED
    vec4 forward = beforeTrue - before[0] -
                   leg.sense * (depthAt(viewPlace, trueLayer(0)) - depthAt(viewPlace, 0)) +
                   sunDepthAt(sunPlace, trueLayer(0)) - sunDepthAt(sunPlace, 0);
    light.forward += peakedHere * 0.25 * max(dot(forward, vec4(1.0)), 0.0);
    light.forwardWeight += peakedHere;
#endif
#ifdef AIR_THICK
  } while (++n <= last);
#else
  } while (++n < end);
#endif
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

AirLight marchLegs(AirRay ray, AirWay way, WayEnds ends, AirCuts cuts) {
  AirShell shell = airShell();
  AirLight light = darkAir();
  vec4 phases[AIR_LAYERS * AIR_CONSTITUENTS];
#ifdef AIR_SINGLE
  for (int layer = 0; layer < AIR_LAYERS; ++layer)
    for (int c = AIR_DARK; c < AIR_CONSTITUENTS; ++c)
#ifdef AIR_BY_MOMENTS
      phases[layer * AIR_CONSTITUENTS + c] = phaseByMoments(c, layer, ray.sunAlong);
#else
      phases[layer * AIR_CONSTITUENTS + c] = phaseOf(c, layer, ray.sunAlong, 0.0);
#endif
#endif
#ifdef BODY_GROUND
  {
#if defined(BODY_SUNLIT) && !defined(AIR_HAZY) && !defined(AIR_THICK)
    const bool sparse = true;
    int first = nodeCount.x, end = nodeCount.x + nodeCount.y;
#else
    const bool sparse = false;
    int first = 0, end = nodeCount.x;
#endif
    vec4 before[AIR_LAYERS];
    for (int layer = 0; layer < AIR_LAYERS; ++layer) before[layer] = -depthAt(ends.start, layer);
    vec4 beforeTrue = -depthAt(ends.start, trueLayer(0));
    marchLeg(ray, way.legs[0], 0.0, 1.0, first, end, sparse, before, beforeTrue, phases, light);
    return light;
  }
#else
  int n = 0;
  do {
    AirLeg leg = way.legs[0];
    if (n == 1) leg = way.legs[1];
    vec4 before[AIR_LAYERS];
    for (int layer = 0; layer < AIR_LAYERS; ++layer) {
      vec4 start = depthAt(ends.start, layer);
      if (way.legCount == 2 && n == 1)
        before[layer] = 2.0 * depthAt(ends.low, layer) - start;
      else
        before[layer] = leg.sense * start;
    }
    vec4 beforeTrue = leg.sense * depthAt(ends.start, trueLayer(0));
    if (way.legCount == 2 && n == 1)
      beforeTrue = 2.0 * depthAt(ends.low, trueLayer(0)) - depthAt(ends.start, trueLayer(0));
#ifdef AIR_CUTS
    LegSpan span = legSpan(leg);
    // Distances of the cuts as positions u on this leg, ascending.
    float at[4];
    for (int i = 0; i < 4; ++i) {
      float fromLow = (cuts.at[i] - leg.lowDistance) * leg.sense;
      at[i] = cuts.at[i] > 0.0 && fromLow > 0.0
                  ? nodeOfHeight(leg, span, heightOnLeg(shell, leg, fromLow))
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
      if (to > from) marchLeg(ray, leg, from, to, 0, nodeCount.x, false, before, beforeTrue, phases, light);
      from = to;
    }
#else
    marchLeg(ray, leg, 0.0, 1.0, 0, nodeCount.x, false, before, beforeTrue, phases, light);
#endif
  } while (++n < way.legCount);
#ifdef AIR_PASSAGE
  AirLeg sunk = way.legs[0];
  float share = way.hitsGround ? fewSamplesShare(sunk.lowSunRise * (1.0 / shell.radius),
                                                 sunk.lowRise * (1.0 / shell.radius)) : 0.0;
  if (share > 0.0) {
    AirLight few = darkAir();
    vec4 before[AIR_LAYERS];
    for (int layer = 0; layer < AIR_LAYERS; ++layer) before[layer] = -depthAt(ends.start, layer);
    marchLeg(ray, sunk, 0.0, 1.0, nodeCount.x, nodeCount.x + nodeCount.y, true, before, vec4(0.0),
             phases, few);
    for (int layer = 0; layer < AIR_LAYERS; ++layer)
      light.joint[layer] = mix(light.joint[layer], few.joint[layer], share);
  }
#endif
  return light;
#endif
}

// The light of the whole way; with AIR_SEPARATE its peaks are still apart.
AirLight marchAlong(AirRay ray, AirWay way, WayEnds ends, AirCuts cuts) {
  AirLight light = marchLegs(ray, way, ends, cuts);
#ifdef AIR_NORMALISED
  // What the samples take away is what is missing in the end: no order brighter than the one before,
  // however coarse the steps are in thick air.
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 depth = depthOfWay(ends, layer);
    vec4 missing = mix(depth, 1.0 - exp(-depth), greaterThan(depth, vec4(1e-3)));
    vec4 share = missing / max(light.taken[layer], max(1e-4 * missing, vec4(1e-30)));
    light.joint[layer] *= share;
#ifdef AIR_SEPARATE
    for (int c = 0; c < AIR_PEAKED; ++c) light.peaked[layer * AIR_PEAKED + c] *= share;
#endif
  }
#endif
  return light;
}

#ifdef AIR_BLURRED
// The row of the phase functions with the blur of that light.
float blurOf(AirLight light) {
  float depth = light.forwardWeight > 0.0 ? light.forward / light.forwardWeight : 0.0;
  return blurRow(depth, float(AIR_PHASE_LEVELS - 1));
}
#endif

// The light of the whole way.
AirLight lightAlong(AirRay ray, AirWay way, WayEnds ends, AirCuts cuts) {
  AirLight light = marchAlong(ray, way, ends, cuts);
#ifdef AIR_JOINED
  float blur = blurOf(light);
  for (int layer = 0; layer < AIR_LAYERS; ++layer)
    for (int c = 0; c < AIR_PEAKED; ++c)
      light.joint[layer] += light.peaked[layer * AIR_PEAKED + c] *
                            phaseOf(AIR_SMOOTH + c, layer, ray.sunAlong, blur);
#endif
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
