// Apparent places against Swiss Ephemeris and ERFA reductions of DE431.
#include "ephemeris/apparent.h"

#include <gtest/gtest.h>

#include "quantity/constants.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

// What the full series themselves err by (tests/ephemeris/ephemeris_test.cpp), arcseconds.
const std::map<std::string, double> kSeriesFloor{
    {"Sun", 0.045},    {"Moon", 0.025},  {"Mercury", 0.08}, {"Venus", 0.08}, {"Mars", 0.28},
    {"Jupiter", 0.45}, {"Saturn", 0.36}, {"Uranus", 1.6},   {"Neptune", 2.3}};

Direction<TrueEquatorOfDate> fromDegrees(double ra, double dec) {
  double const a = ra * degree.si, d = dec * degree.si;
  return {{std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)}};
}

TEST(Apparent, GeocentricPlacesOfDate) {
  Ephemeris const e({.theory = Theory::Series});
  int rows = 0;
  for (const auto& row : readCsv("tests/authorities/apparent_geocentric.csv")) {
    auto const floor = kSeriesFloor.find(row.text("body"));
    if (floor == kSeriesFloor.end() || !row.text("epoch_id").starts_with("main")) continue;
    auto const t = Instant::fromTt({row.number("jd_tt"), 0.0});
    auto const place = apparentPlace(e, systemOf(*bodyFromName(floor->first)),
                                     observerAt(e, BodyId::Earth, t), t, {.deflection = true});
    auto const seen = directionOf(trueEquatorOfDateFromIcrs(t)(place.displacement));
    auto const truth = fromDegrees(row.number("ra_deg"), row.number("dec_deg"));
    // 0.003": the file's own floor of reduction.
    EXPECT_LT(angleBetween(seen, truth) / arcsecond, floor->second + 0.003) << floor->first;
    ++rows;
  }
  EXPECT_GT(rows, 300);
}

TEST(Apparent, TopocentricAzimuthAndAltitude) {
  Ephemeris const e({.theory = Theory::Series});
  int rows = 0;
  for (const auto& row : readCsv("tests/authorities/topocentric_horizontal.csv")) {
    auto const floor = kSeriesFloor.find(row.text("body"));
    if (floor == kSeriesFloor.end() || ++rows % 3 != 0) continue;
    auto const deltaT = DeltaT::fixed(row.number("deltaT_s") * second);
    auto const t = Instant::fromUt1({row.number("jd_ut1"), 0.0}, deltaT);
    Site const site{row.number("lat_deg") * degree, row.number("lon_deg_east") * degree,
                    row.number("height_m") * metre};
    auto const place = apparentPlace(e, systemOf(*bodyFromName(floor->first)),
                                     observerAt(e, site, t, deltaT), t, {.deflection = true});
    auto const enu = enuFromItrs(site)(itrsFromIcrs(t, deltaT)(place.displacement));
    auto const truth = enuFromHorizontal(
        {row.number("az_deg_N0E90") * degree, row.number("alt_deg_airless") * degree});
    // The Moon's parallax magnifies nothing; UT1 printed to 1e-6 days moves the sky by 1.3".
    EXPECT_LT(angleBetween(directionOf(enu), truth) / arcsecond, floor->second + 1.3)
        << floor->first;
  }
  EXPECT_GT(rows, 400);
}

TEST(Apparent, WithoutLightTimeAndAberrationTheShadowMoves38Kilometres) {
  // The axis Sun-Moon meets the plane through the geocentre; where it does shifts by the Moon's own
  // motion in 1.3 s and the Sun's aberration of 20" at the Moon's distance.
  auto const& e = Ephemeris::standard();
  auto const t = parseInstant("2017-08-21T18:26:40Z", "test");
  auto const eye = observerAt(e, BodyId::Earth, t);
  auto const foot = [](glm::dvec3 sun, glm::dvec3 moon) {
    glm::dvec3 const axis = glm::normalize(moon - sun);
    return moon - glm::dot(moon, axis) * axis;
  };
  auto const place = [&](BodyId body, Corrections c) {
    return apparentPlace(e, body, eye, t, c).displacement.m;
  };
  Corrections const full, none{false, false, false};
  double const shift = glm::length(foot(place(BodyId::Sun, full), place(BodyId::Moon, full)) -
                                   foot(place(BodyId::Sun, none), place(BodyId::Moon, none)));
  // 38 km is the mean over eclipses; the Moon's speed and distance vary by a tenth.
  EXPECT_NEAR(shift / 1000.0, 38.0, 4.0);
}

TEST(Apparent, AberrationOfTheSunIs20Point5Arcseconds) {
  auto const& e = Ephemeris::standard();
  auto const t = Instant();
  auto const p = apparentPlace(e, BodyId::Sun, observerAt(e, BodyId::Earth, t), t);
  // Constant of aberration 20.49552" (IAU 1976) times the Earth's speed in early January: 1.017.
  EXPECT_NEAR(angleBetween(p.displacement, p.retarded) / arcsecond, 20.49552 * 1.0171, 0.02);
  EXPECT_NEAR(p.lightTime / second, 490.7, 0.3);
}

TEST(Apparent, DeflectionAtTheSolarLimb) {
  // 1.75" for a star at the limb (4 GM / c^2 R); a body at finite distance r behind the Sun keeps
  // r/(r + 1 au) of it.
  auto const& e = Ephemeris::standard();
  double largest = 0.0;
  for (int i = 0; i < 400;
       ++i) {  // Jupiter's conjunction of December 2019 passes 0.1 degrees from the Sun
    auto const t = Instant::fromTt({2458844.0, 0.02 * i});
    auto const eye = observerAt(e, BodyId::Earth, t);
    auto const a = apparentPlace(e, BodyId::Jupiter, eye, t, {.deflection = true});
    auto const b = apparentPlace(e, BodyId::Jupiter, eye, t);
    auto const sun = apparentPlace(e, BodyId::Sun, eye, t);
    double const radii = angleBetween(b.displacement, sun.displacement).si /
                         (kSolarRadiusIau.si / glm::length(sun.displacement.m));
    double const expected = 1.751 / radii * 5.2 / 6.2;
    if (radii > 0.9) {
      EXPECT_NEAR(angleBetween(a.displacement, b.displacement) / arcsecond, expected,
                  0.02 * expected);
    }
    largest = std::max(largest, angleBetween(a.displacement, b.displacement) / arcsecond);
  }
  EXPECT_GT(largest, 0.5);
}

}  // namespace
}  // namespace antumbra
