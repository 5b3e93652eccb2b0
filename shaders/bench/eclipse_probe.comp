// Evaluates the shared eclipse functions for lists of discs and of points, so that a device can be
// compared with double precision.
layout(local_size_x = 64) in;
#include "shared/eclipse.glsl"

struct Probe {
  vec4 discs;  // radius of the Sun, excess, gap (rad)
  vec4 point;  // m from the pair's origin
};
struct Answer {
  vec4 light;    // limb-darkened, of the discs
  vec4 atPoint;  // limb-darkened, at the point
  vec4 other;    // uniform disc, of the discs; gap at the point (rad); first and second crossing (m)
};
layout(std430, binding = 0) readonly buffer Probes { Probe probes[]; };
layout(std430, binding = 1) writeonly buffer Answers { Answer answers[]; };
layout(std140, binding = 0) uniform Shadow { ShadowPair pair; };
layout(std140, binding = 1) uniform Law { LimbDarkening law; };

void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= uint(probes.length())) {
    return;
  }
  DiscPair discs;
  discs.sun = probes[k].discs.x;
  discs.excess = probes[k].discs.y;
  discs.gap = probes[k].discs.z;
  vec3 point = probes[k].point.xyz;
  ShadowPlace place = placeInShadow(pair, point);
  ConeCrossing crossing = crossPenumbra(pair, point - 1e9 * vec3(0.6, 0.64, 0.48), vec3(0.6, 0.64, 0.48));
  Answer answer;
  answer.light = visibleFraction(discs, law);
  answer.atPoint = visibleSunlight(pair, law, point);
  answer.other = vec4(visibleFractionUniform(discs), discsAt(pair, place.along, place.distance).gap,
                      crossing.first, crossing.second);
  answers[k] = answer;
}
