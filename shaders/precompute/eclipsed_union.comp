// The map of interface/eclipsed_union.glsl: around each place, visible sunlight past all casters over
// that past one of them, averaged over rings on the ground.
//
// Radii of the rings over the distance of the horizon from the top of the air, and weights: where
// light in the Moon's shadow on the Earth comes from, fitted to the path tracer's irradiance from the
// axis out to the penumbra's edge (half from within 20 km, 1 % from beyond 200 km, where the umbra's
// centre gets all of its light).
#include "interface/eclipsed_air.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba16f, binding = 0) writeonly uniform image2DArray map;

const int kRings = 6;
const float kRadii[kRings] = float[](0.0, 0.05, 0.1, 0.23, 0.34, 0.65);
const float kWeights[kRings] = float[](0.6, 0.327, 0.06, 0.003, 0.009, 0.001);
const int kPoints[kRings] = int[](1, 6, 6, 8, 12, 12);

vec4 past(int caster, vec3 scaled, int layer) {
  ShadowPair pair = shadowPairs[caster];
  ShadowTablePlace place =
      shadowTablePlace(pair, placeInShadow(pair, scaled * vec3(1.0, 1.0, shadowScale.x)));
  if (place.outer >= 1.0 || pair.casterBehind + place.along < -pair.casterRadius) return vec4(1.0);
  if (place.umbra > 0.0 && place.outer <= 0.0) return vec4(0.0);
  return sunlightPast(caster, place, layer);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(map);
  if (texel.x >= size.x || texel.y >= size.y) return;
  int caster = texel.z / AIR_LAYERS, layer = texel.z - caster * AIR_LAYERS;
  ShadowPair pair = shadowPairs[caster];
  EclipsedAxis own = eclipsedAxes[caster];
  float distance = eclipsedDistance(own, float(texel.x) / float(size.x - 1));
  float azimuth = kPi * (2.0 * float(texel.y) / float(size.y - 1) - 1.0);
  vec3 squeeze = vec3(1.0, 1.0, 1.0 / shadowScale.x);
  vec3 axis = normalize(pair.axis * squeeze);
  vec3 from = squeeze *
              (pair.foot + distance * (cos(azimuth) * own.across.xyz + sin(azimuth) * own.side.xyz));
  from -= axis * dot(from, axis);
  float radius = airShape.x;
  vec3 up = normalize(from - axis * sqrt(max(radius * radius - dot(from, from), 0.0)));
  vec3 east = normalize(cross(up, abs(up.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  vec3 north = cross(up, east);
  float reach = sqrt(2.0 * radius * airShape.y);
  vec4 all = vec4(0.0), alone = vec4(0.0);
  for (int ring = 0; ring < kRings; ++ring)
    for (int i = 0; i < kPoints[ring]; ++i) {
      float turn = 2.0 * kPi * (float(i) + 0.5) / float(kPoints[ring]);
      vec3 there = radius * normalize(radius * up + kRadii[ring] * reach *
                                                        (cos(turn) * east + sin(turn) * north));
      float weight = kWeights[ring] / float(kPoints[ring]);
      all += weight * visibleSunlight(there, layer);
      alone += weight * past(caster, there, layer);
    }
  const vec4 least = vec4(1e-9);
  imageStore(map, texel, min(log2(max(all, least) / max(alone, least)), vec4(0.0)));
}
