// Light that has been scattered before, inside the shadows on a body with air: for each caster a
// grid fixed to the shadow's axis, computed by passes/eclipsed_source.cpp.
//   x  distance from the axis: even steps in the umbra, then as the hyperbolic sine from its edge
//   y  azimuth about it over half a turn from `across` (the other half mirrors it)
//      in blocks: of the azimuths of directions from the horizontal part of `forward`
//   z  level of height; for each spectral layer of
//   slab 0     block 0: mean radiance over its value without the eclipse, binary logarithm
//              block 1: likewise the irradiance of the horizontal
//   slab 1...  for each rise of directions: light scattered toward them over that without the
//              eclipse, binary logarithm
// Several casters: what they leave together is in interface/eclipsed_union.glsl.
#ifndef INTERFACE_ECLIPSED_AIR_GLSL
#define INTERFACE_ECLIPSED_AIR_GLSL
#include "interface/air.glsl"
#include "interface/shadows.glsl"

#define ECLIPSED_RISES 11  // of directions: z = s / (2 - |s|), s in even steps from -1 to 1
#define ECLIPSED_SLABS (ECLIPSED_RISES + 1)
struct EclipsedAxis {
  vec4 across;   // unit vector across the axis from the body's centre; w: umbra's radius on the ground
  vec4 side;     // axis x across; w: outermost distance, m
  vec4 forward;  // scaled space: unit vector, horizontal at the axis, in the plane of Sun and axis
};
layout(std140, binding = 9) uniform EclipsedSource {
  EclipsedAxis eclipsedAxes[ECLIPSED_SOURCE];
  vec4 eclipsedShape;  // x: scale of distances, m; y: heights; z: share of x inside the umbra; w: azimuths
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
                  sourceLevel(rootHeight(airShell(), height)));
  found.side = sideways < 0.0 ? -1.0 : 1.0;
  found.inside = 1.0 - smoothstep(0.9, 1.0, place.distance / axis.side.w);
  return found;
}

float eclipsedRise(int index) {
  float s = 2.0 * float(index) / float(ECLIPSED_RISES - 1) - 1.0;
  return s / (2.0 - abs(s));
}

// A value of the grid; `block` and `slab` are whole.
vec4 eclipsedValue(int caster, EclipsedPlace place, float block, float slab, int layer) {
  float heights = eclipsedShape.y, azimuths = eclipsedShape.w;
  vec3 size = vec3(textureSize(eclipsedSource, 0));
  float first = ((float(caster * ECLIPSED_SLABS) + slab) * float(AIR_LAYERS) + float(layer)) * heights;
  return textureLod(eclipsedSource,
                    vec3(place.at.x * (size.x - 1.0) + 0.5, block * azimuths + place.at.y * (azimuths - 1.0) + 0.5,
                         first + 0.5 + place.at.z * (heights - 1.0)) / size, 0.0);
}

// Mean radiance (quantity 0) or irradiance (1).
vec4 eclipsedQuantity(int caster, EclipsedPlace place, int quantity, int layer) {
  return eclipsedValue(caster, place, float(quantity), 0.0, layer);
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

#ifdef ECLIPSED_TURNS
// Of light scattered toward a direction, binary logarithm.
vec4 eclipsedPowerToward(int caster, EclipsedPlace place, vec3 up, vec3 direction, int layer) {
  float z = dot(direction, up);
  float rise = (z / (1.0 + abs(z)) + 0.5) * float(ECLIPSED_RISES - 1);
  float low = min(floor(rise), float(ECLIPSED_RISES - 2));
  vec3 forward = eclipsedAxes[caster].forward.xyz;
  vec3 level = forward - up * dot(up, forward);
  vec2 flat_ = vec2(dot(direction, level), place.side * dot(direction, cross(up, level)));
  // Toward the vertical the azimuth is any.
  flat_.x += flat_.x < 0.0 ? -1e-9 : 1e-9;
  float turn = (atan(flat_.y, flat_.x) / (2.0 * kPi) + 1.0) * float(ECLIPSED_TURNS);
  float whole = floor(turn), block = mod(whole, float(ECLIPSED_TURNS));
  float next = block + 1.0 < float(ECLIPSED_TURNS) ? block + 1.0 : 0.0;
  vec4 lower = mix(eclipsedValue(caster, place, block, low + 1.0, layer),
                   eclipsedValue(caster, place, next, low + 1.0, layer), turn - whole);
  vec4 upper = mix(eclipsedValue(caster, place, block, low + 2.0, layer),
                   eclipsedValue(caster, place, next, low + 2.0, layer), turn - whole);
  return mix(lower, upper, rise - low);
}

// What is left of light scattered toward a direction. Of several casters each has its part in how
// that differs from the mean.
vec4 eclipsedShareToward(vec3 scaled, float height, vec3 direction, int layer) {
  vec3 up = normalize(scaled);
#if ECLIPSED_SOURCE > 1
  EclipsedTogether together = eclipsedTogether(scaled, height, 0, layer);
  vec4 power = together.power;
  for (int caster = 0; caster < ECLIPSED_SOURCE; ++caster) {
    EclipsedPlace place = eclipsedPlace(caster, scaled, height);
    power += place.inside * together.part[caster] *
             (eclipsedPowerToward(caster, place, up, direction, layer) - eclipsedQuantity(caster, place, 0, layer));
  }
  return exp2(power);
#else
  EclipsedPlace place = eclipsedPlace(0, scaled, height);
  return exp2(place.inside * eclipsedPowerToward(0, place, up, direction, layer));
#endif
}
#endif
#endif
