// The corona as a source of light: what the body that covers the Sun leaves of it, as a share of
// the whole Sun's light. Integrals of the drawn profile (shaders/shared/corona.glsl, up to
// kCoronaEnd) in double precision over the sky around the disc that covers it, within 1e-6 of
// themselves; about 1.0e-6 of the Sun in the middle of a total eclipse by the Moon.
//
// To be honest: the flattening of the K corona is averaged over the position angle, which shifts
// the light past an eccentric Moon by up to 0.2 %, past the edge of a disc of many solar radii by
// up to 14 % (tests/eclipse/corona_light_test.cpp); streamers leave the mean as it is. The light
// has the Sun's colour and comes, for what it falls on, from the Sun's centre. Chromosphere and
// prominences (2e-7 of the Sun for seconds at the contacts) light nothing.
#pragma once

#include <array>
#include <vector>

#include "eclipse/limb_darkening.h"
#include "quantity/quantity.h"
#include "shared/as_cpp.h"

namespace antumbra {

class CoronaLight {
 public:
  // `activity`: phase of the solar cycle, 0 at minimum to 1 at maximum; `law`: the disc's, whose
  // brightness at the centre is the profile's unit. Throws InputError for another activity.
  CoronaLight(double activity, LimbDarkeningLaw law);

  double activity() const { return activity_; }
  LimbDarkeningLaw law() const { return law_; }
  // Past a disc of `ratio` times the Sun's radius whose centre is `separation` solar radii from the
  // Sun's: total, partial and annular eclipses alike.
  double past(double ratio, double separation) const;
  double past(const glsl::DiscPair& discs) const;
  double whole() const { return beyond(1.0); }  // of the unhidden Sun
  // The fit for programs, about a receiver up to `reach` from its centre, the pair's origin. Within
  // 0.01 % of `past` in the Moon's umbra, 1 % where that ends within reach (hybrid), 20 % in the
  // umbra of a disc of many solar radii. Beyond the umbra the value of its edge is kept, beside a
  // crescent that outshines the difference at once: 0.01 % of the light.
  glsl::CoronaFit fit(const glsl::ShadowPair& pair, Length reach) const;

 private:
  double beyond(double radius) const;  // light from farther than `radius` >= 1

  double activity_;
  LimbDarkeningLaw law_;
  std::vector<double> cumulative_, slope_;  // over the logarithm of the radius
};

// The fit as it lies in a uniform block: three vec4 in the order of the structure.
std::array<float, 12> packedForShader(const glsl::CoronaFit& fit);

}  // namespace antumbra
