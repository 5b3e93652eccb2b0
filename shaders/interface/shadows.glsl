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

#ifdef ECLIPSED_SOURCE
// Light that has been scattered before, inside the first caster's shadow: on a grid fixed to the
// shadow's axis, x: distance from it, y: azimuth about it over half a turn (the other half mirrors
// it), z: height; for each quantity and spectral layer. Computed by eclipsed_source.cpp.
//   0   mean radiance over its value without the eclipse
//   1   irradiance of the horizontal over its value without the eclipse
//   2-9 harmonics over the mean radiance: z, x, y, (3 z^2 - 1)/2, x z, x^2 - y^2, y z, x y
#define ECLIPSED_QUANTITIES 10
layout(std140, binding = 9) uniform EclipsedSource {
  vec4 eclipsedAcross;  // unit vector across the axis from the body's centre; w: scale of x, m
  vec4 eclipsedSide;    // axis x across; w: outermost distance, m
  vec4 eclipsedSun;     // scaled space: unit vector to the Sun; w: heights of the grid
};
layout(binding = 10) uniform sampler3D eclipsedSource;

struct EclipsedPlace {
  vec3 at;       // x, y as texture coordinates; z in [0, 1]
  float side;    // -1 on the mirrored half
  float inside;  // 1 within the grid, falling to 0 at its edge
};

float inverseSinh(float x) { return log(x + sqrt(x * x + 1.0)); }

EclipsedPlace eclipsedPlace(vec3 scaled, float height) {
  ShadowPlace place = placeInShadow(shadowPairs[0], scaled * vec3(1.0, 1.0, shadowScale.x));
  float x = inverseSinh(place.distance / eclipsedAcross.w) /
            inverseSinh(eclipsedSide.w / eclipsedAcross.w);
  float sideways = dot(place.away, eclipsedSide.xyz);
  float y = atan(abs(sideways), dot(place.away, eclipsedAcross.xyz)) / kPi;
  ivec3 size = textureSize(eclipsedSource, 0);
  EclipsedPlace found;
  found.at = vec3((vec2(min(x, 1.0), y) * vec2(size.xy - 1) + 0.5) / vec2(size.xy),
                  sqrt(clamp(height / airShape.y, 0.0, 1.0)));
  found.side = sideways < 0.0 ? -1.0 : 1.0;
  found.inside = 1.0 - smoothstep(0.9, 1.0, place.distance / eclipsedSide.w);
  return found;
}

vec4 eclipsedQuantity(EclipsedPlace place, int quantity, int layer) {
  float heights = eclipsedSun.w;
  float z = (float(quantity * AIR_LAYERS + layer) * heights + 0.5 + place.at.z * (heights - 1.0)) /
            float(textureSize(eclipsedSource, 0).z);
  return textureLod(eclipsedSource, vec3(place.at.xy, z), 0.0);
}

// What is left of the mean radiance (quantity 0) or of the sky's irradiance (1).
vec4 eclipsedShare(EclipsedPlace place, int quantity, int layer) {
  vec4 share = mix(vec4(1.0), eclipsedQuantity(place, quantity, layer), place.inside);
  return share;
}
#endif
#endif
#endif
