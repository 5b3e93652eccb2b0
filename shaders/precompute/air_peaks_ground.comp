// Adds to the bent Sun's irradiance of the ground what forward peaks have turned (src/passes/peak_sunlight.h).
#include "interface/air.glsl"
layout(local_size_x = 64) in;
layout(rgba32f, binding = 0) uniform image2D densities;

void main() {
  ivec2 size = imageSize(densities);
  int layer = int(gl_GlobalInvocationID.z);
  ivec2 texel = ivec2(int(gl_GlobalInvocationID.x), AIR_DENSITY_ROWS + 1 + layer);
  if (texel.x >= size.x) return;
  AirShell shell = airShell();
  float root = float(texel.x) / float(size.x - 1);
  float sunCosine = airBent.y + root * root / airBent.z;
  vec2 place = sunDepthPlace(shell, depthRow(shell, 0.0), sunCosine * shell.radius, texelsOf(textureSize(airSource, 0).xy));
  imageStore(densities, texel, imageLoad(densities, texel) + textureLod(airSource, vec3(place.x, 0.5, float(layer)), 0.0));
}
