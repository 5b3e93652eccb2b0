// What a scene says about the Sun itself: the look of its corona and limb in an eclipse.
//
//   [sun]
//   activity = 0.5      # phase of the solar cycle, 0 minimum to 1 maximum; default: of the date
//   corona = "smooth"   # or "streamers": helmets and plumes, invented, about the measured mean
//   prominences = 0     # count, 0 to 24, invented
//   drawn = true        # false: neither its disc nor corona nor glare; its light stays
//   corona_light = true # whether the corona lights what lies in shadows: ground, air in totality
#pragma once

#include <optional>

#include "document/document.h"
#include "time/instant.h"

namespace antumbra {

struct SunSettings {
  std::optional<double> activity;
  bool streamers = false;
  int prominences = 0;
  bool drawn = true;
  bool coronaLight = true;
};

SunSettings readSunSettings(const Table& table);

// Phase of the cycle at an instant: 0 at minima and 1 at maxima of the smoothed sunspot number
// (catalogs/sun/cycle.csv, 1878 to 2024), half a cosine between. Outside the table cycles of 11.0
// years with a rise of 4.8 follow one another (their means): a guess, off by a year a cycle.
double solarActivity(Instant when);

}  // namespace antumbra
