// An instant of physical time, and its readings in the scales of astronomy.
//
// Held as terrestrial time (TT): a two-part Julian date, whole days and a fraction, so that it
// resolves 1e-11 s at any date. TDB - TT by the seven largest terms of Fairhead & Bretagnon 1990
// (as in USNO Circular 179, eq. 2.6; 10 microseconds over 1600-2200, and cheap enough for every
// evaluation of a body). TAI and UTC by ERFA's leap seconds. UT1 needs a delta T (time/delta_t.h).
//
// UTC exists from 1960. Before that, and after 2035-12-31 (resolution 4 of the 27th CGPM leaves
// leap seconds open beyond), a civil time "Z" is read as UT1.
//
// Calendar: Gregorian from 1582-10-15, Julian before; years are astronomical (0 is 1 BC).
#pragma once

#include <string>
#include <string_view>

#include "quantity/quantity.h"

namespace antumbra {

class DeltaT;

enum class TimeScale { Tt, Tdb, Tai, Utc, Ut1 };
std::string nameOf(TimeScale scale);

// A Julian date as two doubles whose sum is meant; any split is allowed.
struct JulianDate {
  double whole = 0.0;
  double fraction = 0.0;
  double value() const { return whole + fraction; }
};

class Instant {
 public:
  Instant() = default;  // J2000.0: 2000-01-01T12:00:00 TT
  static Instant fromTt(JulianDate date);
  static Instant fromTdb(JulianDate date);
  static Instant fromTai(JulianDate date);
  // Throws InputError before 1960, where UTC is not defined. ERFA's quasi Julian date.
  static Instant fromUtc(JulianDate date);
  static Instant fromUt1(JulianDate date, const DeltaT& deltaT);
  static Instant from(TimeScale scale, JulianDate date, const DeltaT& deltaT);

  JulianDate tt() const { return {whole_, fraction_}; }
  JulianDate tdb() const;
  JulianDate tai() const;
  JulianDate utc() const;
  JulianDate ut1(const DeltaT& deltaT) const;
  JulianDate in(TimeScale scale, const DeltaT& deltaT) const;

  // Days of TDB since J2000.0, rounded to a double (1e-11 days near the present).
  double tdbDaysSinceJ2000() const;
  // Julian centuries of TT since J2000.0.
  double ttCenturiesSinceJ2000() const;
  // Decimal year of TT: 2000.0 + Julian years since J2000.0.
  double julianYear() const { return 2000.0 + 100.0 * ttCenturiesSinceJ2000(); }

  friend Duration operator-(Instant a, Instant b) {
    return ((a.whole_ - b.whole_) + (a.fraction_ - b.fraction_)) * day;
  }
  friend Instant operator+(Instant a, Duration d);
  friend Instant operator-(Instant a, Duration d) { return a + -d; }
  friend bool operator==(Instant a, Instant b) = default;
  friend std::partial_ordering operator<=>(Instant a, Instant b) { return (a - b) <=> Duration(); }

 private:
  Instant(double whole, double fraction);
  double whole_ = 2451545.0;  // an integer
  double fraction_ = 0.0;     // in [-0.5, 0.5)
};

// TDB - TT at the geocentre.
Duration tdbMinusTt(Instant t);

// Reads "2027-08-02T10:07:50.5Z" (UTC; "+02:00" also), "-0584-05-28T14:00:00 UT1", "2451545.0 TT",
// "JD 2451545.25 TDB". A calendar date may leave out seconds, or the whole time of day; without a
// scale it is UTC. A Julian date must name its scale. Scales: TT, TDB, TAI, UTC, UT1.
// `where` opens the message of the InputError thrown otherwise.
Instant parseInstant(std::string_view text, const std::string& where, const DeltaT& deltaT);
Instant parseInstant(std::string_view text, const std::string& where);  // DeltaT::standard()

// "2027-08-02T10:07:50.500Z", "... TT" and so on, rounded to the given decimals of a second.
std::string formatIso(Instant t, TimeScale scale, const DeltaT& deltaT, int decimals = 3);
std::string formatIso(Instant t, TimeScale scale = TimeScale::Utc, int decimals = 3);

// Calendar day <-> Julian day number at noon (Gregorian from 1582-10-15, Julian before).
struct CalendarDay {
  long year = 2000;
  int month = 1;
  int day = 1;
};
long julianDayNumber(CalendarDay date);
CalendarDay calendarDay(long julianDayNumber);

}  // namespace antumbra
