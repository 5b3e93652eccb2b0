#include "ephemeris/vsop87.h"

#include <cmath>

namespace antumbra {
namespace {

constexpr double kDaysPerMillennium = 365250.0;

// Dynamical ecliptic and equinox J2000 to FK5 equator and equinox J2000: Bretagnon & Francou 1988,
// as printed in the readme of the VSOP87 files.
const glm::dmat3 kFk5FromVsop87 =
    glm::transpose(glm::dmat3(glm::dvec3(1.000000000000, 0.000000440360, -0.000000190919),
                              glm::dvec3(-0.000000479966, 0.917482137087, -0.397776982902),
                              glm::dvec3(0.000000000000, 0.397776982902, 0.917482137087)));

}  // namespace

std::string nameOf(Planet planet) {
  constexpr const char* kNames[] = {"Mercury", "Venus",  "Earth",  "Mars",
                                    "Jupiter", "Saturn", "Uranus", "Neptune"};
  return kNames[static_cast<int>(planet)];
}

PlanetSeries planetSeries(const SeriesCatalogue& catalogue, Planet planet) {
  auto const name = nameOf(planet);
  return {catalogue.series(name, "L"), catalogue.series(name, "B"), catalogue.series(name, "R")};
}

State PlanetSeries::state(double tdbDays) const {
  double const t = tdbDays / kDaysPerMillennium;
  auto const l = longitude.evaluate(t), b = latitude.evaluate(t), r = radius.evaluate(t);
  double const cl = std::cos(l.value), sl = std::sin(l.value);
  double const cb = std::cos(b.value), sb = std::sin(b.value);
  glm::dvec3 const p(r.value * cb * cl, r.value * cb * sl, r.value * sb);
  double const planeRate = r.rate * cb - r.value * sb * b.rate;
  glm::dvec3 const v(planeRate * cl - p.y * l.rate, planeRate * sl + p.x * l.rate,
                     r.rate * sb + r.value * cb * b.rate);
  double const au = astronomicalUnit / metre;
  double const perSecond = 1.0 / (kDaysPerMillennium * 86400.0);
  return {{au * (kFk5FromVsop87 * p)}, {au * perSecond * (kFk5FromVsop87 * v)}};
}

glm::dvec3 PlanetSeries::positionMetres(double tdbDays) const {
  double const t = tdbDays / kDaysPerMillennium;
  double const l = longitude.value(t), b = latitude.value(t), r = radius.value(t);
  glm::dvec3 const p(std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b));
  return astronomicalUnit.si * r * (kFk5FromVsop87 * p);
}

}  // namespace antumbra
