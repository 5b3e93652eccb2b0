#include "ephemeris/ephemeris.h"

#include <fmt/format.h>

#include "document/paths.h"
#include "ephemeris/masses.h"

namespace antumbra {
namespace {

std::filesystem::path catalogue(const char* name) { return catalogsFolder() / "ephemeris" / name; }

std::optional<Planet> planetOf(BodyId body) {
  switch (body) {
    case BodyId::Mercury:
      return Planet::Mercury;
    case BodyId::Venus:
      return Planet::Venus;
    case BodyId::Mars:
      return Planet::Mars;
    case BodyId::Jupiter:
    case BodyId::JupiterBarycentre:
      return Planet::Jupiter;
    case BodyId::Saturn:
    case BodyId::SaturnBarycentre:
      return Planet::Saturn;
    case BodyId::Uranus:
    case BodyId::UranusBarycentre:
      return Planet::Uranus;
    case BodyId::Neptune:
    case BodyId::NeptuneBarycentre:
      return Planet::Neptune;
    default:
      return std::nullopt;
  }
}

}  // namespace

const Ephemeris& Ephemeris::standard() {
  static const Ephemeris ephemeris{Options{}};
  return ephemeris;
}

Ephemeris::Ephemeris(Options options)
    : options_(options),
      planetCatalogue_(std::make_shared<SeriesCatalogue>(catalogue("vsop87b.bin"))),
      moonCatalogue_(std::make_shared<SeriesCatalogue>(catalogue("elpmpp02.bin"))),
      moon_(moonSeries(*moonCatalogue_)) {
  for (int i = 0; i < kPlanets; ++i)
    planets_[static_cast<std::size_t>(i)] = planetSeries(*planetCatalogue_, static_cast<Planet>(i));
}

Span Ephemeris::span() const {
  auto const year = [](long y) {
    return Instant::fromTt({static_cast<double>(julianDayNumber({y, 1, 1})) - 0.5, 0.0});
  };
  return {year(-3000), year(3001)};
}

State Ephemeris::sunFromBarycentre(double tdbDays) const {
  // Pluto and the asteroids are left out: 50 km, and 1e-7 m/s in the velocity.
  State sum;
  double mass = 1.0;
  for (std::size_t i = 0; i < kPlanets; ++i) {
    double const m = 1.0 / kSunOverSystemMass[i];
    State s = planets_[i].state(tdbDays);
    if (i == static_cast<std::size_t>(Planet::Earth))
      s = s + 1.0 / (1.0 + kEarthOverMoonMass) * moon_.state(tdbDays);
    sum = sum + m * s;
    mass += m;
  }
  return -1.0 / mass * sum;
}

State Ephemeris::heliocentric(BodyId body, double tdbDays) const {
  if (auto const planet = planetOf(body))
    return planets_[static_cast<std::size_t>(*planet)].state(tdbDays);
  auto const earth = [&] {
    return planets_[static_cast<std::size_t>(Planet::Earth)].state(tdbDays);
  };
  switch (body) {
    case BodyId::Earth:
      return earth();
    case BodyId::Moon:
      return earth() + moon_.state(tdbDays);
    case BodyId::EarthMoonBarycentre:
      return earth() + 1.0 / (1.0 + kEarthOverMoonMass) * moon_.state(tdbDays);
    case BodyId::SolarSystemBarycentre:
      return -1.0 * sunFromBarycentre(tdbDays);
    default:
      return {};  // the Sun
  }
}

State Ephemeris::state(BodyId target, BodyId centre, Instant t) const {
  if (!options_.extrapolate && !span().covers(t))
    throw SpanError("VSOP87 and ELP/MPP02", t, span());
  if (target == centre) return {};
  double const days = t.tdbDaysSinceJ2000();
  // The Earth and the Moon directly, so that no digits are lost to the distance of the Sun.
  auto const geocentric = [&](BodyId body) -> std::optional<State> {
    if (body == BodyId::Earth) return State{};
    if (body == BodyId::Moon) return moon_.state(days);
    if (body == BodyId::EarthMoonBarycentre)
      return 1.0 / (1.0 + kEarthOverMoonMass) * moon_.state(days);
    return std::nullopt;
  };
  if (auto const a = geocentric(target))
    if (auto const b = geocentric(centre)) return *a - *b;
  return heliocentric(target, days) - heliocentric(centre, days);
}

}  // namespace antumbra
