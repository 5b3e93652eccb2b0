// The eclipse commands as a user calls them: documented columns, documented fields, explained
// errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands.h"
#include "document/input_error.h"

namespace antumbra {
namespace {

// Runs `antumbra eclipse ARGUMENTS -o FILE` and gives the file's text.
std::string runToFile(std::vector<std::string> arguments, const std::string& ending = "txt") {
  auto const file = std::filesystem::temp_directory_path() / ("eclipse_command_test." + ending);
  std::filesystem::remove(file);
  CLI::App program;
  addEclipseCommand(program);
  arguments.insert(arguments.begin(), "eclipse");
  arguments.insert(arguments.end(), {"-o", file.string()});
  std::reverse(arguments.begin(), arguments.end());
  program.parse(arguments);
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(EclipseCommand, ListHasTheDocumentedColumns) {
  std::string const solar =
      runToFile({"list", "--kind", "solar", "--from", "2027", "--to", "2027", "--format", "csv"});
  EXPECT_THAT(firstLine(solar),
              testing::StartsWith("ecl_id,type,jd_tt_greatest,delta_t_s,gamma,lat_deg,lon_deg_east,"
                                  "sun_alt_deg,magnitude,duration_s,width_km,saros"));
  EXPECT_THAT(solar, testing::HasSubstr("\n2027-02-06,A,"));
  EXPECT_THAT(solar, testing::HasSubstr("\n2027-08-02,T,"));
  std::string const lunar =
      runToFile({"list", "--kind", "lunar", "--from", "2025", "--to", "2025", "--format", "csv"});
  EXPECT_THAT(firstLine(lunar),
              testing::StartsWith("ecl_id,type,jd_tt_greatest,delta_t_s,gamma,umbral_magnitude,"
                                  "penumbral_magnitude,p1_ut1,u1_ut1,u2_ut1,u3_ut1,u4_ut1,p4_ut1,"
                                  "saros"));
  EXPECT_THAT(lunar, testing::HasSubstr("\n2025-03-14,T,"));
}

TEST(EclipseCommand, AtGivesTheDocumentedFields) {
  auto const j = nlohmann::json::parse(runToFile(
      {"at", "2027-08-02", "--site=25.687,32.640,76", "--delta-t=68.8", "--format", "json"}));
  EXPECT_EQ(j["ecl_id"], "2027-08-02");
  EXPECT_EQ(j["type"], "T");
  EXPECT_EQ(j["convention"], "nasa");
  EXPECT_DOUBLE_EQ(j["delta_t_s"].get<double>(), 68.8);
  EXPECT_THAT(j["contacts_ut1"]["C2"].get<std::string>(),
              testing::MatchesRegex("2027-08-02T10:02:0[0-9]\\.[0-9][0-9][0-9]"));
  auto const partial = nlohmann::json::parse(
      runToFile({"at", "2027-08-02", "--site=51.5,-0.1,20", "--format", "json"}));
  EXPECT_EQ(partial["type"], "P");
  EXPECT_TRUE(partial["contacts_ut1"]["C2"].is_null());
  EXPECT_FALSE(partial["contacts_ut1"]["max"].is_null());
  auto const none = nlohmann::json::parse(
      runToFile({"at", "2027-08-02", "--site=-60,-150,0", "--format", "json"}));
  EXPECT_TRUE(none["contacts_ut1"]["C1"].is_null());
}

TEST(EclipseCommand, MarksContactsBelowTheHorizon) {
  // In Boston the Sun rises while the eclipse of 2021-06-10 goes on.
  auto const j = nlohmann::json::parse(
      runToFile({"at", "2021-06-10", "--site=42.36,-71.06,10", "--format", "json"}));
  EXPECT_EQ(j["visibility"], "partly visible");
  EXPECT_THAT(j["below_horizon"].dump(), testing::HasSubstr("C1"));
  ASSERT_EQ(j["sunrise_sunset"].size(), 1u);
  EXPECT_EQ(j["sunrise_sunset"][0]["event"], "sunrise");
  EXPECT_GT(j["sunrise_sunset"][0]["magnitude"].get<double>(), 0.4);
}

TEST(EclipseCommand, AtAnswersForLunarEclipses) {
  auto const j = nlohmann::json::parse(
      runToFile({"at", "2026-03-03", "--site=40,-100,300", "--format", "json"}));
  EXPECT_EQ(j["kind"], "lunar");
  EXPECT_EQ(j["type"], "T");
  EXPECT_EQ(j["visibility"], "partly visible");
  EXPECT_THAT(j["contacts_ut1"]["U2"].get<std::string>(), testing::StartsWith("2026-03-03T11:04"));
  EXPECT_EQ(j["below_horizon"].dump(), "[\"U4\",\"P4\"]");
  EXPECT_EQ(j["moonrise_moonset"][0]["event"], "moonset");
  std::string const table = runToFile({"at", "2026-03-03", "--site=40,-100,300"});
  EXPECT_THAT(table, testing::HasSubstr("total"));
  EXPECT_THAT(table, testing::HasSubstr("below the horizon"));
  auto const penumbral =
      nlohmann::json::parse(runToFile({"at", "2027-02-20", "--site=0,0,0", "--format", "json"}));
  EXPECT_TRUE(penumbral["contacts_ut1"]["U1"].is_null());
  EXPECT_TRUE(penumbral["total_duration_s"].is_null());
}

TEST(EclipseCommand, ListsTheGalileanMoonsToTheEndsOfTheirTheory) {
  for (const char* year : {"1900", "2099"})
    EXPECT_THAT(
        runToFile({"list", "--kind", "jovian", "--from", year, "--to", year, "--format", "csv"}),
        testing::HasSubstr("-Ganymede-shadow"));
}

TEST(EclipseCommand, PathHasExactlyTheDocumentedColumns) {
  std::string const csv = runToFile({"path", "2027-08-02", "--step", "30min"});
  EXPECT_EQ(firstLine(csv),
            "jd_tt,lat_deg,lon_deg_east,sun_alt_deg,sun_az_deg,magnitude,phase,duration_s,width_km,"
            "left_limit_lat_deg,left_limit_lon_deg_east,right_limit_lat_deg,"
            "right_limit_lon_deg_east");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 8);
  auto const geo = nlohmann::json::parse(
      runToFile({"path", "2027-08-02", "--step", "30min", "--format", "geojson"}));
  EXPECT_EQ(geo["type"], "FeatureCollection");
  EXPECT_GE(geo["features"].size(), 10u);
  EXPECT_THAT(runToFile({"path", "2027-08-02", "--format", "kml"}), testing::HasSubstr("</kml>"));
}

TEST(EclipseCommand, DrawsAMapInPixels) {
  EXPECT_GT(runToFile({"map", "2027-08-02"}, "png").size(), 100000u);
}

TEST(EclipseCommand, ExplainsBadInput) {
  auto const message = [](std::vector<std::string> arguments) {
    try {
      runToFile(std::move(arguments));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message({"at", "2027-08-03", "--site=1,2,3"}), testing::HasSubstr("2027-08-02"));
  EXPECT_THAT(message({"at", "2027-08-03", "--site=1,2,3"}), testing::HasSubstr("2027-08-17"));
  EXPECT_THAT(message({"at", "2027-8-3", "--site=1,2,3"}), testing::HasSubstr("YYYY-MM-DD"));
  EXPECT_THAT(message({"at", "5000-01-01", "--site=1,2,3"}), testing::HasSubstr("allowed: -3000"));
  EXPECT_THAT(message({"at", "2027-08-02", "--site=95,2,3"}), testing::HasSubstr("--site"));
  EXPECT_THAT(message({"at", "2027-08-02", "--site=5,361,3"}), testing::HasSubstr("-180 to 360"));
  EXPECT_THAT(message({"at", "2027-08-02", "--site=5"}), testing::HasSubstr("LAT,LON,HEIGHT"));
  EXPECT_THAT(message({"path", "2025-03-29"}), testing::HasSubstr("partial"));
  EXPECT_THAT(message({"path", "2027-08-02", "--step", "0min"}), testing::HasSubstr("--step"));
  EXPECT_THAT(message({"path", "2027-08-02", "--convention", "own"}),
              testing::HasSubstr("--convention"));
  EXPECT_THAT(message({"path", "2027-08-02", "--k-umbra", "0.5"}), testing::HasSubstr("--k-umbra"));
  EXPECT_THAT(message({"path", "2027-08-02", "--delta-t", "soon"}),
              testing::HasSubstr("--delta-t"));
  EXPECT_THAT(message({"map", "2027-08-02"}), testing::HasSubstr(".svg"));
  EXPECT_THAT(message({"list", "--from", "4000", "--to", "4001"}), testing::HasSubstr("3000"));
  EXPECT_THAT(message({"list", "--from", "2000", "--to", "1999"}), testing::HasSubstr("--to"));
  EXPECT_THAT(message({"list", "--from", "1990000000", "--to", "1990000001"}),
              testing::HasSubstr("--from"));
  EXPECT_THAT(message({"list", "--kind", "jovian", "--from", "1850", "--to", "1850"}),
              testing::HasSubstr("allowed: 1900-01-01"));
}

}  // namespace
}  // namespace antumbra
