// Light that has been scattered before, inside the shadows on a body with air: for each caster a
// grid fixed to the shadow's axis, computed by passes/eclipsed_source.cpp.
//   x  distance from the axis: even steps in the umbra, then as the hyperbolic sine from its edge
//   y  azimuth about it over half a turn from `across` (the other half mirrors it)
//   z  square root of height; for each quantity and spectral layer:
//   0   mean radiance over its value without the eclipse, binary logarithm
//   1   irradiance of the horizontal over its value without the eclipse, binary logarithm
//   2-9 harmonics over the mean radiance: z, x, y, (3 z^2 - 1)/2, x z, x^2 - y^2, y z, x y, with z
//       up and x the horizontal part of `forward`
// Several casters: what they leave together is in interface/eclipsed_union.glsl.
#ifndef INTERFACE_ECLIPSED_AIR_GLSL
#define INTERFACE_ECLIPSED_AIR_GLSL
#include "interface/air.glsl"
#include "interface/shadows.glsl"

#define ECLIPSED_QUANTITIES 10
struct EclipsedAxis {
  vec4 across;   // unit vector across the axis from the body's centre; w: umbra's radius on the ground
  vec4 side;     // axis x across; w: outermost distance, m
  vec4 forward;  // scaled space: unit vector, horizontal at the axis, in the plane of Sun and axis
};
layout(std140, binding = 9) uniform EclipsedSource {
  EclipsedAxis eclipsedAxes[ECLIPSED_SOURCE];
  vec4 eclipsedShape;  // x: scale of distances, m; y: heights; z: share of x inside the umbra
};
layout(binding = 10) uniform sampler3D eclipsedSource;

struct EclipsedPlace {
  vec3 at;       // in [0, 1]
  float side;    // -1 on the mirrored half
  float inside;  // 1 within the grid, falling to 0 at its edge
};

float inverseSinh(float x) { return log(x + sqrt(x * x + 1.0)); }

// The distance from the axis at a place x of the grid, 0 to 1.
float eclipsedDistance(EclipsedAxis axis, float x) {
  float scale = eclipsedShape.x, edge = eclipsedShape.z, umbra = max(axis.across.w, 0.0);
  if (x <= edge) return umbra * x / edge;
  return umbra + scale * sinh((x - edge) / (1.0 - edge) *
                              inverseSinh((axis.side.w - umbra) / scale));
}

EclipsedPlace eclipsedPlace(int caster, vec3 scaled, float height) {
  EclipsedAxis axis = eclipsedAxes[caster];
  ShadowPlace place = placeInShadow(shadowPairs[caster], scaled * vec3(1.0, 1.0, shadowScale.x));
  float umbra = max(axis.across.w, 0.0);
  float beyond = place.distance - umbra;
  float scale = eclipsedShape.x, edge = eclipsedShape.z;
  float x = beyond < 0.0 ? edge * place.distance / umbra
                         : edge + (1.0 - edge) * inverseSinh(beyond / scale) /
                                      inverseSinh((axis.side.w - umbra) / scale);
  float sideways = dot(place.away, axis.side.xyz);
  EclipsedPlace found;
  found.at = vec3(min(x, 1.0), atan(abs(sideways), dot(place.away, axis.across.xyz)) / kPi,
                  sqrt(clamp(height / airShape.y, 0.0, 1.0)));
  found.side = sideways < 0.0 ? -1.0 : 1.0;
  found.inside = 1.0 - smoothstep(0.9, 1.0, place.distance / axis.side.w);
  return found;
}

vec4 eclipsedQuantity(int caster, EclipsedPlace place, int quantity, int layer) {
  float heights = eclipsedShape.y;
  vec3 size = vec3(textureSize(eclipsedSource, 0));
  float slab = float((caster * ECLIPSED_QUANTITIES + quantity) * AIR_LAYERS + layer) * heights;
  return textureLod(eclipsedSource,
                    vec3((place.at.xy * (size.xy - 1.0) + 0.5) / size.xy,
                         (slab + 0.5 + place.at.z * (heights - 1.0)) / size.z), 0.0);
}

#if ECLIPSED_SOURCE > 1
#include "interface/eclipsed_union.glsl"
#endif

// What is left of the mean radiance (quantity 0) or of the sky's irradiance (1).
vec4 eclipsedShare(vec3 scaled, float height, int quantity, int layer) {
#if ECLIPSED_SOURCE > 1
  return exp2(eclipsedTogether(scaled, height, quantity, layer).power);
#else
  EclipsedPlace place = eclipsedPlace(0, scaled, height);
  return exp2(place.inside * eclipsedQuantity(0, place, quantity, layer));
#endif
}

// The parts of degree 1 and 2 of the light toward a direction, over the mean.
struct EclipsedHarmonics {
  vec4 first;
  vec4 second;
};

EclipsedHarmonics eclipsedHarmonics(int caster, EclipsedPlace place, vec3 scaled, vec3 direction,
                                    int layer) {
  vec3 up = normalize(scaled);
  float z = dot(direction, up);
  vec3 forward = eclipsedAxes[caster].forward.xyz;
  vec3 level = forward - up * dot(up, forward);
  level *= inversesqrt(max(dot(level, level), 1e-12));
  float x = dot(direction, level);
  float y = place.side * dot(direction, cross(up, level));
  EclipsedHarmonics found;
  found.first = z * eclipsedQuantity(caster, place, 2, layer) +
                x * eclipsedQuantity(caster, place, 3, layer) +
                y * eclipsedQuantity(caster, place, 4, layer);
  found.second = (1.5 * z * z - 0.5) * eclipsedQuantity(caster, place, 5, layer) +
                 x * z * eclipsedQuantity(caster, place, 6, layer) +
                 (x * x - y * y) * eclipsedQuantity(caster, place, 7, layer) +
                 y * z * eclipsedQuantity(caster, place, 8, layer) +
                 x * y * eclipsedQuantity(caster, place, 9, layer);
  return found;
}
#endif
