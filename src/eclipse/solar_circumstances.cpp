// Global circumstances of a solar eclipse.
#include "eclipse/solar_circumstances.h"

#include <algorithm>
#include <cmath>

#include "eclipse/central_path.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

double angleOf(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The two zeros of `clearance` about its minimum at `middle`, where it is negative.
template <class F>
std::pair<double, double> contacts(F&& clearance, double middle, double speed) {
  double const depth = -clearance(middle);
  // The clearance falls and rises like the distance of the axis, whose chord is at least this long.
  double const reach = std::sqrt(depth * (depth + 2.0 * kEarthEquatorialRadius.si)) / speed;
  double const half = std::max(reach, 1.0);
  return {rootNear(clearance, middle - half, middle - 0.9 * half),
          rootNear(clearance, middle + half, middle + 0.9 * half)};
}

}  // namespace

double SolarAppearance::coveredArea() const {
  return 1.0 -
         glsl::visibleFractionUniform(glsl::discsFromAngles(sunRadius, moonRadius, separation));
}

SolarAppearance solarAppearance(const SunMoonTrack& track, const ShadowRadii& radii,
                                const Site& site, double seconds) {
  auto const places = track.placesAt(seconds);
  glm::dvec3 const eye = itrsMetres(site);
  glm::dvec3 const sun = places.sun - eye, moon = places.moon - eye;
  SolarAppearance seen;
  seen.sunRadius = std::asin(radii.sun.si / glm::length(sun));
  seen.moonRadius = std::asin(radii.casterUmbra.si / glm::length(moon));
  seen.penumbralMoonRadius = std::asin(radii.casterPenumbra.si / glm::length(moon));
  seen.separation = angleOf(sun, moon);
  seen.sun = horizontalOf(sun, site);
  glm::dvec3 const w = glm::normalize(sun);
  auto const angleFrom = [&](const glm::dvec3& up) {
    glm::dvec3 const north = glm::normalize(up - w * glm::dot(up, w));
    glm::dvec3 const east = glm::cross(north, w);
    double const a = std::atan2(glm::dot(moon, east), glm::dot(moon, north));
    return a < 0.0 ? a + 2.0 * M_PI : a;
  };
  seen.positionAngle = angleFrom({0.0, 0.0, 1.0});
  double const latitude = site.latitude / radian, longitude = site.longitude / radian;
  seen.zenithAngle = angleFrom({std::cos(latitude) * std::cos(longitude),
                                std::cos(latitude) * std::sin(longitude), std::sin(latitude)});
  return seen;
}

double greatestSeconds(const SunMoonTrack& track, const ShadowRadii& radii) {
  auto const distanceSquared = [&](double t) {
    auto const pair = track.shadowAt(t, radii);
    return glm::dot(pair.foot, pair.foot);
  };
  return minimumNear(distanceSquared, 0.0, 1800.0, 60.0);
}

std::optional<SolarEclipse> solarEclipse(const SunMoonTrack& track, const ShadowRadii& radii) {
  double const greatest = greatestSeconds(track, radii);
  auto const shadow = [&](double t) { return track.shadowAt(t, radii); };
  auto const penumbra = [&](double t) { return penumbraClearance(shadow(t)).metres; };
  auto const umbra = [&](double t) { return umbraClearance(shadow(t)).metres; };
  auto const axis = [&](double t) { return axisClearance(shadow(t)).metres; };

  auto const pair = shadow(greatest);
  double const speed =
      glm::length(shadow(greatest + 60.0).foot - shadow(greatest - 60.0).foot) / 120.0;
  double const offset = glm::length(pair.foot);
  if (offset - pair.penumbraRadius > kEarthEquatorialRadius.si) return std::nullopt;
  // Where the axis passes near the edge, the least clearance decides, a little off the greatest
  // eclipse because the Earth is flattened. Well inside it does not matter.
  auto const least = [&](auto&& clearance) {
    return minimumNear(clearance, greatest, 120.0, 20.0);
  };
  double const closest = offset > 3e6 ? least(penumbra) : greatest;
  if (penumbra(closest) >= 0.0) return std::nullopt;

  SolarEclipse e;
  e.greatest = track.instantAt(greatest);
  e.deltaT = track.deltaT();
  e.gamma = std::copysign(offset / kEarthEquatorialRadius.si, pair.foot.z);
  auto const [p1, p4] = contacts(penumbra, closest, speed);
  e.p1 = track.instantAt(p1);
  e.p4 = track.instantAt(p4);

  double const umbraClosest = offset > 3e6 ? least(umbra) : greatest;
  double const axisClosest = offset > 3e6 ? least(axis) : greatest;
  bool const touched = umbra(umbraClosest) < 0.0;
  bool const axisHits = axis(axisClosest) < 0.0;
  e.type = std::string("P");
  if (touched || axisHits) {
    auto const [u1, u4] = contacts(umbra, umbraClosest, speed);
    e.u1 = track.instantAt(u1);
    e.u4 = track.instantAt(u4);
    if (axisHits) {
      auto const [c1, c4] = contacts(axis, axisClosest, speed);
      e.c1 = track.instantAt(c1);
      e.c4 = track.instantAt(c4);
      // Umbral radius where the axis meets the ground: at both ends and between.
      bool total = false, annular = false;
      constexpr int kSamples = 16;
      for (int i = 0; i <= kSamples; ++i) {
        double const t = c1 + (c4 - c1) * i / kSamples;
        auto const there = shadow(t);
        auto const ground = axisOnEllipsoid(there);
        glm::dvec3 const point = ground ? *ground : axisClearance(there).touchPoint;
        double const radius = glsl::umbraRadiusAt(there, glsl::placeInShadow(there, point).along);
        (radius > 0.0 ? total : annular) = true;
      }
      e.type = std::string(total && annular ? "H" : (total ? "T" : "A"));
    } else {
      auto const there = shadow(umbraClosest);
      glm::dvec3 const point = umbraClearance(there).touchPoint;
      double const radius = glsl::umbraRadiusAt(there, glsl::placeInShadow(there, point).along);
      e.type = std::string(radius > 0.0 ? "Tnc" : "Anc");
    }
  }
  auto const ground = axisOnEllipsoid(pair);
  e.central = ground.has_value();
  e.place = siteOf(ground ? *ground : axisClearance(pair).touchPoint);
  e.place.height = 0.0 * metre;
  e.seen = solarAppearance(track, radii, e.place, greatest);
  e.magnitude = e.central ? e.seen.diameterRatio() : e.seen.coveredDiameter();
  e.obscuration = e.seen.coveredArea();
  if (e.central) {
    CentralPoint const point = *centralPoint(track, radii, greatest);
    e.duration = point.duration;
    if (point.left && point.right) e.width = point.width;
  }
  return e;
}

}  // namespace antumbra
