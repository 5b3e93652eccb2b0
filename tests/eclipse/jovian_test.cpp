// Galilean shadow transits against published observations of rare ones.
#include "eclipse/jovian.h"

#include <gtest/gtest.h>

#include <cmath>

namespace antumbra {
namespace {

TEST(Jovian, ThreeShadowsFellOnJupiterOn24January2015) {
  // Sky & Telescope, "Rare Triple Transit!", January 2015: three shadows on the disc from 6:26 to
  // 6:53 UT (1:26 to 1:53 a.m. EST), of Callisto, Io and Europa.
  Instant const day = startOfDate("2015-01-24", "test");
  auto const events = jovianEvents(EclipseBasis{}, day, day + 1.0 * antumbra::day);
  int triple = 0;
  Instant enters = day, leaves = day + 2.0 * antumbra::day;
  for (auto const& e : events) {
    if (!e.shadowOnJupiter || e.shadowsAtOnce < 3) continue;
    ++triple;
    enters = std::max(enters, e.seen(e.begin));
    leaves = std::min(leaves, e.seen(e.end));
  }
  EXPECT_EQ(triple, 3);
  auto const minuteOfDay = [&](Instant t) {
    std::string const iso = ut1Text(t, 67.6 * second);
    return 60.0 * std::stod(iso.substr(11, 2)) + std::stod(iso.substr(14, 2)) +
           std::stod(iso.substr(17)) / 60.0;
  };
  // Published for whole shadows or first specks of them: Callisto's takes ten minutes to leave.
  EXPECT_NEAR(minuteOfDay(enters), 6 * 60 + 26, 3.0);
  EXPECT_NEAR(minuteOfDay(leaves), 6 * 60 + 53, 6.0);
}

TEST(Jovian, EventsComeOncePerRevolution) {
  Instant const from = startOfYear(2020);
  auto const events = jovianEvents(EclipseBasis{}, from, from + 100.0 * day);
  int io = 0, ioEclipsed = 0, callisto = 0;
  for (auto const& e : events) {
    if (e.moon == BodyId::Io) (e.shadowOnJupiter ? io : ioEclipsed) += 1;
    callisto += e.moon == BodyId::Callisto;
    EXPECT_LT(e.begin, e.middle);
    EXPECT_LT(e.middle, e.end);
    EXPECT_LT(e.end - e.begin, 6.0 * hour);
    EXPECT_LT(e.leastDistance, 1.0);
    EXPECT_GT(e.lightTime, 32.0 * minute);
    EXPECT_LT(e.lightTime, 55.0 * minute);
  }
  // 100 days hold 56.5 revolutions of Io and 6 of Callisto, whose shadow meets Jupiter within some
  // eighteen months of the planet's equinoxes (2015 February, 2021 May) and passes by it in 2018.
  EXPECT_NEAR(io, 56.5, 0.6);
  EXPECT_NEAR(ioEclipsed, 56.5, 0.6);
  EXPECT_NEAR(callisto, 12, 1);
  for (auto const& e : jovianEvents(EclipseBasis{}, startOfYear(2018), startOfYear(2019)))
    EXPECT_NE(e.moon, BodyId::Callisto) << e.id;
}

}  // namespace
}  // namespace antumbra
