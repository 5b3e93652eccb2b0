// Scales, calendars and text of instants.
#include "time/instant.h"

#include <erfa.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/input_error.h"
#include "tests/support/csv.h"
#include "time/delta_t.h"

namespace antumbra {
namespace {

Instant at(const std::string& text) { return parseInstant(text, "test"); }

TEST(Instant, UtcIsTtLessLeapSecondsAnd32Point184) {
  // 37 leap seconds since 2017 (IERS Bulletin C 52).
  auto const t = at("2027-08-02T10:07:50.000Z");
  EXPECT_NEAR((t - at("2027-08-02T10:07:50.000 TT")) / second, 69.184, 1e-9);
  EXPECT_NEAR((t - at("2027-08-02T12:07:50+02:00")) / second, 0.0, 1e-9);
  EXPECT_EQ(formatIso(t), "2027-08-02T10:07:50.000Z");
  EXPECT_EQ(formatIso(at("2016-12-31T23:59:60.5Z")), "2016-12-31T23:59:60.500Z");
  EXPECT_EQ(formatIso(t, TimeScale::Tt), "2027-08-02T10:08:59.184 TT");
}

TEST(Instant, ResolvesNanosecondsFarFromTheEpoch) {
  auto const t = Instant::fromTt({-1000000.5, 0.123456789});
  EXPECT_NEAR(((t + 1e-9 * second) - t) / second, 1e-9, 2e-11);
}

TEST(Instant, TdbMinusTtAgreesWithTheFullSeries) {
  // ERFA's eraDtdb sums 787 terms; 10 microseconds is the claim of USNO Circular 179 for 1600-2200.
  for (double year = 1600; year <= 2200; year += 3.37) {
    auto const t = Instant::fromTt({2451545.0, (year - 2000.0) * 365.25});
    auto const tt = t.tt();
    EXPECT_NEAR(tdbMinusTt(t) / second, eraDtdb(tt.whole, tt.fraction, 0.0, 0.0, 0.0, 0.0), 1.1e-5)
        << year;
    EXPECT_NEAR((Instant::fromTdb(t.tdb()) - t) / second, 0.0, 1e-9);
  }
}

TEST(Instant, CalendarChangesOn1582October15) {
  EXPECT_EQ(julianDayNumber({2000, 1, 1}), 2451545);
  EXPECT_EQ(julianDayNumber({1582, 10, 15}), 2299161);
  EXPECT_EQ(julianDayNumber({1582, 10, 4}), 2299160);
  EXPECT_EQ(julianDayNumber({-4712, 1, 1}), 0);
  for (long n = -4000000; n < 8000000; n += 997) {
    auto const c = calendarDay(n);
    EXPECT_EQ(julianDayNumber(c), n);
  }
  EXPECT_THROW(at("1582-10-10T00:00 TT"), InputError);
}

TEST(Instant, ReadsAncientDatesAndJulianDates) {
  // Thales' eclipse, 585 BC May 28: JD 1507900 (noon).
  EXPECT_NEAR(at("-0584-05-28T12:00:00 TT").tt().value(), 1507900.0, 1e-9);
  EXPECT_NEAR(at("JD 2451545.25 TDB").tdb().value(), 2451545.25, 1e-9);
  EXPECT_NEAR(at("2451545.0 TT").ttCenturiesSinceJ2000(), 0.0, 1e-15);
  EXPECT_EQ(formatIso(at("-0584-05-28T12:00:00 TT"), TimeScale::Tt, 0), "-0584-05-28T12:00:00 TT");
}

TEST(Instant, RefusesWhatIsNoDateAndSaysWhatIsAllowed) {
  for (const char* bad :
       {"", "yesterday", "2027-13-01T00:00Z", "2027-02-29T00:00Z", "2451545.0", "nan",
        "2027-08-02T25:00Z", "2027-08-02T10:00:60Z", "2027-08-02T10:00 XYZ"}) {
    try {
      at(bad);
      ADD_FAILURE() << bad << " was accepted";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(),
                  testing::AllOf(testing::HasSubstr("test"), testing::HasSubstr("allowed")));
    }
  }
}

TEST(DeltaT, AgreesWithAnIndependentTableWithinItsUncertainty) {
  // Swiss Ephemeris follows Stephenson et al. 2016 (we follow its 2021 revision) and extrapolates
  // in its own way: agreement within 3 of our standard errors, plus 0.15 s of smoothing.
  for (const auto& row : readCsv("tests/authorities/delta_t.csv")) {
    double const year = row.number("year");
    auto const t = Instant::fromTt({row.number("jd_ut_jan1"), 0.0});
    auto const mine = DeltaT::standard().explain(t);
    EXPECT_NEAR(mine.value / second, row.number("deltaT_s"), 4.5 * mine.uncertainty.si + 0.7)
        << year << " " << mine.source;
  }
}

TEST(DeltaT, IsContinuousAtEverySeam) {
  double before = 0.0;
  for (double year = -2500.0; year < 3500.0; year += 0.05) {
    double const now =
        DeltaT::standard().at(Instant::fromTt({2451545.0, (year - 2000.0) * 365.25})) / second;
    if (year > -2499.0) {
      // The parabola's slope is 0.0065 s a year per year of distance; the spline's stays below 3.
      EXPECT_LT(std::fabs(now - before), 0.05 * (0.0075 * std::fabs(year - 1825.0) + 3.0)) << year;
    }
    before = now;
  }
}

TEST(DeltaT, GivenValueAndEarthOrientationFileAreUsed) {
  auto const fixed = DeltaT::fixed(100.0 * second);
  auto const t = at("2450000.5 TT");
  EXPECT_NEAR((t - Instant::fromTt(t.ut1(fixed))) / second, 100.0, 1e-9);
  std::string const file = testing::TempDir() + "eop.txt";
  std::ofstream(file) << "# MJD UT1-UTC x y\n57753 -0.4 0.1 0.3\n57755 0.6 0.2 0.4\n";
  auto const eop = DeltaT::fromEarthOrientationFile(file);
  // The leap second of 2017-01-01 (MJD 57754) lies between the rows: delta T stays smooth.
  EXPECT_NEAR(eop.at(at("2017-01-01T00:00:00Z")) / second, 32.184 + 36.0 + 0.4, 1e-4);
  EXPECT_NEAR(eop.pole(at("2017-01-01T00:00:00Z")).first / arcsecond, 0.15, 1e-4);
  std::ofstream(file) << "57753 -0.4\n57752 0.6\n";
  EXPECT_THROW(DeltaT::fromEarthOrientationFile(file), InputError);
}

}  // namespace
}  // namespace antumbra
