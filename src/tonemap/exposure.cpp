#include "tonemap/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace antumbra {
namespace {

constexpr double kMiddleGrey = 0.18;
constexpr double kDarkStops = 10.0;
constexpr double kHighShare = 0.02;
// Brings the published key, made for another curve, to 0.28 of white for a noon sky.
constexpr double kDisplayKeyScale = 0.4;

// Highlights of the 98th percentile stay within two stops above white, where the curve still parts
// them.
constexpr double kMostOverWhite = 4.0;

}  // namespace

Exposure exposureOfEv(double ev100) { return {0.125 * std::exp2(ev100) / kMiddleGrey}; }

double evOfExposure(Exposure exposure) {
  return std::log2(exposure.whiteLuminance * kMiddleGrey / 0.125);
}

MeterReading readMeter(std::span<const MeterCell> cells) {
  std::vector<MeterCell> sorted;
  double total = 0.0;
  for (MeterCell const& cell : cells)
    if (cell.solidAngle > 0.0f) {
      sorted.push_back(cell);
      total += cell.solidAngle;
    }
  std::sort(sorted.begin(), sorted.end(), [](const MeterCell& a, const MeterCell& b) {
    return a.log2Luminance > b.log2Luminance;
  });
  MeterReading reading;
  double const floor = std::log2(kMeterFloor * 1.001);
  if (sorted.empty() || sorted.front().log2Luminance < floor) return reading;
  reading.black = false;
  // The 98th percentile, or the faintest lit cell where less than 2 % is lit.
  double above = 0.0;
  double high = sorted.front().log2Luminance;
  std::size_t first = 0;
  for (; first < sorted.size() && sorted[first].log2Luminance >= floor; ++first) {
    high = sorted[first].log2Luminance;
    above += sorted[first].solidAngle;
    if (above > kHighShare * total) break;
  }
  double sum = 0.0, weight = 0.0, dark = 0.0;
  for (MeterCell const& cell : sorted) {
    double const stops = cell.log2Luminance;
    if (stops > high) continue;
    if (stops < high - kDarkStops || stops < floor) {
      dark += cell.solidAngle;
      continue;
    }
    sum += stops * cell.solidAngle;
    weight += cell.solidAngle;
  }
  reading.highLuminance = std::exp2(high);
  reading.meanLuminance = weight > 0.0 ? std::exp2(sum / weight) : reading.highLuminance;
  reading.darkShare = dark / total;
  return reading;
}

Exposure exposureFor(const MeterReading& reading, const AutomaticExposure& settings) {
  double white = settings.darkestWhite;
  if (!reading.black) {
    double const l = reading.meanLuminance;
    double const key = kDisplayKeyScale * (1.03 - 2.0 / (2.0 + std::log10(l + 1.0)));
    white = std::max({white, l / key, reading.highLuminance / kMostOverWhite});
  }
  return {white * std::exp2(-settings.compensationStops)};
}

Exposure adaptedExposure(Exposure now, Exposure target, Duration passed) {
  double const from = std::log2(now.whiteLuminance), to = std::log2(target.whiteLuminance);
  double const constant = to > from ? 0.4 : 1.5;
  double const kept = std::exp(-std::max(passed.si, 0.0) / constant);
  return {std::exp2(to + (from - to) * kept)};
}

}  // namespace antumbra
