// All eclipses in a span, and the eclipse of a date.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "eclipse/lunar_circumstances.h"
#include "eclipse/solar_circumstances.h"
#include "eclipse/syzygy.h"

namespace antumbra {

// What every prediction rests on.
struct EclipseBasis {
  const Ephemeris* ephemeris = &Ephemeris::standard();
  ShadowConvention convention = ShadowConvention::named("nasa", "convention");
  ShadowEnlargement enlargement = ShadowEnlargement::Danjon;
  std::optional<Duration> deltaT;  // for every date; otherwise DeltaT::standard()

  Duration deltaTAt(Instant t) const;
  ShadowRadii radii() const;
};

// An eclipse with the track it was found on.
struct SolarEvent {
  SunMoonTrack track;
  SolarEclipse eclipse;
};
struct LunarEvent {
  SunMoonTrack track;
  LunarEclipse eclipse;
};

using Progress = std::function<void(double fractionDone)>;

// Eclipses whose greatest instant (TT) lies in [from, to), in order. Throws SpanError where the
// ephemeris does not reach.
std::vector<SolarEclipse> solarEclipses(const EclipseBasis& basis, Instant from, Instant to,
                                        const Progress& progress = {});
std::vector<LunarEclipse> lunarEclipses(const EclipseBasis& basis, Instant from, Instant to,
                                        const Progress& progress = {});

// The eclipse whose id is `id` ("2027-08-02"). Throws InputError that opens with `where` and offers
// the nearest eclipse before and after if there is none.
SolarEvent solarEventOn(const EclipseBasis& basis, const std::string& id, const std::string& where);
LunarEvent lunarEventOn(const EclipseBasis& basis, const std::string& id, const std::string& where);
// Of either kind.
std::variant<SolarEvent, LunarEvent> eclipseOn(const EclipseBasis& basis, const std::string& id,
                                               const std::string& where);

// First instant of a calendar year, and of a date written "2027-08-02" or "-0584-05-28".
Instant startOfYear(long year);
Instant startOfDate(const std::string& text, const std::string& where);
// "2027-08-02", of TT.
std::string dateOf(Instant t);
// "2027-08-02T10:02:06.606" of UT1 at that delta T.
std::string ut1Text(Instant t, Duration deltaT);

}  // namespace antumbra
