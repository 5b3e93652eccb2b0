#include "eclipse/jovian.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ephemeris/apparent.h"
#include "frame/body_rotation.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

// Archinal et al. 2018 (IAU WGCCRE 2015), table 4: Jupiter at 1 bar.
constexpr double kEquatorialMetres = 71492e3, kPolarMetres = 66854e3;

struct GalileanMoon {
  BodyId body;
  double periodDays;  // sidereal: Explanatory Supplement, 3rd edition, table 10.3
};
constexpr std::array<GalileanMoon, 4> kMoons{{{BodyId::Io, 1.769137786},
                                              {BodyId::Europa, 3.551181041},
                                              {BodyId::Ganymede, 7.15455296},
                                              {BodyId::Callisto, 16.6890184}}};

// The line from the Sun through a moon, in axes whose z is Jupiter's pole and in which the planet
// is stretched to a sphere of its equatorial radius.
struct SunLine {
  double distance = 0.0;  // of the line from the centre, m
  double phase = 0.0;  // rad, of the moon about the pole from the Sun's direction, in half a turn
};

class JovianSky {
 public:
  JovianSky(const Ephemeris& ephemeris, BodyId moon, Instant near)
      : ephemeris_(ephemeris),
        moon_(moon),
        axes_(bodyFixedFromIcrs(bodyRotation("Jupiter"), near).matrix),
        near_(near) {}

  SunLine at(double seconds) const {
    std::array<BodyId, 2> const bodies{BodyId::Sun, moon_};
    Instant const t = near_ + seconds * second;
    auto const places =
        apparentPlaces(ephemeris_, bodies, observerAt(ephemeris_, BodyId::Jupiter, t), t);
    glm::dvec3 const stretch(1.0, 1.0, kEquatorialMetres / kPolarMetres);
    glm::dvec3 const sun = axes_ * places[0].displacement.m * stretch;
    glm::dvec3 const moon = axes_ * places[1].displacement.m * stretch;
    glm::dvec3 const ray = glm::normalize(moon - sun);
    SunLine line;
    line.distance = glm::length(glm::cross(moon, ray));
    line.phase = std::remainder(std::atan2(moon.y, moon.x) - std::atan2(sun.y, sun.x), 2.0 * M_PI);
    return line;
  }

 private:
  const Ephemeris& ephemeris_;
  BodyId moon_;
  glm::dmat3 axes_;  // fixed over an event: only the pole matters
  Instant near_;
};

// The event about the moon's conjunction with the Sun (shadow) or opposition to it near `about`.
std::optional<JovianEvent> eventNear(const EclipseBasis& basis, const GalileanMoon& moon,
                                     Instant about, bool shadow) {
  JovianSky const sky(*basis.ephemeris, moon.body, about);
  double const rate = 2.0 * M_PI / (moon.periodDays * 86400.0);
  double const target = shadow ? 0.0 : M_PI;
  double middle = 0.0;
  for (int i = 0; i < 5; ++i) {
    double const step = std::remainder(target - sky.at(middle).phase, 2.0 * M_PI) / rate;
    middle += step;
    if (std::fabs(step) < 1.0) break;
  }
  auto const squared = [&](double t) {
    double const d = sky.at(t).distance / kEquatorialMetres;
    return d * d - 1.0;
  };
  double const step = 0.02 / rate;
  middle = minimumNear(squared, middle, step, step);
  double const least = squared(middle);
  if (least >= 0.0) return std::nullopt;
  double const curvature =
      (squared(middle + step) - 2.0 * least + squared(middle - step)) / (2.0 * step * step);
  double const half = std::sqrt(-least / curvature);
  JovianEvent e;
  e.moon = moon.body;
  e.shadowOnJupiter = shadow;
  e.begin = about + rootNear(squared, middle - half, middle - 0.98 * half) * second;
  e.end = about + rootNear(squared, middle + half, middle + 0.98 * half) * second;
  e.middle = about + middle * second;
  e.leastDistance = std::sqrt(least + 1.0);
  // Light from Jupiter at the middle to the Earth at its arrival.
  auto const barycentric = [&](BodyId body, Instant t) {
    return basis.ephemeris->state(body, BodyId::SolarSystemBarycentre, t).position.m;
  };
  glm::dvec3 const jupiter = barycentric(BodyId::Jupiter, e.middle);
  e.lightTime = 2600.0 * second;
  for (int i = 0; i < 4; ++i)
    e.lightTime =
        Duration(glm::length(barycentric(BodyId::Earth, e.middle + e.lightTime) - jupiter) /
                 kSpeedOfLight.si);
  e.deltaT = basis.deltaTAt(e.seen(e.middle));
  return e;
}

void countShadows(std::vector<JovianEvent>& events) {
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!events[i].shadowOnJupiter) continue;
    auto const covers = [&](const JovianEvent& e, Instant t) {
      return e.shadowOnJupiter && e.begin <= t && t < e.end;
    };
    // The number on the planet changes only where a shadow enters.
    std::vector<Instant> moments{events[i].begin};
    std::size_t const from = i < 12 ? 0 : i - 12, to = std::min(events.size(), i + 13);
    for (std::size_t k = from; k < to; ++k)
      if (covers(events[i], events[k].begin)) moments.push_back(events[k].begin);
    for (Instant const t : moments) {
      int count = 0;
      for (std::size_t k = from; k < to; ++k) count += covers(events[k], t);
      events[i].shadowsAtOnce = std::max(events[i].shadowsAtOnce, count);
    }
  }
}

}  // namespace

std::vector<JovianEvent> jovianEvents(const EclipseBasis& basis, Instant from, Instant to,
                                      const Progress& progress) {
  std::vector<JovianEvent> events;
  double done = 0.0;
  for (auto const& moon : kMoons) {
    // Light takes 33 to 54 minutes; a revolution more on both sides, cut off afterwards. Steps of
    // the period as seen from the Sun, each starting where the last event was.
    double const synodic = 1.0 / (1.0 / moon.periodDays - 1.0 / 4332.589);
    for (bool const shadow : {true, false}) {
      // An hour in, for what is seen at the very start of a theory has left the moons before it.
      JovianSky const sky(*basis.ephemeris, moon.body, from + 1.0 * hour);
      double const phase = std::remainder((shadow ? 0.0 : M_PI) - sky.at(0.0).phase, 2.0 * M_PI);
      Instant t = from + (phase / (2.0 * M_PI) - 1.0) * synodic * day;
      for (; t < to + synodic * day; t = t + synodic * day) {
        std::optional<JovianEvent> event;
        try {
          event = eventNear(basis, moon, t, shadow);
        } catch (const SpanError&) {
          // Steps reach a revolution beyond what is asked for; the moons' theory may end there.
          if (t > from + 1.0 * day && t < to - 1.0 * day) throw;
        }
        if (progress) progress(std::min(done + 0.125 * ((t - from) / (to - from)), 1.0));
        if (!event) continue;
        t = event->middle;
        Instant const seen = event->seen(event->middle);
        if (seen < from || seen >= to) continue;
        event->id = dateOf(seen) + "-" + nameOf(moon.body) + (shadow ? "-shadow" : "-eclipse");
        events.push_back(*event);
      }
      done += 0.125;
    }
  }
  if (progress) progress(1.0);
  std::sort(events.begin(), events.end(),
            [](const JovianEvent& a, const JovianEvent& b) { return a.middle < b.middle; });
  countShadows(events);
  return events;
}

}  // namespace antumbra
