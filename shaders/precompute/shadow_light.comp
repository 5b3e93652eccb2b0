// The table of interface/shadows.glsl: visible light over place^1.5, of one caster.
#include "interface/shadows.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) writeonly uniform image2DArray table;
layout(std140, binding = 8) uniform Law {
  LimbDarkening laws[AIR_LAYERS];
};

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(table);
  if (texel.x >= size.x || texel.y >= size.y) return;
  int caster = texel.z / AIR_LAYERS;
  float along = shadowScale.y * (2.0 * float(texel.y) / float(size.y - 1) - 1.0);
  // The first texel stands for a place just outside the umbra.
  float x = max(float(texel.x), 0.1) / float(size.x - 1);
  ShadowPair pair = shadowPairs[caster];
  float umbra = umbraRadiusAt(pair, along);
  float distance = umbra + x * x * (penumbraRadiusAt(pair, along) - umbra);
  DiscPair discs = discsAt(pair, along, max(distance, 0.0));
  vec4 light = texel.x == size.x - 1 ? vec4(1.0)
                                     : visibleFraction(discs, laws[texel.z - caster * AIR_LAYERS]);
  imageStore(table, texel, light / (x * x * x));
}
