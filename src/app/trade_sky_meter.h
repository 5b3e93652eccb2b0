// Error and cost of a setting of the air's knobs: views are drawn by the programs of `render`, and
// the same programs are asked for the light of the views' directions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/draw_timing.h"
#include "app/trade_sky_view.h"
#include "gl/decoded_image.h"
#include "passes/air_quality.h"

namespace antumbra {

struct AirCost {
  double fillUnits = 0.0;          // sky table and body with its air
  double milliseconds = 0.0;       // of the same
  double precomputeSeconds = 0.0;  // of the air's tables
  double mebibytes = 0.0;          // of all tables, the sky table's with them
};

// What one sample of the air for several pixels changes: all pixels of the view against those with
// a sample each.
struct ScaleError {
  double luminance = 0.0;    // mean of |relative difference|
  double worst = 0.0;        // the largest, with its sign
  double worstDeltaE = 0.0;  // CIEDE2000, white at twice the pixel's luminance
};

struct AirMeasurement {
  SkyError error;
  ScaleError scale;
  AirCost cost;
};

// Of several views: means; the worst direction of all; the most memory.
AirMeasurement overall(const std::vector<AirMeasurement>& views);

class AirMeter {
 public:
  // `views` and their references outlive it. Medians of `repeats` drawings, at least 7. Needs a
  // current context.
  AirMeter(const std::vector<AirView>& views, const std::vector<ReferenceSky>& references,
           int repeats, DrawClock clock);
  // View by view. Tables are computed once for views of the same medium; the time of the others'
  // is nil.
  std::vector<AirMeasurement> measure(const AirQuality& quality);

 private:
  const std::vector<AirView>& views_;
  const std::vector<ReferenceSky>& references_;
  int repeats_;
  DrawClock clock_;
  std::map<std::string, DecodedImage> images_;
};

}  // namespace antumbra
