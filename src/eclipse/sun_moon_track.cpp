// Chebyshev fit of apparent places through the nodes of the first kind.
#include "eclipse/sun_moon_track.h"

#include <cmath>

#include "eclipse/shadow_pair.h"
#include "ephemeris/apparent.h"

namespace antumbra {
namespace {

// Turns per day of UT1: IERS Conventions 2010, equation 5.15. UT1 runs with TT over a few hours.
constexpr double kEarthTurnsPerDay = 1.00273781191135448;

}  // namespace

SunMoonTrack::SunMoonTrack(const Ephemeris& ephemeris, Instant middle, Duration halfSpan,
                           Duration deltaT, BodyId occulter)
    : middle_(middle), halfSpan_(halfSpan), deltaT_(deltaT) {
  auto const equator = trueEquatorOfDateFromIcrs(middle);
  siderealTime_ = greenwichApparentSiderealTime(middle, DeltaT::fixed(deltaT)) / radian;
  std::array<BodyId, 2> const bodies{BodyId::Sun, occulter};
  std::array<std::array<double, 6>, kNodes> values{};
  for (int node = 0; node < kNodes; ++node) {
    double const x = std::cos(M_PI * (node + 0.5) / kNodes);
    Instant const t = middle + x * halfSpan;
    auto const places =
        apparentPlaces(ephemeris, bodies, observerAt(ephemeris, BodyId::Earth, t), t);
    for (std::size_t body = 0; body < 2; ++body) {
      glm::dvec3 const v = equator(places[body].displacement).m;
      for (int k = 0; k < 3; ++k)
        values[static_cast<std::size_t>(node)][3 * body + static_cast<std::size_t>(k)] = v[k];
    }
  }
  for (int degree = 0; degree < kNodes; ++degree) {
    auto& row = coefficients_[static_cast<std::size_t>(degree)];
    for (int node = 0; node < kNodes; ++node) {
      double const weight =
          (degree == 0 ? 1.0 : 2.0) / kNodes * std::cos(M_PI * degree * (node + 0.5) / kNodes);
      for (std::size_t k = 0; k < 6; ++k)
        row[k] += weight * values[static_cast<std::size_t>(node)][k];
    }
  }
}

SunMoonTrack::Places SunMoonTrack::celestialAt(double seconds) const {
  double const x = seconds / (halfSpan_ / second);
  std::array<double, 6> next{}, afterNext{};
  for (int degree = kNodes - 1; degree > 0; --degree) {
    auto const& row = coefficients_[static_cast<std::size_t>(degree)];
    for (std::size_t k = 0; k < 6; ++k) {
      double const value = row[k] + 2.0 * x * next[k] - afterNext[k];
      afterNext[k] = next[k];
      next[k] = value;
    }
  }
  std::array<double, 6> v{};
  for (std::size_t k = 0; k < 6; ++k) v[k] = coefficients_[0][k] + x * next[k] - afterNext[k];
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

double SunMoonTrack::siderealTimeAt(double seconds) const {
  return siderealTime_ + 2.0 * M_PI * kEarthTurnsPerDay * seconds / 86400.0;
}

SunMoonTrack::Places SunMoonTrack::placesAt(double seconds) const {
  Places const celestial = celestialAt(seconds);
  double const angle = siderealTimeAt(seconds);
  double const c = std::cos(angle), s = std::sin(angle);
  auto const turned = [&](const glm::dvec3& v) {
    return glm::dvec3(c * v.x + s * v.y, c * v.y - s * v.x, v.z);
  };
  return {turned(celestial.sun), turned(celestial.moon)};
}

glsl::ShadowPair SunMoonTrack::shadowAt(double seconds, const ShadowRadii& radii) const {
  Places const places = placesAt(seconds);
  return shadowPairMetres(places.sun, places.moon, radii);
}

}  // namespace antumbra
