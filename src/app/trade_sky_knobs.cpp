#include "app/trade_sky_knobs.h"

#include <fmt/format.h>

namespace antumbra {
namespace {

AirKnob knob(const std::string& name, int AirQuality::*member, std::initializer_list<int> values) {
  AirKnob k{name, {}, [=](const AirQuality& q) { return q.*member; }};
  for (int value : values)
    k.settings.push_back(
        {fmt::format("{} = {}", name, value), [=](AirQuality& q) { q.*member = value; }, value});
  return k;
}

AirKnob knob(const std::string& name, const std::string& first, int AirQuality::*a,
             const std::string& second, int AirQuality::*b,
             std::initializer_list<std::pair<int, int>> values) {
  AirKnob k{name, {}, [=](const AirQuality& q) { return q.*a; }};
  for (auto const& [x, y] : values)
    k.settings.push_back({fmt::format("{} = {}; {} = {}", first, x, second, y),
                          [=, x = x, y = y](AirQuality& q) {
                            q.*a = x;
                            q.*b = y;
                          },
                          x});
  return k;
}

}  // namespace

const std::vector<AirKnob>& airKnobs() {
  using Q = AirQuality;
  static const std::vector<AirKnob> all = [] {
    std::vector<AirKnob> list{
        knob("wavelengths", &Q::wavelengths, {4, 8}),
        knob("orders", &Q::orders, {2, 3, 4, 5, 7}),
        knob("degree", &Q::degree, {2, 3, 4, 5, 6}),
        knob("haze_degree", &Q::hazeDegree, {4, 5, 6, 8}),
        knob("depth", "depth_width", &Q::depthWidth, "depth_height", &Q::depthHeight,
             {{64, 32}, {128, 32}, {256, 64}, {512, 128}}),
        knob("source", "source_width", &Q::sourceWidth, "source_height", &Q::sourceHeight,
             {{48, 12}, {64, 16}, {96, 24}, {128, 32}}),
        knob("directions", "zenith_directions", &Q::zenithDirections, "azimuth_directions",
             &Q::azimuthDirections, {{8, 4}, {12, 6}, {16, 8}, {20, 10}}),
        knob("source_samples", &Q::sourceSamples, {6, 8, 12, 16, 24}),
        knob("sky_samples", &Q::skySamples, {8, 12, 16, 24, 32}),
        knob("sky", "sky_width", &Q::skyWidth, "sky_height", &Q::skyHeight,
             {{24, 64}, {32, 96}, {48, 128}, {72, 192}}),
        knob("view_samples", &Q::viewSamples, {4, 6, 8, 12, 16}),
        knob("ground_samples", &Q::groundSamples, {2, 3, 4, 5, 6, 8, 10}),
    };
    // The cheapest first.
    AirKnob scale{"air_scale", {}, [](const Q& q) { return -q.airScale; }};
    for (int pixels : {4, 2, 1})
      scale.settings.push_back({fmt::format("air_scale = {}", pixels),
                                [pixels](Q& q) { q.airScale = pixels; }, -pixels});
    list.push_back(scale);
    auto const bits = [](const Q& q) { return q.storage == AirStorage::Half ? 16 : 32; };
    list.push_back({"storage",
                    {{"storage = half", [](Q& q) { q.storage = AirStorage::Half; }, 16},
                     {"storage = float", [](Q& q) { q.storage = AirStorage::Float; }, 32}},
                    bits});
    return list;
  }();
  return all;
}

}  // namespace antumbra
