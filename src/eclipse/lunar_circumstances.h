// A lunar eclipse as a whole, in the Earth's shadow as enlarged by its air. Greatest eclipse is the
// least geocentric angle between the Moon and the shadow's axis. Radii of the shadows, with the
// Moon's horizontal parallax p, the Sun's semidiameter s and parallax q:
//   Danjon     1.01 p -+ s + q            (Espenak & Meeus, NASA/TP-2009-214172, section 1.8)
//   Chauvenet  1.02 (0.998340 p -+ s + q)
//   none       p -+ s + q
#pragma once

#include <optional>
#include <string>

#include "eclipse/sun_moon_track.h"

namespace antumbra {

enum class ShadowEnlargement { Danjon, Chauvenet, None };
ShadowEnlargement parseShadowEnlargement(const std::string& name, const std::string& where);
std::string nameOf(ShadowEnlargement rule);

struct LunarShadow {
  double separation = 0.0;  // rad, Moon's centre from the shadow's axis
  double moonRadius = 0.0;
  double umbraRadius = 0.0;
  double penumbraRadius = 0.0;
  double umbralMagnitude() const {
    return (umbraRadius + moonRadius - separation) / (2.0 * moonRadius);
  }
  double penumbralMagnitude() const {
    return (penumbraRadius + moonRadius - separation) / (2.0 * moonRadius);
  }
};
LunarShadow lunarShadow(const SunMoonTrack& track, const ShadowConvention& convention,
                        ShadowEnlargement rule, double seconds);

struct LunarEclipse {
  std::string id;    // date of greatest eclipse in TT
  std::string type;  // N penumbral, P partial, T total
  Instant greatest;
  Duration deltaT;
  double gamma = 0.0;  // least distance of the Moon's centre from the axis, in equatorial radii
  double umbralMagnitude = 0.0;
  double penumbralMagnitude = 0.0;
  std::optional<Instant> p1, u1, u2, u3, u4, p4;
  int saros = 0;
  int lunation = 0;  // Brown's, of the new moon before
};

// Nothing if the Moon misses the penumbra.
std::optional<LunarEclipse> lunarEclipse(const SunMoonTrack& track,
                                         const ShadowConvention& convention,
                                         ShadowEnlargement rule);

}  // namespace antumbra
