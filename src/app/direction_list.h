// Directions of a sky as text: a header view_zenith_deg,rel_azimuth_deg and a line for each.
#pragma once

#include <string>
#include <vector>

namespace antumbra {

inline constexpr const char* kDirectionsHeader = "view_zenith_deg,rel_azimuth_deg";

struct ViewDirection {
  double zenithDegrees, azimuthDegrees;
  std::string zenithText, azimuthText;  // printed as they were given
};

// From a file, or "-" for standard input. Empty lines and those that start with # are skipped.
// Throws InputError with file and line.
std::vector<ViewDirection> readDirections(const std::string& source);

// What commas part, without the blanks about it; nothing before, between or behind them is a cell
// too.
std::vector<std::string> cellsOf(const std::string& line);
// A number from `low` to `high`; `where` opens the message of the InputError otherwise.
double numberWithin(const std::string& text, const std::string& where, double low, double high);

}  // namespace antumbra
