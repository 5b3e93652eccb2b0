#include "scene/apparent_stars.h"

#include <cmath>

#include "photometry/magnitude.h"
#include "quantity/constants.h"

namespace antumbra {

std::vector<ApparentStar> apparentStars(const StarCatalogue& catalogue, Instant when,
                                        Velocity<Icrs> observer, double limitingMagnitude) {
  std::vector<ApparentStar> seen;
  glm::dvec3 const beta = observer.m / kSpeedOfLight.si;
  double const inverseGamma = std::sqrt(1.0 - glm::dot(beta, beta));
  std::size_t const count = catalogue.countBrighterThan(limitingMagnitude);
  seen.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Star& star = catalogue.stars[i];
    glm::dvec3 const d = directionAt(star, when).u;
    // Addition of velocities for light (Urban & Seidelmann 2013, eq. 7.40).
    double const along = glm::dot(d, beta);
    glm::dvec3 const moved =
        (inverseGamma * d + (1.0 + along / (1.0 + inverseGamma)) * beta) / (1.0 + along);
    seen.push_back({{glm::normalize(moved)},
                    illuminanceLuxOfMagnitude(star.magnitudeV),
                    star.colorBv.value_or(0.6)});
  }
  return seen;
}

}  // namespace antumbra
