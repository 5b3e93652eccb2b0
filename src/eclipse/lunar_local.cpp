// Where the Moon stands at the contacts of a lunar eclipse.
#include "eclipse/lunar_local.h"

#include <algorithm>
#include <cmath>

#include "eclipse/horizon_crossings.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

constexpr Angle kHorizontalRefraction = 34.0 * arcminute;  // mean, at the horizon: the almanacs'

glm::dvec3 moonFrom(const SunMoonTrack& track, const Site& site, double seconds) {
  return track.placesAt(seconds).moon - itrsMetres(site);
}

}  // namespace

LunarLocalCircumstances lunarLocalCircumstances(const LunarEvent& event, const EclipseBasis& basis,
                                                const Site& site) {
  SunMoonTrack const& track = event.track;
  LunarEclipse const& e = event.eclipse;
  LunarLocalCircumstances local;
  std::array<std::optional<Instant>, 7> const instants{e.p1, e.u1, e.u2, e.greatest,
                                                       e.u3, e.u4, e.p4};
  bool allUp = true;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    if (!instants[i]) continue;
    LunarContact contact;
    contact.instant = *instants[i];
    contact.moon = horizontalOf(moonFrom(track, site, track.secondsAt(*instants[i])), site);
    contact.aboveHorizon = contact.moon.altitude > 0.0 * degree;
    allUp = allUp && contact.aboveHorizon;
    local.contacts[i] = contact;
  }
  double const moonRadius = basis.convention.lunarKPenumbra * kEarthEquatorialRadius.si;
  auto const horizon = horizonCrossings(
      [&](double t) {
        glm::dvec3 const moon = moonFrom(track, site, t);
        double const semidiameter = std::asin(moonRadius / glm::length(moon));
        return (horizontalOf(moon, site).altitude + kHorizontalRefraction) / radian + semidiameter;
      },
      track.secondsAt(*e.p1), track.secondsAt(*e.p4));
  for (auto const& c : horizon.crossings)
    local.horizonEvents.push_back(
        {c.rises ? "moonrise" : "moonset", track.instantAt(c.seconds),
         lunarShadow(track, basis.convention, basis.enlargement, c.seconds).umbralMagnitude()});
  local.visibility = horizon.visibility(allUp);
  return local;
}

}  // namespace antumbra
