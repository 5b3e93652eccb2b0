// The cones of shadow in space as translucent bodies, in display colours: each takes from what lies
// behind as much as its depth along the line of sight says, up to its own limit.
#include "interface/view.glsl"
#include "interface/solids.glsl"
#include "shared/shadow_cone.glsl"

struct Cone {
  vec4 foot;       // of the axis, from the camera, m; w: 1 where the end fades
  vec4 axis;       // away from the Sun; w: along it to the caster, m
  vec4 umbra;      // radius at the foot, gain per metre; along to the apex, along to the end, m
  vec4 penumbra;   // radius at the foot, gain per metre
};
layout(std140, binding = 12) uniform Cones {
  Cone cones[4];
  int coneCount;
};
out vec4 ink;

// sRGB as displayed; w: the most that a cone covers of what lies behind it.
const vec4 kUmbra = vec4(0.40, 0.47, 0.95, 0.80);
const vec4 kAntumbra = vec4(0.98, 0.60, 0.24, 0.80);
const vec4 kPenumbra = vec4(0.55, 0.66, 0.94, 0.42);

// Premultiplied colour and cover, the cone on top of `under`. Cover grows slowly with depth: from the
// side a cone is clear (depth 2 through its axis: half of its most), from inside, where depths run to
// hundreds along the axis, the way still shows.
vec4 onTop(vec4 under, vec4 colour, float depth) {
  float cover = colour.w * (1.0 - pow(1.0 + depth, -0.6));
  return vec4(colour.rgb * cover, cover) + under * (1.0 - cover);
}

vec4 seenThrough(vec3 ray, float farthest) {
  vec4 all = vec4(0.0);
  for (int i = 0; i < coneCount; ++i) {
    vec3 foot = cones[i].foot.xyz;
    vec3 axis = cones[i].axis.xyz;
    float base = cones[i].axis.w;
    float apex = cones[i].umbra.z;
    float end = cones[i].umbra.w;
    ConePiece penumbra = ConePiece(cones[i].penumbra.x, cones[i].penumbra.y, base, end);
    ConePiece umbra = ConePiece(cones[i].umbra.x, cones[i].umbra.y, base, min(apex, end));
    ConePiece antumbra = ConePiece(-cones[i].umbra.x, -cones[i].umbra.y, apex, end);
    float pixel = viewPixelAngle;
    // A free end fades over its last third, by where the ray passes the axis.
    float slide = dot(ray, axis);
    vec3 sideways = ray - axis * slide;
    float passes = slide * max(dot(foot, sideways) / max(dot(sideways, sideways), 1e-12), 0.0);
    float left = 1.0 - cones[i].foot.w * smoothstep(mix(base, end, 0.7), end, passes);
    all = onTop(all, kPenumbra, left * depthInCone(foot, axis, penumbra, ray, farthest, pixel));
    all = onTop(all, kUmbra, left * depthInCone(foot, axis, umbra, ray, farthest, pixel));
    if (end > apex) {
      all = onTop(all, kAntumbra, left * depthInCone(foot, axis, antumbra, ray, farthest, pixel));
    }
  }
  return all;
}

void main() {
  ViewRay view = viewRayOf(gl_FragCoord.xy);
  if (view.inside == 0.0) discard;
  vec3 ray = normalize(view.direction);
  float whole = 1e30;  // to the nearest body that fills the pixel, and to any that touches it
  float touched = 1e30;
  float cover = 0.0;
  for (int i = 0; i < solidCount; ++i) {
    SolidMeeting meeting = meetSolid(i, ray, viewPixelAngle);
    if (meeting.cover >= 1.0) whole = min(whole, meeting.distance);
    if (meeting.cover > 0.0) touched = min(touched, meeting.distance);
    cover = max(cover, meeting.cover);
  }
  ink = seenThrough(ray, whole);
  if (touched < whole) ink = mix(ink, seenThrough(ray, touched), cover);
}
