// A drawing made into pixels: areas by exact horizontal and fourfold vertical coverage, lines by
// the distance from them, words in a plain stroke alphabet of capitals.
#pragma once

#include <cstdint>
#include <vector>

#include "eclipse/drawing.h"

namespace antumbra {

// 8-bit sRGB, three components, first row at the top.
std::vector<std::uint8_t> rasterised(const Drawing& drawing);

}  // namespace antumbra
