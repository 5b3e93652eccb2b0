// Heliocentric places of the eight planets by the full VSOP87B series: P. Bretagnon & G. Francou,
// "Planetary theories in rectangular and spherical variables. VSOP87 solutions", Astron. Astrophys.
// 202, 309 (1988). Ecliptic and dynamical equinox J2000, tied to Icrs by the authors' rotation to
// FK5.
//
// Jupiter to Neptune are the barycentres of planet and moons. Against JPL DE431, 1900-2100: Sun
// 0.04", Mercury 0.07", Mars 0.26", Jupiter 0.43", Saturn 0.34", Uranus 1.5", Neptune 2.1".
#pragma once

#include "ephemeris/state.h"
#include "ephemeris/term_series.h"

namespace antumbra {

enum class Planet { Mercury, Venus, Earth, Mars, Jupiter, Saturn, Uranus, Neptune };
inline constexpr int kPlanets = 8;

// One planet's three variables, possibly truncated.
struct PlanetSeries {
  TermSeries longitude, latitude, radius;
  std::size_t terms() const { return longitude.terms() + latitude.terms() + radius.terms(); }
  // Heliocentric, from days of TDB since J2000.
  State state(double tdbDays) const;
  glm::dvec3 positionMetres(double tdbDays) const;  // position only: half the cost
};

PlanetSeries planetSeries(const SeriesCatalogue& catalogue, Planet planet);
std::string nameOf(Planet planet);

}  // namespace antumbra
