// What an eye sees: places corrected for the time light takes, for the motion of the eye
// (aberration) and, if asked, for the bending of light by the Sun.
//
// Light time: the target at t - tau, the eye at t, both in the frame of the solar-system
// barycentre. Aberration: special relativity, all orders of v/c (ERFA eraAb, Klioner 2003). The
// same correction for every body, so that shadows and discs agree: leaving both out moves the
// Moon's shadow on the Earth by 38 km; leaving out aberration alone by 0.6 km.
#pragma once

#include <span>
#include <vector>

#include "ephemeris/ephemeris.h"
#include "geodesy/site.h"

namespace antumbra {

// The eye: where it is and how it moves, relative to the solar-system barycentre.
struct Observer {
  State barycentric;
};
// An eye at rest in the centre of a body.
Observer observerAt(const Ephemeris& ephemeris, BodyId centre, Instant t);
// An eye at a fixed site on the Earth, turning with it (diurnal aberration, parallax).
Observer observerAt(const Ephemeris& ephemeris, const Site& site, Instant t,
                    const DeltaT& deltaT = DeltaT::standard());

struct Corrections {
  bool lightTime = true;
  bool aberration = true;
  bool deflection = false;  // by the Sun; 1.75" at its limb, 0.004" at 90 degrees
};

struct ApparentPlace {
  BodyId body = BodyId::Sun;
  Displacement<Icrs> displacement;  // apparent direction times c * lightTime; Icrs axes at the eye
  Duration lightTime;
  Displacement<Icrs> retarded;  // before aberration and deflection
};

ApparentPlace apparentPlace(const Ephemeris& ephemeris, BodyId target, const Observer& observer,
                            Instant t, Corrections corrections = {});
// Every body in `targets` as seen from the same eye at the same instant. A target whose centre the
// eye shares comes out at zero.
std::vector<ApparentPlace> apparentPlaces(const Ephemeris& ephemeris,
                                          std::span<const BodyId> targets, const Observer& observer,
                                          Instant t, Corrections corrections = {});

}  // namespace antumbra
