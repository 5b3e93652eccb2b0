// The curves of a solar eclipse on the globe.
//
// Limits and isolines are found on a grid of latitude and longitude on which the circumstances of
// each node are exact; where a curve crosses an edge of the grid its place is refined on the edge
// by the same circumstances, to about 0.01 degrees. Between crossings a curve runs straight: with
// the grid of one degree it strays up to 1 km.
#pragma once

#include <string>
#include <vector>

#include "eclipse/central_path.h"
#include "eclipse/eclipse_search.h"

namespace antumbra {

enum class CurveKind {
  CentralLine,
  UmbraLimit,     // left and right limits of totality or annularity
  PenumbraLimit,  // magnitude 0 at maximum, Sun up
  EqualMagnitude,
  MaximumOnHorizon,       // maximum at sunrise or sunset
  BeginsOrEndsOnHorizon,  // first or last contact at sunrise or sunset
};

struct GlobeCurve {
  CurveKind kind = CurveKind::CentralLine;
  std::string name;
  double magnitude = 0.0;  // of EqualMagnitude
  std::vector<Site> sites;
};

struct TimeMark {
  Instant instant;
  Site place;
  std::vector<Site> footprint;  // of the umbra or antumbra
};

struct EclipseCurves {
  std::vector<GlobeCurve> curves;
  std::vector<TimeMark> marks;  // on the central line, every ten minutes of UT1
};

EclipseCurves eclipseCurves(const SolarEvent& event, const ShadowRadii& radii,
                            Angle gridStep = 1.0 * degree);

// Of them, what needs no grid: central line and limits, at 401 instants closer together near both
// ends; and marks at whole multiples of `interval` since 0 h UT1. Empty where the axis misses.
std::vector<GlobeCurve> centralCurves(const SolarEvent& event, const ShadowRadii& radii);
std::vector<TimeMark> timeMarks(const SolarEvent& event, const ShadowRadii& radii,
                                Duration interval);

}  // namespace antumbra
