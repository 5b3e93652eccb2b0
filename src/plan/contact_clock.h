// A clock of an eclipse's contacts, as an inset of the picture: a dial from first to last contact
// with the present marked, the Sun as it stands there (zenith up) or, for the whole eclipse, the
// Earth as the Sun sees it with the shadow on it; the contacts in UTC, and the phase.
#pragma once

#include <string>

#include "eclipse/drawing.h"
#include "plan/eclipse_at_hand.h"

namespace antumbra {

struct ContactClock {
  Drawing drawing;   // in pixels of the picture, y down; without shapes where there is nothing
  std::string says;  // for an explanation
};

// Of the scene's clock_site; else of the camera's place, where that stands below 100 km on the
// Earth; else of the eclipse as a whole. `textSize` in pixels.
ContactClock contactClock(const Scene& scene, const PlacedScene& placed,
                          const EclipseAtHand& eclipse, double textSize);

}  // namespace antumbra
