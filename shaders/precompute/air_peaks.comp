// Sunlight turned once more by a forward peak (src/passes/peak_sunlight.h): invocation (x, y) is a cell over the
// Sun's zenith angle and height, as the depths toward the Sun have them; z: the spectral layer. Stored
// as negative logarithms of the light over that outside the air.
#include "interface/air_march.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) writeonly uniform image2DArray turned;
layout(rgba32f, binding = 1) uniform image2DArray total;
layout(rgba32f, binding = 2) uniform image2DArray onGround;  // irradiance of its horizontal by the total
layout(std430, binding = 0) readonly buffer Rings { vec4 rings[]; };
uniform int order;
uniform float reach;
const int kTurns = 4;  // azimuths about the Sun, in half a turn
const float kDark = 1e-30;

// What reaches the start of a ray from its direction, as if every peak turned light that way: shares of 1.
vec4 turnedAlong(AirRay ray, int layer) {
  AirShell shell = airShell();
  AirWay way = wayOf(ray);
  WayEnds ends = endsOf(ray, way);
  vec4 sum = vec4(0.0), taken = vec4(0.0);
  vec4 depths = depthTexels(), cells = texelsOf(imageSize(turned).xy);
  vec2 densities = densityTexels();
  int through = trueLayer(layer);
  for (int k = 0; k < way.legCount; ++k) {
    AirLeg leg = way.legs[0];
    if (k == 1) leg = way.legs[1];
    vec4 start = depthAt(ends.start, through);
    vec4 before = leg.sense * start;
    if (way.legCount == 2 && k == 1) before = 2.0 * depthAt(ends.low, through) - start;
    LegSpan span = legSpan(leg);
    float topRise = sqrt(leg.lowRise * leg.lowRise + squareBetween(shell, leg.lowHeight, shell.top));
    for (int n = 0; n < nodeCount.x; ++n) {
      LegNode node = nodeOnLeg(leg, span, nodes[n].x);
      AirPoint p = pointOnLeg(shell, leg, ray.sunAlong, node.height);
      float distance = nodes[n].y * node.step / max(p.cosine, 1e-9);
      AirDensities d = densitiesAt(rootHeight(shell, p.height) * densities.x + densities.y);
      DepthRow row = depthRow(shell, p.height);
      vec2 viewPlace = onTexels(depthCoordinatesAt(shell, row, row.gain / max(topRise + p.rise, 1e-9)), depths);
      vec4 peaks = vec4(0.0), takes = vec4(0.0);
      for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
        int i = layer * AIR_CONSTITUENTS + c;
        peaks += airScattering[i] * (1.0 - airPhaseMoments[i]) * d.of[c];
        takes += airExtinction[i] * d.of[c];
      }
      vec4 weight = distance * exp(-max(before - leg.sense * depthAt(viewPlace, through), vec4(0.0)));
      float above = 1.0;
#ifndef AIR_BENT
      above = sunAboveHorizon((p.sunRise + row.across) * p.overRadius);
#endif
      vec4 dimmed = order == 1 ? sunDepthAt(sunDepthPlace(shell, row, p.sunRise, depths), through)
                               : textureLod(airSource, vec3(sunDepthPlace(shell, row, p.sunRise, cells), float(layer)), 0.0);
      taken += weight * takes;
      sum += weight * peaks * above * exp(-dimmed);
    }
  }
  vec4 depth = depthOfWay(ends, through);
  vec4 missing = mix(depth, 1.0 - exp(-depth), greaterThan(depth, vec4(1e-3)));
  return sum * missing / max(taken, max(1e-4 * missing, vec4(1e-30)));
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(turned);
  if (texel.x >= size.x || texel.y >= size.y) return;
  AirShell shell = airShell();
  vec2 place = vec2(texel.xy) / vec2(size.xy - 1);
  HeightAndCosine at = heightAndCosineAt(shell, vec2(place.x * reach, place.y));
  at.height = min(at.height, 0.9999 * shell.top);
  float r = shell.radius + at.height;
  float sunSine = sqrt(max(1.0 - at.cosine * at.cosine, 0.0));
  vec4 light = vec4(0.0), level = vec4(0.0);
  for (int ring = 0; ring < PEAK_RINGS; ++ring) {
    float along = rings[ring * (AIR_LAYERS + 1)].x, aside = sqrt(max(1.0 - along * along, 0.0));
    vec4 ringLight = vec4(0.0), ringLevel = vec4(0.0);
    for (int i = 0; i < kTurns; ++i) {
      float turn = (float(i) + 0.5) * kPi / float(kTurns), up = aside * cos(turn);
      AirRay ray;
      ray.height = at.height;
      ray.sunAlong = along;
      ray.direction = vec3(along * sunSine - up * at.cosine, aside * sin(turn), along * at.cosine + up * sunSine);
      ray.rise = r * ray.direction.z;
      ray.sunRise = r * at.cosine;
      ray.groundRoot = ray.rise * ray.rise - squareAboveGround(shell, at.height);
      ray.start = vec3(0.0, 0.0, r);
      vec4 one = turnedAlong(ray, texel.z) / float(kTurns);
      ringLight += one;
      ringLevel += one * max(ray.direction.z, 0.0);
    }
    vec4 share = rings[ring * (AIR_LAYERS + 1) + 1 + texel.z];
    light += ringLight * share;
    level += ringLevel * share;
  }
  if (texel.y == 0) imageStore(onGround, texel, imageLoad(onGround, texel) + level);
  vec4 sum = light;
  if (order > 1) sum += exp(-imageLoad(total, texel));
  imageStore(turned, texel, -log(max(light, vec4(kDark))));
  imageStore(total, texel, -log(max(sum, vec4(kDark))));
}
