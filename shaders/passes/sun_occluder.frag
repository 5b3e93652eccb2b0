// Depth of the bodies before the Sun, ray cast: nearer than the disc wherever one hides it.
#include "passes/sun_plane.glsl"
#include "passes/sun_window.glsl"

void main() {
  vec3 p = vec3(windowPoint(gl_FragCoord.xy), 1.0);
  bool hidden = false;
  for (int i = 0; i < silhouetteCount; ++i) {
    vec4 a = silhouettes[3 * i];
    vec4 b = silhouettes[3 * i + 1];
    vec3 front = vec3(a.w, b.w, silhouettes[3 * i + 2].x);
    mat3 quadric = mat3(a.x, a.y, b.x, a.y, a.z, b.y, b.x, b.y, b.z);
    hidden = hidden || (dot(p, quadric * p) > 0.0 && dot(front, p) > 0.0);
  }
  if (!hidden) discard;
}
