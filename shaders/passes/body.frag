// Draws one body with its air: light toward the camera, and (second source of the blend) the
// transmittance of what lies behind it. Blend with GL_ONE, GL_SRC1_COLOR. AIR_SAMPLES (body.glsl)
// goes to two targets of their own instead, without blending.
#include "interface/view.glsl"
#include "interface/body.glsl"
#ifdef AIR_SAMPLES
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 transmittance;

void main() {
  ViewRay view = viewRayOf(pictureOfSample(gl_FragCoord.xy) - viewTileOrigin);
  BodyLight body = bodyLight(view.direction);
  light = vec4(body.light, 1.0);
  transmittance = vec4(body.transmittance, 1.0);
}
#else
layout(location = 0, index = 0) out vec4 light;
layout(location = 0, index = 1) out vec4 transmittance;

void main() {
#if defined(AIR_SAMPLED) && defined(BODY_SKY)
  light = vec4(max(sampledLight(gl_FragCoord.xy + viewTileOrigin), vec3(0.0)), 0.0);
  transmittance = vec4(sampledTransmittance(gl_FragCoord.xy + viewTileOrigin), 1.0);
#else
  ViewRay view = viewRayOf(gl_FragCoord.xy);
#ifdef AIR_SAMPLED
  sampled = sampledLight(gl_FragCoord.xy + viewTileOrigin);
#endif
  BodyLight body = bodyLight(view.direction);
  light = vec4(body.light * view.inside, 0.0);
  transmittance = mix(vec4(1.0), vec4(body.transmittance, 1.0), view.inside);
#endif
}
#endif
