#include "eclipse/transit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace antumbra {
namespace {

struct InferiorPlanet {
  BodyId body;
  // Mean inferior conjunctions: Meeus, Astronomical Algorithms (2nd edition), table 36.A.
  double firstJulianDate, synodicDays;
  double yearDays;  // sidereal period: Explanatory Supplement, 3rd edition, table 8.7
  Length radius;    // Archinal et al. 2018 (IAU WGCCRE 2015), table 4
};
constexpr std::array<InferiorPlanet, 2> kPlanetsInside{
    {{BodyId::Mercury, 2451612.023, 115.8774771, 87.9693, 2439.4 * kilometre},
     {BodyId::Venus, 2451996.706, 583.921361, 224.7008, 6051.8 * kilometre}}};

// Heliocentric longitude of the planet less that of the Earth, reduced to half a turn; and the sine
// of the planet's geocentric latitude at conjunction, roughly.
struct Alignment {
  double longitude, latitude;
};
Alignment alignmentAt(const Ephemeris& ephemeris, BodyId planet, Instant t) {
  static auto const ecliptic = eclipticJ2000FromIcrs();
  glm::dvec3 const p = ecliptic(ephemeris.state(planet, BodyId::Sun, t).position).m;
  glm::dvec3 const e = ecliptic(ephemeris.state(BodyId::Earth, BodyId::Sun, t).position).m;
  glm::dvec3 const seen = p - e;
  glm::dvec3 const sun = -e;
  double const cross = glm::length(glm::cross(glm::normalize(seen), glm::normalize(sun)));
  return {std::remainder(std::atan2(p.y, p.x) - std::atan2(e.y, e.x), 2.0 * M_PI), cross};
}

std::optional<Transit> transitAt(const EclipseBasis& basis, const InferiorPlanet& planet,
                                 Instant about) {
  // To the conjunction in longitude, by the mean relative motion and then the true one.
  double const rate = 2.0 * M_PI * (1.0 / planet.yearDays - 1.0 / 365.25636);
  Instant t = about;
  Alignment at = alignmentAt(*basis.ephemeris, planet.body, t);
  double speed = rate;
  for (int i = 0; i < 12 && std::fabs(at.longitude) > 1e-5; ++i) {
    Instant const next = t + std::clamp(-at.longitude / speed, -8.0, 8.0) * day;
    Alignment const there = alignmentAt(*basis.ephemeris, planet.body, next);
    double const found = (there.longitude - at.longitude) / ((next - t) / day);
    if (found > 0.3 * rate && found < 3.0 * rate) speed = found;
    t = next;
    at = there;
  }
  // The Sun's radius is 0.27 degrees; the least separation comes some hours from conjunction.
  if (at.latitude > std::sin(0.6 * M_PI / 180.0)) return std::nullopt;
  SunMoonTrack const track(*basis.ephemeris, t, 14.0 * hour, basis.deltaTAt(t), planet.body);
  double const solarRadius = basis.convention.sunRadius.si;
  struct Discs {
    double separation, sun, planet;
  };
  auto const discs = [&](double seconds) {
    auto const places = track.celestialAt(seconds);
    return Discs{std::atan2(glm::length(glm::cross(places.sun, places.moon)),
                            glm::dot(places.sun, places.moon)),
                 std::asin(solarRadius / glm::length(places.sun)),
                 std::asin(planet.radius.si / glm::length(places.moon))};
  };
  auto const squared = [&](double seconds) {
    double const s = discs(seconds).separation;
    return 1e8 * s * s;
  };
  double const greatest = minimumNear(squared, 0.0, 7200.0, 120.0);
  if (std::fabs(greatest) > 9.0 * 3600.0) return std::nullopt;
  Discs const least = discs(greatest);
  if (least.separation >= least.sun + least.planet) return std::nullopt;
  Transit transit;
  transit.planet = planet.body;
  transit.greatest = track.instantAt(greatest);
  transit.id = dateOf(transit.greatest);
  transit.deltaT = track.deltaT();
  transit.separation = Angle(least.separation);
  transit.sunRadius = Angle(least.sun);
  transit.planetRadius = Angle(least.planet);
  auto const places = track.celestialAt(greatest);
  glm::dvec3 const w = glm::normalize(places.sun);
  glm::dvec3 const north = glm::normalize(glm::dvec3(0.0, 0.0, 1.0) - w * w.z);
  double const angle =
      std::atan2(glm::dot(places.moon, glm::cross(north, w)), glm::dot(places.moon, north));
  transit.positionAngle = angle < 0.0 ? angle + 2.0 * M_PI : angle;
  double const curvature =
      (squared(greatest + 3600.0) - 2.0 * squared(greatest) + squared(greatest - 3600.0)) /
      (2.0 * 3600.0 * 3600.0 * 1e8);
  auto const contacts = [&](double sign, std::optional<Instant>& first,
                            std::optional<Instant>& last) {
    auto const edge = [&](double seconds) {
      Discs const d = discs(seconds);
      double const reach = d.sun + sign * d.planet;
      return d.separation * d.separation - reach * reach;
    };
    double const depth = -edge(greatest);
    if (depth <= 0.0) return;
    double const half = std::sqrt(depth / curvature);
    first = track.instantAt(rootNear(edge, greatest - half, greatest - 0.98 * half));
    last = track.instantAt(rootNear(edge, greatest + half, greatest + 0.98 * half));
  };
  contacts(1.0, transit.i, transit.iv);
  contacts(-1.0, transit.ii, transit.iii);
  return transit;
}

}  // namespace

std::vector<Transit> transits(const EclipseBasis& basis, Instant from, Instant to,
                              const Progress& progress) {
  std::vector<Transit> found;
  double done = 0.0;
  for (auto const& planet : kPlanetsInside) {
    auto const countAt = [&](Instant t) {
      return (t - Instant::fromTt({2451545.0, planet.firstJulianDate - 2451545.0})) / day /
             planet.synodicDays;
    };
    // True conjunctions stray some days from the mean ones.
    double const first = std::ceil(countAt(from) - 0.15), last = std::floor(countAt(to) + 0.15);
    for (double k = first; k <= last; k += 1.0) {
      Instant const mean =
          Instant::fromTt({2451545.0, planet.firstJulianDate - 2451545.0 + k * planet.synodicDays});
      auto const transit = transitAt(basis, planet, mean);
      if (transit && transit->greatest >= from && transit->greatest < to) found.push_back(*transit);
      if (progress) progress(done + 0.5 * (k - first + 1.0) / (last - first + 1.0));
    }
    done += 0.5;
  }
  std::sort(found.begin(), found.end(),
            [](const Transit& a, const Transit& b) { return a.greatest < b.greatest; });
  for (std::size_t n = 1; n < found.size(); ++n)
    if (found[n].id == found[n - 1].id) found[n].id += "b";
  return found;
}

}  // namespace antumbra
