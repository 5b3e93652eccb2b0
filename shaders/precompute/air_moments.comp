// Harmonics of the radiance at each cell over all directions (air_geometry.glsl, SunFrame), and the
// irradiance on a horizontal surface there; added to the sum over orders. With LAST, the orders
// beyond are summed as the geometric series that the last two suggest.
#include "interface/air.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) readonly uniform image2DArray radiances;
layout(rgba32f, binding = 1) uniform image2DArray previous;
layout(rgba32f, binding = 2) uniform image2DArray total;     // both as airSource
uniform int order;  // 1 for sunlight scattered once
uniform int lastOrder;
#include "interface/air_directions.glsl"

// A slice as look-ups take it, of a cell with that mean radiance.
vec4 held(int slice, vec4 value, vec4 mean) {
  return slice == 0 || slice == AIR_HARMONICS ? rootOfLight(value) : overMean(value, mean);
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  int layer = int(gl_GlobalInvocationID.z);
  int firstLayer = layer * (AIR_HARMONICS + 1);
  int directions = directionCount.x * directionCount.y;
  ivec2 size = imageSize(radiances).xy;
  if (texel.x >= size.x || texel.y >= size.y) return;
  AirShell shell = airShell();
  HeightAndCosine at = sourceCell(texel, size);
  float horizon = horizonCosine(shell, at.height);
  vec4 sums[AIR_HARMONICS + 1];
  for (int i = 0; i <= AIR_HARMONICS; ++i) sums[i] = vec4(0.0);
  for (int n = 0; n < directions; ++n) {
    AirDirection look = airDirection(n, horizon);
    vec4 light = imageLoad(radiances, ivec3(texel, layer * directions + n)) * look.weight;
    SunFrame f;
    f.z = look.cosine;
    f.x = look.sine * cos(look.azimuth);
    SunHarmonic h = firstHarmonic();
    for (int m = 0; m <= AIR_DEGREE; ++m) {
      for (int l = m; l <= AIR_DEGREE; ++l) {
        sums[l * (l + 1) / 2 + m] += light * h.value;
        h = higherDegree(h, f, l, m);
      }
      h = higherOrder(h, f, m);
    }
    if (look.cosine > 0.0) sums[AIR_HARMONICS] += light * look.cosine;
  }
  for (int l = 0; l <= AIR_DEGREE; ++l)
    for (int m = 0; m <= l; ++m) sums[l * (l + 1) / 2 + m] /= harmonicNorm(l, m);
  vec4 tail = vec4(0.0);
  if (order == lastOrder && order > 1) {
    vec4 before = lightOfRoot(imageLoad(previous, ivec3(texel, firstLayer)));
    vec4 ratio = clamp(sums[0] / max(before, vec4(1e-30)), vec4(0.0), vec4(0.98));
    tail = ratio / (1.0 - ratio);
  }
  // The sum is held as look-ups take it once it is whole.
  bool whole = order == lastOrder;
  vec4 mean = vec4(0.0);
  for (int i = 0; i <= AIR_HARMONICS; ++i) {
    ivec3 to = ivec3(texel, firstLayer + i);
    vec4 sum = sums[i] * (1.0 + tail);
    if (order > 1) sum += imageLoad(total, to);
    if (i == 0) mean = sum;
    imageStore(total, to, whole ? held(i, sum, mean) : sum);
    imageStore(previous, to, held(i, sums[i], sums[0]));
  }
}
