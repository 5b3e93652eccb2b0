// Radiance that reaches each cell about a shadow's axis from a set of directions.
//   AIR_SINGLE: sunlight scattered or reflected once
//   AIR_VOLUME: the light held by the cells, scattered or reflected once more
//   UNECLIPSED, AIR_SINGLE, AIR_SOURCE: all light without the eclipse, for cells of their own
#define AIR_BY_MOMENTS
#include "interface/air_march.glsl"
#ifndef UNECLIPSED
#include "interface/eclipsed_air.glsl"
#endif
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) writeonly uniform image2DArray radiances;  // y: azimuth, then height
uniform int firstDirection;
#include "interface/air_directions.glsl"

#ifdef AIR_VOLUME
// Of eclipsed_volume.comp: by direction from firstDirection on, layer and height.
layout(binding = 13) uniform sampler3D volume;
layout(binding = 11) uniform sampler2DArray uneclipsed;
layout(binding = 12) uniform sampler2DArray held;
#include "interface/uneclipsed_light.glsl"
// Along a ray the direction keeps its number though the vertical turns by up to a few degrees.
int direction, mirrored;

VolumePlace volumePlace(vec3 where, float height) {
  EclipsedPlace found = eclipsedPlace(0, where, height);
  vec2 size = vec2(cellCount.xy);
  VolumePlace place;
  place.at = vec3((found.at.xy * (size - 1.0) + 0.5) / size, found.at.z);
  place.slab = float((found.side < 0.0 ? mirrored : direction) - firstDirection);
  // A cell stands for its whole line along the axis, on the night side too: it gives the share.
  place.uneclipsed = uneclipsedPlace(where.z * inversesqrt(dot(where, where)),
                                     found.at.z * float(cellCount.z - 1));
  return place;
}

vec4 volumeLight(VolumePlace place, int layer) {
  float heights = float(cellCount.z);
  float z = (place.slab * float(AIR_LAYERS) + float(layer)) * heights + 0.5 +
            place.at.z * (heights - 1.0);
  return exp2(textureLod(volume, vec3(place.at.xy, z / float(textureSize(volume, 0).z)), 0.0) +
              uneclipsedLight(place.uneclipsed, layer, 0));
}

// Irradiance of the ground by the light that the cells hold.
vec4 heldOnGround(vec3 where, int layer) {
  vec2 at = eclipsedPlace(0, where, 0.0).at.xy * vec2(cellCount.xy - 1);
  ivec2 low = min(ivec2(at), cellCount.xy - 2);
  vec2 share = at - vec2(low);
  int index = layer * 2 + 1;
  vec4 power = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 step_ = ivec2(i & 1, i >> 1);
    vec2 part = mix(1.0 - share, share, vec2(step_));
    vec4 irradiance = texelFetch(held, ivec3(low + step_, index), 0);
    power += part.x * part.y * log2(max(irradiance, vec4(1e-30)));
  }
  float sunCosine = where.z * inversesqrt(dot(where, where));
  vec4 here = uneclipsedLight(uneclipsedPlace(sunCosine, 0.0), layer, 1);
  vec4 sunlit = uneclipsedLight(uneclipsedPlace(abs(sunCosine), 0.0), layer, 1);
  return exp2(power + here - sunlit);
}
#endif

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= cellCount.x || texel.y >= cellCount.y * cellCount.z) return;
  int index = firstDirection + texel.z;
  AirShell shell = airShell();
  EclipsedCell cell = eclipsedCell(ivec3(texel.x, texel.y % cellCount.y, texel.y / cellCount.y));
  AirDirection look = airDirection(index, horizonCosine(shell, cell.height));
#ifdef AIR_VOLUME
  direction = index;
  int ring = index / directionCount.y;
  mirrored = (2 * ring + 1) * directionCount.y - 1 - index;
#endif
  float r = shell.radius + cell.height;
  AirRay ray;
  ray.height = cell.height;
  ray.rise = r * look.cosine;
  ray.sunRise = r * cell.sunCosine;
  ray.start = cell.position;
  ray.direction = cell.up * look.cosine +
                  (cell.forward * cos(look.azimuth) + cell.side * sin(look.azimuth)) * look.sine;
  ray.sunAlong = clamp(dot(ray.direction, cell.sun), -1.0, 1.0);
  ray.groundRoot = ray.rise * ray.rise - squareAboveGround(shell, cell.height);
  if (look.down) ray.groundRoot = max(ray.groundRoot, 1e-3); else ray.groundRoot = min(ray.groundRoot, 0.0);
  AirWay way = wayOf(ray);
  WayEnds ends = endsOf(ray, way);
#ifdef UNECLIPSED
  AirCuts cuts = noCuts();
#else
  AirCuts cuts = shadowCuts(ray);
  cuts.at[0] = cuts.at[1] = -1.0;
#endif
  AirLight light = lightAlong(ray, way, ends, cuts);
  float sunCosine = clamp(way.legs[0].lowSunRise / shell.radius, -1.0, 1.0);
#ifdef AIR_SOURCE
  vec2 ground = sourcePlaceOf(0.0, sunCosine);
#endif
  vec3 where = ray.start + ray.direction * way.length;
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 sum = light.joint[layer];
    if (way.hitsGround) {
      vec4 irradiance = vec4(0.0);
#ifdef AIR_SINGLE
      irradiance += sunOnGround(sunCosine, layer)
#ifndef UNECLIPSED
          * visibleSunlight(where, layer)
#endif
          ;
#endif
#ifdef AIR_SOURCE
      irradiance += sourceIrradiance(ground, layer);
#endif
#ifdef AIR_VOLUME
      irradiance += heldOnGround(where, layer);
#endif
      sum += irradiance * airGroundAlbedo[layer] / kPi * exp(-depthOfWay(ends, layer));
    }
    imageStore(radiances, ivec3(texel.xy, layer * directionCount.x * directionCount.y + index), sum);
  }
}
