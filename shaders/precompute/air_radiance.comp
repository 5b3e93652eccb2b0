// Radiance that reaches a point of the air from each of a set of directions: of sunlight scattered or
// reflected once (AIR_SINGLE), or of the light of the previous order scattered once more (AIR_SOURCE).
// Invocation (x, y): Sun's zenith angle and height; z: direction. Stored by spectral layer, then direction.
#define AIR_BY_MOMENTS
#ifndef AIR_NORMALISED
#define AIR_NORMALISED
#endif
#include "interface/air_march.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) writeonly uniform image2DArray radiances;
#include "interface/air_directions.glsl"

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(radiances);
  if (texel.x >= size.x || texel.y >= size.y) return;
  AirShell shell = airShell();
  HeightAndCosine at = sourceCell(texel.xy, size.xy);
  AirDirection look = airDirection(texel.z, horizonCosine(shell, at.height));
  float r = shell.radius + at.height;
  AirRay ray;
  ray.height = at.height;
  ray.rise = r * look.cosine;
  ray.sunRise = r * at.cosine;
  float sunSine = sqrt(max(1.0 - at.cosine * at.cosine, 0.0));
  ray.sunAlong = clamp(look.cosine * at.cosine + look.sine * cos(look.azimuth) * sunSine, -1.0, 1.0);
  ray.groundRoot = ray.rise * ray.rise - squareAboveGround(shell, at.height);
  // The quadrature decides what lies below the horizon.
  if (look.down) ray.groundRoot = max(ray.groundRoot, 1e-3); else ray.groundRoot = min(ray.groundRoot, 0.0);
  ray.start = vec3(0.0, 0.0, r);
  ray.direction = vec3(look.sine, 0.0, look.cosine);
  AirWay way = wayOf(ray);
  WayEnds ends = endsOf(ray, way);
  AirLight light = lightAlong(ray, way, ends, noCuts());
  float sunCosine = clamp(way.legs[0].lowSunRise / shell.radius, -1.0, 1.0);
  vec2 ground = sourcePlaceOf(0.0, sunCosine);
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 sum = light.joint[layer];
    if (way.hitsGround) {
#ifdef AIR_SINGLE
      vec4 irradiance = sunOnGround(sunCosine, layer);
#else
      vec4 irradiance = sourceIrradiance(ground, layer);
#endif
      sum += irradiance * airGroundAlbedo[layer] / kPi * exp(-depthOfWay(ends, layer));
    }
    imageStore(radiances, ivec3(texel.xy, layer * directionCount.x * directionCount.y + texel.z), sum);
  }
}
