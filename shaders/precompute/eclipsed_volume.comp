// The light that the cells hold, scattered toward each ring of a run of directions: averaged over the
// constituents by what each scatters there; binary logarithm over what the mean is there without the
// eclipse. Density comes where rays are marched.
#include "interface/eclipsed_air.glsl"
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 10) uniform sampler2DArray light;  // by direction and layer; y: azimuth, then height
layout(binding = 11) uniform sampler2DArray uneclipsed;
layout(binding = 12) uniform sampler2DArray held;
layout(binding = 14) uniform sampler2DArray phases;
layout(rgba32f, binding = 0) writeonly uniform image3D volume;
uniform int firstDirection;
#include "interface/air_directions.glsl"
#include "interface/uneclipsed_light.glsl"
#include "interface/eclipsed_scattering.glsl"

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= cellCount.x || texel.y >= cellCount.y * cellCount.z) return;
  int height = texel.y / cellCount.y;
  float sunCosine = eclipsedCell(ivec3(texel.x, texel.y % cellCount.y, height)).sunCosine;
  vec2 free = uneclipsedPlace(sunCosine, float(height));
  int ring = firstDirection / directionCount.y + texel.z;
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 sums[ECLIPSED_TURNS_IN];
    for (int j = 0; j < ECLIPSED_TURNS_IN; ++j) sums[j] = vec4(0.0);
    for (int i = 0; i < directionCount.x; ++i) {
      LightOfRing from = lightOfRing(texel.xy, i, layer);
      PhaseOfRings phase = phaseOfRings(i, ring, height, layer);
      for (int j = 0; j < ECLIPSED_TURNS_IN; ++j)
        for (int k = 0; k < ECLIPSED_TURNS_IN; ++k)
          sums[j] += phase.of[turnStep(2 * (j - k))] * from.of[k];
    }
    vec4 mean = texelFetch(held, ivec3(texel.xy, layer * 2), 0);
    vec4 before = uneclipsedLight(free, layer, 0);
    for (int j = 0; j < ECLIPSED_TURNS_IN; ++j) {
      vec4 power = log2(max(sums[j], max(1e-3 * mean, vec4(1e-30)))) - before;
      int direction = texel.z * ECLIPSED_TURNS_IN + j;
      imageStore(volume, ivec3(texel.x, texel.y % cellCount.y,
                               (direction * AIR_LAYERS + layer) * cellCount.z + height), power);
    }
  }
}
