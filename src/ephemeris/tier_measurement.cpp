#include "ephemeris/tier_measurement.h"

#include <cmath>
#include <memory>
#include <random>

#include "document/paths.h"

namespace antumbra {
namespace {

const SeriesCatalogue& planetCatalogue() {
  static const SeriesCatalogue catalogue(catalogsFolder() / "ephemeris" / "vsop87b.bin");
  return catalogue;
}
const SeriesCatalogue& moonCatalogue() {
  static const SeriesCatalogue catalogue(catalogsFolder() / "ephemeris" / "elpmpp02.bin");
  return catalogue;
}

std::optional<Planet> planetNamed(const std::string& name) {
  for (int i = 0; i < kPlanets; ++i)
    if (nameOf(static_cast<Planet>(i)) == name) return static_cast<Planet>(i);
  return std::nullopt;
}

double angle(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

const std::vector<std::string>& tierBodies() {
  static const std::vector<std::string> bodies{"Sun",     "Moon",   "Mercury", "Venus",  "Mars",
                                               "Jupiter", "Saturn", "Uranus",  "Neptune"};
  return bodies;
}

TierMeasurer::TierMeasurer(std::string body, TierSpan span, std::size_t dates, std::uint64_t seed)
    : body_(std::move(body)), span_(span) {
  std::mt19937_64 generator(seed);
  double const first = span == TierSpan::NearPresent ? -36525.0 : -5000.0 * 365.25;
  double const last = span == TierSpan::NearPresent ? 36525.0 : 1000.0 * 365.25;
  for (std::size_t i = 0; i < dates; ++i)
    days_.push_back(first + (last - first) * (static_cast<double>(generator() >> 11) * 0x1p-53));
  if (body_ == "Moon") {
    auto const moon = moonSeries(moonCatalogue());
    for (double d : days_) target_.push_back(moon.state(d).position.m);
    return;
  }
  auto const earth = planetSeries(planetCatalogue(), Planet::Earth);
  for (double d : days_) earth_.push_back(earth.positionMetres(d));
  if (auto const planet = planetNamed(body_)) {
    auto const series = planetSeries(planetCatalogue(), *planet);
    for (double d : days_) target_.push_back(series.positionMetres(d));
  }
}

TierMeasurement TierMeasurer::measure(double threshold) const {
  TierMeasurement m;
  double worst = 0.0, worstHeliocentric = 0.0, squares = 0.0;
  auto const note = [&](double geocentric) {
    worst = std::max(worst, geocentric);
    squares += geocentric * geocentric;
  };
  if (body_ == "Moon") {
    auto moon = moonSeries(moonCatalogue());
    m.droppedSum = truncate(moon, threshold, span_);
    m.terms = moon.terms();
    for (std::size_t i = 0; i < days_.size(); ++i)
      note(angle(moon.state(days_[i]).position.m, target_[i]));
  } else {
    auto earth = planetSeries(planetCatalogue(), Planet::Earth);
    m.droppedSum = truncate(earth, Planet::Earth, threshold, span_);
    m.earthTerms = m.terms = earth.terms();
    PlanetSeries target;
    auto const planet = planetNamed(body_);
    if (planet) {
      target = planetSeries(planetCatalogue(), *planet);
      m.droppedSum = truncate(target, *planet, threshold, span_);
      m.terms = target.terms();
    }
    for (std::size_t i = 0; i < days_.size(); ++i) {
      auto const e = earth.positionMetres(days_[i]);
      auto const p = planet ? target.positionMetres(days_[i]) : glm::dvec3(0.0);
      auto const full = planet ? target_[i] : glm::dvec3(0.0);
      note(angle(p - e, full - earth_[i]));
      if (planet) worstHeliocentric = std::max(worstHeliocentric, angle(p, full));
    }
  }
  m.geocentricMax = worst * radian;
  m.heliocentricMax = worstHeliocentric * radian;
  m.geocentricRms = std::sqrt(squares / static_cast<double>(days_.size())) * radian;
  return m;
}

}  // namespace antumbra
