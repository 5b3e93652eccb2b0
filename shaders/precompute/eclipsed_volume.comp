// The light that the cells hold, scattered toward each of a run of directions: averaged over the
// constituents by what each scatters there; binary logarithm over what the mean is there without the
// eclipse. Density comes where rays are marched.
#include "interface/eclipsed_air.glsl"
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 12) uniform sampler2DArray held;  // ten moments by layer; y: azimuth, then height
layout(rgba32f, binding = 0) writeonly uniform image3D volume;
layout(binding = 11) uniform sampler2DArray uneclipsed;
uniform int firstDirection;
#include "interface/air_directions.glsl"
#include "interface/uneclipsed_light.glsl"

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= cellCount.x || texel.y >= cellCount.y * cellCount.z) return;
  int height = texel.y / cellCount.y;
  float h = cellHeight(height);
  float sunCosine = eclipsedCell(ivec3(texel.x, texel.y % cellCount.y, height)).sunCosine;
  vec2 free = uneclipsedPlace(sunCosine, float(height));
  AirDirection look = airDirection(firstDirection + texel.z, horizonCosine(airShell(), h));
  float x = look.sine * cos(look.azimuth), y = look.sine * sin(look.azimuth), z = look.cosine;
  vec2 texels = densityTexels();
  AirDensities d = densitiesAt(rootHeight(airShell(), h) * texels.x + texels.y);
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 m[ECLIPSED_QUANTITIES];
    for (int i = 0; i < ECLIPSED_QUANTITIES; ++i)
      m[i] = texelFetch(held, ivec3(texel.xy, layer * ECLIPSED_QUANTITIES + i), 0);
    vec4 first = z * m[2] + x * m[3] + y * m[4];
    vec4 second = (1.5 * z * z - 0.5) * m[5] + x * z * m[6] + (x * x - y * y) * m[7] +
                  y * z * m[8] + x * y * m[9];
    vec4 sum = vec4(0.0), scatters = vec4(0.0);
    for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
      int i = layer * AIR_CONSTITUENTS + c;
      vec4 here = airScattering[i] * d.of[c];
      scatters += here;
      const int step_ = AIR_LAYERS * AIR_CONSTITUENTS;
      sum += here * (airPhaseMoments[i] * m[0] + airPhaseMoments[step_ + i] * first +
                     airPhaseMoments[2 * step_ + i] * second);
    }
    vec4 light = mix(m[0], sum / max(scatters, vec4(1e-30)), greaterThan(scatters, vec4(1e-30)));
    imageStore(volume,
               ivec3(texel.x, texel.y % cellCount.y,
                     (texel.z * AIR_LAYERS + layer) * cellCount.z + height),
               log2(max(light, max(1e-3 * m[0], vec4(1e-30)))) - uneclipsedLight(free, layer, 0));
  }
}
