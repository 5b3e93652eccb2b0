// How light from each direction of the quadrature about a shadow's axis is scattered into others:
// into the quadrature's own, for the next order, and into those in which drawing looks it up.
// What is averaged with the phase functions is known at few azimuths, so their own variation with
// azimuth is taken by as many harmonics, integrated finely; each constituent turns into all
// directions together what it should. By heights, for the mixture of constituents changes.
#include "interface/eclipsed_air.glsl"
#include "interface/eclipsed_cells.glsl"
layout(local_size_x = 8, local_size_y = 1) in;
// x: zenith angle of incidence, y: of the quadrature, then rises; z: by layer and height, the
// difference of azimuths in half steps of the quadrature's, 0 to pi. Times the solid angle of
// incidence; divided by what scatters.
layout(rgba32f, binding = 0) writeonly uniform image2DArray phases;
#include "interface/air_directions.glsl"

const int kAzimuths = 48;  // of the integral over half a turn
const int kHarmonics = ECLIPSED_TURNS_IN / 2;

float outwardCosine(int row, float horizon) {
  if (row >= directionCount.x) return eclipsedRise(row - directionCount.x);
  return airDirection(row * directionCount.y, horizon).cosine;
}

vec4 phaseBetween(int c, int layer, float a, float b, float turn) {
  float sines = sqrt(max((1.0 - a * a) * (1.0 - b * b), 0.0));
  return phaseByMoments(c, layer, clamp(a * b + sines * cos(turn), -1.0, 1.0));
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  int row = texel.x, height = texel.y, layer = texel.z;
  if (row >= directionCount.x + ECLIPSED_RISES || height >= cellCount.z) return;
  float h = cellHeight(height), horizon = horizonCosine(airShell(), h);
  float outward = outwardCosine(row, horizon);
  vec2 texels = densityTexels();
  AirDensities d = densitiesAt(rootHeight(airShell(), h) * texels.x + texels.y);
  vec4 scatters = vec4(0.0), share[AIR_CONSTITUENTS];
  for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
    share[c] = vec4(0.0);
    if (c < AIR_DARK) continue;
    vec4 all = vec4(0.0);
    for (int i = 0; i < directionCount.x; ++i) {
      AirDirection inward = airDirection(i * directionCount.y, horizon);
      for (int n = 0; n < kAzimuths; ++n)
        all += inward.weight * float(directionCount.y) / float(kAzimuths) *
               phaseBetween(c, layer, outward, inward.cosine, (float(n) + 0.5) * kPi / float(kAzimuths));
    }
    vec4 here = airScattering[layer * AIR_CONSTITUENTS + c] * d.of[c];
    scatters += here;
    share[c] = here * airPhaseMoments[layer * AIR_CONSTITUENTS + c] / max(all, vec4(1e-6));
  }
  for (int i = 0; i < directionCount.x; ++i) {
    AirDirection inward = airDirection(i * directionCount.y, horizon);
    vec4 modes[kHarmonics + 1];
    for (int m = 0; m <= kHarmonics; ++m) modes[m] = vec4(0.0);
    for (int n = 0; n < kAzimuths; ++n) {
      float turn = (float(n) + 0.5) * kPi / float(kAzimuths);
      vec4 value = vec4(0.0);
      for (int c = AIR_DARK; c < AIR_CONSTITUENTS; ++c)
        value += share[c] * phaseBetween(c, layer, outward, inward.cosine, turn);
      for (int m = 0; m <= kHarmonics; ++m) modes[m] += value * cos(float(m) * turn);
    }
    for (int step_ = 0; step_ <= ECLIPSED_TURNS_IN; ++step_) {
      float turn = kPi * float(step_) / float(ECLIPSED_TURNS_IN);
      vec4 sum = modes[0];
      for (int m = 1; m <= kHarmonics; ++m)
        sum += (2 * m == ECLIPSED_TURNS_IN ? 1.0 : 2.0) * modes[m] * cos(float(m) * turn);
      sum *= inward.weight / (float(kAzimuths) * max(scatters, vec4(1e-30)));
      imageStore(phases, ivec3(i, row, (layer * cellCount.z + height) * (ECLIPSED_TURNS_IN + 1) + step_),
                 mix(vec4(0.0), sum, greaterThan(scatters, vec4(1e-30))));
    }
  }
}
