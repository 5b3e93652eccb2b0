// The Sun and the Moon (or another body before the Sun) as seen from the geocentre over a few hours
// about a syzygy, at a cost of 0.2 microseconds a look: what searching, contacts and paths evaluate
// thousands of times.
//
// Apparent places (light time and aberration of an observer at the geocentre) as Chebyshev
// polynomials of degree 6 through the ephemeris; over eight hours they stay within 1 m of it
// (tests/eclipse). Axes are those of the Earth: the celestial pole is held fixed at the middle of
// the span (it moves by 0.03", 1 m, in four hours) and the Earth turns at its rate in the
// non-rotating origin, IERS Conventions 2010, equation 5.15.
#pragma once

#include <array>

#include "eclipse/shadow_convention.h"
#include "ephemeris/ephemeris.h"
#include "quantity/vector.h"
#include "shared/as_cpp.h"

namespace antumbra {

class SunMoonTrack {
 public:
  // Throws SpanError if the ephemeris does not reach.
  SunMoonTrack(const Ephemeris& ephemeris, Instant middle, Duration halfSpan, Duration deltaT,
               BodyId occulter = BodyId::Moon);

  Instant middle() const { return middle_; }
  Duration halfSpan() const { return halfSpan_; }
  Duration deltaT() const { return deltaT_; }
  Instant instantAt(double seconds) const { return middle_ + seconds * second; }
  double secondsAt(Instant t) const { return (t - middle_) / second; }

  // Geocentric apparent places in metres along the axes of Itrs, at seconds of TT from the middle.
  struct Places {
    glm::dvec3 sun, moon;  // moon: the occulter
  };
  Places placesAt(double seconds) const;
  // The same along the true equator and equinox of date.
  Places celestialAt(double seconds) const;
  // Greenwich apparent sidereal time, rad, not reduced to a turn.
  double siderealTimeAt(double seconds) const;

  // The Moon's shadow about the geocentre, along the axes of Itrs.
  glsl::ShadowPair shadowAt(double seconds, const ShadowRadii& radii) const;

 private:
  static constexpr int kNodes = 7;
  Instant middle_;
  Duration halfSpan_, deltaT_;
  double siderealTime_ = 0.0;
  std::array<std::array<double, 6>, kNodes> coefficients_{};
};

}  // namespace antumbra
