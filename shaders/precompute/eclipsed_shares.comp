// The grid of a shadow from the light that its cells hold (interface/eclipsed_air.glsl).
//   UNECLIPSED: what is scattered toward the grid's directions without the eclipse, binary logarithms:
//   of the light that the cells hold and of that which the drawing programs take
#ifdef UNECLIPSED
#include "interface/air_march.glsl"
#endif
#include "interface/eclipsed_air.glsl"
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 10) uniform sampler2DArray light;
layout(binding = 14) uniform sampler2DArray phases;
#ifdef UNECLIPSED
layout(rgba32f, binding = 0) writeonly uniform image2DArray scattered;  // by layer, rise, azimuth; held, drawn
#else
layout(binding = 11) uniform sampler2DArray uneclipsed;
layout(binding = 12) uniform sampler2DArray held;
layout(binding = 13) uniform sampler2DArray scattered;
layout(rgba32f, binding = 3) readonly uniform image2DArray raise;
layout(ECLIPSED_FORMAT, binding = 4) writeonly uniform image3D grid;
#include "interface/uneclipsed_light.glsl"
#endif
#include "interface/air_directions.glsl"
#include "interface/eclipsed_scattering.glsl"

struct Scattered {
  vec4 of[ECLIPSED_TURNS];
};

Scattered scatteredToward(ivec2 cell, int rise, int height, int layer) {
  Scattered sums;
  for (int t = 0; t < ECLIPSED_TURNS; ++t) sums.of[t] = vec4(0.0);
  for (int i = 0; i < directionCount.x; ++i) {
    LightOfRing from = lightOfRing(cell, i, layer);
    PhaseOfRings phase = phaseOfRings(i, directionCount.x + rise, height, layer);
    for (int t = 0; t < ECLIPSED_TURNS; ++t)
      for (int k = 0; k < ECLIPSED_TURNS_IN; ++k)
        sums.of[t] += phase.of[turnStep(t - 2 * k - 1)] * from.of[k];
  }
  return sums;
}

#ifdef UNECLIPSED
// As the drawing programs find it without the eclipse, averaged over what scatters.
vec4 drawnSource(EclipsedCell cell, int rise, int turn, int layer) {
  float z = eclipsedRise(rise), level = sqrt(max(1.0 - z * z, 0.0));
  float azimuth = 2.0 * kPi * float(turn) / float(ECLIPSED_TURNS);
  float sunSine = sqrt(max(1.0 - cell.sunCosine * cell.sunCosine, 0.0));
  AirPoint p;
  p.height = cell.height;
  p.cosine = z;
  p.sunCosine = cell.sunCosine;
  float sunAlong = clamp(z * cell.sunCosine + level * cos(azimuth) * sunSine, -1.0, 1.0);
  SourceParts parts = sourcePartsAt(sourcePlaceOf(cell.height, cell.sunCosine), p, 1.0, sunAlong, cell.position,
                                    vec3(0.0), AIR_DEGREE, layer);
  vec2 texels = densityTexels();
  AirDensities d = densitiesAt(rootHeight(airShell(), cell.height) * texels.x + texels.y);
  vec4 sum = vec4(0.0), scatters = vec4(0.0);
  for (int c = AIR_DARK; c < AIR_CONSTITUENTS; ++c) {
    sum += d.of[c] * sourceOf(parts, AIR_DEGREE, layer * AIR_CONSTITUENTS + c);
    scatters += d.of[c] * airScattering[layer * AIR_CONSTITUENTS + c];
  }
  return max(sum / max(scatters, vec4(1e-30)), max(1e-2 * parts.of[0], vec4(1e-30)));
}
#endif

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= cellCount.x || texel.y >= cellCount.y * cellCount.z) return;
  ivec3 index = ivec3(texel.x, texel.y % cellCount.y, texel.y / cellCount.y);
  int rise = texel.z;
  EclipsedCell cell = eclipsedCell(index);
#ifndef UNECLIPSED
  vec2 place = uneclipsedPlace(cell.sunCosine, float(index.z));
#endif
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    Scattered found = scatteredToward(texel.xy, rise, index.z, layer);
#ifdef UNECLIPSED
    for (int t = 0; t < ECLIPSED_TURNS; ++t) {
      int slice = 2 * ((layer * ECLIPSED_RISES + rise) * ECLIPSED_TURNS + t);
      imageStore(scattered, ivec3(texel.xy, slice), log2(max(found.of[t], vec4(1e-30))));
      imageStore(scattered, ivec3(texel.xy, slice + 1), log2(drawnSource(cell, rise, t, layer)));
    }
#else
    vec4 power = imageLoad(raise, ivec3(texel.xy, layer * 2));
    vec4 mean = texelFetch(held, ivec3(texel.xy, layer * 2), 0);
    vec4 share = power + log2(max(mean, vec4(1e-30))) - uneclipsedLight(place, layer, 0);
    // Where most of the light is left, shares are of the light found likewise, for nothing to jump
    // where a shadow begins; in the dark they are of what will be multiplied by them.
    vec4 dark = smoothstep(vec4(0.0), vec4(3.0), -share);
    for (int t = 0; t < ECLIPSED_TURNS; ++t) {
      vec4 here = power + log2(max(found.of[t], max(1e-3 * mean, vec4(1e-30))));
      float slice = float(2 * ((layer * ECLIPSED_RISES + rise) * ECLIPSED_TURNS + t));
      vec4 before = mix(textureLod(scattered, vec3(place, slice), 0.0),
                        textureLod(scattered, vec3(place, slice + 1.0), 0.0), dark);
      imageStore(grid, ivec3(index.x, t * cellCount.y + index.y, ((rise + 1) * AIR_LAYERS + layer) * cellCount.z + index.z),
                 here - before);
    }
    if (rise > 0) continue;
    vec4 ofGround = power + log2(max(texelFetch(held, ivec3(texel.xy, layer * 2 + 1), 0), vec4(1e-30))) -
                    uneclipsedLight(place, layer, 1);
    imageStore(grid, ivec3(index.xy, layer * cellCount.z + index.z), share);
    imageStore(grid, ivec3(index.x, cellCount.y + index.y, layer * cellCount.z + index.z), ofGround);
#endif
  }
}
