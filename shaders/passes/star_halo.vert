// A square around each bright point source, as far as its halo in the eye is worth drawing.
#include "interface/pixel_solid_angle.glsl"

layout(location = 0) in vec3 starDirection;    // unit vector, camera axes
layout(location = 1) in vec3 starIlluminance;  // lux in linear sRGB, facing the source

uniform vec2 targetSize;  // pixels
uniform float magnification;
uniform float faintest;  // cd/m^2 where the halo ends

flat out vec2 starPixel;
flat out vec3 starLight;
flat out vec3 starPlace;
flat out float haloPixels;

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  vec3 pixel = viewPixelOf(starDirection);
  starPixel = pixel.xy;
  starLight = starIlluminance;
  starPlace = starDirection;
  // Beyond half a degree the function falls as 13.6 / (degrees)^3: where it reaches `faintest`.
  float lux = dot(starIlluminance, vec3(0.2126, 0.7152, 0.0722));
  float reach = radians(pow(13.6 * lux / (faintest * magnification), 1.0 / 3.0));
  vec2 fragCoord = pixel.xy - viewTileOrigin;
  float solidAngle = pixelSolidAngleOf(fragCoord, viewRayOf(fragCoord).direction);
  haloPixels = clamp(reach * inversesqrt(solidAngle), 1.0, 2048.0);
  vec2 onTarget = (pixel.xy + corner * haloPixels - viewTileOrigin) / targetSize;
  gl_Position = pixel.z > 0.0 ? vec4(onTarget * 2.0 - 1.0, 0.5, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
