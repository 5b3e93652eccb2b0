#include "app/row_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace antumbra {

std::string textOf(const Cell& cell) {
  if (auto const* text = std::get_if<std::string>(&cell)) return *text;
  if (auto const* number = std::get_if<Decimal>(&cell)) {
    std::string written = fmt::format("{:.{}f}", number->value, number->decimals);
    // Never "-0.000".
    if (written.find_first_not_of("-0.") == std::string::npos && written[0] == '-')
      written.erase(0, 1);
    return written;
  }
  return {};
}

std::string RowTable::text(const std::string& format,
                           const std::vector<std::string>& columns) const {
  if (format == "json") {
    auto array = nlohmann::ordered_json::array();
    for (auto const& row : rows_) {
      nlohmann::ordered_json object;
      for (auto const& [name, value] : row) {
        if (auto const* number = std::get_if<Decimal>(&value)) {
          double const scale = std::pow(10.0, number->decimals);
          object[name] = number->decimals == 0
                             ? nlohmann::ordered_json(std::llround(number->value))
                             : nlohmann::ordered_json(std::round(number->value * scale) / scale);
        } else if (auto const* text = std::get_if<std::string>(&value)) {
          object[name] = *text;
        } else {
          object[name] = nullptr;
        }
      }
      array.push_back(std::move(object));
    }
    return array.dump(2) + "\n";
  }
  std::vector<std::string> names = columns;
  if (!rows_.empty()) {
    names.clear();
    for (auto const& [name, value] : rows_.front()) names.push_back(name);
  }
  std::string out;
  if (format == "csv") {
    out = fmt::format("{}\n", fmt::join(names, ","));
    for (auto const& row : rows_) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (i > 0) out += ',';
        out += textOf(row[i].second);
      }
      out += '\n';
    }
    return out;
  }
  std::vector<std::size_t> widths;
  for (auto const& name : names) widths.push_back(name.size());
  for (auto const& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], textOf(row[i].second).size());
  for (std::size_t i = 0; i < names.size(); ++i)
    out += fmt::format("{:>{}}  ", names[i], widths[i]);
  out += '\n';
  for (auto const& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out += fmt::format("{:>{}}  ", textOf(row[i].second), widths[i]);
    out += '\n';
  }
  return out;
}

}  // namespace antumbra
