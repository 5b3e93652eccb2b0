// The path of a central eclipse on the ellipsoid at sea level.
//
// Limits belong to an instant thus: on the geodesic through the central point, perpendicular to its
// ground track there (left = azimuth of motion - 90 degrees), the points where totality or
// annularity is just grazed at any moment; the width is their distance along that geodesic. The
// canon's width is the formula of Explanatory Supplement 8.3623 as used by Espenak & Meeus: the
// umbra's diameter on the fundamental plane stretched by its slant on the ground.
#pragma once

#include <optional>
#include <vector>

#include "eclipse/solar_circumstances.h"

namespace antumbra {

struct CentralPoint {
  double seconds = 0.0;  // of TT from the middle of the track
  Site place;
  HorizontalDirection sun;  // airless
  double magnitude = 0.0;   // ratio of the diameters
  CentralPhase phase = CentralPhase::Total;
  Duration duration;
  Length width;
  Length canonWidth;
  Angle trackAzimuth;
  std::optional<Site> left,
      right;  // absent where the geodesic leaves the shadow's side of the Earth
};

// Nothing where the axis misses the Earth.
std::optional<CentralPoint> centralPoint(const SunMoonTrack& track, const ShadowRadii& radii,
                                         double seconds);
// Only the place.
std::optional<Site> centralPlace(const SunMoonTrack& track, const ShadowRadii& radii,
                                 double seconds);

// Central points at whole multiples of `step` since 0 h TT between C1 and C4.
std::vector<CentralPoint> centralLine(const SunMoonTrack& track, const ShadowRadii& radii,
                                      const SolarEclipse& eclipse, Duration step);

// The edge of the umbra or antumbra on the ground at an instant, as points in order; empty where it
// misses the Earth. Parts beyond the terminator are left out.
std::vector<Site> umbraFootprint(const SunMoonTrack& track, const ShadowRadii& radii,
                                 double seconds, int points = 120);

// By how many metres a point lies inside the umbra or antumbra (negative outside), across the axis.
double umbraDepth(const SunMoonTrack& track, const ShadowRadii& radii, const glm::dvec3& point,
                  double seconds);

}  // namespace antumbra
