// `antumbra trade sky`: what bad input is told, and a short walk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/trade_sky_meter.h"
#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string sceneFile(const std::string& name) {
  return (configsFolder() / "scenes" / (name + ".toml")).string();
}

// What the command prints, or the message of its InputError.
std::string tradeSky(const std::string& options) {
  CLI::App program;
  addTradeCommand(program);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string complaint;
  try {
    program.parse("trade sky " + options);
  } catch (const InputError& error) {
    complaint = error.what();
  } catch (const CLI::ParseError& error) {
    complaint = std::string("command line: ") + error.what();
  }
  testing::internal::GetCapturedStderr();
  std::string const printed = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(complaint.empty() || printed.empty()) << "half an answer before an error";
  return complaint.empty() ? printed : complaint;
}

TEST(TradeSky, TellsWhatIsWrong) {
  std::string const scene = sceneFile("day_sky");
  EXPECT_THAT(tradeSky(scene + " --directions 3"),
              AllOf(HasSubstr("--directions"), HasSubstr("3")));
  EXPECT_THAT(tradeSky(scene + " --stderr 50%"), AllOf(HasSubstr("--stderr"), HasSubstr("20%")));
  EXPECT_THAT(tradeSky(scene + " --knobs colour"),
              AllOf(HasSubstr("--knobs"), HasSubstr("colour"), HasSubstr("ground_samples")));
  EXPECT_THAT(tradeSky(scene + " --presets best"),
              AllOf(HasSubstr("--presets"), HasSubstr("best")));
  EXPECT_THAT(tradeSky(scene + " --base best"), AllOf(HasSubstr("--base"), HasSubstr("best")));
  EXPECT_THAT(tradeSky(scene + " --format xml"), AllOf(HasSubstr("--format"), HasSubstr("xml")));
  EXPECT_THAT(tradeSky(sceneFile("from_space")), AllOf(HasSubstr("eclipsed"), HasSubstr("Moon")));
  EXPECT_THAT(tradeSky("nowhere.toml"), HasSubstr("nowhere.toml"));
  EXPECT_THAT(tradeSky(""), HasSubstr("scene"));
  EXPECT_THAT(tradeSky(scene + " " + scene),
              AllOf(HasSubstr("second scene"), HasSubstr("day_sky")));
  EXPECT_THAT(tradeSky(sceneFile("saturn")), AllOf(HasSubstr("saturn.toml"), HasSubstr("air")));
  EXPECT_THAT(tradeSky(scene + " --repeat 3"), AllOf(HasSubstr("--repeat"), HasSubstr("7")));
  EXPECT_THAT(tradeSky(scene + " --size wide"), AllOf(HasSubstr("--size"), HasSubstr("wide")));
}

// configs/quality/front.json, which README shows: measured with the presets as they are, and they
// are on the front. What does not depend on the machine is measured again.
TEST(TradeSky, PresetsAreOnTheStoredFront) {
  auto const file = configsFolder() / "quality" / "front.json";
  auto const stored = nlohmann::json::parse(std::ifstream(file));
  EXPECT_EQ(stored["complete"], true);
  EXPECT_GT(stored["rows"].size(), 20u);
  std::map<std::string, nlohmann::json> rows;
  for (auto const& row : stored["rows"]) rows[row["point"]] = row;
  std::string scenes;
  for (std::string const name : {"day_sky", "dusk_sky", "whole_earth"})
    scenes += sceneFile(name) + " ";
  auto const found = nlohmann::json::parse(
      tradeSky(scenes + "--size 64x36 --knobs none --format json --reference " +
               (rootFolder() / "tests/authorities/trade_sky_reference.json").string()));
  for (std::string const preset : {"draft", "balanced", "accurate"}) {
    EXPECT_TRUE(rows.at(preset)["on_front"].get<bool>()) << preset;
    EXPECT_EQ(stored["preset " + preset], found["preset " + preset]);
  }
  for (auto const& row : found["rows"]) {
    auto const& known = rows.at(row["point"]);
    // Rounding of floats; other drivers.
    for (std::string const key : {"luminance_error_percent", "delta_e2000"})
      EXPECT_NEAR(row[key].get<double>(), known[key].get<double>(), 0.05) << row["point"] << key;
    EXPECT_NEAR(row["memory_mib"].get<double>(), known["memory_mib"].get<double>(), 0.01);
  }
}

TEST(TradeSky, MeasuresTwoPointsAndKeepsTheReference) {
  auto const file = std::filesystem::temp_directory_path() / "antumbra_trade_sky_reference.json";
  std::filesystem::remove(file);
  std::string const options =
      " --size 96x54 --presets none --knobs storage --directions 4 --stderr "
      "5% --format json --reference " +
      file.string();
  auto const json = nlohmann::json::parse(tradeSky(sceneFile("day_sky") + options));
  EXPECT_EQ(json["subject"], "sky");
  EXPECT_EQ(json["cost"], "fill_units");
  EXPECT_EQ(json["complete"], true);
  EXPECT_GT(json["error_floor"].get<double>(), 0.0);
  ASSERT_EQ(json["rows"].size(), 2u);
  auto const &whole = json["rows"][0], &half = json["rows"][1];
  EXPECT_EQ(whole["point"], "balanced");
  EXPECT_EQ(half["point"], "storage = half");
  for (auto const& row : json["rows"]) {
    // The bar of `balanced` by day.
    EXPECT_LT(row["luminance_error_percent"].get<double>(), 3.0);
    EXPECT_GT(row["luminance_error_percent"].get<double>(), 0.0);
    EXPECT_LT(row["delta_e2000"].get<double>(), 2.0);
    EXPECT_GT(row["fill_units"].get<double>(), 0.0);
    EXPECT_GT(row["precompute_s"].get<double>(), 0.0);
    EXPECT_TRUE(row["on_front"].is_boolean());
  }
  // But for the densities, 16 KiB of the whole.
  EXPECT_NEAR(half["memory_mib"].get<double>() / whole["memory_mib"].get<double>(), 0.5, 0.03);

  // The reference of another scene is refused.
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_THAT(tradeSky(sceneFile("whole_earth") + options),
              AllOf(HasSubstr("--reference"), HasSubstr("other scenes")));
  // So is one that has lost a direction.
  auto stored = nlohmann::ordered_json::parse(std::ifstream(file));
  auto& radiances = stored["skies"][0]["radiances"];
  radiances.erase(radiances.begin());
  std::ofstream(file) << stored;
  EXPECT_THAT(tradeSky(sceneFile("day_sky") + options),
              AllOf(HasSubstr("--reference"), HasSubstr("63 radiances"), HasSubstr("64")));
  std::filesystem::remove(file);
}

TEST(TradeSky, AveragesViews) {
  AirMeasurement day, space;
  day.error = {.luminance = 0.01, .worst = 0.02, .deltaE = 0.1, .worstDeltaE = 0.9};
  day.cost = {.fillUnits = 1.0, .milliseconds = 20.0, .precomputeSeconds = 0.5, .mebibytes = 0.9};
  space.error = {.luminance = 0.03, .worst = -0.05, .deltaE = 0.3, .worstDeltaE = 0.4};
  space.cost = {.fillUnits = 3.0, .milliseconds = 60.0, .mebibytes = 0.6};
  auto const both = overall({day, space});
  EXPECT_DOUBLE_EQ(both.error.luminance, 0.02);
  EXPECT_DOUBLE_EQ(both.error.worst, -0.05);
  EXPECT_DOUBLE_EQ(both.error.deltaE, 0.2);
  EXPECT_DOUBLE_EQ(both.error.worstDeltaE, 0.9);
  EXPECT_DOUBLE_EQ(both.cost.fillUnits, 2.0);
  EXPECT_DOUBLE_EQ(both.cost.milliseconds, 40.0);
  EXPECT_DOUBLE_EQ(both.cost.precomputeSeconds, 0.5);
  EXPECT_DOUBLE_EQ(both.cost.mebibytes, 0.9);
}

}  // namespace
}  // namespace antumbra
