#include "app/eclipse_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "document/document.h"
#include "document/input_error.h"

namespace antumbra {
namespace {

double ratioWithin(const std::string& text, const std::string& where) {
  double const value = parseNumber(text, where);
  if (!(value > 0.2 && value < 0.3))
    throw InputError(fmt::format("{}: found {}; allowed: 0.2 to 0.3 equatorial radii of the Earth",
                                 where, text));
  return value;
}

}  // namespace

void EclipseOptions::addTo(CLI::App& command) {
  command
      .add_option("--convention", convention,
                  "nasa (the published canons) or iau: radii of Sun and Moon")
      ->capture_default_str();
  command.add_option("--sun-radius", sunRadius, "the Sun's radius, as \"695700 km\"");
  command.add_option("--k-umbra", kUmbra,
                     "the Moon's radius for the umbra, equatorial Earth radii");
  command.add_option("--k-penumbra", kPenumbra, "the same for the penumbra");
  command.add_option("--shadow-enlargement", enlargement,
                     "of the Earth's shadow on the Moon: danjon (default), chauvenet or none");
  command.add_option("--delta-t", deltaT, "TT - UT1 in seconds, for every date");
}

void DatedEclipseOptions::addTo(CLI::App& command, const std::vector<std::string>& formats) {
  command.add_option("date", date, "date of greatest eclipse (TT), YYYY-MM-DD")->required();
  format = formats.front();
  command.add_option("--format", format)->check(CLI::IsMember(formats))->capture_default_str();
  command.add_option("-o,--output", output, "file instead of standard output");
  shared.addTo(command);
}

EclipseBasis EclipseOptions::basis() const {
  EclipseBasis basis;
  basis.convention = ShadowConvention::named(convention, "--convention");
  if (!sunRadius.empty()) {
    basis.convention.sunRadius = parseLength(sunRadius, "--sun-radius");
    if (!(basis.convention.sunRadius > 600000.0 * kilometre &&
          basis.convention.sunRadius < 800000.0 * kilometre))
      throw InputError(
          fmt::format("--sun-radius: found \"{}\"; allowed: 600000 km to 800000 km", sunRadius));
  }
  if (!kUmbra.empty()) basis.convention.lunarKUmbra = ratioWithin(kUmbra, "--k-umbra");
  if (!kPenumbra.empty()) basis.convention.lunarKPenumbra = ratioWithin(kPenumbra, "--k-penumbra");
  if (!enlargement.empty())
    basis.enlargement = parseShadowEnlargement(enlargement, "--shadow-enlargement");
  if (!deltaT.empty()) {
    double const seconds = parseNumber(deltaT, "--delta-t");
    if (!(std::fabs(seconds) < 1e6))
      throw InputError(
          fmt::format("--delta-t: found {}; allowed: -1000000 to 1000000 seconds", deltaT));
    basis.deltaT = seconds * second;
  }
  return basis;
}

std::string describe(const EclipseBasis& basis) {
  return fmt::format(
      "convention {}: Sun {:.1f} km, Moon k {} (umbra) {} (penumbra), a smooth sphere (its real "
      "limb "
      "shifts contacts by up to 3 s); Earth's shadow after {}; delta T {}",
      basis.convention.name, basis.convention.sunRadius / kilometre, basis.convention.lunarKUmbra,
      basis.convention.lunarKPenumbra, nameOf(basis.enlargement),
      basis.deltaT ? fmt::format("{} s, given", *basis.deltaT / second) : "of the standard model");
}

Duration parseStep(const std::string& text, const std::string& where) {
  // "5min" as well as "5 min".
  std::string spaced = text;
  std::size_t const unit = text.find_first_not_of("0123456789.");
  if (unit != std::string::npos && unit > 0 && text[unit] != ' ') spaced.insert(unit, " ");
  Duration const step = parseDuration(spaced, where);
  if (!(step >= 1.0 * second && step <= 6.0 * hour))
    throw InputError(fmt::format("{}: found \"{}\"; allowed: 1 s to 6 h", where, text));
  return step;
}

}  // namespace antumbra
