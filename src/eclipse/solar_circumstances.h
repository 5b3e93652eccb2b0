// A solar eclipse as a whole: when it is greatest, its kind, its contacts with the Earth and what
// is seen where it is greatest. Exact cones of the shared functions against the WGS84 ellipsoid at
// sea level. Times are seconds of TT from the middle of the track.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "eclipse/ellipsoid_contact.h"
#include "eclipse/sun_moon_track.h"

namespace antumbra {

// What an observer sees at one place and instant, by angles; the Moon of the umbra's k.
struct SolarAppearance {
  double sunRadius = 0.0;  // rad
  double moonRadius = 0.0;
  double penumbralMoonRadius = 0.0;
  double separation = 0.0;
  HorizontalDirection sun;     // airless
  double positionAngle = 0.0;  // of the Moon's centre from the Sun's, from north through east
  double zenithAngle = 0.0;    // the same from the zenith, anticlockwise
  double diameterRatio() const { return moonRadius / sunRadius; }
  // Covered part of the Sun's diameter.
  double coveredDiameter() const {
    return (sunRadius + penumbralMoonRadius - separation) / (2.0 * sunRadius);
  }
  double coveredArea() const;
};
SolarAppearance solarAppearance(const SunMoonTrack& track, const ShadowRadii& radii,
                                const Site& site, double seconds);

// The kind seen where the Moon's disc is central.
enum class CentralPhase { Total, Annular };

struct SolarEclipse {
  std::string id;    // date of greatest eclipse in TT
  std::string type;  // P, A, T, H; suffix nc: the umbra touches, the axis misses
  Instant greatest;  // least distance of the shadow axis from the geocentre
  Duration deltaT;
  double gamma = 0.0;  // that distance in equatorial radii, positive to the north
  bool central = false;
  Site place;  // on the axis, or nearest to it
  SolarAppearance seen;
  double magnitude = 0.0;
  double obscuration = 0.0;
  std::optional<Duration> duration;  // of totality or annularity at `place`; central ones
  std::optional<Length> width;       // of the path there; central ones with two limits
  std::optional<Instant> p1, u1, c1, c4, u4, p4;
  int saros = 0;
  int lunation = 0;  // Brown's
};

// Seconds of the least distance of the axis from the geocentre.
double greatestSeconds(const SunMoonTrack& track, const ShadowRadii& radii);

// Nothing if the penumbra misses the Earth.
std::optional<SolarEclipse> solarEclipse(const SunMoonTrack& track, const ShadowRadii& radii);

// Root of f near `from` and `to` (on either side of it or not) by the secant method, kept within
// the bracket where there is one; to 1e-5 s.
template <class F>
double rootNear(F&& f, double from, double to) {
  double a = from, fa = f(a), b = to, fb = f(b);
  for (int i = 0; i < 30 && std::fabs(b - a) > 1e-6; ++i) {
    double const slope = (fb - fa) / (b - a);
    if (slope == 0.0) break;
    double const next = b - fb / slope;
    a = b, fa = fb;
    b = next, fb = f(b);
    if (fb == 0.0) break;
  }
  return b;
}
// Least value of a smooth f near `start`, by parabolas of shrinking step.
template <class F>
double minimumNear(F&& f, double start, double step, double finest) {
  double t = start;
  for (int i = 0; i < 20; ++i) {
    double const before = f(t - step), at = f(t), after = f(t + step);
    double const curvature = before - 2.0 * at + after;
    double const slope = 0.5 * (after - before);
    double const move = curvature > 0.0 ? std::clamp(-slope / curvature, -4.0, 4.0) * step
                                        : (slope > 0.0 ? -2.0 : 2.0) * step;
    t += move;
    if (std::fabs(move) < step) {
      if (step <= finest) break;
      step = std::max(step / 8.0, finest);
    }
  }
  return t;
}

}  // namespace antumbra
