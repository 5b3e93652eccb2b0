// The light that the cells about a shadow's axis hold, by direction, and its mean and irradiance.
//   UNECLIPSED: of all light, binary logarithms
//   stage 1: sunlight scattered once: kept, and the first light that the cells hold
//   stage 2: what the light held adds to it is the new light held
//   stage 3: the same, and by how much further orders would raise it, as a geometric series
#ifndef UNECLIPSED
#include "interface/eclipsed_air.glsl"
#else
#include "interface/air.glsl"
#endif
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) readonly uniform image2DArray radiances;
layout(rgba32f, binding = 1) uniform image2DArray held;       // by layer: mean, irradiance
#ifndef UNECLIPSED
layout(rgba32f, binding = 2) uniform image2DArray first;
// By layer: step of the mean (in the end the raise), and its ratio to the one before.
layout(rgba32f, binding = 3) uniform image2DArray lastStep;
layout(rgba32f, binding = 4) writeonly uniform image2DArray lightHeld;
layout(binding = 11) uniform sampler2DArray uneclipsed;
uniform int stage;
#include "interface/uneclipsed_light.glsl"
#endif
#include "interface/air_directions.glsl"

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= cellCount.x || texel.y >= cellCount.y * cellCount.z) return;
  ivec3 index = ivec3(texel.x, texel.y % cellCount.y, texel.y / cellCount.y);
  int layer = texel.z;
  AirShell shell = airShell();
  EclipsedCell cell = eclipsedCell(index);
  float horizon = horizonCosine(shell, cell.height);
  vec4 mean = vec4(0.0), irradiance = vec4(0.0);
  int directions = directionCount.x * directionCount.y;
  for (int n = 0; n < directions; ++n) {
    AirDirection look = airDirection(n, horizon);
    ivec3 at = ivec3(texel.xy, layer * directions + n);
    vec4 light = imageLoad(radiances, at);
#ifndef UNECLIPSED
    if (stage == 1) {
      imageStore(first, at, light);
    } else {
      light += imageLoad(first, at);
      imageStore(lightHeld, at, light);
    }
#endif
    light *= look.weight;
    mean += light;
    irradiance += light * max(look.cosine, 0.0);
  }
  mean *= 1.0 / (4.0 * kPi);
  ivec3 of = ivec3(texel.xy, layer * 2);
#ifdef UNECLIPSED
  imageStore(held, of, log2(max(mean, vec4(1e-30))));
  imageStore(held, of + ivec3(0, 0, 1), log2(max(irradiance, vec4(1e-30))));
#else
  if (stage == 1) {
    // Where much of the Sun is seen, the share of its light is the better start.
    vec2 place = uneclipsedPlace(cell.sunCosine, float(index.z));
    vec4 share = visibleSunlight(cell.position, layer);
    vec4 lift = max(share * exp2(uneclipsedLight(place, layer, 0)) / max(mean, vec4(1e-30)), vec4(1.0));
    for (int n = 0; n < directions; ++n) {
      ivec3 at = ivec3(texel.xy, layer * directions + n);
      imageStore(lightHeld, at, lift * imageLoad(radiances, at));
    }
    imageStore(held, of, mean * lift);
    imageStore(held, of + ivec3(0, 0, 1), max(irradiance, share * exp2(uneclipsedLight(place, layer, 1))));
    imageStore(lastStep, of, vec4(0.0));
    imageStore(lastStep, of + ivec3(0, 0, 1), vec4(1.0));
    return;
  }
  vec4 gain = mean - imageLoad(held, of);
  vec4 before = imageLoad(lastStep, of);
  vec4 ratio = clamp(gain * before / max(before * before, vec4(1e-36)), vec4(0.0), vec4(1.0));
  imageStore(held, of, mean);
  imageStore(held, of + ivec3(0, 0, 1), irradiance);
  if (stage == 3) {
    // Light that comes from far reaches a cell over some orders, whose ratios fall on the way to the last.
    vec4 fall = ratio / max(imageLoad(lastStep, of + ivec3(0, 0, 1)), vec4(1e-3));
    vec4 next = min(ratio * min(fall, vec4(1.0)), vec4(0.8));
    gain = log2(max(1.0 + gain * next / ((1.0 - next) * max(mean, vec4(1e-30))), vec4(0.5)));
  }
  imageStore(lastStep, of, gain);
  imageStore(lastStep, of + ivec3(0, 0, 1), ratio);
#endif
}
