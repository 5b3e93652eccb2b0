// Geometric places of the full series against JPL DE431.
#include "ephemeris/ephemeris.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/csv.h"

namespace antumbra {
namespace {

TEST(Ephemeris, FullSeriesReachTheTheoriesOwnFloor) {
  // Arcseconds over 1900-2100: VSOP87's and ELP/MPP02's own error against DE431.
  std::map<std::string, double> const bars{{"Sun", 0.045},   {"Moon", 0.025}, {"Mercury", 0.08},
                                           {"Venus", 0.08},  {"Mars", 0.28},  {"Jupiter", 0.45},
                                           {"Saturn", 0.36}, {"Uranus", 1.6}, {"Neptune", 2.3}};
  Ephemeris const series({.theory = Theory::Series});
  int rows = 0;
  for (const auto& row : readCsv("tests/authorities/geocentric_geometric.csv")) {
    auto const bar = bars.find(row.text("body"));
    if (bar == bars.end() || !row.text("epoch_id").starts_with("main")) continue;
    auto const name = row.text("body");
    auto const t = Instant::fromTdb({row.number("jd_tdb"), 0.0});
    auto const s = series.state(systemOf(*bodyFromName(name)), BodyId::Earth, t);
    Displacement<Icrs> const truth{astronomicalUnit.si * glm::dvec3(row.number("x_au"),
                                                                    row.number("y_au"),
                                                                    row.number("z_au"))};
    EXPECT_LT(angleBetween(s.position, truth) / arcsecond, bar->second)
        << name << " " << row.text("jd_tdb");
    glm::dvec3 const v =
        astronomicalUnit.si / 86400.0 *
        glm::dvec3(row.number("vx_au_d"), row.number("vy_au_d"), row.number("vz_au_d"));
    // Neptune's error of 2" over its shortest perturbation gives 0.11 m/s; nothing exceeds 0.15.
    EXPECT_LT(glm::length(v - s.velocity.m), name == "Moon" ? 0.001 : 0.15) << name;
    ++rows;
  }
  EXPECT_GT(rows, 500);
}

TEST(Ephemeris, VelocityIsTheRateOfThePosition) {
  auto const& e = Ephemeris::standard();
  auto const t = Instant::fromTt({2451545.0, 4321.123});
  Duration const h = 60.0 * second;
  for (BodyId body : {BodyId::Mercury, BodyId::Moon, BodyId::Jupiter, BodyId::EarthMoonBarycentre,
                      BodyId::SolarSystemBarycentre}) {
    auto const centre = body == BodyId::Moon ? BodyId::Earth : BodyId::Sun;
    auto const a = e.state(body, centre, t - h), b = e.state(body, centre, t + h);
    glm::dvec3 const rate = (b.position.m - a.position.m) / 120.0;
    // A longitude of 300 rad rounds to 6e-14 rad, 4 mm at Mercury: 7e-5 m/s over 120 s.
    EXPECT_LT(glm::length(rate - e.state(body, centre, t).velocity.m), 2e-4) << nameOf(body);
  }
}

TEST(Ephemeris, CentresAreConsistent) {
  auto const& e = Ephemeris::standard();
  auto const t = Instant::fromTt({2461254.0, 0.5});
  auto const there = e.state(BodyId::Mars, BodyId::Moon, t);
  auto const back = e.state(BodyId::Moon, BodyId::Mars, t);
  EXPECT_LT(glm::length(there.position.m + back.position.m), 1e-3);
  auto const sum = e.state(BodyId::Moon, BodyId::EarthMoonBarycentre, t).position.m -
                   e.state(BodyId::Earth, BodyId::EarthMoonBarycentre, t).position.m;
  EXPECT_LT(glm::length(sum - e.state(BodyId::Moon, BodyId::Earth, t).position.m), 1e-6);
}

TEST(Ephemeris, DatesOutsideTheSpanCarryTheSpan) {
  auto const t = Instant::fromTt({0.0, 0.0});
  try {
    Ephemeris::standard().state(BodyId::Mars, BodyId::Sun, t);
    FAIL() << "no error";
  } catch (const SpanError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("-3000-01-01"));
    EXPECT_FALSE(error.span().covers(t));
  }
}

}  // namespace
}  // namespace antumbra
