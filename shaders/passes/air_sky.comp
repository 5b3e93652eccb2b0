// Fills the sky table of a camera low in the air. AIR_SKY_FORMAT: of its images.
#include "interface/air_march.glsl"
#include "interface/air_sky.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(AIR_SKY_FORMAT, binding = 0) writeonly uniform image2DArray joint;
layout(AIR_SKY_FORMAT, binding = 1) writeonly uniform image2DArray peaked;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(joint).xy;
  if (texel.x >= size.x || texel.y >= size.y) return;
  AirShell shell = airShell();
  vec2 angles = skyAngles(texel, size);
  bool down = texel.y < size.y / 2;
  float z = sin(angles.x), level = cos(angles.x);
  float height = skyUp.w, r = shell.radius + height;
  float sunCosine = skySunward.w, sunSine = sqrt(max(1.0 - sunCosine * sunCosine, 0.0));
  AirRay ray;
  ray.height = height;
  ray.rise = r * z;
  ray.sunRise = r * sunCosine;
  ray.sunAlong = clamp(z * sunCosine + level * cos(angles.y) * sunSine, -1.0, 1.0);
  ray.groundRoot = ray.rise * ray.rise - squareAboveGround(shell, height);
  ray.groundRoot = down ? max(ray.groundRoot, 0.0) : min(ray.groundRoot, 0.0);
  if (down) ray.rise = min(ray.rise, -1e-3);
  ray.start = skyUp.xyz * r;
  ray.direction = skyUp.xyz * z + (skySunward.xyz * cos(angles.y) + skySide.xyz * sin(angles.y)) * level;
  AirWay way = wayOf(ray);
  if (down) way.hitsGround = true;
  WayEnds ends = endsOf(ray, way);
  AirLight light = marchAlong(ray, way, ends, shadowCuts(ray));
  const vec4 most = vec4(6.0e4);  // of a half float
  for (int layer = 0; layer < AIR_LAYERS; ++layer) {
    imageStore(joint, ivec3(texel, layer), min(light.joint[layer] * skyDip.y, most));
    for (int c = 0; c < AIR_PEAKED; ++c)
      imageStore(peaked, ivec3(texel, layer * AIR_PEAKED + c),
                 min(light.peaked[layer * AIR_PEAKED + c] * skyDip.y, most));
  }
#ifdef AIR_BLURRED
  imageStore(peaked, ivec3(texel, AIR_LAYERS * AIR_PEAKED), vec4(blurOf(light)));
#endif
}
