// The Moon in the Earth's shadow.
#include "eclipse/lunar_circumstances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/input_error.h"
#include "eclipse/solar_circumstances.h"
#include "quantity/constants.h"

namespace antumbra {

ShadowEnlargement parseShadowEnlargement(const std::string& name, const std::string& where) {
  if (name == "danjon") return ShadowEnlargement::Danjon;
  if (name == "chauvenet") return ShadowEnlargement::Chauvenet;
  if (name == "none") return ShadowEnlargement::None;
  throw InputError(fmt::format(
      "{}: found the shadow enlargement \"{}\"; allowed: danjon, chauvenet, none", where, name));
}

std::string nameOf(ShadowEnlargement rule) {
  if (rule == ShadowEnlargement::Danjon) return "danjon";
  return rule == ShadowEnlargement::Chauvenet ? "chauvenet" : "none";
}

LunarShadow lunarShadow(const SunMoonTrack& track, const ShadowConvention& convention,
                        ShadowEnlargement rule, double seconds) {
  auto const places = track.celestialAt(seconds);
  double const earth = kEarthEquatorialRadius.si;
  double const moonDistance = glm::length(places.moon), sunDistance = glm::length(places.sun);
  double const parallax = std::asin(earth / moonDistance);
  double const solarParallax = std::asin(earth / sunDistance);
  double const semidiameter = std::asin(convention.sunRadius.si / sunDistance);
  LunarShadow shadow;
  glm::dvec3 const axis = -places.sun;
  shadow.separation =
      std::atan2(glm::length(glm::cross(places.moon, axis)), glm::dot(places.moon, axis));
  shadow.moonRadius = std::asin(convention.lunarKPenumbra * earth / moonDistance);
  double mean = parallax + solarParallax, scale = 1.0;
  if (rule == ShadowEnlargement::Danjon) mean = 1.01 * parallax + solarParallax;
  if (rule == ShadowEnlargement::Chauvenet) {
    mean = 0.998340 * parallax + solarParallax;
    scale = 1.02;
  }
  shadow.umbraRadius = scale * (mean - semidiameter);
  shadow.penumbraRadius = scale * (mean + semidiameter);
  return shadow;
}

std::optional<LunarEclipse> lunarEclipse(const SunMoonTrack& track,
                                         const ShadowConvention& convention,
                                         ShadowEnlargement rule) {
  auto const shadow = [&](double t) { return lunarShadow(track, convention, rule, t); };
  auto const squared = [&](double t) {
    double const s = shadow(t).separation;
    return s * s * 1e8;
  };
  double const greatest = minimumNear(squared, 0.0, 1800.0, 60.0);
  LunarShadow const least = shadow(greatest);
  if (least.penumbralMagnitude() <= 0.0) return std::nullopt;
  LunarEclipse e;
  e.greatest = track.instantAt(greatest);
  e.deltaT = track.deltaT();
  auto const places = track.celestialAt(greatest);
  // Positive where the Moon passes north of the axis.
  glm::dvec3 const across = places.moon - places.sun * (glm::dot(places.moon, places.sun) /
                                                        glm::dot(places.sun, places.sun));
  e.gamma = std::copysign(glm::length(across) / kEarthEquatorialRadius.si, across.z);
  e.umbralMagnitude = least.umbralMagnitude();
  e.penumbralMagnitude = least.penumbralMagnitude();
  double const rate =
      std::sqrt(std::max(squared(greatest + 600.0) - squared(greatest), 0.0) / 1e8) / 600.0;
  // Contacts: the separation equals a sum or difference of radii.
  auto const pair = [&](auto&& reach) -> std::pair<std::optional<Instant>, std::optional<Instant>> {
    if (reach(least) <= least.separation) return {};
    auto const edge = [&](double t) {
      LunarShadow const s = shadow(t);
      return s.separation * s.separation - reach(s) * reach(s);
    };
    double const half =
        std::sqrt(reach(least) * reach(least) - least.separation * least.separation) / rate;
    return {track.instantAt(rootNear(edge, greatest - half, greatest - 0.98 * half)),
            track.instantAt(rootNear(edge, greatest + half, greatest + 0.98 * half))};
  };
  std::tie(e.p1, e.p4) = pair([](const LunarShadow& s) { return s.penumbraRadius + s.moonRadius; });
  std::tie(e.u1, e.u4) = pair([](const LunarShadow& s) { return s.umbraRadius + s.moonRadius; });
  std::tie(e.u2, e.u3) = pair([](const LunarShadow& s) { return s.umbraRadius - s.moonRadius; });
  e.type = std::string(e.u2 ? "T" : (e.u1 ? "P" : "N"));
  return e;
}

}  // namespace antumbra
