// A point source's luminance in a pixel: its illuminance, spread over 4x4 pixels, per solid angle.
#include "interface/pixel_solid_angle.glsl"
#include "shared/point_spread.glsl"

flat in vec2 starPixel;
flat in vec3 starLight;

out vec4 luminance;  // cd/m^2 in linear sRGB, added

void main() {
  ViewRay ray = viewRayOf(gl_FragCoord.xy);
  vec2 offset = gl_FragCoord.xy + viewTileOrigin - starPixel;
  float share = pointSpread(offset.x) * pointSpread(offset.y) * ray.inside;
  luminance = vec4(starLight * (share / pixelSolidAngleOf(gl_FragCoord.xy, ray.direction)), 0.0);
}
