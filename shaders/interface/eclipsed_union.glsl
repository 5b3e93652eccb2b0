// What several casters leave of scattered light together (passes/eclipsed_union.h). Included by
// interface/eclipsed_air.glsl where there are several.
//
// The map: x as in the grid; y the azimuth over a whole turn; by caster and spectral layer the binary
// logarithm of the light let through by all over that let through by the caster, near the place.
layout(binding = 14) uniform sampler2DArray eclipsedUnion;

struct EclipsedTogether {
  vec4 power;                  // binary logarithm of the share
  vec4 part[ECLIPSED_SOURCE];  // weights of the casters, summing to 1
};

EclipsedTogether eclipsedTogether(vec3 scaled, float height, int quantity, int layer) {
  EclipsedTogether found;
  vec4 sum = vec4(0.0);
  found.power = vec4(0.0);
  vec2 size = vec2(textureSize(eclipsedUnion, 0).xy);
  for (int caster = 0; caster < ECLIPSED_SOURCE; ++caster) {
    EclipsedPlace place = eclipsedPlace(caster, scaled, height);
    vec4 own = place.inside * eclipsedQuantity(caster, place, quantity, layer);
    vec2 at = vec2(place.at.x, 0.5 + 0.5 * place.side * place.at.y) * (size - 1.0) + 0.5;
    vec4 others = place.inside * textureLod(eclipsedUnion,
                                            vec3(at / size, float(caster * AIR_LAYERS + layer)), 0.0);
    // The darker a caster's own shadow, the more its grid knows of the place; at the edge nothing.
    vec4 weight = place.inside * max(exp2(-2.0 * own) - exp2(-own), vec4(0.0)) + vec4(1e-6);
    found.part[caster] = weight;
    found.power += weight * (own + others);
    sum += weight;
  }
  found.power /= sum;
  for (int caster = 0; caster < ECLIPSED_SOURCE; ++caster) found.part[caster] /= sum;
  return found;
}
