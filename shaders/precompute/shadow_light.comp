// The table of interface/shadows.glsl: visible light between the cones of each caster.
#include "interface/shadows.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) writeonly uniform image2DArray table;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(table);
  if (texel.x >= size.x || texel.y >= size.y) return;
  int caster = texel.z / AIR_LAYERS;
  LimbDarkening law = shadowLaws[texel.z - caster * AIR_LAYERS];
  ShadowPair pair = shadowPairs[caster];
  ShadowTablePlace place;
  place.along = alongAxisAt(float(texel.y) / float(size.y - 1), shadowScale.y);
  place.umbra = umbraRadiusAt(pair, place.along);
  place.inner = min(float(texel.x) / float(SHADOW_INNER - 1), 1.0);
  // The first texel beyond the edge stands for a place just outside it.
  place.outer = texel.x < SHADOW_INNER ? 0.0
                : max(float(texel.x - SHADOW_INNER), 0.1) / float(size.x - 1 - SHADOW_INNER);
  float penumbra = penumbraRadiusAt(pair, place.along);
  float edge = abs(place.umbra);
  DiscPair discs = discsAt(pair, place.along,
                           place.inner * edge + place.outer * place.outer * (penumbra - edge));
  float scale = shadowLightScale(pair, place, law.exponent.y);
  if (texel.x < SHADOW_INNER && place.umbra >= 0.0) {
    // There is no ring before the apex. One of a thousandth's width continues the table, so that
    // between this row and one beyond the apex it holds true.
    discs = discsFromAngles(1.0, 0.999, 0.001 * place.inner);
    scale = exp2((1.0 + 0.5 * law.exponent.y) * log2(0.001 * 1.999));
  }
  vec4 light = texel.x == size.x - 1 ? vec4(1.0) : visibleFraction(discs, law);
  imageStore(table, texel, light / scale);
}
