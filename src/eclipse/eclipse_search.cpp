// From mean syzygies to exact eclipses.
#include "eclipse/eclipse_search.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "document/input_error.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

// Every eclipse lasts less than 3.2 h before and after its greatest instant; the mean elements
// leave up to half an hour.
constexpr Duration kHalfSpan{4.0 * 3600.0};

SunMoonTrack trackAbout(const EclipseBasis& basis, Instant middle) {
  return SunMoonTrack(*basis.ephemeris, middle, kHalfSpan, basis.deltaTAt(middle));
}

std::optional<SolarEvent> solarEventAt(const EclipseBasis& basis, const Syzygy& syzygy) {
  SunMoonTrack track = trackAbout(basis, syzygy.greatest);
  auto eclipse = solarEclipse(track, basis.radii());
  if (!eclipse) return std::nullopt;
  eclipse->id = dateOf(eclipse->greatest);
  eclipse->lunation = brownLunation(syzygy.lunation);
  eclipse->saros = sarosNumber(EclipseKind::Solar, syzygy.lunation);
  return SolarEvent{track, *eclipse};
}

std::optional<LunarEvent> lunarEventAt(const EclipseBasis& basis, const Syzygy& syzygy) {
  SunMoonTrack track = trackAbout(basis, syzygy.greatest);
  auto eclipse = lunarEclipse(track, basis.convention, basis.enlargement);
  if (!eclipse) return std::nullopt;
  eclipse->id = dateOf(eclipse->greatest);
  eclipse->lunation = brownLunation(syzygy.lunation);
  eclipse->saros = sarosNumber(EclipseKind::Lunar, syzygy.lunation);
  return LunarEvent{track, *eclipse};
}

template <class Event>
std::optional<Event> eventAt(const EclipseBasis& basis, const Syzygy& syzygy) {
  if constexpr (std::is_same_v<Event, SolarEvent>)
    return solarEventAt(basis, syzygy);
  else
    return lunarEventAt(basis, syzygy);
}

template <class Event>
constexpr EclipseKind kKindOf =
    std::is_same_v<Event, SolarEvent> ? EclipseKind::Solar : EclipseKind::Lunar;

template <class Event>
auto allIn(const EclipseBasis& basis, Instant from, Instant to, const Progress& progress) {
  std::vector<decltype(Event::eclipse)> found;
  auto const candidates = eclipseCandidates(kKindOf<Event>, from, to);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    auto const event = eventAt<Event>(basis, candidates[i]);
    if (event && event->eclipse.greatest >= from && event->eclipse.greatest < to)
      found.push_back(event->eclipse);
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(candidates.size()));
  }
  return found;
}

template <class Event>
std::optional<Event> findOn(const EclipseBasis& basis, const std::string& id, Instant start) {
  for (auto const& syzygy : eclipseCandidates(kKindOf<Event>, start - 1.0 * day, start + 2.0 * day))
    if (auto event = eventAt<Event>(basis, syzygy); event && event->eclipse.id == id) return event;
  return std::nullopt;
}

// "2027-08-02 and 2028-01-26": the eclipses before and after a day.
template <class Event>
std::string nearestTo(const EclipseBasis& basis, Instant start) {
  std::string nearest;
  for (int side = 0; side < 2; ++side) {
    auto const candidates = side == 0
                                ? eclipseCandidates(kKindOf<Event>, start - 400.0 * day, start)
                                : eclipseCandidates(kKindOf<Event>, start, start + 400.0 * day);
    std::string found;
    for (auto const& syzygy : candidates) {
      if (side == 1 && !found.empty()) break;
      if (auto event = eventAt<Event>(basis, syzygy)) found = event->eclipse.id;
    }
    if (!found.empty()) nearest += (nearest.empty() ? "" : " and ") + found;
  }
  return nearest;
}

template <class Event>
Event eventOn(const EclipseBasis& basis, const std::string& id, const std::string& where) {
  Instant const start = startOfDate(id, where);
  if (auto event = findOn<Event>(basis, id, start)) return *event;
  throw InputError(fmt::format("{}: no {} eclipse on {} (TT); the nearest are {}", where,
                               kKindOf<Event> == EclipseKind::Solar ? "solar" : "lunar", id,
                               nearestTo<Event>(basis, start)));
}

}  // namespace

Duration EclipseBasis::deltaTAt(Instant t) const {
  return deltaT ? *deltaT : DeltaT::standard().at(t);
}

ShadowRadii EclipseBasis::radii() const {
  return convention.radiiOf("Moon", convention.lunarKUmbra * kEarthEquatorialRadius);
}

std::vector<SolarEclipse> solarEclipses(const EclipseBasis& basis, Instant from, Instant to,
                                        const Progress& progress) {
  return allIn<SolarEvent>(basis, from, to, progress);
}

std::vector<LunarEclipse> lunarEclipses(const EclipseBasis& basis, Instant from, Instant to,
                                        const Progress& progress) {
  return allIn<LunarEvent>(basis, from, to, progress);
}

SolarEvent solarEventOn(const EclipseBasis& basis, const std::string& id,
                        const std::string& where) {
  return eventOn<SolarEvent>(basis, id, where);
}

LunarEvent lunarEventOn(const EclipseBasis& basis, const std::string& id,
                        const std::string& where) {
  return eventOn<LunarEvent>(basis, id, where);
}

std::variant<SolarEvent, LunarEvent> eclipseOn(const EclipseBasis& basis, const std::string& id,
                                               const std::string& where) {
  Instant const start = startOfDate(id, where);
  if (auto solar = findOn<SolarEvent>(basis, id, start)) return *solar;
  if (auto lunar = findOn<LunarEvent>(basis, id, start)) return *lunar;
  throw InputError(
      fmt::format("{}: no eclipse on {} (TT); the nearest are {} (solar) and {} (lunar)", where, id,
                  nearestTo<SolarEvent>(basis, start), nearestTo<LunarEvent>(basis, start)));
}

Instant startOfYear(long year) {
  return Instant::fromTt({static_cast<double>(julianDayNumber({year, 1, 1})), -0.5});
}

Instant startOfDate(const std::string& text, const std::string& where) {
  auto const refuse = [&]() -> InputError {
    return InputError(
        fmt::format("{}: found \"{}\"; a date is written YYYY-MM-DD, as 2027-08-02", where, text));
  };
  std::size_t const month = text.find('-', 1);
  if (month == std::string::npos || text.size() != month + 6 || text[month + 3] != '-')
    throw refuse();
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool const dash = i == month || i == month + 3 || (i == 0 && text[0] == '-');
    if (!dash && (text[i] < '0' || text[i] > '9')) throw refuse();
  }
  CalendarDay const date{std::strtol(text.substr(0, month).c_str(), nullptr, 10),
                         std::atoi(text.substr(month + 1, 2).c_str()),
                         std::atoi(text.substr(month + 4, 2).c_str())};
  if (month < 4 || std::labs(date.year) > 20000) throw refuse();
  long const number = julianDayNumber(date);
  CalendarDay const back = calendarDay(number);
  if (back.year != date.year || back.month != date.month || back.day != date.day) throw refuse();
  return Instant::fromTt({static_cast<double>(number), -0.5});
}

std::string dateOf(Instant t) {
  auto const tt = t.tt();
  CalendarDay const date = calendarDay(static_cast<long>(std::floor(tt.whole + 0.5 + tt.fraction)));
  return fmt::format("{}{:04d}-{:02d}-{:02d}", date.year < 0 ? "-" : "", std::labs(date.year),
                     date.month, date.day);
}

std::string ut1Text(Instant t, Duration deltaT) {
  std::string text = formatIso(t, TimeScale::Ut1, DeltaT::fixed(deltaT), 3);
  return text.substr(0, text.find(' '));
}

}  // namespace antumbra
