// What `antumbra eclipse at` says about a lunar eclipse.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "eclipse/lunar_local.h"

namespace antumbra {

// `value` to so many decimals, never -0.
double rounded(double value, int decimals);

nlohmann::ordered_json lunarReport(const LunarEvent& event, const EclipseBasis& basis,
                                   const Site& site);
// `report` with its "site".
std::string lunarTable(const nlohmann::ordered_json& report, const std::string& basis);

}  // namespace antumbra
