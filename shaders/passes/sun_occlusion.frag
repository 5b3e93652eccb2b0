// The Sun's disc in the small target: brightness relative to the disc's mean in red, green, blue and
// luminance. The depth test takes away what is hidden.
#include "passes/sun_plane.glsl"
#include "passes/sun_window.glsl"

out vec4 brightness;

void main() {
  vec2 p = windowPoint(gl_FragCoord.xy);
  if (dot(p, p) > 1.0) discard;
  brightness = photosphereAt(sunLaw(), p);
}
