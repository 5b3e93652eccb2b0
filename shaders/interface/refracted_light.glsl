// Light in the shadow of a caster with air (src/passes/refracted_light.cpp). Included by shadows.glsl;
// compiled out unless REFRACTED_LIGHT is defined.
#ifndef INTERFACE_REFRACTED_LIGHT_GLSL
#define INTERFACE_REFRACTED_LIGHT_GLSL
#ifdef REFRACTED_LIGHT
#include "shared/refracted_shadow.glsl"

layout(std140, binding = 11) uniform Refracted {
  // x: outer edge of the penumbra at the foot, m, 0 for a caster without air; y: its growth per
  // metre along the axis; z, w: the same of the umbra's rim.
  vec4 refractedReach[SHADOW_PAIRS];
};
// log2 of the light: x: placeOfDistance, y: along the axis; caster times layers.
layout(binding = 11) uniform sampler2DArray refractedLight;

// Share of sunlight at a place in the shadow of a caster with air. `span`: half the table's length
// along the axis.
vec4 refractedSunlight(int caster, ShadowPlace place, float span, int layer) {
  vec2 edge = refractedReach[caster].xz + refractedReach[caster].yw * place.along;
  if (place.distance >= edge.x) return vec4(1.0);
  ivec2 size = textureSize(refractedLight, 0).xy;
  vec2 at = vec2(placeOfDistance(place.distance, edge.y, edge.x),
                 clamp(0.5 + 0.5 * place.along / span, 0.0, 1.0));
  at = (at * vec2(size - 1) + 0.5) / vec2(size);
  return exp2(textureLod(refractedLight, vec3(at, float(caster * AIR_LAYERS + layer)), 0.0));
}
#endif
#endif
