#include "app/direction_list.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "document/document.h"
#include "document/input_error.h"

namespace antumbra {
namespace {

constexpr std::size_t kMostShown = 80;  // characters of a faulty line

// A line as a message shows it: of a file that is no text, not its control characters.
std::string shown(const std::string& line) {
  std::string text;
  for (char c : line.substr(0, kMostShown)) {
    auto const code = static_cast<unsigned char>(c);
    text += code < 0x20 || code >= 0x7f ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  return text + (line.size() > kMostShown ? "..." : "");
}

}  // namespace

double numberWithin(const std::string& text, const std::string& where, double low, double high) {
  double const value = parseNumber(text, where);
  if (!(value >= low && value <= high))
    throw InputError(fmt::format("{}: found {}; allowed: {} to {}", where, text, low, high));
  return value;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    std::size_t const end = std::min(line.find(',', begin), line.size());
    std::string const cell = line.substr(begin, end - begin);
    auto const first = cell.find_first_not_of(" \t\r"), last = cell.find_last_not_of(" \t\r");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    begin = end + 1;
  }
  return cells;
}

std::vector<ViewDirection> readDirections(const std::string& source) {
  std::ifstream file;
  if (source != "-") {
    if (!std::filesystem::is_directory(source)) file.open(source);
    if (!file.is_open())
      throw InputError(fmt::format(
          "--directions: \"{}\" cannot be read; allowed: a file, or - for standard input", source));
  }
  std::istream& in = source == "-" ? std::cin : file;
  std::string const name = source == "-" ? "standard input" : source;
  std::vector<ViewDirection> directions;
  bool header = false;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    // The byte order mark that spreadsheets write.
    if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
    auto const cells = cellsOf(line);
    if ((cells.size() == 1 && cells[0].empty()) || cells[0].starts_with("#")) continue;
    std::string const where = fmt::format("{}:{}", name, number);
    if (!header) {
      if (cells.size() != 2 || cells[0] + "," + cells[1] != kDirectionsHeader)
        throw InputError(fmt::format("{}: found \"{}\"; allowed: the header {}", where, shown(line),
                                     kDirectionsHeader));
      header = true;
      continue;
    }
    if (cells.size() != 2)
      throw InputError(fmt::format("{}: found \"{}\", {} columns; allowed: two, {}", where,
                                   shown(line), cells.size(), kDirectionsHeader));
    directions.push_back({numberWithin(cells[0], where + ": view_zenith_deg", 0.0, 180.0),
                          numberWithin(cells[1], where + ": rel_azimuth_deg", -360.0, 360.0),
                          cells[0], cells[1]});
  }
  if (directions.empty())
    throw InputError(
        fmt::format("{}: holds no direction; allowed: the header {} and lines of two numbers", name,
                    kDirectionsHeader));
  return directions;
}

}  // namespace antumbra
