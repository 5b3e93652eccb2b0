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
