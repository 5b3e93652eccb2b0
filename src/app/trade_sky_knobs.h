// The knobs of the air that `antumbra trade sky` walks: their names as in configs/quality/*.toml
// and the values that it tries.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "passes/air_quality.h"

namespace antumbra {

// A value of a knob, from the cheapest up; some knobs turn two keys together.
struct KnobSetting {
  std::string text;  // as "source_width = 96; source_height = 24"
  std::function<void(AirQuality&)> set;
  int size = 0;  // what orders the settings, of the first key
};
struct AirKnob {
  std::string name;
  std::vector<KnobSetting> settings;
  std::function<int(const AirQuality&)> size;  // where a quality stands among them
};
const std::vector<AirKnob>& airKnobs();

}  // namespace antumbra
