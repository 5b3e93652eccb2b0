// The stars as an observer sees them at an instant: proper motion and the aberration of the
// observer's motion about the solar system's barycentre applied. To be honest: annual parallax
// (under 0.8") is left out.
#pragma once

#include <vector>

#include "frame/frames.h"
#include "quantity/vector.h"
#include "scene/star_catalogue.h"
#include "time/instant.h"

namespace antumbra {

struct ApparentStar {
  Direction<Icrs> direction;
  double illuminance = 0.0;  // lx outside any air
  double colorIndexBv = 0.0;
};

// Of V `limitingMagnitude` and brighter. Aberration by special relativity, all orders of v/c.
std::vector<ApparentStar> apparentStars(const StarCatalogue& catalogue, Instant when,
                                        Velocity<Icrs> observer, double limitingMagnitude);

}  // namespace antumbra
