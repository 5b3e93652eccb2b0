#include "plan/contact_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "plan/clock_face.h"

namespace antumbra {
namespace {

constexpr Length kHighestLocal = 100.0 * kilometre;

std::string placeText(const Site& site) {
  return fmt::format("{:.2f}°{} {:.2f}°{}", std::fabs(site.latitude / degree),
                     site.latitude.si >= 0.0 ? "N" : "S", std::fabs(site.longitude / degree),
                     site.longitude.si >= 0.0 ? "E" : "W");
}

std::optional<Site> siteOfClock(const Scene& scene, const PlacedScene& placed) {
  if (scene.overlays.clockSite) return scene.overlays.clockSite;
  bool const onEarth = placed.bodies[placed.anchor].body->name == "Earth";
  if (!onEarth || scene.camera.height > kHighestLocal) return std::nullopt;
  return Site{scene.camera.latitude, scene.camera.longitude, scene.camera.height};
}

// Phase at an instant, in words.
std::string phaseText(const SolarAppearance& seen) {
  double const covered = seen.coveredDiameter();
  if (covered <= 0.0) return "not eclipsed";
  if (seen.separation + seen.sunRadius < seen.moonRadius) return "total";
  std::string const share = fmt::format("{:.1f} % covered", 100.0 * seen.coveredArea());
  bool const annular = seen.separation + seen.moonRadius < seen.sunRadius;
  return annular ? "annular, " + share : share;
}

}  // namespace

ContactClock contactClock(const Scene& scene, const PlacedScene& placed,
                          const EclipseAtHand& eclipse, double textSize) {
  ContactClock clock;
  auto const& track = eclipse.event.track;
  auto const& e = eclipse.event.eclipse;
  ClockReading reading;
  if (auto const site = siteOfClock(scene, placed)) {
    auto const local = localCircumstances(eclipse.event, eclipse.radii, *site);
    reading.place = placeText(*site);
    if (local.type == "none") {
      clock.says = fmt::format("the eclipse of {} is not seen at {}", e.id, reading.place);
      return clock;
    }
    auto const entry = [](const char* name, const std::optional<LocalContact>& contact) {
      ClockEntry made{name, std::nullopt, false};
      if (contact) made.instant = contact->instant, made.below = !contact->aboveHorizon;
      return made;
    };
    reading.entries = {entry("C1", local.c1), entry("C2", local.c2), entry("max", local.maximum),
                       entry("C3", local.c3), entry("C4", local.c4)};
    double const seconds = std::clamp(track.secondsAt(placed.when), -track.halfSpan() / second,
                                      track.halfSpan() / second);
    reading.seen = solarAppearance(track, eclipse.radii, *site, seconds);
    reading.phase = phaseText(*reading.seen);
    clock.says = fmt::format("contacts of the eclipse of {} at {}", e.id, reading.place);
  } else {
    reading.place = "on Earth";
    reading.entries = {{"P1", e.p1, false},
                       {"U1", e.u1, false},
                       {"max", e.greatest, false},
                       {"U4", e.u4, false},
                       {"P4", e.p4, false}};
    bool const begun = e.p1 && placed.when >= *e.p1, over = e.p4 && placed.when > *e.p4;
    bool const central = e.u1 && e.u4 && placed.when >= *e.u1 && placed.when <= *e.u4;
    reading.phase = !begun    ? "not begun"
                    : over    ? "over"
                    : central ? "umbra on Earth"
                              : "penumbra on Earth";
    clock.says = fmt::format("contacts of the eclipse of {} with the Earth", e.id);
  }
  clock.drawing = clockFace(scene.picture, eclipse, placed.when, textSize, reading);
  return clock;
}

}  // namespace antumbra
