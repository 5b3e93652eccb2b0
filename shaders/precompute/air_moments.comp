// Moments of the radiance at each cell over all directions (air_geometry.glsl, SunFrame), and the
// irradiance on a horizontal surface there; added to the sum over orders. With LAST, the orders
// beyond are summed as the geometric series that the last two suggest.
#include "interface/air.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) readonly uniform image2DArray radiances;
layout(rgba32f, binding = 1) uniform image2DArray previous;
layout(rgba32f, binding = 2) uniform image2DArray total;     // both: seven a spectral layer
uniform int order;  // 1 for sunlight scattered once
uniform int lastOrder;
#include "interface/air_directions.glsl"

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  int layer = int(gl_GlobalInvocationID.z);
  int firstLayer = layer * 7;
  int directions = directionCount.x * directionCount.y;
  ivec2 size = imageSize(radiances).xy;
  if (texel.x >= size.x || texel.y >= size.y) return;
  AirShell shell = airShell();
  HeightAndCosine at = sourcePlace(shell, airShape.z, vec2(texel) / vec2(size - 1));
  at.height = min(at.height, shell.top * 0.9999);
  float horizon = horizonCosine(shell, at.height);
  vec4 m[7];
  for (int i = 0; i < 7; ++i) m[i] = vec4(0.0);
  for (int n = 0; n < directions; ++n) {
    AirDirection look = airDirection(n, horizon);
    vec4 light = imageLoad(radiances, ivec3(texel, layer * directions + n)) * look.weight;
    float x = look.sine * cos(look.azimuth);
    m[0] += light;
    m[1] += light * look.cosine;
    m[2] += light * x;
    m[3] += light * (1.5 * look.cosine * look.cosine - 0.5);
    m[4] += light * x * look.cosine;
    m[5] += light * (2.0 * x * x - look.sine * look.sine);
    if (look.cosine > 0.0) m[6] += light * look.cosine;
  }
  // Over the squared norms of the harmonics.
  m[0] *= 1.0 / (4.0 * kPi);
  m[1] *= 3.0 / (4.0 * kPi);
  m[2] *= 3.0 / (4.0 * kPi);
  m[3] *= 5.0 / (4.0 * kPi);
  m[4] *= 15.0 / (4.0 * kPi);
  m[5] *= 15.0 / (16.0 * kPi);
  vec4 tail = vec4(0.0);
  if (order == lastOrder && order > 1) {
    vec4 before = imageLoad(previous, ivec3(texel, firstLayer));
    vec4 ratio = clamp(m[0] / max(before, vec4(1e-30)), vec4(0.0), vec4(0.98));
    tail = ratio / (1.0 - ratio);
  }
  for (int i = 0; i < 7; ++i) {
    ivec3 to = ivec3(texel, firstLayer + i);
    vec4 sum = order > 1 ? imageLoad(total, to) : vec4(0.0);
    imageStore(total, to, sum + m[i] * (1.0 + tail));
    imageStore(previous, to, m[i]);
  }
}
