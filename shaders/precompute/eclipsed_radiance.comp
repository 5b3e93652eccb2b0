// Radiance that reaches each cell about a shadow's axis from a set of directions.
//   AIR_SINGLE, with or without UNECLIPSED: sunlight scattered or reflected once
//   AIR_SOURCE: the light held by the grid (or, UNECLIPSED, by the air's own table), once more
#include "interface/air_march.glsl"
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
layout(rgba32f, binding = 0) writeonly uniform image2DArray radiances;  // y: azimuth, then height
#include "interface/air_directions.glsl"

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= cellCount.x || texel.y >= cellCount.y * cellCount.z) return;
  AirShell shell = airShell();
  EclipsedCell cell = eclipsedCell(ivec3(texel.x, texel.y % cellCount.y, texel.y / cellCount.y));
  AirDirection look = airDirection(texel.z, horizonCosine(shell, cell.height));
  float r = shell.radius + cell.height;
  AirRay ray;
  ray.height = cell.height;
  ray.rise = r * look.cosine;
  ray.sunRise = r * cell.sunCosine;
  ray.start = cell.position;
  ray.direction = cell.up * look.cosine +
                  (cell.sunward * cos(look.azimuth) + cell.side * sin(look.azimuth)) * look.sine;
  ray.sunAlong = clamp(dot(ray.direction, eclipsedSun.xyz), -1.0, 1.0);
  ray.groundRoot = ray.rise * ray.rise - squareAboveGround(shell, cell.height);
  if (look.down) ray.groundRoot = max(ray.groundRoot, 1e-3); else ray.groundRoot = min(ray.groundRoot, 0.0);
  AirWay way = wayOf(ray);
  WayEnds ends = endsOf(ray, way);
  AirCuts cuts = shadowCuts(ray);
  cuts.at[0] = cuts.at[1] = -1.0;
  AirLight light = lightAlong(ray, way, ends, cuts);
  float sunCosine = clamp(way.legs[0].lowSunRise / shell.radius, -1.0, 1.0);
  vec2 ground = sourcePlaceOf(0.0, sunCosine);
  vec3 where = ray.start + ray.direction * way.length;
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    vec4 sum = light.joint[layer];
    if (way.hitsGround) {
      vec4 irradiance = vec4(0.0);
#ifdef AIR_SINGLE
      irradiance += max(sunCosine, 0.0) * exp(-depthAt(depthPlace(0.0, sunCosine), layer))
#ifndef UNECLIPSED
          * visibleSunlight(where, layer)
#endif
          ;
#endif
#ifdef AIR_SOURCE
      irradiance += textureLod(airSource, vec3(ground, float(layer * 7 + 6)), 0.0)
#ifndef UNECLIPSED
          * eclipsedShare(eclipsedPlace(where, 0.0), 1, layer)
#endif
          ;
#endif
      sum += irradiance * airGroundAlbedo[layer] / kPi * exp(-depthOfWay(ends, layer));
    }
    imageStore(radiances, ivec3(texel.xy, layer * directionCount.x * directionCount.y + texel.z), sum);
  }
}
