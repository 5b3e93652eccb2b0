// Shadows of the Galilean moons on Jupiter, and eclipses of the moons in Jupiter's shadow.
//
// A shadow is on the planet while the line from the Sun through the moon meets Jupiter's ellipsoid
// (71 492 and 66 854 km, IAU WGCCRE 2015) behind the moon; a moon is eclipsed while that line meets
// it before the moon. Begin and end are those of the moon's centre: half of the shadow's spot, or
// half of the moon's light. Sun and moons as seen from Jupiter's centre (light time, aberration).
// Times at Jupiter, and when the event is seen from the Earth's centre.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eclipse/eclipse_search.h"

namespace antumbra {

struct JovianEvent {
  std::string id;  // date of the middle as seen from the Earth (TT), moon and kind
  BodyId moon = BodyId::Io;
  bool shadowOnJupiter = true;  // otherwise an eclipse of the moon
  Instant begin, middle, end;   // at Jupiter
  Duration lightTime;           // from Jupiter to the Earth at the middle
  Duration deltaT;
  // Distance of the line from Jupiter's centre at the middle, in equatorial radii.
  double leastDistance = 0.0;
  int shadowsAtOnce = 0;  // most shadows on Jupiter at any moment of this one; 0 for an eclipse
  Instant seen(Instant atJupiter) const { return atJupiter + lightTime; }
};

// Events whose middle is seen from the Earth in [from, to), in order of their middles. Throws
// SpanError outside the span of the moons' theory; events of its first and last hours, of which it
// holds only a part, are left out.
std::vector<JovianEvent> jovianEvents(const EclipseBasis& basis, Instant from, Instant to,
                                      const Progress& progress = {});

}  // namespace antumbra
