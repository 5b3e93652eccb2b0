// Instants as text: ISO 8601 calendar dates and Julian dates, read and written.
#include <erfa.h>
#include <fmt/format.h>
#include <cmath>
#include <regex>

#include "document/document.h"
#include "time/delta_t.h"
#include "time/instant.h"

namespace antumbra {
namespace {

constexpr double kFirstLeapSecondDay = 2441317.5;  // 1972-01-01

[[noreturn]] void refuse(const std::string& where, std::string_view text, const std::string& why) {
  throw InputError(
      fmt::format("{}: found \"{}\"; {}; allowed: a date like 2027-08-02T10:07:50Z, "
                  "-0584-05-28T14:00 UT1, or a "
                  "Julian date with its scale like \"2451545.0 TT\" (TT, TDB, TAI, UTC, UT1)",
                  where, text, why));
}

TimeScale scaleNamed(const std::string& name) {
  if (name == "TT") return TimeScale::Tt;
  if (name == "TDB") return TimeScale::Tdb;
  if (name == "TAI") return TimeScale::Tai;
  if (name == "UT1") return TimeScale::Ut1;
  return TimeScale::Utc;
}

int daysInMonth(long year, int month) {
  CalendarDay const next =
      month == 12 ? CalendarDay{year + 1, 1, 1} : CalendarDay{year, month + 1, 1};
  return static_cast<int>(julianDayNumber(next) - julianDayNumber({year, month, 1}));
}

}  // namespace

Instant parseInstant(std::string_view view, const std::string& where, const DeltaT& deltaT) {
  std::string const text(view);
  static const std::regex julian(R"(\s*(?:JD\s*)?([-+]?\d+)(\.\d*)?\s*(TT|TDB|TAI|UTC|UT1)?\s*)");
  static const std::regex calendar(
      R"(\s*([-+]?\d{4,6})-(\d\d)-(\d\d)(?:[T ](\d\d):(\d\d)(?::(\d\d(?:\.\d*)?))?)?)"
      R"(\s*(Z|TT|TDB|TAI|UTC|UT1|[-+]\d\d:?\d\d)?\s*)");
  std::smatch m;
  if (std::regex_match(text, m, julian)) {
    if (!m[3].matched) refuse(where, text, "a Julian date needs its time scale");
    if (m[1].length() > 9) refuse(where, text, "the Julian date has too many digits");
    double const whole = std::stod(m[1].str());
    double const part =
        m[2].matched && m[2].length() > 1 ? std::stod(fmt::format("0{}", m[2].str())) : 0.0;
    return Instant::from(scaleNamed(m[3].str()),
                         {whole, text.find('-') == std::string::npos ? part : -part}, deltaT);
  }
  if (!std::regex_match(text, m, calendar)) refuse(where, text, "not a date");
  long const year = std::stol(m[1].str());
  int const month = std::stoi(m[2].str()), dayOfMonth = std::stoi(m[3].str());
  if (month < 1 || month > 12) refuse(where, text, "the month must be 01 to 12");
  if (year == 1582 && month == 10 && dayOfMonth > 4 && dayOfMonth < 15)
    refuse(where, text, "1582-10-05 to 1582-10-14 do not exist (start of the Gregorian calendar)");
  if (dayOfMonth < 1 || (dayOfMonth > daysInMonth(year, month) && !(year == 1582 && month == 10)) ||
      dayOfMonth > 31)
    refuse(where, text, "the month has no such day");
  int const hours = m[4].matched ? std::stoi(m[4].str()) : 0;
  int const minutes = m[5].matched ? std::stoi(m[5].str()) : 0;
  double const seconds = m[6].matched ? std::stod(m[6].str()) : 0.0;
  if (hours > 23 || minutes > 59) refuse(where, text, "the time of day must be 00:00 to 23:59");
  std::string const zone = m[7].matched ? m[7].str() : "Z";
  bool const offset = zone[0] == '+' || zone[0] == '-';
  TimeScale const scale = offset || zone == "Z" ? TimeScale::Utc : scaleNamed(zone);
  double offsetMinutes = 0.0;
  if (offset) {
    offsetMinutes = std::stoi(zone.substr(1, 2)) * 60 + std::stoi(zone.substr(zone.size() - 2));
    if (zone[0] == '-') offsetMinutes = -offsetMinutes;
  }
  long const dayNumber = julianDayNumber({year, month, dayOfMonth});
  double const midnight = static_cast<double>(dayNumber) - 0.5;
  if (scale == TimeScale::Utc && midnight >= kFirstLeapSecondDay) {
    double jd1, jd2;
    int const status = eraDtf2d("UTC", static_cast<int>(year), month, dayOfMonth, hours, minutes,
                                seconds, &jd1, &jd2);
    if (status < 0 || status == 2 || status == 3)
      refuse(where, text, "no such second on that day (60 is a leap second)");
    return Instant::from(scale, {jd1, jd2}, deltaT) - offsetMinutes * minute;
  }
  if (seconds >= 60.0) refuse(where, text, "seconds must be below 60 except in a UTC leap second");
  double const fraction = (hours * 3600.0 + minutes * 60.0 + seconds) / 86400.0;
  return Instant::from(scale, {midnight, fraction}, deltaT) - offsetMinutes * minute;
}

Instant parseInstant(std::string_view text, const std::string& where) {
  return parseInstant(text, where, DeltaT::standard());
}

std::string formatIso(Instant t, TimeScale scale, const DeltaT& deltaT, int decimals) {
  auto date = t.in(scale, deltaT);
  std::string const suffix = scale == TimeScale::Utc ? "Z" : fmt::format(" {}", nameOf(scale));
  if (scale == TimeScale::Utc && date.value() >= kFirstLeapSecondDay) {
    int year, month, dayOfMonth, clock[4];
    eraD2dtf("UTC", std::min(decimals, 9), date.whole, date.fraction, &year, &month, &dayOfMonth,
             clock);
    std::string const part =
        decimals > 0 ? fmt::format(".{:0{}d}", clock[3], std::min(decimals, 9)) : "";
    return fmt::format("{:04d}-{:02d}-{:02d}T{:02d}:{:02d}:{:02d}{}{}", year, month, dayOfMonth,
                       clock[0], clock[1], clock[2], part, suffix);
  }
  double const unit = std::pow(10.0, decimals);
  double dayNumber = std::floor(date.whole + 0.5);
  double ticks = std::round(((date.whole - dayNumber + 0.5) + date.fraction) * 86400.0 * unit);
  double const ticksPerDay = 86400.0 * unit;
  dayNumber += std::floor(ticks / ticksPerDay);
  ticks -= std::floor(ticks / ticksPerDay) * ticksPerDay;
  auto const c = calendarDay(static_cast<long>(dayNumber));
  double const wholeSeconds = std::floor(ticks / unit);
  long const s = static_cast<long>(wholeSeconds);
  long const rest = static_cast<long>(ticks - wholeSeconds * unit);
  std::string const year =
      c.year < 0 ? fmt::format("-{:04d}", -c.year) : fmt::format("{:04d}", c.year);
  std::string const part = decimals > 0 ? fmt::format(".{:0{}d}", rest, decimals) : "";
  return fmt::format("{}-{:02d}-{:02d}T{:02d}:{:02d}:{:02d}{}{}", year, c.month, c.day, s / 3600,
                     s / 60 % 60, s % 60, part, suffix);
}

std::string formatIso(Instant t, TimeScale scale, int decimals) {
  return formatIso(t, scale, DeltaT::standard(), decimals);
}

}  // namespace antumbra
