// One cell of the exposure meter: the mean of log2 luminance over up to 8x8 pixels of the cell, spread
// evenly, each weighted by its solid angle; pixels of a fisheye's mask have none.
#include "interface/pixel_solid_angle.glsl"

layout(binding = 0) uniform sampler2D image;  // linear sRGB, cd/m^2
uniform ivec2 cells;

out vec2 metered;  // mean log2(cd/m^2), solid angle in sr

void main() {
  ivec2 size = textureSize(image, 0);
  ivec2 cell = ivec2(gl_FragCoord.xy);
  ivec2 first = cell * size / cells;
  ivec2 beyond = max((cell + 1) * size / cells, first + 1);
  ivec2 taps = min(beyond - first, ivec2(kTaps));
  float sum = 0.0, weight = 0.0;
  for (int y = 0; y < taps.y; ++y)
    for (int x = 0; x < taps.x; ++x) {
      ivec2 at = first + (2 * ivec2(x, y) + 1) * (beyond - first) / (2 * taps);
      ViewRay ray = viewRayOf(vec2(at) + 0.5);
      if (ray.inside == 0.0) continue;
      float luminance = dot(texelFetch(image, at, 0).rgb, vec3(0.2126, 0.7152, 0.0722));
      float solidAngle = pixelSolidAngleOf(vec2(at) + 0.5, ray.direction);
      // NaN-proof: a comparison with NaN is false.
      float safe = luminance > kDarkest ? min(luminance, 1.0e12) : kDarkest;
      sum += log2(safe) * solidAngle;
      weight += solidAngle;
    }
  metered = vec2(weight > 0.0 ? sum / weight : 0.0, weight);
}
