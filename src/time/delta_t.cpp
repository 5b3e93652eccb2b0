#include "time/delta_t.h"

#include <fmt/format.h>
#include <cmath>
#include <fstream>
#include <sstream>

#include "document/document.h"
#include "document/paths.h"

namespace antumbra {
namespace {

constexpr double kBlendYears = 800.0;  // over which the spline's ends join the parabola

double parabola(double year) {
  double const u = (year - 1825.0) / 100.0;
  return -320.0 + 32.5 * u * u;
}
double parabolaSlope(double year) { return 2.0 * 32.5 * (year - 1825.0) / 1e4; }

// The cubic with given values and slopes at a and b.
double hermite(double x, double a, double b, double ya, double yb, double sa, double sb) {
  double const h = b - a, u = (x - a) / h, v = 1.0 - u;
  return ya * (1.0 + 2.0 * u) * v * v + yb * (3.0 - 2.0 * u) * u * u +
         h * u * v * (sa * v - sb * u);
}

double mjdOf(Instant t) {
  auto const tt = t.tt();
  return (tt.whole - 2400000.5) + tt.fraction;
}

}  // namespace

const DeltaT& DeltaT::standard() {
  static const DeltaT table = [] {
    auto const file = catalogsFolder() / "ephemeris" / "delta_t.txt";
    std::ifstream in(file);
    if (!in) throw InputError(file.string() + ": cannot be read; allowed: the delta T catalogue");
    DeltaT d;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      std::istringstream words(line);
      std::string kind;
      if (!(words >> kind) || kind[0] == '#') continue;
      Cubic c{};
      double value;
      if (kind == "segment" && words >> c.from >> c.to >> c.a3 >> c.a2 >> c.a1 >> c.a0) {
        d.cubics_.push_back(c);
      } else if (kind == "monthly" && words >> d.firstYear_ >> d.firstMonth_) {
      } else if (kind == "values") {
        while (words >> value) d.monthly_.push_back(value);
      } else {
        throw InputError(fmt::format("{}:{}: found \"{}\"; allowed: segment, monthly, values",
                                     file.string(), number, line));
      }
    }
    if (d.cubics_.empty() || d.monthly_.size() < 13)
      throw InputError(file.string() + ": holds no complete table");
    d.firstMonthly_ = static_cast<double>(d.firstYear_) + (d.firstMonth_ - 1) / 12.0;
    d.lastMonthly_ = d.firstMonthly_ + static_cast<double>(d.monthly_.size() - 1) / 12.0;
    return d;
  }();
  return table;
}

DeltaT DeltaT::fixed(Duration value) {
  DeltaT d;
  d.fixed_ = value / second;
  return d;
}

DeltaT DeltaT::fromEarthOrientationFile(const std::string& file) {
  DeltaT d = standard();
  std::ifstream in(file);
  if (!in) throw InputError(file + ": cannot be read; allowed: an Earth-orientation table");
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    line = line.substr(0, line.find('#'));
    std::istringstream words(line);
    std::vector<double> v;
    std::string word;
    std::string const where = fmt::format("{}:{}", file, number);
    while (words >> word) v.push_back(parseNumber(word, where));
    if (v.empty()) continue;
    if (v.size() != 2 && v.size() != 4)
      throw InputError(
          fmt::format("{}: found {} numbers; allowed: MJD, UT1-UTC in seconds, and "
                      "optionally x and y of the pole in arcseconds",
                      where, v.size()));
    if (!d.rows_.empty() && v[0] <= d.rows_.back().utcModifiedJulianDate)
      throw InputError(fmt::format("{}: found MJD {}; dates must ascend", where, v[0]));
    if (std::fabs(v[1]) > 1.0)
      throw InputError(fmt::format("{}: found UT1-UTC = {} s; allowed: -1 to 1", where, v[1]));
    d.rows_.push_back({v[0], v[1] * second, v.size() == 4 ? v[2] * arcsecond : Angle(),
                       v.size() == 4 ? v[3] * arcsecond : Angle()});
  }
  if (d.rows_.size() < 2) throw InputError(file + ": found fewer than two rows");
  return d;
}

double DeltaT::observedAt(double year) const {
  if (year >= firstMonthly_) {
    // Cubic through four months around; linear at the two ends.
    double const x = (year - firstMonthly_) * 12.0;
    auto const n = monthly_.size();
    auto const i = std::min(static_cast<std::size_t>(x), n - 2);
    double const u = x - static_cast<double>(i);
    double const a = monthly_[i], b = monthly_[i + 1];
    if (i == 0 || i + 2 >= n) return a + u * (b - a);
    double const before = monthly_[i - 1], after = monthly_[i + 2];
    return a + 0.5 * u *
                   (b - before +
                    u * (2.0 * before - 5.0 * a + 4.0 * b - after +
                         u * (3.0 * (a - b) + after - before)));
  }
  for (const auto& c : cubics_)
    if (year < c.to) {
      double const u = (year - c.from) / (c.to - c.from);
      double const spline = ((c.a3 * u + c.a2) * u + c.a1) * u + c.a0;
      // The year before the monthly table carries the spline over to it.
      double const weight = std::clamp(year - (firstMonthly_ - 1.0), 0.0, 1.0);
      return spline + (weight > 0.0 ? weight * (monthly_.front() - spline) : 0.0);
    }
  return monthly_.front();
}

double DeltaT::secondsAt(double year) const {
  if (fixed_) return *fixed_;
  double const first = cubics_.front().from;
  if (year >= first && year <= lastMonthly_) return observedAt(year);
  if (year < first) {
    double const far = first - kBlendYears;
    auto const& c = cubics_.front();
    return year < far ? parabola(year)
                      : hermite(year, far, first, parabola(far), c.a0, parabolaSlope(far),
                                c.a1 / (c.to - c.from));
  }
  double const far = lastMonthly_ + kBlendYears;
  // The slope of the last five years: the seasonal wave of the monthly values averages out.
  double const slope = (observedAt(lastMonthly_) - observedAt(lastMonthly_ - 5.0)) / 5.0;
  return year > far ? parabola(year)
                    : hermite(year, lastMonthly_, far, observedAt(lastMonthly_), parabola(far),
                              slope, parabolaSlope(far));
}

Duration DeltaT::at(Instant t) const {
  if (!rows_.empty()) {
    double const mjd = mjdOf(t);
    if (mjd >= rows_.front().utcModifiedJulianDate && mjd <= rows_.back().utcModifiedJulianDate) {
      auto const after = std::upper_bound(
          rows_.begin() + 1, rows_.end() - 1, mjd,
          [](double m, const EarthOrientationRow& r) { return m < r.utcModifiedJulianDate; });
      auto const& b = *after;
      auto const& a = *(after - 1);
      double const u =
          (mjd - a.utcModifiedJulianDate) / (b.utcModifiedJulianDate - a.utcModifiedJulianDate);
      // UT1 - TAI is smooth across a leap second, UT1 - UTC is not.
      auto const taiMinusUtc = [&](double m) {
        auto const utc = JulianDate{2400000.5, m};
        return 86400.0 * (((Instant::fromUtc(utc).tai().whole - utc.whole) - utc.fraction) +
                          Instant::fromUtc(utc).tai().fraction);
      };
      double const first = taiMinusUtc(a.utcModifiedJulianDate) - a.ut1MinusUtc / second;
      double const next = taiMinusUtc(b.utcModifiedJulianDate) - b.ut1MinusUtc / second;
      return (32.184 + first + u * (next - first)) * second;
    }
  }
  return secondsAt(t.julianYear()) * second;
}

std::pair<Angle, Angle> DeltaT::pole(Instant t) const {
  double const mjd = mjdOf(t);
  if (rows_.empty() || mjd < rows_.front().utcModifiedJulianDate ||
      mjd > rows_.back().utcModifiedJulianDate)
    return {};
  auto const after = std::upper_bound(
      rows_.begin() + 1, rows_.end() - 1, mjd,
      [](double m, const EarthOrientationRow& r) { return m < r.utcModifiedJulianDate; });
  auto const& b = *after;
  auto const& a = *(after - 1);
  double const u =
      (mjd - a.utcModifiedJulianDate) / (b.utcModifiedJulianDate - a.utcModifiedJulianDate);
  return {a.poleX + u * (b.poleX - a.poleX), a.poleY + u * (b.poleY - a.poleY)};
}

DeltaTValue DeltaT::explain(Instant t) const {
  double const year = t.julianYear();
  DeltaTValue v{at(t), Duration(), ""};
  if (fixed_) {
    v.source = "given";
    return v;
  }
  double const mjd = mjdOf(t);
  double const u = (year - 1820.0) / 100.0;
  if (!rows_.empty() && mjd >= rows_.front().utcModifiedJulianDate &&
      mjd <= rows_.back().utcModifiedJulianDate) {
    v.source = "Earth-orientation table";
    v.uncertainty = 0.0001 * second;
  } else if (year > lastMonthly_) {
    // Huber 2006: sigma = 365.25 N sqrt(N Q / 3 (1 + N / M)) / 1000, Q = 0.058 ms^2/yr, M = 2500
    // yr.
    double const n = year - lastMonthly_;
    v.uncertainty = 0.36525 * n * std::sqrt(n * 0.058 / 3.0 * (1.0 + n / 2500.0)) * second;
    v.source = "extrapolated to the parabola of Morrison et al. 2021";
  } else if (year >= firstMonthly_) {
    v.uncertainty = 0.005 * second;
    v.source = "US Naval Observatory, monthly";
  } else if (year >= cubics_.front().from) {
    // Before the telescope the parabola of Morrison & Stephenson 2004; then their table's order of
    // magnitude, falling from 20 s (1600) to 1 s (1800) and 0.1 s (1900).
    double const sigma = year < 1600.0   ? std::max(0.8 * u * u, 20.0)
                         : year < 1800.0 ? 20.0 * std::pow(20.0, (1600.0 - year) / 200.0)
                                         : std::max(std::pow(10.0, (1800.0 - year) / 100.0), 0.05);
    v.uncertainty = sigma * second;
    v.source = "Morrison et al. 2021, Table S15";
  } else {
    v.uncertainty = 0.8 * u * u * second;
    v.source = "parabola of Morrison et al. 2021";
  }
  return v;
}

}  // namespace antumbra
