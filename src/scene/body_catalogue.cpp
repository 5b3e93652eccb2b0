#include "scene/body_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "document/paths.h"

namespace antumbra {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

Length radius(const Table& figure, std::string_view key) {
  Length const value = figure.length(key);
  if (!(value.si > 0.0))
    figure.fail(key, fmt::format("found {} km; allowed: a positive radius", value / kilometre));
  return value;
}

glm::vec3 colour(const Table& table, std::string_view key) {
  auto const values = table.numbers(key);
  if (values.size() != 3)
    table.fail(key, fmt::format("found {} numbers; allowed: three, linear sRGB", values.size()));
  for (double v : values)
    if (v < 0.0) table.fail(key, "found a negative number; allowed: zero or more");
  return {values[0], values[1], values[2]};
}

MagnitudeLaw readMagnitude(const Table& table) {
  MagnitudeLaw law;
  for (const Table& t : table.tables("magnitude")) {
    MagnitudeLaw::Interval interval;
    interval.to = t.angle("to");
    if (!law.intervals.empty() && interval.to <= law.intervals.back().to)
      t.fail("to", "intervals of the phase angle must ascend");
    std::string const form = t.oneOf("form", {"polynomial", "log-polynomial", "ringed"});
    interval.form = form == "polynomial"       ? MagnitudeLaw::Form::Polynomial
                    : form == "log-polynomial" ? MagnitudeLaw::Form::LogPolynomial
                                               : MagnitudeLaw::Form::Ringed;
    interval.coefficients = t.numbers("coefficients");
    std::size_t const least = interval.form == MagnitudeLaw::Form::Ringed ? 5 : 1;
    if (interval.coefficients.size() < least)
      t.fail("coefficients",
             fmt::format("found {}; allowed: at least {}", interval.coefficients.size(), least));
    law.intervals.push_back(interval);
  }
  return law;
}

Surface readSurface(const Table& table, double colorIndexBv) {
  Surface s;
  if (table.has("scattering") &&
      table.oneOf("scattering", {"lambert", "lommel-seeliger"}) == "lommel-seeliger")
    s.scattering = Surface::Scattering::LommelSeeliger;
  s.geometricAlbedo = table.number("geometric_albedo", 0.0);
  (void)table.number("bond_albedo", 0.0);
  s.map = table.text("map", "");
  s.waterMask = table.text("water_mask", "");
  s.nightMap = table.text("night_map", "");
  s.nightLuminance = table.number("night_luminance_cd_m2", 0.0);
  if (table.has("map_mean")) s.mapMean = colour(table, "map_mean");
  if (table.has("reflectance")) {
    s.reflectance = colour(table, "reflectance");
  } else {
    // Reflectance from photometry of the disc (catalogs/bodies/README.md, "Reflectance"): green is
    // the geometric albedo (times 3/2 for Lambert), red and blue on the line through 440 and 550
    // nm.
    double const ratio = std::pow(10.0, -0.4 * (colorIndexBv - 0.653));
    double const p = s.geometricAlbedo * (s.scattering == Surface::Scattering::Lambert ? 1.5 : 1.0);
    auto const at = [&](double nm) { return p * (1.0 + (nm - 550.0) * (1.0 - ratio) / 110.0); };
    s.reflectance = glm::max(glm::vec3(at(612.0), at(549.0), at(465.0)), 0.0f);
  }
  return s;
}

}  // namespace

std::optional<double> MagnitudeLaw::apparent(Angle phase, Length r, Length d,
                                             Angle ringTilt) const {
  for (const Interval& interval : intervals) {
    if (phase > interval.to) continue;
    auto const& c = interval.coefficients;
    double v = 0.0;
    switch (interval.form) {
      case Form::Polynomial:
        for (std::size_t i = c.size(); i-- > 0;) v = v * (phase / degree) + c[i];
        break;
      case Form::LogPolynomial: {
        double const x = phase / (180.0 * degree);
        double inner = 0.0;
        for (std::size_t i = c.size(); i-- > 1;) inner = (inner + c[i]) * x;
        v = c[0] - 2.5 * std::log10(1.0 + inner);
        break;
      }
      case Form::Ringed: {
        double const s = sin(ringTilt), a = phase / degree;
        v = c[0] + c[1] * s + c[2] * a + c[3] * s * std::exp(c[4] * a);
        break;
      }
    }
    return v + 5.0 * std::log10((r / astronomicalUnit) * (d / astronomicalUnit));
  }
  return std::nullopt;
}

Body readBody(const Table& table, const std::string& key) {
  Body body;
  body.key = key;
  body.file = table.file();
  body.name = table.text("name");
  body.kind = table.oneOf("kind", {"star", "planet", "dwarf planet", "moon"});
  body.parent = table.text("parent", "");
  body.ephemeris = table.text("ephemeris");
  body.atmosphere = table.text("atmosphere", "");
  body.colorIndexBv = table.number("color_index_bv", body.colorIndexBv);
  Table const figure = table.table("figure");
  body.equatorialRadius = radius(figure, "equatorial_radius");
  body.polarRadius = radius(figure, "polar_radius");
  if (body.polarRadius > body.equatorialRadius)
    figure.fail("polar_radius", "exceeds the equatorial radius; allowed: a = b >= c");
  // A star shines by its own light (photometry/, limb darkening); only its colour is surface.
  auto const surface = table.tableIfPresent("surface");
  if (surface) body.surface = readSurface(*surface, body.colorIndexBv);
  if (!surface && body.kind != "star") table.fail("surface", "missing; a body needs its surface");
  body.magnitude = readMagnitude(table);
  if (auto const rings = table.tableIfPresent("rings")) {
    body.rings = readRings(*rings);
    if (body.rings->inner() < body.equatorialRadius)
      rings->fail("part", "the innermost part begins inside the body; allowed: outside it");
  }
  return body;
}

BodyCatalogue BodyCatalogue::load(const std::filesystem::path& folder) {
  BodyCatalogue catalogue;
  if (!std::filesystem::is_directory(folder))
    throw InputError(
        fmt::format("{}: no such folder; body catalogues were expected", folder.string()));
  for (auto const& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    Document const document = Document::load(entry.path());
    std::string const key = lower(entry.path().stem().string());
    catalogue.bodies_.emplace(key, readBody(document.root(), key));
    document.root().finish();
  }
  for (auto const& [key, body] : catalogue.bodies_) {
    std::size_t steps = 0;
    for (const Body* at = &body; !at->parent.empty();) {
      auto const parent = catalogue.bodies_.find(at->parent);
      if (parent == catalogue.bodies_.end())
        throw InputError(fmt::format("{}: parent: found \"{}\"; allowed: the stem of a file in {}",
                                     at->file, at->parent, folder.string()));
      at = &parent->second;
      if (++steps > catalogue.bodies_.size())
        throw InputError(fmt::format("{}: parent: bodies orbit each other in a loop", body.file));
    }
  }
  return catalogue;
}

const BodyCatalogue& BodyCatalogue::standard() {
  static BodyCatalogue const catalogue = load(catalogsFolder() / "bodies");
  return catalogue;
}

const Body& BodyCatalogue::body(const std::string& name, const std::string& where) const {
  std::string const wanted = lower(name);
  std::string known;
  for (auto const& [key, body] : bodies_) {
    if (key == wanted || lower(body.name) == wanted) return body;
    known += (known.empty() ? "" : ", ") + body.name;
  }
  throw InputError(
      fmt::format("{}: found the unknown body \"{}\"; allowed: {}", where, name, known));
}

int BodyCatalogue::depth(const Body& body) const {
  int steps = 0;
  for (const Body* at = &body; !at->parent.empty(); at = &bodies_.at(at->parent)) ++steps;
  return steps;
}

}  // namespace antumbra
