// Moments of the radiances about a shadow's axis.
//   UNECLIPSED: mean and irradiance of all light, binary logarithms
//   stage 1: sunlight scattered once: kept, and the first light that the cells hold
//   stage 2: what the light held adds to it; the new light held
//   stage 3: the same, and the grid: what the further orders would add, as a geometric series
#ifndef UNECLIPSED
#include "interface/eclipsed_air.glsl"
#else
#include "interface/air.glsl"
#define ECLIPSED_QUANTITIES 10
#endif
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) readonly uniform image2DArray radiances;
layout(rgba32f, binding = 1) uniform image2DArray held;  // ten moments by layer; UNECLIPSED: two
#ifndef UNECLIPSED
layout(rgba32f, binding = 2) uniform image2DArray first;
layout(rgba32f, binding = 3) uniform image2DArray lastStep;  // by layer: of the mean
layout(rgba32f, binding = 4) writeonly uniform image3D grid;
layout(binding = 11) uniform sampler2DArray uneclipsed;  // by layer: mean, irradiance
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
  vec4 m[ECLIPSED_QUANTITIES];
  for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) m[i] = vec4(0.0);
  int directions = directionCount.x * directionCount.y;
  for (int n = 0; n < directions; ++n) {
    AirDirection look = airDirection(n, horizon);
    vec4 light = imageLoad(radiances, ivec3(texel.xy, layer * directions + n)) * look.weight;
    float x = look.sine * cos(look.azimuth), y = look.sine * sin(look.azimuth), z = look.cosine;
    m[0] += light;
    if (z > 0.0) m[1] += light * z;
#ifndef UNECLIPSED
    m[2] += light * z;
    m[3] += light * x;
    m[4] += light * y;
    m[5] += light * (1.5 * z * z - 0.5);
    m[6] += light * x * z;
    m[7] += light * (x * x - y * y);
    m[8] += light * y * z;
    m[9] += light * x * y;
#endif
  }
  m[0] *= 1.0 / (4.0 * kPi);
  ivec2 at = texel.xy;
#ifdef UNECLIPSED
  for (int i = 0; i < 2; ++i)
    imageStore(held, ivec3(at, layer * 2 + i), log2(max(m[i], vec4(1e-30))));
#else
  m[2] *= 3.0 / (4.0 * kPi);
  m[3] *= 3.0 / (4.0 * kPi);
  m[4] *= 3.0 / (4.0 * kPi);
  m[5] *= 5.0 / (4.0 * kPi);
  m[6] *= 15.0 / (4.0 * kPi);
  m[7] *= 15.0 / (16.0 * kPi);
  m[8] *= 15.0 / (4.0 * kPi);
  m[9] *= 15.0 / (4.0 * kPi);
  vec2 place = uneclipsedPlace(cell.sunCosine, float(index.z));
  vec4 free[2];
  for (int i = 0; i < 2; ++i) free[i] = uneclipsedLight(place, layer, i);
  int slab = layer * ECLIPSED_QUANTITIES;
  if (stage == 1) {
    for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) imageStore(first, ivec3(at, slab + i), m[i]);
    // Where much of the Sun is seen, the share of its light is the better start.
    vec4 share = visibleSunlight(cell.position, layer);
    vec4 lift = max(share * exp2(free[0]) / max(m[0], vec4(1e-30)), vec4(1.0));
    for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) m[i] *= lift;
    m[1] = max(m[1], share * exp2(free[1]));
    for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) imageStore(held, ivec3(at, slab + i), m[i]);
    imageStore(lastStep, ivec3(at, layer), vec4(0.0));
    return;
  }
  for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) m[i] += imageLoad(first, ivec3(at, slab + i));
  vec4 gain = m[0] - imageLoad(held, ivec3(at, slab));
  vec4 before = imageLoad(lastStep, ivec3(at, layer));
  for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) imageStore(held, ivec3(at, slab + i), m[i]);
  imageStore(lastStep, ivec3(at, layer), gain);
  if (stage == 2) return;
  vec4 mean = max(m[0], vec4(1e-30));
  vec4 ratio = clamp(gain * before / max(before * before, vec4(1e-36)), vec4(0.0), vec4(0.8));
  vec4 power = log2(max(1.0 + gain * ratio / ((1.0 - ratio) * mean), vec4(0.5)));
  for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) {
    vec4 value = m[i] / mean;
    if (i < 2) value = power + log2(max(m[i], vec4(1e-30))) - free[i];
    imageStore(grid, ivec3(index.xy, (i * AIR_LAYERS + layer) * cellCount.z + index.z), value);
  }
#endif
}
