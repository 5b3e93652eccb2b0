// Reads a medium from its TOML file: catalogs/atmospheres/README.md describes every key.
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "document/document.h"
#include "document/paths.h"
#include "medium/medium.h"
#include "photometry/standard_spectra.h"

namespace antumbra {
namespace {

// The span over which laws are tabulated, in steps whose linear interpolation of a fourth power
// errs by 1e-5.
constexpr double kFirstNm = 360.0, kLastNm = 830.0, kStepNm = 1.0;

Spectrum tabulated(const std::function<double(Length)>& law, const std::string& name) {
  std::vector<double> nm, values;
  for (double w = kFirstNm; w <= kLastNm; w += kStepNm) {
    nm.push_back(w);
    values.push_back(law(w * nanometre));
  }
  return {nm, values, name};
}

// Prefixes what a constructor complains about with the file and line of the table it came from.
template <class Make>
auto explained(const Table& table, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(table.where() + ": " + error.what());
  }
}

void checkValues(const Table& table, std::string_view key, const Spectrum& s, double low,
                 double high) {
  auto const check = [&](double v) {
    if (!(v >= low && v <= high))
      table.fail(key, fmt::format("found {}; allowed: {}", v,
                                  std::isinf(high) ? fmt::format("{} or more", low)
                                                   : fmt::format("{} to {}", low, high)));
  };
  if (s.isConstant()) check(s.at(550.0 * nanometre));
  for (double v : s.values()) check(v);
}

// A number, or { wavelengths_nm = [...], values = [...] }.
Spectrum readNumberSpectrum(const Table& parent, std::string_view key, double low, double high) {
  Spectrum s;
  if (!parent.holdsTable(key)) {
    s = Spectrum(parent.number(key));
  } else {
    Table const t = parent.table(key);
    s = explained(
        t, [&] { return Spectrum(t.numbers("wavelengths_nm"), t.numbers("values"), t.where()); });
  }
  checkValues(parent, key, s, low, high);
  return s;
}

// A coefficient in 1/m: constant, table, power law or cross section.
Spectrum readCoefficient(const Table& parent, std::string_view key) {
  Table const t = parent.table(key);
  Spectrum s;
  if (t.has("cross_section")) {
    auto const molecule = t.oneOf("cross_section", {"rayleigh", "ozone"});
    double const n = t.number("number_density_per_m3");
    s = tabulated(
        [&](Length w) {
          return n * (molecule == "ozone" ? ozoneCrossSection(w) : rayleighCrossSection(w));
        },
        t.where());
  } else if (t.has("exponent")) {
    double const value = t.number("per_metre"), exponent = t.number("exponent");
    Length const reference = t.length("at");
    if (!(reference > Length(0.0))) t.fail("at", "allowed: a positive wavelength");
    s = tabulated([&](Length w) { return value * std::pow(w / reference, exponent); }, t.where());
  } else if (t.has("wavelengths_nm")) {
    s = explained(t, [&] {
      return Spectrum(t.numbers("wavelengths_nm"), t.numbers("per_metre"), t.where());
    });
  } else {
    s = Spectrum(t.number("per_metre"));
  }
  checkValues(parent, key, s, 0.0, INFINITY);
  return s;
}

Spectrum product(const Spectrum& a, const Spectrum& b, const std::function<double(double)>& ofB,
                 const std::string& name) {
  if (a.isConstant() && b.isConstant())
    return Spectrum(a.at(550.0 * nanometre) * ofB(b.at(550.0 * nanometre)));
  // The nodes of the one that has them; where both do, the finer span in common, 1 nm apart.
  if (a.isConstant() || b.isConstant()) {
    std::vector<double> values;
    auto const& nodes = a.isConstant() ? b.wavelengthsNm() : a.wavelengthsNm();
    for (double nm : nodes) values.push_back(a.at(nm * nanometre) * ofB(b.at(nm * nanometre)));
    return {nodes, values, name};
  }
  std::vector<double> nm, values;
  double const first = std::max(a.first(), b.first()) / nanometre;
  double const last = std::min(a.last(), b.last()) / nanometre;
  int const steps = std::max(1, static_cast<int>(std::ceil((last - first) / kStepNm)));
  for (int i = 0; i <= steps; ++i) {
    double const w = first + (last - first) * i / steps;
    nm.push_back(w);
    values.push_back(a.at(w * nanometre) * ofB(b.at(w * nanometre)));
  }
  return {nm, values, name};
}

DensityProfile readDensity(const Table& t) {
  auto const kind = t.oneOf("kind", {"exponential", "layer", "table"});
  if (kind == "exponential") {
    Length const scale = t.length("scale_height");
    return explained(t, [&] { return DensityProfile::exponential(scale); });
  }
  if (kind == "layer") {
    Length const bottom = t.length("bottom"), peak = t.length("peak"), top = t.length("top");
    return explained(t, [&] {
      return DensityProfile::table({bottom, peak, top}, {0.0, 1.0, 0.0});
    });
  }
  std::vector<Length> heights;
  for (double km : t.numbers("heights_km")) heights.push_back(km * kilometre);
  auto const values = t.numbers("values");
  bool const logarithmic = t.has("interpolation") &&
                           t.oneOf("interpolation", {"linear", "logarithmic"}) == "logarithmic";
  return explained(t, [&] {
    return logarithmic ? DensityProfile::logarithmicTable(heights, values)
                       : DensityProfile::table(heights, values);
  });
}

PhaseFunction readPhase(const Table& t) {
  auto const kind =
      t.oneOf("kind", {"isotropic", "rayleigh", "henyey_greenstein", "cornette_shanks",
                       "double_henyey_greenstein", "table", "legendre"});
  if (kind == "isotropic") return PhaseFunction::isotropic();
  if (kind == "rayleigh") return PhaseFunction::rayleigh();
  return explained(t, [&] {
    if (kind == "henyey_greenstein")
      return PhaseFunction::henyeyGreenstein(readNumberSpectrum(t, "g", -1.0, 1.0));
    if (kind == "cornette_shanks")
      return PhaseFunction::cornetteShanks(readNumberSpectrum(t, "g", -1.0, 1.0));
    if (kind == "double_henyey_greenstein")
      return PhaseFunction::doubleHenyeyGreenstein(
          readNumberSpectrum(t, "forward_g", -1.0, 1.0),
          readNumberSpectrum(t, "backward_g", -1.0, 1.0),
          readNumberSpectrum(t, "forward_share", 0.0, 1.0));
    if (kind == "legendre") return PhaseFunction::legendre(t.numbers("moments"));
    std::vector<Angle> angles;
    for (double a : t.numbers("angles_deg")) angles.push_back(a * degree);
    return PhaseFunction::table(angles, t.numbers("values"));
  });
}

Constituent readConstituent(const Table& t) {
  Constituent c;
  c.name = t.text("name");
  (void)t.text("source");  // every constituent says where its numbers come from
  c.density = readDensity(t.table("density"));
  if (t.has("extinction")) {
    Spectrum const extinction = readCoefficient(t, "extinction");
    Spectrum const albedo = readNumberSpectrum(t, "single_scattering_albedo", 0.0, 1.0);
    c.scattering = product(
        extinction, albedo, [](double w) { return w; }, t.where());
    c.absorption = product(
        extinction, albedo, [](double w) { return 1.0 - w; }, t.where());
  } else {
    if (!t.has("scattering") && !t.has("absorption"))
      t.fail(
          "scattering",
          "missing; allowed: scattering, absorption, or extinction with single_scattering_albedo");
    if (t.has("scattering")) c.scattering = readCoefficient(t, "scattering");
    if (t.has("absorption")) c.absorption = readCoefficient(t, "absorption");
  }
  if (t.has("phase"))
    c.phase = readPhase(t.table("phase"));
  else if (t.has("scattering") || t.has("extinction"))
    t.fail("phase", "missing; it is required of what scatters");
  return c;
}

// How much of the limb is clear of clouds, over the height of a ray's lowest point.
void readClouds(const Table& t, Medium& m) {
  (void)t.text("source");
  auto const heights = t.numbers("heights_km");
  m.clearShares = t.numbers("clear_share_of_limb");
  if (heights.empty() || heights.size() != m.clearShares.size())
    t.fail("clear_share_of_limb", fmt::format("found {} values for {} heights; allowed: one each",
                                              m.clearShares.size(), heights.size()));
  for (size_t i = 0; i < heights.size(); ++i) {
    if (!(heights[i] >= 0.0) || (i > 0 && !(heights[i] > heights[i - 1])))
      t.fail("heights_km", fmt::format("found {} km; allowed: 0 or more, ascending", heights[i]));
    if (!(m.clearShares[i] >= 0.0 && m.clearShares[i] <= 1.0))
      t.fail("clear_share_of_limb", fmt::format("found {}; allowed: 0 to 1", m.clearShares[i]));
    m.clearHeights.push_back(heights[i] * kilometre);
  }
}

Medium readTable(const Table& root) {
  Medium m;
  m.name = root.text("name");
  m.radius = root.length("radius");
  if (!(m.radius > Length(0.0))) root.fail("radius", "found a radius that is not positive");
  m.topHeight = root.length("top");
  if (!(m.topHeight > Length(0.0)))
    root.fail("top", "found a height that is not positive; allowed: above the ground");
  m.groundAlbedo = readNumberSpectrum(root, "ground_albedo", 0.0, 1.0);
  for (Table const& t : root.tables("constituent")) {
    m.constituents.push_back(readConstituent(t));
    for (size_t i = 0; i + 1 < m.constituents.size(); ++i)
      if (m.constituents[i].name == m.constituents.back().name)
        t.fail("name", fmt::format("found a second \"{}\"; allowed: names of their own",
                                   m.constituents.back().name));
  }
  if (auto const refraction = root.tableIfPresent("refraction")) {
    m.refractivity = readNumberSpectrum(*refraction, "refractivity", 0.0, 0.1);
    m.refractingConstituent = refraction->text("constituent");
    std::string names;
    bool known = false;
    for (Constituent const& c : m.constituents) {
      names += (names.empty() ? "" : ", ") + c.name;
      known = known || c.name == m.refractingConstituent;
    }
    if (!known)
      refraction->fail("constituent",
                       fmt::format("found \"{}\"; allowed: {}", m.refractingConstituent, names));
  }
  if (auto const clouds = root.tableIfPresent("clouds")) readClouds(*clouds, m);
  root.finish();
  if (!(m.firstWavelength() < m.lastWavelength()))
    throw InputError(root.file() + ": the tables have no wavelengths in common");
  return m;
}

}  // namespace

std::filesystem::path mediumFile(const std::string& name) {
  return catalogsFolder() / "atmospheres" / (name + ".toml");
}

Medium readMedium(const std::filesystem::path& file) {
  return readTable(Document::load(file).root());
}

Medium parseMedium(std::string_view content, const std::string& name) {
  return readTable(Document::parse(content, name).root());
}

}  // namespace antumbra
