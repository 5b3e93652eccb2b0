// Transits of Mercury and Venus across the Sun, seen from the geocentre. Contacts are the instants
// when the planet's limb touches the Sun's: I and IV from outside, II and III from inside. An
// observer on the ground sees them up to 7 minutes (Venus) or 2 minutes (Mercury) earlier or later.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eclipse/eclipse_search.h"

namespace antumbra {

struct Transit {
  std::string id;  // date of the least separation in TT
  BodyId planet = BodyId::Mercury;
  Instant greatest;  // least angle between the centres
  Duration deltaT;
  Angle separation;  // of the centres then
  Angle sunRadius, planetRadius;
  double positionAngle = 0.0;  // rad, of the planet from the Sun's centre, from north through east
  std::optional<Instant> i, ii, iii, iv;  // II and III are missing where the planet only grazes
};

// Both planets' transits whose greatest instant lies in [from, to), in order. Throws SpanError
// where the ephemeris does not reach.
std::vector<Transit> transits(const EclipseBasis& basis, Instant from, Instant to,
                              const Progress& progress = {});

}  // namespace antumbra
