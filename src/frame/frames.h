// The reference frames, and the rotations between them. A rotation is named after what it yields:
// itrsFromIcrs(t) turns Icrs components into Itrs components. All angles by ERFA (IAU 2006/2000A);
// outside 1800-2200 precession is the long-term model of Vondrak, Capitaine & Wallace 2011.
#pragma once

#include "quantity/vector.h"
#include "time/delta_t.h"
#include "time/instant.h"

namespace antumbra {

// International Celestial Reference System axes; whatever the origin, which each function names.
// To be honest: ICRS, ICRF, GCRS and BCRS axes are one here, though GCRS turns against BCRS by
// geodesic precession (1.9"/century, part of the precession model) and scales differ by 1e-8, which
// is 1 500 m in the astronomical unit and absorbed in the units of the ephemerides.
struct Icrs {};

// Mean equator and equinox of J2000.0 (IAU 2006). To be honest: constant frame bias, 0.02" from
// Icrs, good to 0.0001".
struct EquatorJ2000 {};

// Mean ecliptic and equinox of J2000.0 (IAU 2006). To be honest: the ecliptic of the planetary
// theories differs by up to 0.05"; each theory carries its own tie to Icrs.
struct EclipticJ2000 {};

// Mean equator and equinox of date. To be honest: see TrueEquatorOfDate.
struct MeanEquatorOfDate {};

// True equator and equinox of date: precession and nutation applied. x to the equinox, z to the
// celestial intermediate pole. To be honest: without the observed corrections dX, dY (0.0005", free
// core nutation); nutation 2000A is meant for a few centuries about 2000 and its arguments lose
// about 0.1" over 3 000 years.
struct TrueEquatorOfDate {};

// True ecliptic and equinox of date. To be honest: as TrueEquatorOfDate.
struct TrueEclipticOfDate {};

// International Terrestrial Reference System: x to Greenwich, z to the pole, origin at the
// geocentre. To be honest: polar motion (up to 0.6", 18 m) is zero unless an Earth-orientation file
// gives it; tides and plate motion (0.4 m, 0.1 m a year) are left out; delta T errs as its source
// says (464 m on the equator per second of time).
struct Itrs {};

// Local horizon of a site: x east, y north, z up along the ellipsoid's normal, origin at the site.
// To be honest: the plumb line deviates from that normal by up to 0.02 degrees in mountains.
struct Enu {};

// Axes fixed in a rotating body: z to its north pole (IAU), x to its prime meridian on the equator.
// To be honest: which body is not part of the type; IAU models err by 0.001 to 1 degree by body, as
// the report says (the Moon's: 150 m on the surface against its numerical libration).
struct BodyFixed {};

Rotation<EquatorJ2000, Icrs> equatorJ2000FromIcrs();
Rotation<EclipticJ2000, Icrs> eclipticJ2000FromIcrs();
Rotation<MeanEquatorOfDate, Icrs> meanEquatorOfDateFromIcrs(Instant t);
// Cost: IAU 2000A sums 1 365 nutation terms, about 50 microseconds.
Rotation<TrueEquatorOfDate, Icrs> trueEquatorOfDateFromIcrs(Instant t);
Rotation<TrueEclipticOfDate, Icrs> trueEclipticOfDateFromIcrs(Instant t);
// Rotation of the Earth through the Greenwich apparent sidereal time (equinox based, consistent
// with IAU 2006), and polar motion if deltaT carries it.
Rotation<Itrs, TrueEquatorOfDate> itrsFromTrueEquatorOfDate(Instant t, const DeltaT& deltaT);
Rotation<Itrs, Icrs> itrsFromIcrs(Instant t, const DeltaT& deltaT = DeltaT::standard());
Angle greenwichApparentSiderealTime(Instant t, const DeltaT& deltaT);

// Mean Earth's angular velocity in the inertial frame about the celestial pole: IERS Conventions
// 2010, table 1.2.
inline constexpr AngularRate kEarthAngularVelocity{7.292115e-5};

struct NutationAndObliquity {
  Angle longitude;      // nutation in longitude
  Angle obliquity;      // nutation in obliquity
  Angle meanObliquity;  // IAU 2006, or Vondrak 2011 outside 1800-2200
};
NutationAndObliquity nutationAndObliquity(Instant t);

}  // namespace antumbra
