#include "frame/body_rotation.h"

#include <fmt/format.h>
#include <cmath>
#include <map>
#include <mutex>

#include "document/paths.h"

namespace antumbra {
namespace {

double polynomial(const std::vector<double>& c, double x) {
  double sum = 0.0;
  for (auto i = c.size(); i-- > 0;) sum = sum * x + c[i];
  return sum;
}

std::vector<double> coefficients(const Table& table, const char* key, std::size_t atLeast) {
  auto c = table.numbers(key);
  if (c.size() < atLeast || c.size() > 4)
    table.fail(key,
               fmt::format("found {} numbers; allowed: {} to 4 coefficients of ascending powers "
                           "of time",
                           c.size(), atLeast));
  return c;
}

std::filesystem::path fileOf(const std::string& name) {
  std::string lower;
  for (char c : name) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return catalogsFolder() / "rotation" / (lower + ".toml");
}

glm::dmat3 aboutX(double a) {
  double const c = std::cos(a), s = std::sin(a);
  return glm::dmat3(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);  // column by column
}
glm::dmat3 aboutZ(double a) {
  double const c = std::cos(a), s = std::sin(a);
  return glm::dmat3(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
}

}  // namespace

BodyRotation BodyRotation::fromTable(const Table& table) {
  BodyRotation r;
  r.source = table.text("source");
  r.poleRaDegrees = coefficients(table, "pole_ra_deg", 1);
  r.poleDecDegrees = coefficients(table, "pole_dec_deg", 1);
  r.primeMeridianDegrees = coefficients(table, "prime_meridian_deg", 2);
  for (const auto& t : table.tables("term")) {
    Term term;
    term.argumentDegrees = coefficients(t, "argument_deg", 1);
    term.perDay = t.has("argument_unit") && t.oneOf("argument_unit", {"century", "day"}) == "day";
    term.raSinDegrees = t.number("ra_sin_deg", 0.0);
    term.decCosDegrees = t.number("dec_cos_deg", 0.0);
    term.wSinDegrees = t.number("w_sin_deg", 0.0);
    r.terms.push_back(term);
  }
  table.finish();
  return r;
}

bool hasBodyRotation(const std::string& name) { return std::filesystem::exists(fileOf(name)); }

const BodyRotation& bodyRotation(const std::string& name) {
  static std::mutex guard;
  static std::map<std::string, BodyRotation> read;
  std::lock_guard const lock(guard);
  auto const found = read.find(name);
  if (found != read.end()) return found->second;
  if (!hasBodyRotation(name)) {
    std::vector<std::string> names;
    for (const auto& e : std::filesystem::directory_iterator(catalogsFolder() / "rotation"))
      names.push_back(e.path().stem().string());
    std::sort(names.begin(), names.end());
    throw InputError(
        fmt::format("rotation of \"{}\": unknown; allowed: {}", name, fmt::join(names, ", ")));
  }
  auto const document = Document::load(fileOf(name));
  return read.emplace(name, BodyRotation::fromTable(document.root())).first->second;
}

RotationAngles rotationAngles(const BodyRotation& rotation, Instant t) {
  double const days = t.tdbDaysSinceJ2000(), centuries = days / 36525.0;
  double ra = polynomial(rotation.poleRaDegrees, centuries);
  double dec = polynomial(rotation.poleDecDegrees, centuries);
  double w = polynomial(rotation.primeMeridianDegrees, days);
  for (const auto& term : rotation.terms) {
    double const a = polynomial(term.argumentDegrees, term.perDay ? days : centuries) * degree.si;
    ra += term.raSinDegrees * std::sin(a);
    dec += term.decCosDegrees * std::cos(a);
    w += term.wSinDegrees * std::sin(a);
  }
  return {ra * degree, dec * degree, (w - 360.0 * std::floor(w / 360.0)) * degree};
}

Rotation<BodyFixed, Icrs> bodyFixedFromIcrs(const BodyRotation& rotation, Instant t) {
  auto const a = rotationAngles(rotation, t);
  // The body's equator crosses the ICRS equator at right ascension alpha0 + 90 degrees.
  double const quarter = 90.0 * degree.si;
  return {aboutZ(a.primeMeridian.si) * aboutX(quarter - a.poleDeclination.si) *
          aboutZ(a.poleRightAscension.si + quarter)};
}

}  // namespace antumbra
