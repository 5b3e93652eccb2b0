// The face of an eclipse's clock: an inset with a dial, the Sun or the Earth in its middle, and
// words.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "eclipse/drawing.h"
#include "eclipse/local_circumstances.h"
#include "plan/eclipse_at_hand.h"

namespace antumbra {

struct ClockEntry {
  std::string name;
  std::optional<Instant> instant;
  bool below = false;  // the Sun is below the horizon
};

// What the clock shows, apart from how.
struct ClockReading {
  std::string place;
  std::vector<ClockEntry> entries;  // five: first, second, middle, third, fourth
  std::string phase;
  std::optional<SolarAppearance> seen;  // of its place; else the whole Earth is drawn
};

// In pixels of the picture, y down; `textSize` is that of the picture's other words.
Drawing clockFace(const Projection& picture, const EclipseAtHand& eclipse, Instant now,
                  double textSize, const ClockReading& reading);

// The corners of its panel in a picture.
std::pair<glm::dvec2, glm::dvec2> clockPanel(const Projection& picture, double textSize);

}  // namespace antumbra
