// Contacts at a place.
#include "eclipse/local_circumstances.h"

#include <algorithm>
#include <cmath>

#include "eclipse/horizon_crossings.h"

namespace antumbra {
namespace {

// Upper limb on the horizon with mean refraction: the almanacs' 50'.
constexpr Angle kRiseSetAltitude{-50.0 * arcminute.si};

struct Distances {
  double axis, umbra, penumbra;  // m; distance from the axis and radii of the cones there
};

Distances distancesAt(const SunMoonTrack& track, const ShadowRadii& radii, const glm::dvec3& point,
                      double seconds) {
  auto const pair = track.shadowAt(seconds, radii);
  auto const place = glsl::placeInShadow(pair, point);
  return {place.distance, glsl::umbraRadiusAt(pair, place.along),
          glsl::penumbraRadiusAt(pair, place.along)};
}

LocalContact contactAt(const SunMoonTrack& track, const ShadowRadii& radii, const Site& site,
                       double seconds, bool opposite) {
  auto const seen = solarAppearance(track, radii, site, seconds);
  LocalContact contact;
  contact.instant = track.instantAt(seconds);
  contact.sun = seen.sun;
  contact.aboveHorizon = seen.sun.altitude > 0.0 * degree;
  auto const turned = [&](double a) { return opposite ? std::fmod(a + M_PI, 2.0 * M_PI) : a; };
  contact.positionAngle = turned(seen.positionAngle);
  contact.zenithAngle = turned(seen.zenithAngle);
  return contact;
}

}  // namespace

double localMaximumSeconds(const SunMoonTrack& track, const ShadowRadii& radii,
                           const glm::dvec3& point, double start) {
  // The uncovered part of the diameter, but for a constant.
  auto const uncovered = [&](double t) {
    auto const places = track.placesAt(t);
    glm::dvec3 const sun = places.sun - point, moon = places.moon - point;
    double const separation = std::atan2(glm::length(glm::cross(sun, moon)), glm::dot(sun, moon));
    double const solar = std::asin(radii.sun.si / glm::length(sun));
    double const lunar = std::asin(radii.casterPenumbra.si / glm::length(moon));
    return (separation - lunar) / solar;
  };
  // Near the axis that has a corner: find the least distance first, by its smooth square.
  auto const squared = [&](double t) {
    double const d = distancesAt(track, radii, point, t).axis;
    return d * d;
  };
  double const closest = minimumNear(squared, start, 900.0, 30.0);
  if (std::sqrt(squared(closest)) < 3e4) return closest;
  return minimumNear(uncovered, closest, 60.0, 10.0);
}

LocalCircumstances localCircumstances(const SolarEvent& event, const ShadowRadii& radii,
                                      const Site& site) {
  SunMoonTrack const& track = event.track;
  glm::dvec3 const point = itrsMetres(site);
  LocalCircumstances local;
  double const limit = track.halfSpan() / second;
  double const middle =
      std::clamp(localMaximumSeconds(track, radii, point, track.secondsAt(event.eclipse.greatest)),
                 -limit, limit);
  auto const penumbra = [&](double t) {
    Distances const d = distancesAt(track, radii, point, t);
    return d.axis * d.axis - d.penumbra * d.penumbra;
  };
  auto const umbra = [&](double t) {
    Distances const d = distancesAt(track, radii, point, t);
    return d.axis * d.axis - d.umbra * d.umbra;
  };
  Distances const least = distancesAt(track, radii, point, middle);
  if (least.axis >= least.penumbra) {
    local.type = std::string("none");
    local.visibility = std::string("no eclipse");
    return local;
  }
  auto const speedSquaredAbout = [&](auto&& f, double step) {
    return std::max((f(middle + step) - 2.0 * f(middle) + f(middle - step)) / (2.0 * step * step),
                    1e3);
  };
  auto const roots = [&](auto&& f, double step) {
    double const half = std::sqrt(std::max(-f(middle), 0.0) / speedSquaredAbout(f, step));
    return std::pair(rootNear(f, middle - half, middle - 0.98 * half),
                     rootNear(f, middle + half, middle + 0.98 * half));
  };
  auto const seen = solarAppearance(track, radii, site, middle);
  auto const [first, fourth] = roots(penumbra, 1200.0);
  local.type = std::string("P");
  local.c1 = contactAt(track, radii, site, first, false);
  local.c4 = contactAt(track, radii, site, fourth, false);
  local.maximum = contactAt(track, radii, site, middle, false);
  // Near the edge the point may be deepest in the umbra at another instant than the maximum.
  double const deepest = minimumNear(umbra, middle, 30.0, 10.0);
  if (umbra(deepest) < 0.0) {
    bool const total = distancesAt(track, radii, point, deepest).umbra > 0.0;
    double const half = std::sqrt(
        -umbra(deepest) /
        std::max((umbra(deepest + 30.0) - 2.0 * umbra(deepest) + umbra(deepest - 30.0)) / 1800.0,
                 1e3));
    double const second_ = rootNear(umbra, deepest - half, deepest - 0.98 * half);
    double const third = rootNear(umbra, deepest + half, deepest + 0.98 * half);
    local.type = std::string(total ? "T" : "A");
    // The larger Moon's limb touches on the far side, the smaller one's on the near side.
    local.c2 = contactAt(track, radii, site, second_, total);
    local.c3 = contactAt(track, radii, site, third, total);
    local.duration = Duration(third - second_);
  }
  local.magnitude = local.type == "P" ? seen.coveredDiameter() : seen.diameterRatio();
  local.obscuration = seen.coveredArea();

  auto const horizon = horizonCrossings(
      [&](double t) {
        return (solarAppearance(track, radii, site, t).sun.altitude - kRiseSetAltitude) / radian;
      },
      first, fourth);
  for (auto const& c : horizon.crossings) {
    auto const then = solarAppearance(track, radii, site, c.seconds);
    local.horizonEvents.push_back({c.rises ? "sunrise" : "sunset", track.instantAt(c.seconds),
                                   std::max(then.coveredDiameter(), 0.0)});
  }
  bool const allUp =
      local.c1->aboveHorizon && local.c4->aboveHorizon && local.maximum->aboveHorizon;
  local.visibility = horizon.visibility(allUp);
  return local;
}

}  // namespace antumbra
