// Where the Moon stands at the contacts of a lunar eclipse: against the reduction of a topocentric
// place by its own way (light time and aberration of an eye at the site, full frames of date),
// which tests/ephemeris holds against an independent program.
#include "eclipse/lunar_local.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ephemeris/apparent.h"

namespace antumbra {
namespace {

Site siteAt(double latitude, double longitude, double height = 0.0) {
  return {latitude * degree, longitude * degree, height * metre};
}

HorizontalDirection reducedMoon(const Site& site, Instant t, Duration deltaT) {
  auto const& ephemeris = Ephemeris::standard();
  auto const delta = DeltaT::fixed(deltaT);
  auto const place =
      apparentPlace(ephemeris, BodyId::Moon, observerAt(ephemeris, site, t, delta), t);
  return horizontalFromEnu(
      enuFromItrs(site)(itrsFromIcrs(t, delta)(directionOf(place.displacement))));
}

TEST(LunarLocal, TheMoonStandsWhereAReducedPlacePutsIt) {
  EclipseBasis const basis;
  double worst = 0.0;
  int contacts = 0;
  for (const char* date : {"2025-03-14", "2026-03-03", "2028-12-31", "1982-07-06"}) {
    LunarEvent const event = lunarEventOn(basis, date, "test");
    for (Site const& site : {siteAt(47.4, 8.5, 400.0), siteAt(-33.9, 18.4),
                             siteAt(40.0, -105.3, 1650.0), siteAt(71.0, 156.0)}) {
      auto const local = lunarLocalCircumstances(event, basis, site);
      for (auto const& c : local.contacts) {
        if (!c) continue;
        auto const expected = reducedMoon(site, c->instant, event.eclipse.deltaT);
        double const turn = std::remainder((c->moon.azimuth - expected.azimuth) / degree, 360.0) *
                            cos(expected.altitude);
        worst = std::max(
            {worst, std::fabs((c->moon.altitude - expected.altitude) / degree), std::fabs(turn)});
        EXPECT_EQ(c->aboveHorizon, expected.altitude > 0.0 * degree);
        ++contacts;
      }
    }
  }
  std::printf("Moon at %d contacts: within %.5f deg\n", contacts, worst);
  EXPECT_GE(contacts, 4 * 4 * 5);
  // Diurnal aberration, 0.3", and the pole of the eclipse's middle.
  EXPECT_LT(worst, 2e-4);
}

TEST(LunarLocal, MarksWhatLiesBelowTheHorizon) {
  EclipseBasis const basis;
  LunarEvent const event = lunarEventOn(basis, "2026-03-03", "test");
  // Greatest at 11:33 UT1: the Moon is in the zenith of the Pacific, near 170 degrees west.
  auto const under = lunarLocalCircumstances(event, basis, siteAt(6.0, -170.0));
  EXPECT_EQ(under.visibility, "visible");
  EXPECT_TRUE(under.horizonEvents.empty());
  EXPECT_GT(under.contacts[3]->moon.altitude / degree, 85.0);
  auto const opposite = lunarLocalCircumstances(event, basis, siteAt(-6.0, 10.0));
  EXPECT_EQ(opposite.visibility, "below horizon");
  for (auto const& c : opposite.contacts) EXPECT_FALSE(c->aboveHorizon);
  // In Nebraska the Moon sets while it leaves the umbra.
  auto const west = lunarLocalCircumstances(event, basis, siteAt(40.0, -100.0, 300.0));
  EXPECT_EQ(west.visibility, "partly visible");
  ASSERT_EQ(west.horizonEvents.size(), 1u);
  EXPECT_EQ(west.horizonEvents[0].name, "moonset");
  EXPECT_GT(west.horizonEvents[0].instant, west.contacts[4]->instant);
  EXPECT_LT(west.horizonEvents[0].instant, west.contacts[5]->instant);
  EXPECT_GT(west.horizonEvents[0].umbralMagnitude, 0.0);
  EXPECT_LT(west.horizonEvents[0].umbralMagnitude, 1.0);
  // The upper limb on a horizon that refraction lifts by 34'.
  auto const setting =
      reducedMoon(siteAt(40.0, -100.0, 300.0), west.horizonEvents[0].instant, event.eclipse.deltaT);
  EXPECT_NEAR(setting.altitude / arcminute, -34.0 - 15.6, 1.0);  // semidiameter 14.7' to 16.8'
}

TEST(LunarLocal, APenumbralEclipseHasNoUmbralContacts) {
  EclipseBasis const basis;
  auto const local =
      lunarLocalCircumstances(lunarEventOn(basis, "2027-02-20", "test"), basis, siteAt(0.0, 0.0));
  EXPECT_TRUE(local.contacts[0] && local.contacts[3] && local.contacts[6]);
  for (std::size_t i : {1u, 2u, 4u, 5u}) EXPECT_FALSE(local.contacts[i]);
}

}  // namespace
}  // namespace antumbra
