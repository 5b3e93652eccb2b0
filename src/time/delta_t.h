// Delta T = TT - UT1, how far the Earth's rotation lags behind uniform time.
//
// Standard: -720 to 1973 the spline of Morrison et al. 2021 (Table S15); 1973-2023 monthly values
// of the US Naval Observatory; outside, the parabola -320 + 32.5 u^2 seconds, u = (year -
// 1825)/100, of the same paper, joined over 800 years by cubics of equal value and slope. The
// uncertainty after the last observation follows Huber 2006 (random walk of the length of day);
// before 1600 it is 0.8 s times
// ((year - 1820)/100)^2 (Morrison & Stephenson 2004).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "time/instant.h"

namespace antumbra {

struct DeltaTValue {
  Duration value;
  Duration uncertainty;  // one standard error
  std::string source;
};

// A user's Earth-orientation row; used by linear interpolation between rows.
struct EarthOrientationRow {
  double utcModifiedJulianDate = 0.0;
  Duration ut1MinusUtc;
  Angle poleX;
  Angle poleY;
};

class DeltaT {
 public:
  // From catalogs/ephemeris/delta_t.txt, read once.
  static const DeltaT& standard();
  // One value for every date; source "given".
  static DeltaT fixed(Duration value);
  // Rows "MJD(UTC) UT1-UTC[s] [x_pole[arcsec] y_pole[arcsec]]", '#' comments, ascending dates; the
  // standard values outside them. Throws InputError with file and line.
  static DeltaT fromEarthOrientationFile(const std::string& file);

  Duration at(Instant t) const;
  DeltaTValue explain(Instant t) const;
  // Polar motion; zero unless an Earth-orientation file covers the date.
  std::pair<Angle, Angle> pole(Instant t) const;

 private:
  struct Cubic {
    double from, to, a3, a2, a1, a0;
  };
  double secondsAt(double year) const;
  double observedAt(double year) const;
  std::optional<double> fixed_;
  std::vector<Cubic> cubics_;
  std::vector<double> monthly_;  // first of each month from firstMonth_
  long firstYear_ = 0;
  int firstMonth_ = 1;
  double firstMonthly_ = 0.0, lastMonthly_ = 0.0;  // decimal years
  std::vector<EarthOrientationRow> rows_;
};

}  // namespace antumbra
