// Moments of the radiances about a shadow's axis.
//   stage 0: without the eclipse, all orders: the mean and the irradiance are kept as the base
//   stage 1: sunlight scattered once: kept, and the first form of the grid
//   stage 2: what the grid's light adds; written to the other grid
#include "interface/air.glsl"
#include "interface/shadows.glsl"
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) readonly uniform image2DArray radiances;
layout(rgba32f, binding = 1) uniform image2DArray base;   // mean, irradiance by layer
layout(rgba32f, binding = 2) uniform image2DArray first;  // ten moments by layer
layout(rgba32f, binding = 3) writeonly uniform image3D grid;
uniform int stage;
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
    m[2] += light * z;
    m[3] += light * x;
    m[4] += light * y;
    m[5] += light * (1.5 * z * z - 0.5);
    m[6] += light * x * z;
    m[7] += light * (x * x - y * y);
    m[8] += light * y * z;
    m[9] += light * x * y;
  }
  m[0] *= 1.0 / (4.0 * kPi);
  m[2] *= 3.0 / (4.0 * kPi);
  m[3] *= 3.0 / (4.0 * kPi);
  m[4] *= 3.0 / (4.0 * kPi);
  m[5] *= 5.0 / (4.0 * kPi);
  m[6] *= 15.0 / (4.0 * kPi);
  m[7] *= 15.0 / (16.0 * kPi);
  m[8] *= 15.0 / (4.0 * kPi);
  m[9] *= 15.0 / (4.0 * kPi);
  ivec2 at = texel.xy;
  if (stage == 0) {
    imageStore(base, ivec3(at, layer * 2), m[0]);
    imageStore(base, ivec3(at, layer * 2 + 1), m[1]);
    return;
  }
  vec4 baseMean = max(imageLoad(base, ivec3(at, layer * 2)), vec4(1e-30));
  vec4 baseIrradiance = max(imageLoad(base, ivec3(at, layer * 2 + 1)), vec4(1e-30));
  if (stage == 1) {
    for (int i = 0; i < ECLIPSED_QUANTITIES; ++i)
      imageStore(first, ivec3(at, layer * ECLIPSED_QUANTITIES + i), m[i]);
    // Where much of the Sun is seen, the share of its light is the better start.
    vec4 share = visibleSunlight(cell.position, layer);
    vec4 lift = max(share * baseMean / max(m[0], vec4(1e-30)), vec4(1.0));
    for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) m[i] *= lift;
    m[1] = max(m[1], share * baseIrradiance);
  } else {
    for (int i = 0; i < ECLIPSED_QUANTITIES; ++i)
      m[i] += imageLoad(first, ivec3(at, layer * ECLIPSED_QUANTITIES + i));
  }
  vec4 mean = max(m[0], vec4(1e-30));
  for (int i = 0; i < ECLIPSED_QUANTITIES; ++i) {
    vec4 value = i == 0 ? m[0] / baseMean : i == 1 ? m[1] / baseIrradiance : m[i] / mean;
    imageStore(grid, ivec3(index.xy, (i * AIR_LAYERS + layer) * cellCount.z + index.z), value);
  }
}
