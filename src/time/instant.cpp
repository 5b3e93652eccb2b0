#include "time/instant.h"

#include <erfa.h>
#include <fmt/format.h>
#include <charconv>
#include <cmath>

#include "document/document.h"
#include "time/delta_t.h"

namespace antumbra {
namespace {

constexpr double kJ2000 = 2451545.0;
constexpr double kTtMinusTaiDays = 32.184 / 86400.0;  // IAU 1991, exact
constexpr double kFirstUtc = 2436934.5;               // 1960-01-01
constexpr double kLastUtc = 2464693.5;                // 2036-01-01

JulianDate normalised(double a, double b) {
  // Two-sum keeps the digits that the larger part would swallow.
  double const sum = a + b;
  double const back = sum - a;
  double const lost = (a - (sum - back)) + (b - back);
  double const whole = std::floor(sum + 0.5);
  return {whole, (sum - whole) + lost};
}

bool utcDefined(double julianDate) { return julianDate >= kFirstUtc && julianDate < kLastUtc; }

double tdbMinusTtSeconds(double centuries) {
  // USNO Circular 179, eq. 2.6.
  double const t = centuries;
  return 0.001657 * std::sin(628.3076 * t + 6.2401) + 0.000022 * std::sin(575.3385 * t + 4.2970) +
         0.000014 * std::sin(1256.6152 * t + 6.1969) + 0.000005 * std::sin(606.9777 * t + 4.0212) +
         0.000005 * std::sin(52.9691 * t + 0.4444) + 0.000002 * std::sin(21.3299 * t + 5.5431) +
         0.000010 * t * std::sin(628.3076 * t + 4.2490);
}

}  // namespace

std::string nameOf(TimeScale scale) {
  switch (scale) {
    case TimeScale::Tt:
      return "TT";
    case TimeScale::Tdb:
      return "TDB";
    case TimeScale::Tai:
      return "TAI";
    case TimeScale::Utc:
      return "UTC";
    case TimeScale::Ut1:
      return "UT1";
  }
  return "TT";
}

Instant::Instant(double whole, double fraction) {
  auto const n = normalised(whole, fraction);
  whole_ = n.whole;
  fraction_ = n.fraction;
}

Instant operator+(Instant a, Duration d) { return Instant(a.whole_, a.fraction_ + d / day); }

Instant Instant::fromTt(JulianDate date) { return Instant(date.whole, date.fraction); }

Instant Instant::fromTdb(JulianDate date) {
  double const offset = tdbMinusTtSeconds(((date.whole - kJ2000) + date.fraction) / 36525.0);
  return Instant(date.whole, date.fraction) - offset * second;
}

Instant Instant::fromTai(JulianDate date) {
  return Instant(date.whole, date.fraction) + kTtMinusTaiDays * day;
}

Instant Instant::fromUtc(JulianDate date) {
  if (!utcDefined(date.value()))
    throw InputError(
        fmt::format("UTC Julian date {:.6f}: UTC is defined here from 1960-01-01 to "
                    "2035-12-31; give the instant in UT1, TT or TDB",
                    date.value()));
  double tai1, tai2;
  eraUtctai(date.whole, date.fraction, &tai1, &tai2);
  return fromTai({tai1, tai2});
}

Instant Instant::fromUt1(JulianDate date, const DeltaT& deltaT) {
  Instant const asTt(date.whole, date.fraction);
  // Delta T is a function of TT; two steps settle it to 1e-9 s (its slope is below 1e-6).
  Instant t = asTt + deltaT.at(asTt);
  for (int i = 0; i < 2; ++i) t = asTt + deltaT.at(t);
  return t;
}

Instant Instant::from(TimeScale scale, JulianDate date, const DeltaT& deltaT) {
  switch (scale) {
    case TimeScale::Tt:
      return fromTt(date);
    case TimeScale::Tdb:
      return fromTdb(date);
    case TimeScale::Tai:
      return fromTai(date);
    case TimeScale::Utc:
      return utcDefined(date.value()) ? fromUtc(date) : fromUt1(date, deltaT);
    case TimeScale::Ut1:
      return fromUt1(date, deltaT);
  }
  return {};
}

Duration tdbMinusTt(Instant t) { return tdbMinusTtSeconds(t.ttCenturiesSinceJ2000()) * second; }

JulianDate Instant::tdb() const { return normalised(whole_, fraction_ + tdbMinusTt(*this) / day); }

JulianDate Instant::tai() const { return normalised(whole_, fraction_ - kTtMinusTaiDays); }

JulianDate Instant::utc() const {
  auto const atomic = tai();
  if (!utcDefined(atomic.value()))
    throw InputError(
        fmt::format("instant JD {:.6f} TT: UTC is defined here from 1960-01-01 to "
                    "2035-12-31",
                    tt().value()));
  double utc1, utc2;
  eraTaiutc(atomic.whole, atomic.fraction, &utc1, &utc2);
  return {utc1, utc2};
}

JulianDate Instant::ut1(const DeltaT& deltaT) const {
  return normalised(whole_, fraction_ - deltaT.at(*this) / day);
}

JulianDate Instant::in(TimeScale scale, const DeltaT& deltaT) const {
  switch (scale) {
    case TimeScale::Tt:
      return tt();
    case TimeScale::Tdb:
      return tdb();
    case TimeScale::Tai:
      return tai();
    case TimeScale::Utc:
      return utcDefined(tai().value()) ? utc() : ut1(deltaT);
    case TimeScale::Ut1:
      return ut1(deltaT);
  }
  return tt();
}

double Instant::tdbDaysSinceJ2000() const {
  double const ttDays = (whole_ - kJ2000) + fraction_;
  return (whole_ - kJ2000) + (fraction_ + tdbMinusTtSeconds(ttDays / 36525.0) / 86400.0);
}

double Instant::ttCenturiesSinceJ2000() const { return ((whole_ - kJ2000) + fraction_) / 36525.0; }

long julianDayNumber(CalendarDay date) {
  // Fliegel & Van Flandern's integer form, written with floored divisions for years before -4800.
  auto floorDiv = [](long a, long b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); };
  bool const gregorian =
      date.year > 1582 ||
      (date.year == 1582 && (date.month > 10 || (date.month == 10 && date.day >= 15)));
  long const shift = floorDiv(14 - date.month, 12);
  long const y = date.year + 4800 - shift;
  long const m = date.month + 12 * shift - 3;
  long const base = date.day + floorDiv(153 * m + 2, 5) + 365 * y + floorDiv(y, 4);
  return gregorian ? base - floorDiv(y, 100) + floorDiv(y, 400) - 32045 : base - 32083;
}

CalendarDay calendarDay(long number) {
  auto floorDiv = [](long a, long b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); };
  long c = number + 32082, b = 0;
  if (number >= 2299161) {  // 1582-10-15
    long const a = number + 32044;
    b = floorDiv(4 * a + 3, 146097);
    c = a - floorDiv(146097 * b, 4);
  }
  long const d = floorDiv(4 * c + 3, 1461);
  long const e = c - floorDiv(1461 * d, 4);
  long const m = floorDiv(5 * e + 2, 153);
  return {100 * b + d - 4800 + floorDiv(m, 10), static_cast<int>(m + 3 - 12 * floorDiv(m, 10)),
          static_cast<int>(e - floorDiv(153 * m + 2, 5) + 1)};
}

}  // namespace antumbra
