// A solar eclipse as seen from one place, by the exact cones at the observer's own height.
//
// Contacts are the instants when the observer crosses the cones: C1 and C4 of the penumbra, C2 and
// C3 of the umbra or antumbra. Maximum is the instant of the greatest covered part of the Sun's
// diameter. They are given whether or not the Sun is up; a horizontal plane without refraction
// marks those below the horizon. Sunrise and sunset are those of the Sun's upper limb with 34' of
// refraction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eclipse/eclipse_search.h"

namespace antumbra {

struct LocalContact {
  Instant instant;
  HorizontalDirection sun;  // airless
  bool aboveHorizon = true;
  double positionAngle = 0.0;  // rad, of the contact on the Sun's limb, from north through east
  double zenithAngle = 0.0;    // rad, the same from the zenith
};

struct LocalHorizonEvent {
  std::string name;  // "sunrise" or "sunset"
  Instant instant;
  double magnitude = 0.0;  // covered part of the diameter then
};

struct LocalCircumstances {
  std::string type;  // "T", "A", "P" or "none", whether or not the Sun is up
  std::optional<LocalContact> c1, c2, maximum, c3, c4;
  double magnitude = 0.0;    // at maximum: ratio of the diameters if T or A, else the covered part
  double obscuration = 0.0;  // at maximum: covered part of the disc's area
  Duration duration;         // of totality or annularity
  std::vector<LocalHorizonEvent> horizonEvents;  // between C1 and C4
  // "visible", "partly visible" (a contact or the maximum lies below the horizon) or "below
  // horizon".
  std::string visibility;
};

LocalCircumstances localCircumstances(const SolarEvent& event, const ShadowRadii& radii,
                                      const Site& site);

// Seconds of the greatest covered diameter at a point of Itrs near `start`.
double localMaximumSeconds(const SunMoonTrack& track, const ShadowRadii& radii,
                           const glm::dvec3& point, double start);

}  // namespace antumbra
