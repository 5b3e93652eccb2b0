// The rows of `antumbra ephemeris`: dates echoed, columns, and errors that teach.
#include "app/ephemeris_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "document/input_error.h"

namespace antumbra {
namespace {

std::string written(const std::string& content) {
  std::string const file = testing::TempDir() + "dates.txt";
  std::ofstream(file) << content;
  return file;
}

TEST(EphemerisRows, DatesAreEchoedDigitForDigit) {
  auto const file = written("# comment\n2451545\n 2415383.128606 # tail\n2460000.123456789012\n");
  auto const epochs = epochsFromFile(file, TimeScale::Tdb, DeltaT::standard(), "--jd-tdb");
  ASSERT_EQ(epochs.size(), 3u);
  EXPECT_EQ(epochs[0].julianDate, "2451545.000000000");
  EXPECT_EQ(epochs[1].julianDate, "2415383.128606000");
  EXPECT_EQ(epochs[2].julianDate, "2460000.123456789012");
  // Twelve decimals are 1e-7 s: more than one double of the whole date resolves.
  EXPECT_NEAR(epochs[2].instant.tdb().fraction, 0.123456789012, 1e-14);
}

TEST(EphemerisRows, BadDatesNameFileLineAndWhatIsAllowed) {
  for (const char* bad : {"2451545\nnan\n", "2451545\n1e\n", "2451545\n12 13\n"}) {
    try {
      epochsFromFile(written(bad), TimeScale::Tdb, DeltaT::standard(), "--jd-tdb");
      ADD_FAILURE() << bad;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(),
                  testing::AllOf(testing::HasSubstr("dates.txt:2"), testing::HasSubstr("allowed")));
    }
  }
  EXPECT_THROW(
      epochsFromFile(written("# nothing\n"), TimeScale::Tdb, DeltaT::standard(), "--jd-tdb"),
      InputError);
  EXPECT_THROW(epochsFromFile("/nonexistent", TimeScale::Tdb, DeltaT::standard(), "--jd-tdb"),
               InputError);
}

TEST(EphemerisRows, PlanetsAreSystemsUnlessTheCentreIsNamed) {
  EXPECT_EQ(bodyFromCommandName("Jupiter", "--bodies").id, BodyId::JupiterBarycentre);
  EXPECT_EQ(bodyFromCommandName("Jupiter.center", "--bodies").id, BodyId::Jupiter);
  EXPECT_EQ(bodyFromCommandName("io", "--bodies").id, BodyId::Io);
  EXPECT_EQ(bodiesFromList("all", "--bodies").size(), 10u);
  EXPECT_THROW(bodiesFromList("Sun,,Moon", "--bodies"), InputError);
  EXPECT_THROW(bodyFromCommandName("Vulcan", "--bodies"), InputError);
}

TEST(EphemerisRows, RowsSayWhichTheoryAnswered) {
  EphemerisRequest r;
  r.bodies = bodiesFromList("Sun,Moon", "--bodies");
  auto const file = written("2451545\n1721045.5\n");
  auto const epochs = epochsFromFile(file, TimeScale::Tdb, r.deltaT, "--jd-tdb");
  auto const rows = ephemerisRows(Ephemeris::standard(), r, epochs);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].theory, "de431-table");
  EXPECT_EQ(rows[3].theory, "vsop87+elpmpp02");
  EXPECT_EQ(rows[0].values.size(), valueColumns(r).size());
  EXPECT_GT(rows[3].errorBoundArcseconds, rows[0].errorBoundArcseconds);
}

TEST(EphemerisRows, MoonsSayThatAFitAnswered) {
  EphemerisRequest r;
  r.bodies = bodiesFromList("Io,Charon,Jupiter,Jupiter.center", "--bodies");
  auto const epochs = epochsFromFile(written("2451545\n"), TimeScale::Tdb, r.deltaT, "--jd-tdb");
  auto const rows = ephemerisRows(Ephemeris::standard(), r, epochs);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].theory, "de431-table+moons-fit");
  EXPECT_EQ(rows[1].theory, "de431-table+moons-fit");
  EXPECT_EQ(rows[2].theory, "de431-table");
  EXPECT_EQ(rows[3].theory, "de431-table+moons-fit");
  Ephemeris const series({.theory = Theory::Series, .extrapolate = true});
  EXPECT_EQ(series.theoryName(BodyId::Europa, BodyId::Earth, Instant()),
            "vsop87+elpmpp02+moons-fit");
  // 1850: outside the fit, inside VSOP87. Io's orbit is 843 600 km wide: 188 to 277 arcsec at 6.2
  // to 4.2 au.
  auto const before = Instant::fromTt({2396759.0, 0.0});
  EXPECT_EQ(series.theoryName(BodyId::Io, BodyId::Earth, before),
            "vsop87+elpmpp02+moons-fit+extrapolated");
  double const bound = series.errorBound(BodyId::Io, BodyId::Earth, before) / arcsecond;
  EXPECT_GT(bound, 150.0);
  EXPECT_LT(bound, 400.0);
}

TEST(EphemerisRows, WarnsOnceForEachBodyWhoseRequestIsNotMet) {
  EphemerisRequest r;
  r.bodies = bodiesFromList("Jupiter,Moon", "--bodies");
  auto const epochs =
      epochsFromFile(written("2451545\n1000000\n900000\n"), TimeScale::Tdb, r.deltaT, "--jd-tdb");
  Ephemeris const e({.theory = Theory::Series, .error = 10.0 * arcsecond});
  auto const rows = ephemerisRows(e, r, epochs);
  auto const lines = unmetErrors(e, r, rows, 10.0 * arcsecond);
  std::vector<std::string> jupiter;
  for (const auto& line : lines)
    if (line.find("Jupiter") == 0) jupiter.push_back(line);
  ASSERT_EQ(jupiter.size(), 1u);
  EXPECT_THAT(jupiter[0], testing::AllOf(testing::HasSubstr("requested 10 arcsec"),
                                         testing::HasSubstr("dates.txt:2 (1000000 TDB)"),
                                         testing::HasSubstr("72.0000 arcsec")));
  EXPECT_TRUE(unmetErrors(e, r, rows, 1000.0 * arcsecond).empty());
}

TEST(EphemerisRows, DatesOutsideTheSpanAreNamedAsGiven) {
  EphemerisRequest r;
  auto const refusal = [&](const char* bodies, const char* dates, TimeScale scale) -> std::string {
    r.bodies = bodiesFromList(bodies, "--bodies");
    auto const epochs = epochsFromFile(written(dates), scale, r.deltaT, "--jd");
    try {
      ephemerisRows(Ephemeris::standard(), r, epochs);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(
      refusal("Sun", "2451545\n1e7\n", TimeScale::Ut1),
      testing::AllOf(testing::HasSubstr("dates.txt:2: "), testing::HasSubstr("1e7 UT1"),
                     testing::HasSubstr("-3000-01-01"), testing::HasSubstr("--extrapolate")));
  // Pluto has no series: nothing to extrapolate.
  EXPECT_THAT(refusal("Pluto", "2000000.50\n", TimeScale::Tt),
              testing::AllOf(testing::HasSubstr("2000000.50 TT"), testing::HasSubstr("1800-01-01"),
                             testing::Not(testing::HasSubstr("--extrapolate"))));
}

TEST(EphemerisRows, RangesIncludeBothEnds) {
  auto const first = parseInstant("2451545.0 TDB", "x"), last = parseInstant("2451546.0 TDB", "x");
  auto const epochs = epochsFromRange(first, last, 6.0 * hour, TimeScale::Tdb, DeltaT::standard());
  ASSERT_EQ(epochs.size(), 5u);
  EXPECT_EQ(epochs[1].julianDate, "2451545.250000000000");
  EXPECT_EQ(epochs[4].julianDate, "2451546.000000000000");
  EXPECT_THROW(epochsFromRange(last, first, 6.0 * hour, TimeScale::Tdb, DeltaT::standard()),
               InputError);
  EXPECT_THROW(epochsFromRange(first, last, 0.0 * hour, TimeScale::Tdb, DeltaT::standard()),
               InputError);
}

}  // namespace
}  // namespace antumbra
