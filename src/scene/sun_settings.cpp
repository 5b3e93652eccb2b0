#include "scene/sun_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "document/paths.h"

namespace antumbra {
namespace {

constexpr double kCycleYears = 11.0, kRiseYears = 4.8;

struct Extreme {
  bool maximum;
  double year;
};

std::vector<Extreme> readExtremes() {
  auto const file = catalogsFolder() / "sun" / "cycle.csv";
  std::ifstream content(file);
  if (!content) throw InputError(file.string() + ": cannot be read");
  std::vector<Extreme> extremes;
  int line = 0;
  for (std::string row; std::getline(content, row);) {
    ++line;
    if (row.empty() || row[0] == '#' || row.starts_with("kind")) continue;
    std::string const where = fmt::format("{}:{}", file.string(), line);
    auto const first = row.find(','), second = row.find(',', first + 1);
    if (second == std::string::npos || (!row.starts_with("min,") && !row.starts_with("max,")))
      throw InputError(fmt::format("{}: found \"{}\"; allowed: min|max,YEAR,MONTH", where, row));
    double const year = parseNumber(row.substr(first + 1, second - first - 1), where) +
                        (parseNumber(row.substr(second + 1), where) - 0.5) / 12.0;
    bool const maximum = row[1] == 'a';
    if (!extremes.empty() && (!(year > extremes.back().year) || maximum == extremes.back().maximum))
      throw InputError(where + ": minima and maxima must ascend and alternate");
    extremes.push_back({maximum, year});
  }
  if (extremes.empty()) throw InputError(file.string() + ": found no minimum or maximum");
  // Mean cycles on both sides.
  for (int i = 0; i < 2000; ++i) {
    Extreme const last = extremes.back();
    extremes.push_back(
        {!last.maximum, last.year + (last.maximum ? kCycleYears - kRiseYears : kRiseYears)});
  }
  std::vector<Extreme> before;
  for (Extreme next = extremes.front(); before.size() < 2000;) {
    next = {!next.maximum, next.year - (next.maximum ? kRiseYears : kCycleYears - kRiseYears)};
    before.push_back(next);
  }
  extremes.insert(extremes.begin(), before.rbegin(), before.rend());
  return extremes;
}

}  // namespace

SunSettings readSunSettings(const Table& table) {
  SunSettings s;
  if (table.has("activity")) {
    s.activity = table.number("activity");
    if (!(*s.activity >= 0.0 && *s.activity <= 1.0))
      table.fail("activity",
                 fmt::format("found {}; allowed: 0 (minimum of the cycle) to 1", *s.activity));
  }
  s.streamers =
      table.has("corona") && table.oneOf("corona", {"smooth", "streamers"}) == "streamers";
  s.prominences = static_cast<int>(table.integer("prominences", 0L));
  if (s.prominences < 0 || s.prominences > 24)
    table.fail("prominences", fmt::format("found {}; allowed: 0 to 24", s.prominences));
  s.drawn = table.boolean("drawn", true);
  s.coronaLight = table.boolean("corona_light", true);
  return s;
}

double solarActivity(Instant when) {
  static std::vector<Extreme> const extremes = readExtremes();
  double const year = when.julianYear();
  if (year <= extremes.front().year || year >= extremes.back().year) return 0.5;
  auto const after =
      std::upper_bound(extremes.begin(), extremes.end(), year,
                       [](double y, const Extreme& extreme) { return y < extreme.year; });
  Extreme const from = *(after - 1), to = *after;
  double const t = (year - from.year) / (to.year - from.year);
  double const rise = 0.5 - 0.5 * std::cos(std::numbers::pi * t);
  return to.maximum ? rise : 1.0 - rise;
}

}  // namespace antumbra
