// The sphere that stands for a spheroid where its air is drawn and asked for: the axes of the
// spheroid, stretched along its pole until it is a sphere of its equatorial radius. Rays stay
// straight, and horizon, limb and terminator stay exactly where they are.
// To be honest: angles change by up to the flattening (Earth: 0.19 deg, at 45 degrees of latitude
// and elevation), heights and path lengths by as much (0.34 %).
#pragma once

#include "atmosphere/sunlight.h"
#include "frame/frames.h"
#include "quantity/vector.h"

namespace antumbra {

class ScaledSphere {
 public:
  // `observer`: from the centre; `sun`: toward the Sun. Body-fixed axes, the pole along z.
  ScaledSphere(Length equatorialRadius, Length polarRadius, Displacement<BodyFixed> observer,
               Direction<BodyFixed> sun);
  Length radius() const { return radius_; }
  Length height() const { return height_; }  // of the observer above the sphere
  Angle sunZenith() const;
  // In the sphere's own axes: z through the observer, x toward the Sun's azimuth.
  Direction<AirFrame> operator()(Direction<BodyFixed> direction) const;

 private:
  Length radius_, height_;
  glm::dvec3 stretch_, sunward_, side_, up_;
  glm::dvec3 sun_;
};

}  // namespace antumbra
