#include "ephemeris/tiers.h"

#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "document/document.h"
#include "document/paths.h"

namespace antumbra {
namespace {

// Mean distances of the planets in au, VSOP87's own a0; the scale of the radius' threshold.
constexpr double kMeanDistanceAu[kPlanets] = {0.38710, 0.72333, 1.00000,  1.52368,
                                              5.20260, 9.55491, 19.21845, 30.11039};
// The radius of Mercury does not enter its heliocentric direction, which decides its error.
constexpr double kRadiusSlack[kPlanets] = {1.5, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
constexpr double kMoonMeanDistanceKm = 384400.0;

}  // namespace

const std::vector<TierRow>& tierRows() {
  static const std::vector<TierRow> rows = [] {
    auto const file = catalogsFolder() / "ephemeris" / "tiers.txt";
    std::ifstream in(file);
    if (!in)
      throw InputError(file.string() + ": cannot be read; allowed: the table of error tiers");
    std::vector<TierRow> r;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      if (line.empty() || line[0] == '#') continue;
      std::istringstream words(line);
      TierRow row;
      std::string span;
      if (!(words >> row.body >> span >> row.thresholdRadians >> row.terms >>
            row.maxErrorArcseconds) ||
          (span != "near" && span != "whole"))
        throw InputError(
            fmt::format("{}:{}: found \"{}\"; allowed: body, near or whole, threshold, "
                        "terms, error",
                        file.string(), number, line));
      row.span = span == "near" ? TierSpan::NearPresent : TierSpan::Whole;
      r.push_back(row);
    }
    return r;
  }();
  return rows;
}

TierRow tierFor(const std::string& body, TierSpan span, Angle error) {
  TierRow best{body, span, 0.0, 0, 0.0};
  for (const auto& row : tierRows())
    if (row.body == body && row.span == span && row.thresholdRadians > best.thresholdRadians &&
        row.maxErrorArcseconds * kTierMargin <= error / arcsecond)
      best = row;
  return best;
}

Angle truncate(PlanetSeries& s, Planet planet, double threshold, TierSpan span) {
  double const millennia = span == TierSpan::NearPresent ? 0.1 : 5.0;
  double const a = kMeanDistanceAu[static_cast<int>(planet)];
  double const l = s.longitude.truncate(threshold, millennia);
  double const b = s.latitude.truncate(threshold, millennia);
  double const r =
      s.radius.truncate(kRadiusSlack[static_cast<int>(planet)] * threshold * a, millennia);
  return std::hypot(l, b, r / a) * radian;
}

Angle truncate(MoonSeries& s, double threshold, TierSpan span) {
  double const centuries = span == TierSpan::NearPresent ? 1.0 : 50.0;
  double const l = s.longitude.truncate(threshold / arcsecond.si, centuries) * arcsecond.si;
  double const b = s.latitude.truncate(threshold / arcsecond.si, centuries) * arcsecond.si;
  // The distance does not enter the direction: it may err by twice as much of itself.
  double const r = s.distance.truncate(2.0 * threshold * kMoonMeanDistanceKm, centuries);
  return std::hypot(l, b, r / kMoonMeanDistanceKm) * radian;
}

}  // namespace antumbra
