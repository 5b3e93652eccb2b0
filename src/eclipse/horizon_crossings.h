// When a body rises or sets while an eclipse goes on. The few hours are looked at in twenty-four
// pieces: a body that rises and sets again within one of them, near the edge of a polar day, is
// missed.
#pragma once

#include <string>
#include <vector>

#include "eclipse/solar_circumstances.h"

namespace antumbra {

struct HorizonCrossings {
  struct Crossing {
    bool rises = true;
    double seconds = 0.0;
  };
  std::vector<Crossing> crossings;  // in order
  bool everUp = false;
  // `allUp`: every contact lies above the horizon.
  std::string visibility(bool allUp) const {
    if (allUp && crossings.empty()) return "visible";
    return everUp ? "partly visible" : "below horizon";
  }
};

// `height(seconds)`: above the altitude at which the body rises, of any scale.
template <class Height>
HorizonCrossings horizonCrossings(Height&& height, double from, double to) {
  HorizonCrossings found;
  constexpr int kPieces = 24;
  double before = from, heightBefore = height(from);
  found.everUp = heightBefore > 0.0;
  for (int i = 1; i <= kPieces; ++i) {
    double const t = from + (to - from) * i / kPieces;
    double const h = height(t);
    found.everUp = found.everUp || h > 0.0;
    if ((h > 0.0) != (heightBefore > 0.0))
      found.crossings.push_back({h > 0.0, rootNear(height, before, t)});
    before = t;
    heightBefore = h;
  }
  return found;
}

}  // namespace antumbra
