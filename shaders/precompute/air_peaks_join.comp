// Depths toward the Sun of the rest, from the true ones and the light that forward peaks have turned.
#include "interface/air.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform image2DArray depths;
void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec2 size = imageSize(depths).xy;
  if (texel.x >= size.x || texel.y >= size.y) return;
  vec4 straight = imageLoad(depths, ivec3(texel.xy, sunLayer(trueLayer(texel.z))));
  vec2 place = onTexels(vec2(texel.xy) / vec2(size - 1), texelsOf(textureSize(airSource, 0).xy));
  vec4 turned = textureLod(airSource, vec3(place, float(texel.z)), 0.0);
  vec4 least = min(straight, turned);
  vec4 both = least - log(exp(least - straight) + exp(least - turned));
  imageStore(depths, ivec3(texel.xy, sunLayer(texel.z)), both);
}
