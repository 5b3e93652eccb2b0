#include "scene/star_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numbers>

#include "document/document.h"
#include "document/input_error.h"

namespace antumbra {
namespace {

static_assert(std::endian::native == std::endian::little, "the catalogue is little endian");

// One row of hipparcos_v8.bin, as tools/build_stars packs it.
constexpr size_t kRowBytes = 24;
struct Row {
  std::uint32_t hipparcosNumber, rightAscensionTurns32;
  std::int32_t declinationTurns32;
  std::int16_t motionEastMasPerYear, motionNorthMasPerYear;
  std::uint16_t parallaxTenthMas;
  std::int16_t magnitudeCenti, colorMilli;
  std::uint16_t flags;
};
static_assert(sizeof(Row) == kRowBytes);
constexpr std::uint16_t kMotionKnown = 1, kColorKnown = 2;

constexpr Duration kJulianYear = 365.25 * day;

std::vector<char> contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file.string()));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string rowOf(const std::filesystem::path& file, size_t index) {
  return fmt::format("{}: row {}", file.string(), index);
}

Star starOf(const Row& row, const std::filesystem::path& file, size_t index) {
  constexpr double kTurn32 = 2.0 * std::numbers::pi / 4294967296.0;
  double const ra = kTurn32 * row.rightAscensionTurns32;
  double const dec = kTurn32 * row.declinationTurns32;
  if (std::fabs(dec) > std::numbers::pi / 2.0 || !(row.flags & kMotionKnown))
    throw InputError(
        fmt::format("{}: found declination {} degrees and flags {}, allowed: within 90 degrees, "
                    "proper motion known",
                    rowOf(file, index), dec / degree.si, row.flags));
  AngularRate const masPerYear = 1e-3 * arcsecond / kJulianYear;
  Star star;
  star.hipparcosNumber = static_cast<int>(row.hipparcosNumber);
  star.directionAtJ2000 = {
      {std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec)}};
  star.motionEast = row.motionEastMasPerYear * masPerYear;
  star.motionNorth = row.motionNorthMasPerYear * masPerYear;
  star.parallax = 1e-4 * row.parallaxTenthMas * arcsecond;
  star.magnitudeV = 0.01 * row.magnitudeCenti;
  if (row.flags & kColorKnown) star.colorBv = 0.001 * row.colorMilli;
  return star;
}

std::vector<Star> readStars(const std::filesystem::path& file) {
  auto const bytes = contentOf(file);
  constexpr size_t kHead = 16;
  std::uint32_t count = 0, rowBytes = 0;
  if (bytes.size() < kHead || std::memcmp(bytes.data(), "ANTSTAR1", 8) != 0)
    throw InputError(
        fmt::format("{}: not a star catalogue, allowed: a file that starts with "
                    "'ANTSTAR1'",
                    file.string()));
  std::memcpy(&count, bytes.data() + 8, 4);
  std::memcpy(&rowBytes, bytes.data() + 12, 4);
  if (rowBytes != kRowBytes || bytes.size() != kHead + kRowBytes * count)
    throw InputError(
        fmt::format("{}: found {} bytes for {} rows of {} bytes, needed: rows of {} bytes after a "
                    "head of {}",
                    file.string(), bytes.size(), count, rowBytes, kRowBytes, kHead));
  std::vector<Star> stars;
  stars.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    Row row;
    std::memcpy(&row, bytes.data() + kHead + kRowBytes * i, kRowBytes);
    stars.push_back(starOf(row, file, i));
    if (i > 0 && stars[i - 1].magnitudeV > stars[i].magnitudeV)
      throw InputError(fmt::format("{}: found V {} after {}, allowed: rising V", rowOf(file, i),
                                   stars[i].magnitudeV, stars[i - 1].magnitudeV));
  }
  return stars;
}

std::map<int, StarName> readNames(const std::filesystem::path& file) {
  auto const bytes = contentOf(file);
  std::map<int, StarName> names;
  std::string_view rest(bytes.data(), bytes.size());
  for (int number = 1; !rest.empty(); ++number) {
    auto const end = std::min(rest.find('\n'), rest.size());
    auto const line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    auto const where = fmt::format("{}:{}", file.string(), number);
    if (number == 1) {
      if (line != "hip,name,designation")
        throw InputError(
            fmt::format("{}: found '{}', allowed: 'hip,name,designation'", where, line));
      continue;
    }
    auto const first = line.find(',');
    auto const second = first == line.npos ? line.npos : line.find(',', first + 1);
    if (second == line.npos)
      throw InputError(fmt::format("{}: found '{}', needed: three values", where, line));
    names[static_cast<int>(parseInteger(line.substr(0, first), where))] = {
        std::string(line.substr(first + 1, second - first - 1)),
        std::string(line.substr(second + 1))};
  }
  return names;
}

}  // namespace

Direction<Icrs> directionAt(const Star& star, Instant t) {
  glm::dvec3 const u = star.directionAtJ2000.u;
  // East and north on the tangent plane; none is listed at a pole itself, where there is no east.
  glm::dvec3 const east = glm::normalize(glm::dvec3(-u.y, u.x, 0.0));
  glm::dvec3 const north = glm::cross(u, east);
  Duration const elapsed = t - Instant();
  return {glm::normalize(u + (star.motionEast * elapsed / radian) * east +
                         (star.motionNorth * elapsed / radian) * north)};
}

size_t StarCatalogue::countBrighterThan(double magnitudeV) const {
  auto const end = std::partition_point(
      stars.begin(), stars.end(), [&](const Star& star) { return star.magnitudeV <= magnitudeV; });
  return static_cast<size_t>(end - stars.begin());
}

const Star& StarCatalogue::byNumber(int hipparcosNumber) const {
  for (const Star& star : stars)
    if (star.hipparcosNumber == hipparcosNumber) return star;
  throw InputError(fmt::format("no star HIP {} in the catalogue, which goes to V = {:.2f}",
                               hipparcosNumber, stars.empty() ? 0.0 : stars.back().magnitudeV));
}

const Star& StarCatalogue::byName(const std::string& properName) const {
  for (const auto& [number, name] : nameByHipparcosNumber)
    if (name.properName == properName) return byNumber(number);
  throw InputError(
      fmt::format("unknown star '{}'; allowed: a proper name of stars/names.csv", properName));
}

StarCatalogue StarCatalogue::load(const std::filesystem::path& folder) {
  StarCatalogue catalogue;
  catalogue.stars = readStars(folder / "hipparcos_v8.bin");
  catalogue.nameByHipparcosNumber = readNames(folder / "names.csv");
  return catalogue;
}

}  // namespace antumbra
