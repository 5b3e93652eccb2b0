// The limb-darkened disc of the Sun, as far as no body covers it. Pixels are integrated over samples
// with analytic edges, more of them where a pixel is a large part of the Sun, so that a disc of a few
// pixels keeps its flux, and a thread of photosphere between two limbs within one pixel keeps its own.
#include "interface/view.glsl"
#include "passes/sun_plane.glsl"

uniform int finestSamples;   // along one side of a pixel at an edge

out vec4 luminance;  // cd/m^2 in linear sRGB, added; alpha: edgeMark

void main() {
  vec3 middle = sunPlanePoint(viewRayOf(gl_FragCoord.xy).direction);
  float distance = length(middle.xy);
  // Local size of a pixel in the plane.
  vec3 aside = sunPlanePoint(viewRayOf(gl_FragCoord.xy + vec2(1.0, 0.0)).direction);
  vec3 above = sunPlanePoint(viewRayOf(gl_FragCoord.xy + vec2(0.0, 1.0)).direction);
  vec2 right = aside.xy - middle.xy;
  vec2 up = above.xy - middle.xy;
  float size = max(length(right), length(up));
  if (middle.z == 0.0 || distance > 1.0 + size) discard;

  LimbDarkening law = sunLaw();
  bool atLimb = distance > 1.0 - 2.0 * size;
  float free = uncoveredAt(middle.xy, 4.0 * size);
  if (free <= 0.0) discard;
  int samples = atLimb || free < 1.0 || size > 0.1 ? finestSamples : 1;
  float step = sqrt(abs(right.x * up.y - right.y * up.x)) / float(samples);
  vec3 sum = vec3(0.0);
  float seen = 0.0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      vec2 offset = (vec2(float(i), float(j)) + 0.5) / float(samples) - 0.5;
      vec2 point = middle.xy + right * offset.x + up * offset.y;
      float d = length(point);
      // The sample is a piece of the radius, of which the bodies leave a part: its brightness counts.
      // At the limb disc and bodies are cut together, so that nothing is left where a body reaches
      // beyond the limb by less than a sample.
      float from = max(d - 0.5 * step, 0.0);
      float to = min(d + 0.5 * step, 1.0);
      if (to <= from) continue;
      vec2 ring = uncoveredBetween(point / max(d, 1e-9), from, to);
      float share = d + 0.5 * step > 1.0 ? (ring.y - ring.x) / step : uncoveredAt(point, step);
      if (ring.y <= ring.x) ring = vec2(from, to);
      seen += share;
      if (share > 0.0) sum += photosphereBetween(law, ring).rgb * share;
    }
  float inside = viewRayOf(gl_FragCoord.xy).inside;
  // From the limb on outward corona.frag marks the edges.
  float mark = distance < 1.0 - size ? edgeMark(seen / float(samples * samples)) : 0.0;
  luminance = vec4(sunMeanLuminance * sum * (inside / float(samples * samples)), mark);
}
