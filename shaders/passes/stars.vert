// One quad of 4x4 pixels around each point source; a second round draws copies of those that reach across
// the date line of an equirectangular picture.
#include "interface/view.glsl"

layout(location = 0) in vec3 starDirection;    // unit vector, camera axes
layout(location = 1) in vec3 starIlluminance;  // lux in linear sRGB, facing the source

uniform vec2 targetSize;  // pixels
uniform float copySide;   // 0, or 1 for the copies

flat out vec2 starPixel;  // in the whole picture
flat out vec3 starLight;

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 4.0 - 2.0;
  vec3 pixel = viewPixelOf(starDirection);
  bool drawn = pixel.z > 0.0;
  if (copySide > 0.0) {
    // Only what reaches over the left or right edge has a copy.
    drawn = drawn && (pixel.x < 2.0 || pixel.x > viewImageSize.x - 2.0);
    pixel.x += pixel.x < 2.0 ? viewImageSize.x : -viewImageSize.x;
  }
  starPixel = pixel.xy;
  starLight = starIlluminance;
  vec2 onTarget = (pixel.xy + corner - viewTileOrigin) / targetSize;
  gl_Position = drawn ? vec4(onTarget * 2.0 - 1.0, 0.5, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
