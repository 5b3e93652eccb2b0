// Geocentric place of the Moon by the full ELP/MPP02 series with constants fitted to DE405:
// J. Chapront & G. Francou, "The lunar theory ELP revisited", Astron. Astrophys. 404, 735 (2003).
// Mean inertial ecliptic of date, turned to that of J2000 by Laskar's P and Q, then to Icrs by the
// angles of Chapront, Chapront-Touze & Francou 2002 (A&A 387, 700).
//
// Against JPL DE431, 1900-2100: 0.020", 4 m in distance.
#pragma once

#include "ephemeris/state.h"
#include "ephemeris/term_series.h"

namespace antumbra {

struct MoonSeries {
  double meanLongitude[5] = {};  // W1, radians, powers of Julian centuries
  TermSeries longitude, latitude, distance;
  std::size_t terms() const { return longitude.terms() + latitude.terms() + distance.terms(); }
  // Geocentric, from days of TDB since J2000.
  State state(double tdbDays) const;
};

MoonSeries moonSeries(const SeriesCatalogue& catalogue);

}  // namespace antumbra
