// What eclipses the Sun at a point of the body in hand. Compiled out unless SHADOW_PAIRS, the number
// of casters with a live shadow, is defined.
#ifndef INTERFACE_SHADOWS_GLSL
#define INTERFACE_SHADOWS_GLSL
#ifdef SHADOW_PAIRS
#include "shared/eclipse.glsl"

layout(std140, binding = 7) uniform Shadows {
  ShadowPair shadowPairs[SHADOW_PAIRS];
  vec4 shadowScale;  // x: polar over equatorial radius; y: half the span of the table along the axis
};
// Visible light of the limb-darkened disc between umbra and penumbra, over gap^1.5:
// x: square root of the place between the cones, y: along the axis; caster times layers.
layout(binding = 8) uniform sampler2DArray shadowLight;

struct ShadowTablePlace {
  float between;  // 0 at the umbral cone (or the axis beyond its apex: above 0), 1 at the penumbral
  float along;
};

ShadowTablePlace shadowTablePlace(int caster, vec3 scaled) {
  ShadowPlace place = placeInShadow(shadowPairs[caster], scaled * vec3(1.0, 1.0, shadowScale.x));
  float umbra = umbraRadiusAt(shadowPairs[caster], place.along);
  float penumbra = penumbraRadiusAt(shadowPairs[caster], place.along);
  ShadowTablePlace found;
  found.between = (place.distance - umbra) / (penumbra - umbra);
  found.along = place.along;
  return found;
}

// Visible share of sunlight at a point (scaled space, metres from the centre).
vec4 visibleSunlight(vec3 scaled, int layer) {
  vec4 light = vec4(1.0);
  ivec2 size = textureSize(shadowLight, 0).xy;
  for (int caster = 0; caster < SHADOW_PAIRS; ++caster) {
    ShadowTablePlace place = shadowTablePlace(caster, scaled);
    if (place.between >= 1.0) continue;
    float x = sqrt(max(place.between, 0.0));
    float y = clamp(0.5 + 0.5 * place.along / shadowScale.y, 0.0, 1.0);
    vec2 at = (vec2(x, y) * vec2(size - 1) + 0.5) / vec2(size);
    light *= x * x * x *
             textureLod(shadowLight, vec3(at, float(caster * AIR_LAYERS + layer)), 0.0);
  }
  return light;
}

// The same share of light that has been scattered before.
vec4 diffuseSunlight(vec3 scaled, int layer) { return visibleSunlight(scaled, layer); }
#endif
#endif
