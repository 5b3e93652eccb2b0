// The halo of the visible Sun over the whole picture.
#include "interface/view.glsl"
#include "passes/glare_near.glsl"

layout(binding = 0) uniform sampler2D nearTable;

uniform vec3 sourceAxis;
uniform vec3 sourcePrepared;  // prepareDirection
uniform vec3 sourceAcross;    // axes of the plane over nearScale
uniform vec3 sourceUp;
uniform vec3 illuminance;  // lux in linear sRGB at the eye

out vec4 luminance;  // cd/m^2 in linear sRGB, added

void main() {
  ViewRay ray = viewRayOf(gl_FragCoord.xy);
  if (ray.inside == 0.0) discard;
  vec3 offset = ray.direction - sourcePrepared;
  float along = dot(ray.direction, sourceAxis);
  // Ahead, differences to the source keep the angle at any field; behind, what is far is the same.
  float ratio = 1.0;
  float angle;
  if (along > 0.0) {
    vec2 q = vec2(dot(offset, sourceAcross), dot(offset, sourceUp)) / along;
    angle = atan(length(q) * nearScale);
    vec2 u = q / (1.0 + abs(q));
    ratio = texture(nearTable, 0.5 + 0.5 * u).r;
  } else {
    float across = length(cross(ray.direction, sourceAxis));
    angle = atan(across, along);
  }
  luminance = vec4(illuminance * (softHalo(angle * angle) * ratio), 0.0);
}
