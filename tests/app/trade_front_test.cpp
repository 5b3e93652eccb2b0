// The Pareto front and its output, against cases worked by hand.
#include "app/trade_front.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "document/input_error.h"

namespace antumbra {
namespace {

using Marks = std::vector<bool>;

TEST(TradeFrontTest, KeepsWhatNoPointBeats) {
  EXPECT_EQ(paretoFront({{1, 9}, {2, 5}, {3, 6}, {4, 1}, {2, 7}}),
            (Marks{true, true, false, true, false}));
  EXPECT_EQ(paretoFront({}), Marks{});
}

TEST(TradeFrontTest, KeepsTheFirstOfEqualPoints) {
  EXPECT_EQ(paretoFront({{2, 5}, {1, 9}, {2, 5}}), (Marks{true, true, false}));
}

TEST(TradeFrontTest, ErrorsBelowTheFloorDifferByCostAlone) {
  EXPECT_EQ(paretoFront({{1, 0.30}, {2, 0.09}, {3, 0.01}}, 0.1), (Marks{true, true, false}));
}

TEST(TradeFrontTest, LeavesOutWhatIsNotFinite) {
  EXPECT_EQ(paretoFront({{1, NAN}, {NAN, 1}, {1, INFINITY}, {2, 3}}),
            (Marks{false, false, false, true}));
}

TEST(TradeFrontTest, WeighsSeveralCostsAndTheirNoise) {
  // The second is beaten by the first but for noise, the third is cheaper in the second cost.
  EXPECT_EQ(paretoFront({{{1.0, 5.0}, 1.0}, {{0.98, 5.0}, 2.0}, {{1.0, 3.0}, 2.0}}, 0.0, 0.05, 0.0),
            (Marks{true, false, true}));
  // Without tolerance the second is the cheapest.
  EXPECT_EQ(paretoFront({{{1.0, 5.0}, 1.0}, {{0.98, 5.0}, 2.0}}, 0.0, 0.0, 0.0),
            (Marks{true, true}));
  // A difference of errors below the margin does not beat.
  EXPECT_EQ(paretoFront({{{1.0}, 1.00}, {{1.02}, 1.05}, {{1.0}, 1.5}}, 0.0, 0.05, 0.1),
            (Marks{true, true, false}));
}

TradeFront example() {
  TradeFront front("sky", "fill_units", "error_percent", 0.1);
  front.note("scene", "one.toml");
  front.add(
      {{"point", std::string("b")}, {"fill_units", cell(2.0, 2)}, {"error_percent", cell(3.0, 1)}});
  front.add(
      {{"point", std::string("a")}, {"fill_units", cell(1.0, 2)}, {"error_percent", cell(2.0, 1)}});
  return front;
}

TEST(TradeFrontTest, WritesJsonForThePlot) {
  auto const json = nlohmann::json::parse(example().text("json"));
  EXPECT_EQ(json["subject"], "sky");
  EXPECT_EQ(json["scene"], "one.toml");
  EXPECT_EQ(json["cost"], "fill_units");
  EXPECT_EQ(json["error"], "error_percent");
  EXPECT_DOUBLE_EQ(json["error_floor"], 0.1);
  EXPECT_EQ(json["complete"], true);
  ASSERT_EQ(json["rows"].size(), 2u);
  EXPECT_EQ(json["rows"][0]["on_front"], false);
  EXPECT_EQ(json["rows"][1]["on_front"], true);
}

TEST(TradeFrontTest, TheTableIsInOrderOfCost) {
  auto front = example();
  front.markIncomplete();
  std::string const table = front.text("table");
  EXPECT_LT(table.find("  a  "), table.find("  b  "));
  EXPECT_NE(table.find("interrupted"), std::string::npos);
  EXPECT_EQ(example().text("csv"),
            "point,fill_units,error_percent,on_front\nb,2.00,3.0,no\na,1.00,2.0,yes\n");
}

TEST(TradeFrontTest, RefusesRowsWithoutCostAndUnknownFormats) {
  TradeFront front("sky", "fill_units", "error_percent");
  EXPECT_THROW(front.add({{"fill_units", cell(1.0, 1)}}), std::logic_error);
  EXPECT_THROW(requireTradeOutput("xml", "-"), InputError);
  EXPECT_NO_THROW(requireTradeOutput("json", "-"));
  EXPECT_NO_THROW(requireTradeOutput("csv", "trade.csv"));
  EXPECT_THROW(requireTradeOutput("json", "/no/such/folder/trade.json"), InputError);
  EXPECT_THROW(requireTradeOutput("json", "/tmp"), InputError);
}

}  // namespace
}  // namespace antumbra
