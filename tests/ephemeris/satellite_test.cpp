// Moons of the planets against JPL, and their rotation against their orbits.
#include "ephemeris/satellite_series.h"

#include <gtest/gtest.h>

#include "document/paths.h"
#include "ephemeris/apparent.h"
#include "frame/body_rotation.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

double barKilometres(const std::string& moon) {
  static const std::map<std::string, double> bars{
      {"Phobos", 20},    {"Deimos", 20}, {"Io", 150},        {"Europa", 150}, {"Ganymede", 150},
      {"Callisto", 150}, {"Titan", 100}, {"Hyperion", 1000}, {"Triton", 200}};
  auto const found = bars.find(moon);
  return found == bars.end() ? 300.0 : found->second;
}

TEST(Satellites, PlacesAgreeWithJplWithinTheirSpans) {
  auto const& e = Ephemeris::standard();
  std::map<std::string, int> rows;
  for (const auto& row : readCsv("tests/authorities/moons_planetocentric.csv")) {
    auto const name = row.text("moon");
    auto const t = Instant::fromTdb({row.number("jd_tdb"), 0.0});
    glm::dvec3 const truth(row.number("x_km"), row.number("y_km"), row.number("z_km"));
    auto const planet = *bodyFromName(row.text("planet"));
    if (name.find("center_minus") != std::string::npos) {
      auto const s = e.state(planet, systemOf(planet), t);
      EXPECT_LT(glm::length(s.position.m / 1e3 - truth), 5.0) << name;  // 0.002" at Jupiter
      continue;
    }
    auto const moon = bodyFromName(name);
    if (!moon) continue;  // Nereid has no series
    State s;
    try {
      s = e.state(*moon, planet, t);
    } catch (const SpanError&) {
      continue;
    }
    EXPECT_LT(glm::length(s.position.m / 1e3 - truth), barKilometres(name))
        << name << " " << t.julianYear();
    glm::dvec3 const v(row.number("vx_km_s"), row.number("vy_km_s"), row.number("vz_km_s"));
    // The residual turns with the orbit at most a few times faster than the moon itself.
    EXPECT_LT(glm::length(s.velocity.m / 1e3 - v), 0.02 * glm::length(v)) << name;
    ++rows[name];
  }
  EXPECT_EQ(rows.size(), 22u);
  for (const auto& [name, count] : rows) EXPECT_GT(count, 20) << name;
}

TEST(Satellites, ResidualsAreStoredAndBound) {
  SatelliteCatalogue const catalogue(catalogsFolder() / "ephemeris/moons.bin");
  EXPECT_EQ(catalogue.all().size(), 27u);
  for (const auto& s : catalogue.all()) {
    EXPECT_LT(s.residual / kilometre, barKilometres(s.body)) << s.body;
    EXPECT_LT(s.span().first.julianYear(), 1901.0) << s.body;
    EXPECT_GT(s.span().last.julianYear(), s.body == "Phobos" ? 2028.0 : 2045.0) << s.body;
  }
}

TEST(Satellites, OutsideTheirSpanAnErrorCarriesIt) {
  auto const& e = Ephemeris::standard();
  auto const t = parseInstant("1700-01-01T00:00 TT", "test");
  EXPECT_THROW(e.state(BodyId::Io, BodyId::Jupiter, t), SpanError);
  EXPECT_NO_THROW(e.state(BodyId::Jupiter, BodyId::Sun, t));
  EXPECT_EQ(e.state(BodyId::Jupiter, BodyId::JupiterBarycentre, t).position.m, glm::dvec3(0.0));
  // The centre's place, then: the bound says what the barycentre may be off.
  EXPECT_GT(e.errorBound(BodyId::Jupiter, BodyId::Earth, t),
            e.errorBound(BodyId::JupiterBarycentre, BodyId::Earth, t));
}

TEST(Satellites, TidallyLockedMoonsTurnOneFaceToTheirPlanet) {
  // Independent of the orbits' fit: the IAU rotation puts the planet on the prime meridian, up to
  // the eccentricity's libration (twice e, 3.3 degrees for Titan and Phobos) and the model's own
  // error.
  auto const& e = Ephemeris::standard();
  for (BodyId moon :
       {BodyId::Phobos,   BodyId::Deimos,  BodyId::Io,        BodyId::Europa,  BodyId::Ganymede,
        BodyId::Callisto, BodyId::Mimas,   BodyId::Enceladus, BodyId::Tethys,  BodyId::Dione,
        BodyId::Rhea,     BodyId::Titan,   BodyId::Iapetus,   BodyId::Miranda, BodyId::Ariel,
        BodyId::Umbriel,  BodyId::Titania, BodyId::Oberon,    BodyId::Triton,  BodyId::Proteus,
        BodyId::Charon,   BodyId::Moon}) {
    double largest = 0.0, largestLatitude = 0.0;
    for (int i = 0; i < 40; ++i) {
      auto const t = Instant::fromTt({2451545.0 + 101.7 * i, 0.3});
      auto const planet = moon == BodyId::Moon       ? BodyId::Earth
                          : moon <= BodyId::Deimos   ? BodyId::Mars
                          : moon <= BodyId::Callisto ? BodyId::Jupiter
                          : moon <= BodyId::Iapetus  ? BodyId::Saturn
                          : moon <= BodyId::Oberon   ? BodyId::Uranus
                          : moon <= BodyId::Proteus  ? BodyId::Neptune
                                                     : BodyId::Pluto;
      auto const fixed = bodyFixedFromIcrs(bodyRotation(nameOf(moon)), t);
      auto const d = directionOf(fixed(e.state(planet, moon, t).position)).u;
      largest = std::max(largest, std::fabs(std::atan2(d.y, d.x)) / degree.si);
      largestLatitude = std::max(largestLatitude, std::fabs(std::asin(d.z)) / degree.si);
    }
    // The Moon: 7.9 degrees in longitude, 6.9 in latitude (optical librations); Iapetus: e = 0.029.
    EXPECT_LT(largest, moon == BodyId::Moon ? 8.2 : 7.0) << nameOf(moon);
    EXPECT_LT(largestLatitude, moon == BodyId::Moon ? 7.0 : 2.5) << nameOf(moon);
  }
}

TEST(Satellites, LibrationOfTheMoonAsInTheTextbook) {
  // Meeus, Astronomical Algorithms (1998), example 53.a: 1992 April 12.0 TD, l = -1.23, b = +4.20
  // deg. His physical libration is Eckhardt's for the principal axes; the IAU axes are mean ones,
  // without his terms rho = -0.02245 sin F, sigma = 0.02244 cos F, which make +0.0224 deg of that
  // b.
  auto const& e = Ephemeris::standard();
  auto const t = parseInstant("1992-04-12T00:00:00 TT", "test");
  auto const seen = apparentPlace(e, BodyId::Moon, observerAt(e, BodyId::Earth, t), t);
  auto const fixed = bodyFixedFromIcrs(bodyRotation("Moon"), t - seen.lightTime);
  auto const d = directionOf(fixed(-seen.displacement)).u;
  EXPECT_NEAR(std::atan2(d.y, d.x) / degree.si, -1.23, 0.01);
  EXPECT_NEAR(std::asin(d.z) / degree.si, 4.20 - 0.0224, 0.01);
}

}  // namespace
}  // namespace antumbra
