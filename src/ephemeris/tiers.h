// Which amplitude a series may be cut at for a requested error: measured once against the full
// series and kept in catalogs/ephemeris/tiers.txt (written by `antumbra-bench ephemeris
// --calibrate`).
//
// Terms with amplitude * |t|^n below the threshold are left out, t at the end of the tier's span
// (one century from J2000, or fifty): radians for longitude and latitude, the same times the mean
// distance for the radius (twice that for the Moon). The error is the largest of the geocentric and
// heliocentric direction over 1e5 dates, with the Earth cut at the same threshold as the target.
#pragma once

#include <string>
#include <vector>

#include "ephemeris/elp_mpp02.h"
#include "ephemeris/vsop87.h"

namespace antumbra {

// The factor by which a measured error must stay below the requested one.
inline constexpr double kTierMargin = 1.2;

enum class TierSpan { NearPresent, Whole };  // |t| <= 1 century; -50..10 centuries

struct TierRow {
  std::string body;  // a planet, "Sun" or "Moon"
  TierSpan span = TierSpan::NearPresent;
  double thresholdRadians = 0.0;
  std::size_t terms = 0;
  double maxErrorArcseconds = 0.0;
};
const std::vector<TierRow>& tierRows();
// The coarsest threshold whose measured error times kTierMargin is within `error`; 0 (all terms)
// where none is.
TierRow tierFor(const std::string& body, TierSpan span, Angle error);

// Cuts a series; returns the sum of the amplitudes left out as an angle seen from the Sun (planets)
// or the Earth (Moon).
Angle truncate(PlanetSeries& series, Planet planet, double thresholdRadians, TierSpan span);
Angle truncate(MoonSeries& series, double thresholdRadians, TierSpan span);

}  // namespace antumbra
