// The tabulated tier against JPL DE431, geometric, apparent and topocentric.
#include "ephemeris/apparent.h"
#include "ephemeris/chebyshev_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/paths.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

BodyId systemNamed(const std::string& name) {
  if (auto const barycentre = bodyFromName(name + "Barycentre")) return *barycentre;
  return *bodyFromName(name);
}
// Sun, Moon, Mercury to Saturn 0.005", Uranus to Pluto 0.02".
double bar(const std::string& name) {
  return name == "Uranus" || name == "Neptune" || name == "Pluto" ? 0.02 : 0.005;
}
Direction<TrueEquatorOfDate> fromDegrees(double ra, double dec) {
  double const a = ra * degree.si, d = dec * degree.si;
  return {{std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)}};
}

TEST(Table, ReproducesDe431) {
  Ephemeris const table({.theory = Theory::Table});
  int rows = 0;
  for (const auto& row : readCsv("tests/authorities/geocentric_geometric.csv")) {
    auto const t = Instant::fromTdb({row.number("jd_tdb"), 0.0});
    if (!Ephemeris::tableSpan().covers(t)) continue;
    auto const name = row.text("body");
    auto const s = table.state(systemNamed(name), BodyId::Earth, t);
    glm::dvec3 const truth = astronomicalUnit.si *
                             glm::dvec3(row.number("x_au"), row.number("y_au"), row.number("z_au"));
    EXPECT_LT(angleBetween(s.position, Displacement<Icrs>{truth}) / arcsecond, bar(name))
        << name << " " << row.text("jd_tdb");
    // The stored unit of each body, in parts of the distance: 1e-8.
    EXPECT_NEAR(glm::length(s.position.m) / glm::length(truth), 1.0, 2e-8) << name;
    glm::dvec3 const v =
        astronomicalUnit.si / 86400.0 *
        glm::dvec3(row.number("vx_au_d"), row.number("vy_au_d"), row.number("vz_au_d"));
    EXPECT_LT(glm::length(v - s.velocity.m), 0.02) << name;
    ++rows;
  }
  EXPECT_GT(rows, 600);
}

TEST(Table, ApparentPlacesWithin5MilliArcseconds) {
  auto const& e = Ephemeris::standard();
  int rows = 0;
  for (const auto& row : readCsv("tests/authorities/apparent_geocentric.csv")) {
    if (!row.text("epoch_id").starts_with("main")) continue;
    auto const t = Instant::fromTt({row.number("jd_tt"), 0.0});
    auto const body = systemNamed(row.text("body"));
    auto const place =
        apparentPlace(e, body, observerAt(e, BodyId::Earth, t), t, {.deflection = true});
    auto const seen = directionOf(trueEquatorOfDateFromIcrs(t)(place.displacement));
    EXPECT_LT(
        angleBetween(seen, fromDegrees(row.number("ra_deg"), row.number("dec_deg"))) / arcsecond,
        0.005)
        << row.text("body");
    // The file gives ten decimals of an au.
    EXPECT_NEAR(norm(place.retarded) / astronomicalUnit, row.number("dist_au"),
                1e-10 + 2e-8 * row.number("dist_au"));
    ++rows;
  }
  EXPECT_GT(rows, 300);
}

TEST(Table, TopocentricWithin10MilliArcseconds) {
  auto const& e = Ephemeris::standard();
  int rows = 0;
  for (const auto& row : readCsv("tests/authorities/topocentric_horizontal.csv")) {
    auto const deltaT = DeltaT::fixed(row.number("deltaT_s") * second);
    auto const t = Instant::fromUt1({row.number("jd_ut1"), 0.0}, deltaT);
    Site const site{row.number("lat_deg") * degree, row.number("lon_deg_east") * degree,
                    row.number("height_m") * metre};
    auto const place = apparentPlace(e, systemNamed(row.text("body")),
                                     observerAt(e, site, t, deltaT), t, {.deflection = true});
    auto const equatorial = directionOf(trueEquatorOfDateFromIcrs(t)(place.displacement));
    EXPECT_LT(angleBetween(equatorial,
                           fromDegrees(row.number("topo_ra_deg"), row.number("topo_dec_deg"))) /
                  arcsecond,
              0.01);
    auto const enu = directionOf(enuFromItrs(site)(itrsFromIcrs(t, deltaT)(place.displacement)));
    auto const truth = enuFromHorizontal(
        {row.number("az_deg_N0E90") * degree, row.number("alt_deg_airless") * degree});
    EXPECT_LT(angleBetween(enu, truth) / arcsecond, 0.01) << row.text("body");
    ++rows;
  }
  EXPECT_GT(rows, 400);
}

TEST(Table, HandsOverToTheSeriesOutsideItsSpanAndSaysSo) {
  auto const& e = Ephemeris::standard();
  EXPECT_EQ(e.theoryAt(parseInstant("1800-01-02T00:00 TT", "test")), Theory::Table);
  EXPECT_EQ(e.theoryAt(parseInstant("1799-12-31T00:00 TT", "test")), Theory::Series);
  EXPECT_EQ(e.theoryAt(parseInstant("2399-12-31T00:00 TT", "test")), Theory::Table);
  EXPECT_EQ(e.theoryAt(parseInstant("2400-01-02T00:00 TT", "test")), Theory::Series);
  Ephemeris const table({.theory = Theory::Table});
  auto const early = parseInstant("1700-01-01T00:00 TT", "test");
  EXPECT_THROW(table.state(BodyId::Mars, BodyId::Sun, early), SpanError);
  try {
    e.state(BodyId::PlutoBarycentre, BodyId::Sun, early);
    FAIL() << "Pluto has no series";
  } catch (const SpanError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("1800-01-01"));
  }
  // At the seam the two theories differ by no more than the series' own error.
  auto const seam = Ephemeris::tableSpan().first;
  Ephemeris const series({.theory = Theory::Series});
  for (BodyId body : {BodyId::Sun, BodyId::Moon, BodyId::Venus, BodyId::JupiterBarycentre})
    EXPECT_LT(angleBetween(table.state(body, BodyId::Earth, seam).position,
                           series.state(body, BodyId::Earth, seam).position) /
                  arcsecond,
              1.5);
}

TEST(Table, VectorAndPlainSumsAgree) {
  // Clenshaw by hand in long double against the chosen unit.
  double c[4 * 9] = {};
  for (int k = 0; k < 9; ++k)
    for (int a = 0; a < 3; ++a) c[4 * k + a] = 1e9 / ((k + 1) * (k + 2) * (a + 1));
  for (double x : {-1.0, -0.3, 0.0, 0.77, 1.0}) {
    long double value = 0, rate = 0;
    for (int k = 0; k < 9; ++k) {
      long double const angle = std::acos(static_cast<long double>(x));
      value += c[4 * k] * std::cos(k * angle);
      long double const s = std::sin(angle);
      rate += c[4 * k] * (std::fabs(s) > 1e-9L ? k * std::sin(k * angle) / s
                                               : (x > 0 ? 1.0L : (k % 2 ? 1.0L : -1.0L)) * k * k);
    }
    auto const sum = chebyshevSum(c, 9, x);
    EXPECT_NEAR(sum.value.x, static_cast<double>(value), 1e-5);
    EXPECT_NEAR(sum.derivative.x, static_cast<double>(rate), 1e-4);
  }
}

TEST(Table, RefusesBrokenFiles) {
  std::string const file = testing::TempDir() + "table.bin";
  std::ofstream(file, std::ios::binary) << "ANTCHEB1" << std::string("\x02\0\0\0\0\0\0\0", 8);
  EXPECT_THROW(TableCatalogue{file}, InputError);
  std::ofstream(file, std::ios::binary) << "nonsense";
  EXPECT_THROW(TableCatalogue{file}, InputError);
}

}  // namespace
}  // namespace antumbra
