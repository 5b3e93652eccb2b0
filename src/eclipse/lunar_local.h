// A lunar eclipse as seen from one place. Its contacts come at the same instants everywhere; the
// place decides where the Moon stands then, and whether it is up. Altitudes are those of the Moon's
// centre from the place itself (parallax included), without refraction; moonrise and moonset those
// of its upper limb with 34' of refraction.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "eclipse/eclipse_search.h"

namespace antumbra {

struct LunarContact {
  Instant instant;
  HorizontalDirection moon;  // airless
  bool aboveHorizon = true;
};

struct LunarHorizonEvent {
  std::string name;  // "moonrise" or "moonset"
  Instant instant;
  double umbralMagnitude = 0.0;  // then; negative outside the umbra
};

struct LunarLocalCircumstances {
  // P1, U1, U2, greatest, U3, U4, P4; nothing where a contact does not occur.
  static constexpr std::array<const char*, 7> kNames{"P1", "U1", "U2", "max", "U3", "U4", "P4"};
  std::array<std::optional<LunarContact>, 7> contacts;
  std::vector<LunarHorizonEvent> horizonEvents;  // between P1 and P4
  // "visible", "partly visible" (a contact lies below the horizon) or "below horizon".
  std::string visibility;
};

LunarLocalCircumstances lunarLocalCircumstances(const LunarEvent& event, const EclipseBasis& basis,
                                                const Site& site);

}  // namespace antumbra
