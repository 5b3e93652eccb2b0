// Corona and chromosphere around the Sun's limb, as far as no body covers them.
#include "interface/view.glsl"
#include "passes/sun_plane.glsl"
#include "shared/corona.glsl"

uniform float flattening;
uniform vec3 centreLuminance;  // of the disc, cd/m^2 in linear sRGB
uniform int finestSamples;
uniform float streamers;  // 1: with structure
uniform float activity;   // of the solar cycle
uniform int prominenceCount;

out vec4 luminance;  // cd/m^2 in linear sRGB, added; alpha: edgeMark

void main() {
  ViewRay ray = viewRayOf(gl_FragCoord.xy);
  vec3 middle = sunPlanePoint(ray.direction);
  if (middle.z == 0.0 || ray.inside == 0.0) discard;
  // The plane has no points a right angle from the Sun, and no corona far within that.
  if (dot(middle.xy, middle.xy) > 4.0 * kCoronaEnd * kCoronaEnd) discard;
  vec2 right = sunPlanePoint(viewRayOf(gl_FragCoord.xy + vec2(1.0, 0.0)).direction).xy - middle.xy;
  vec2 up = sunPlanePoint(viewRayOf(gl_FragCoord.xy + vec2(0.0, 1.0)).direction).xy - middle.xy;
  float size = max(length(right), length(up));
  float distance = length(middle.xy);
  if (distance < 1.0 - size) discard;

  // Near the limb all is steep; a radius out, one sample is exact to 1e-3.
  float near = size / max(distance - 1.0, size);
  int samples = near > 0.3 ? finestSamples : near > 0.05 ? 2 : 1;
  float step = sqrt(abs(right.x * up.y - right.y * up.x)) / float(samples);
  vec3 sum = vec3(0.0);
  float seen = 0.0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      vec2 offset = (vec2(float(i), float(j)) + 0.5) / float(samples) - 0.5;
      vec2 point = middle.xy + right * offset.x + up * offset.y;
      float squared = dot(point, point);
      float d = sqrt(squared);
      float free = uncoveredAt(point, step);
      seen += free;
      float outside = clamp((d - 1.0) / step + 0.5, 0.0, 1.0);
      if (outside <= 0.0) continue;
      // Nearest distance of the sight line to the Sun's centre, in solar radii.
      float tangentSquared = sunTangent * sunTangent;
      float radius = d * sqrt((1.0 + tangentSquared) / (1.0 + squared * tangentSquared));
      if (free > 0.0) {
        float outer = coronaFade(radius);
        float angle = atan(point.y, point.x);
        float corona = streamers > 0.5
                           ? structuredCorona(max(radius, 1.0), point.y / d, angle, flattening, activity)
                           : coronaBrightness(max(radius, 1.0), point.y / d, flattening);
        sum += centreLuminance * (corona * outside * free * outer);
        if (prominenceCount > 0 && radius < 1.2)
          sum += chromosphereColour() *
                 (dot(centreLuminance, vec3(0.2126, 0.7152, 0.0722)) *
                  prominences(max(radius - 1.0, 0.0), angle, prominenceCount) * outside * free);
      }
      // Thinner than most samples: whether it shows is asked at the limb itself.
      float rim = chromosphereBetween(radius - 0.5 * step, radius + 0.5 * step);
      if (rim > 1.0e-12) {
        vec2 foot = point * ((1.0 + 0.5 * kChromosphereScale) / d);
        sum += chromosphereColour() * (dot(centreLuminance, vec3(0.2126, 0.7152, 0.0722)) * rim *
                                       uncoveredAt(foot, kChromosphereScale));
      }
    }
  luminance = vec4(sum / float(samples * samples), edgeMark(seen / float(samples * samples)));
}
