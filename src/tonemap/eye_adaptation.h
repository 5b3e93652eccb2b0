// The eye's adaptation in time, from photopic to scotopic and back.
//
// Two things limit what a dark-adapting eye sees. Its nerves follow the light in seconds: the
// display's white moves in stops as exp(-t / time constant), 0.4 s towards the bright, 1.5 s
// towards the dark (as live exposure does). Its pigments follow in minutes: of each the unbleached
// share p obeys
//   dp/dt = (1 - p - p I / I0) / t0,   I the retinal illuminance in trolands
//   cones: t0 = 120 s, I0 = 10^4.3 td (Rushton & Henry 1968, Vision Res. 8, 617)
//   rods:  t0 = 400 s, I0 = 10^4.4 scotopic td (Rushton 1961, J. Physiol. 156, 193; Alpern 1971)
// and a bleached share raises the threshold by a factor 10^(3 (1 - p)) for cones, 10^(20 (1 - p))
// for rods (Dowling & Rushton's relation; Lamb & Pugh 2004, Prog. Retin. Eye Res. 23, 307) over
// 0.003 and 1e-6 cd/m2 (Hecht 1937). The eye cannot adapt to less than the lower of the two, and
// its rods add nothing below theirs. Pupil: Moon & Spencer 1944 (JOSA 34, 319).
// Points of light go where they fall below the naked eye's threshold (photometry/naked_eye.h) at
// the luminance that the nerves have followed to.
//
// To be honest: one retina for the whole field, adapted to the picture's metered mean; scotopic
// trolands are taken as 2 photopic ones (sunlight and skylight: 2.2 to 2.6).
#pragma once

#include <span>
#include <vector>

#include "tonemap/exposure.h"

namespace antumbra {

struct EyeState {
  double whiteLuminance = 1.0e4;  // shown as white, cd/m2
  double conePigment = 1.0;       // unbleached shares
  double rodPigment = 1.0;
  double adaptedLuminance = 1.0e4;  // that its nerves have followed to, cd/m2
};

// Lowest luminance that can be seen, cd/m2.
double coneThreshold(const EyeState& eye);
double rodThreshold(const EyeState& eye);

// Long in the light of a meter's reading.
EyeState steadyEye(const MeterReading& reading, const AutomaticExposure& settings = {});

// After `passed` more, in which the light changes in its logarithm from one reading to the other.
// Exact in the pigments and the nerves for constant light; changing light is cut into steps in
// which it changes by less than 10 %.
EyeState adaptedEye(EyeState eye, const MeterReading& from, const MeterReading& to, Duration passed,
                    const AutomaticExposure& settings = {});

Exposure exposureOf(const EyeState& eye);

// A track of readings for the eye of one instant, times in seconds before it, descending to 0: the
// eye is steady at the first and then lives through the rest.
struct TrackedReading {
  Duration before;
  MeterReading reading;
};
EyeState eyeAfter(std::span<const TrackedReading> track, const AutomaticExposure& settings = {});

// When to meter for that, in seconds on the clock of `now`, ascending, `now` the last: half an hour
// back, on multiples of 1 s, from 2 s back on of 2 s, from 4 s back on of 4 s, and so on. Pictures
// near in time share most of these instants. Measured against a reading every 0.05 s through a
// second contact: the white within 0.05 % (tests/tonemap).
std::vector<double> meteredSeconds(double now);

}  // namespace antumbra
