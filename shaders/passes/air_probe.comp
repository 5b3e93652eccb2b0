// Radiance in a list of directions, by the functions that draw pictures.
#define AIR_FEW_HARMONICS
#include "interface/air_march.glsl"
#ifdef AIR_SKY
#include "interface/air_sky.glsl"
#endif
#include "shared/surface.glsl"
layout(local_size_x = 32) in;
struct Probe {
  vec4 ray;        // height, rise, sunRise, sunAlong
  vec4 start;      // w: groundRoot
  vec4 direction;
};
layout(std430, binding = 0) readonly buffer Probes { Probe probes[]; };
layout(std430, binding = 1) writeonly buffer Radiances { vec4 radiances[]; };

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= probes.length()) return;
  Probe probe = probes[index];
  AirRay ray;
  ray.height = probe.ray.x;
  ray.rise = probe.ray.y;
  ray.sunRise = probe.ray.z;
  ray.sunAlong = probe.ray.w;
  ray.groundRoot = probe.start.w;
  ray.start = probe.start.xyz;
  ray.direction = probe.direction.xyz;
  AirWay way = wayOf(ray);
  WayEnds ends = endsOf(ray, way);
#ifdef AIR_SKY
  vec2 place = skyPlace(ray.direction, way.hitsGround);
  float blur = blurOnSky(place);
#else
  AirLight light = lightAlong(ray, way, ends, shadowCuts(ray));
#endif
  float sunCosine = clamp(way.legs[0].lowSunRise / airShape.x, -1.0, 1.0);
  vec2 ground = sourcePlaceOf(0.0, sunCosine);
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
#ifdef AIR_SKY
    vec4 sum = skyLight(place, layer, ray.sunAlong, blur);
#else
    vec4 sum = light.joint[layer];
#endif
    if (way.hitsGround) {
#ifdef AIR_BENT
      vec4 direct = bentSunOnGround(sunCosine, layer);
#else
      vec4 direct = sunOnHorizontal(sunCosine, airShape.w) * exp(-sunDepthAt(depthPlace(0.0, max(sunCosine, 0.0)), layer));
#endif
      vec4 diffuse = sourceIrradiance(ground, layer);
#ifdef SHADOW_PAIRS
      vec3 where = ray.start + ray.direction * way.length;
      direct *= visibleSunlight(where, layer);
      diffuse *= eclipsedShare(where, 0.0, 1, layer);
#endif
      sum += (direct + diffuse) * airGroundAlbedo[layer] / kPi * exp(-depthOfWay(ends, layer));
    }
    radiances[index * AIR_LAYERS + layer] = sum;
  }
}
