// The few-hour polynomials of Sun and Moon against the ephemeris they were fitted to.
#include "eclipse/sun_moon_track.h"

#include <gtest/gtest.h>

#include "ephemeris/apparent.h"

namespace antumbra {
namespace {

TEST(SunMoonTrack, StaysWithinAMetreOfTheEphemeris) {
  auto const& ephemeris = Ephemeris::standard();
  // Perigee and apogee, and a date outside the table of the present.
  for (double jd : {2461619.92, 2460232.25, 1700000.4}) {
    Instant const middle = Instant::fromTt({jd, 0.0});
    SunMoonTrack const track(ephemeris, middle, 4.0 * hour, 70.0 * second);
    auto const equator = trueEquatorOfDateFromIcrs(middle);
    std::array<BodyId, 2> const bodies{BodyId::Sun, BodyId::Moon};
    for (double hours : {-3.9, -2.7, -1.1, 0.0, 0.6, 2.2, 3.6}) {
      Instant const t = middle + hours * hour;
      auto const places =
          apparentPlaces(ephemeris, bodies, observerAt(ephemeris, BodyId::Earth, t), t);
      auto const found = track.celestialAt(3600.0 * hours);
      EXPECT_LT(glm::length(found.moon - equator(places[1].displacement).m), 1.0)
          << jd << " " << hours;
      // The Sun's direction moves the shadow by 1/390 of what it moves the Sun.
      EXPECT_LT(glm::length(found.sun - equator(places[0].displacement).m), 200.0);
    }
  }
}

TEST(SunMoonTrack, TurnsWithTheEarth) {
  // The pole held fixed: at most 1.5 m on the ground over four hours.
  Instant const middle = Instant::fromTt({2461619.92, 0.0});
  Duration const deltaT = 70.0 * second;
  SunMoonTrack const track(Ephemeris::standard(), middle, 4.0 * hour, deltaT);
  for (double hours : {-3.5, 0.0, 3.5}) {
    Instant const t = middle + hours * hour;
    auto const exact = itrsFromIcrs(t, DeltaT::fixed(deltaT));
    auto const equator = trueEquatorOfDateFromIcrs(middle);
    auto const places = track.placesAt(3600.0 * hours);
    auto const celestial = track.celestialAt(3600.0 * hours);
    glm::dvec3 const turned =
        exact(equator.inverse()(Displacement<TrueEquatorOfDate>{celestial.moon})).m;
    double const angle = glm::length(turned - places.moon) / glm::length(turned);
    EXPECT_LT(angle * 6.378e6, 1.5) << hours;
  }
}

}  // namespace
}  // namespace antumbra
