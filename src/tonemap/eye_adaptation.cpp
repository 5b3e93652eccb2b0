#include "tonemap/eye_adaptation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antumbra {
namespace {

constexpr double kConeSeconds = 120.0, kRodSeconds = 400.0;
constexpr double kConeBleach = 19953.0, kRodBleach = 25119.0;  // 10^4.3, 10^4.4 td
constexpr double kConeThreshold = 3e-3, kRodThreshold = 1e-6;  // cd/m2
constexpr double kConeRise = 3.0, kRodRise = 20.0;             // powers of ten
constexpr double kScotopicRatio = 2.0;
constexpr double kTowardsBright = 0.4, kTowardsDark = 1.5;  // s

// Diameter in mm of the pupil at a luminance in cd/m2 (0.3183 cd/m2 are a tenth of a millilambert).
double trolands(double luminance) {
  double const millilambert = std::max(luminance, 1e-9) * 0.31416;
  double const diameter = 4.9 - 3.0 * std::tanh(0.4 * std::log10(millilambert));
  return luminance * 0.25 * std::numbers::pi * diameter * diameter;
}

// The unbleached share after some seconds in constant light.
double pigmentAfter(double p, double light, double bleach, double recovery, double seconds) {
  double const rate = (1.0 + light / bleach) / recovery;
  double const steady = 1.0 / (1.0 + light / bleach);
  return steady + (p - steady) * std::exp(-rate * seconds);
}

double luminanceSeen(const MeterReading& reading) {
  return reading.black ? kMeterFloor : reading.meanLuminance;
}

MeterReading between(const MeterReading& from, const MeterReading& to, double t) {
  auto const mixed = [&](double a, double b) {
    return std::exp((1.0 - t) * std::log(std::max(a, kMeterFloor)) +
                    t * std::log(std::max(b, kMeterFloor)));
  };
  MeterReading m;
  m.black = from.black && to.black;
  m.meanLuminance = mixed(luminanceSeen(from), luminanceSeen(to));
  m.highLuminance = mixed(from.black ? kMeterFloor : from.highLuminance,
                          to.black ? kMeterFloor : to.highLuminance);
  return m;
}

// White of the display for what the eye, in its state, may adapt to.
double wantedWhite(const EyeState& eye, const MeterReading& reading,
                   const AutomaticExposure& settings) {
  MeterReading least;
  least.black = false;
  least.meanLuminance = least.highLuminance = std::min(coneThreshold(eye), rodThreshold(eye));
  return std::max(exposureFor(reading, settings).whiteLuminance,
                  exposureFor(least, settings).whiteLuminance);
}

constexpr double kTrackSeconds = 1800.0;

}  // namespace

double coneThreshold(const EyeState& eye) {
  return kConeThreshold * std::pow(10.0, kConeRise * (1.0 - eye.conePigment));
}

double rodThreshold(const EyeState& eye) {
  return kRodThreshold * std::pow(10.0, kRodRise * (1.0 - eye.rodPigment));
}

EyeState steadyEye(const MeterReading& reading, const AutomaticExposure& settings) {
  double const light = trolands(luminanceSeen(reading));
  EyeState eye;
  eye.conePigment = 1.0 / (1.0 + light / kConeBleach);
  eye.rodPigment = 1.0 / (1.0 + kScotopicRatio * light / kRodBleach);
  eye.whiteLuminance = wantedWhite(eye, reading, settings);
  eye.adaptedLuminance = luminanceSeen(reading);
  return eye;
}

EyeState adaptedEye(EyeState eye, const MeterReading& from, const MeterReading& to, Duration passed,
                    const AutomaticExposure& settings) {
  double const seconds = std::max(passed.si, 0.0);
  double const change = std::fabs(std::log(luminanceSeen(to) / luminanceSeen(from)));
  // Steps of the light below 10 %, and of time below a quarter of the nerves' and an eighth of the
  // cones' constant.
  double const fine = seconds / (seconds < 20.0 ? 0.1 : 15.0);
  int const steps = std::clamp(static_cast<int>(std::ceil(std::max(change / 0.1, fine))), 1, 400);
  double const step = seconds / steps;
  for (int i = 0; i < steps; ++i) {
    MeterReading const reading = between(from, to, (i + 0.5) / steps);
    double const light = trolands(luminanceSeen(reading));
    eye.conePigment = pigmentAfter(eye.conePigment, light, kConeBleach, kConeSeconds, step);
    eye.rodPigment =
        pigmentAfter(eye.rodPigment, kScotopicRatio * light, kRodBleach, kRodSeconds, step);
    double const target = std::log(wantedWhite(eye, reading, settings));
    double const now = std::log(eye.whiteLuminance);
    double const constant = target > now ? kTowardsBright : kTowardsDark;
    eye.whiteLuminance = std::exp(target + (now - target) * std::exp(-step / constant));
    double const seen = std::log(luminanceSeen(reading)), before = std::log(eye.adaptedLuminance);
    eye.adaptedLuminance = std::exp(
        seen + (before - seen) * std::exp(-step / (seen > before ? kTowardsBright : kTowardsDark)));
  }
  return eye;
}

Exposure exposureOf(const EyeState& eye) { return {eye.whiteLuminance, rodThreshold(eye)}; }

EyeState eyeAfter(std::span<const TrackedReading> track, const AutomaticExposure& settings) {
  if (track.empty()) return {};
  EyeState eye = steadyEye(track.front().reading, settings);
  for (std::size_t i = 1; i < track.size(); ++i)
    eye = adaptedEye(eye, track[i - 1].reading, track[i].reading,
                     track[i - 1].before - track[i].before, settings);
  return eye;
}

std::vector<double> meteredSeconds(double now) {
  std::vector<double> times{now};
  double step = 1.0;
  for (double t = std::ceil(now) - 1.0; now - t <= kTrackSeconds; t -= step) {
    if (now - t >= 2.0 * step && std::fmod(t, 2.0 * step) == 0.0) step *= 2.0;
    times.push_back(t);
  }
  std::reverse(times.begin(), times.end());
  return times;
}

}  // namespace antumbra
