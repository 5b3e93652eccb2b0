// Draws one body with its air: light toward the camera, and (second source of the blend) the
// transmittance of what lies behind it. Blend with GL_ONE, GL_SRC1_COLOR.
#include "interface/view.glsl"
#include "interface/body.glsl"
layout(location = 0, index = 0) out vec4 light;
layout(location = 0, index = 1) out vec4 transmittance;

void main() {
  ViewRay view = viewRayOf(gl_FragCoord.xy);
  BodyLight body = bodyLight(view.direction);
  light = vec4(body.light * view.inside, 0.0);
  transmittance = mix(vec4(1.0), vec4(body.transmittance, 1.0), view.inside);
}
