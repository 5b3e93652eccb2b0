// Orientation of a body's axes by the model of the IAU Working Group on Cartographic Coordinates
// and Rotational Elements (report 2015: Archinal et al. 2018, Celest. Mech. Dyn. Astr. 130, 22):
// right ascension and declination of the north pole and the angle W of the prime meridian, as
// polynomials of time plus periodic terms. The model is exact here (1e-9 degrees); what it says of
// the body is good to 0.001-1 degree.
//
// One file per body, catalogs/rotation/<name in lower case>.toml; a body of catalogs/bodies needs
// no rotation table of its own, it is found by its name:
//   source = "..."                          where the numbers stand
//   pole_ra_deg = [a0, a1, a2]              degrees, powers of Julian centuries T of TDB from J2000
//   pole_dec_deg = [d0, d1, d2]
//   prime_meridian_deg = [w0, w1, w2]       degrees, powers of days d of TDB from J2000
//   [[term]]                                any number; adds to the three angles
//   argument_deg = [n0, n1, n2]             degrees, powers of T, or of d where unit is "day"
//   argument_unit = "century" | "day"       default "century"
//   ra_sin_deg, dec_cos_deg, w_sin_deg      amplitudes in degrees (each 0 where absent): of the
//   sine
//                                           in right ascension and W, of the cosine in declination
#pragma once

#include <string>
#include <vector>

#include "document/document.h"
#include "frame/frames.h"
#include "quantity/vector.h"
#include "time/instant.h"

namespace antumbra {

struct BodyRotation {
  struct Term {
    std::vector<double> argumentDegrees;
    bool perDay = false;
    double raSinDegrees = 0.0, decCosDegrees = 0.0, wSinDegrees = 0.0;
  };
  std::vector<double> poleRaDegrees, poleDecDegrees, primeMeridianDegrees;
  std::vector<Term> terms;
  std::string source;

  // Reads the schema above; refuses unknown keys.
  static BodyRotation fromTable(const Table& table);
};

// catalogs/rotation/<name>.toml ("Moon", "Jupiter", ...). Throws InputError if there is none,
// listing the bodies that have one. Read once, then shared.
const BodyRotation& bodyRotation(const std::string& bodyName);
bool hasBodyRotation(const std::string& bodyName);

struct RotationAngles {
  Angle poleRightAscension, poleDeclination;  // ICRS
  Angle primeMeridian;                        // W, in [0, 360) degrees
};
RotationAngles rotationAngles(const BodyRotation& rotation, Instant t);

Rotation<BodyFixed, Icrs> bodyFixedFromIcrs(const BodyRotation& rotation, Instant t);

}  // namespace antumbra
