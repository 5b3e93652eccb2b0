#include "app/ephemeris_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "document/document.h"

namespace antumbra {
namespace {

constexpr std::size_t kMaxRows = 20'000'000;

std::string lower(std::string_view text) {
  std::string out;
  for (char c : text) out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

struct CommandName {
  const char* name;
  BodyId id;
};
constexpr CommandName kCommandNames[] = {
    {"Sun", BodyId::Sun},
    {"Moon", BodyId::Moon},
    {"Mercury", BodyId::Mercury},
    {"Venus", BodyId::Venus},
    {"Earth", BodyId::Earth},
    {"Mars", BodyId::Mars},
    {"Jupiter", BodyId::JupiterBarycentre},
    {"Saturn", BodyId::SaturnBarycentre},
    {"Uranus", BodyId::UranusBarycentre},
    {"Neptune", BodyId::NeptuneBarycentre},
    {"Pluto", BodyId::PlutoBarycentre},
    {"Jupiter.center", BodyId::Jupiter},
    {"Saturn.center", BodyId::Saturn},
    {"Uranus.center", BodyId::Uranus},
    {"Neptune.center", BodyId::Neptune},
    {"Pluto.center", BodyId::Pluto},
    {"SolarSystemBarycentre", BodyId::SolarSystemBarycentre},
    {"EarthMoonBarycentre", BodyId::EarthMoonBarycentre},
};

// The text of a Julian date with at least nine decimals, digit for digit what was given.
std::string echoed(std::string text) {
  auto const point = text.find('.');
  if (point == std::string::npos) return text + ".000000000";
  auto const decimals = text.size() - point - 1;
  return decimals >= 9 ? text : text + std::string(9 - decimals, '0');
}

// "2451545.123" as whole and fraction, so that no digit is lost to the size of the date.
JulianDate splitJulianDate(const std::string& text, const std::string& where) {
  (void)parseNumber(text, where);
  auto const point = text.find('.');
  if (point == std::string::npos || text.find_first_of("eE") != std::string::npos)
    return {parseNumber(text, where), 0.0};
  double const whole = point == 0 ? 0.0 : parseNumber(text.substr(0, point), where);
  std::string const digits = text.substr(point);
  double const fraction = digits.size() > 1 ? std::stod(fmt::format("0{}", digits)) : 0.0;
  return {whole, text[0] == '-' ? -fraction : fraction};
}

Corrections correctionsOf(CorrectionLevel level) {
  bool const apparent = level == CorrectionLevel::Apparent;
  return {level != CorrectionLevel::Geometric, apparent, apparent};
}

Displacement<Icrs> placeAt(const Ephemeris& e, const EphemerisRequest& r, BodyId body, Instant t) {
  Observer const eye = r.site ? observerAt(e, *r.site, t, r.deltaT) : observerAt(e, r.centre.id, t);
  return apparentPlace(e, body, eye, t, correctionsOf(r.correction)).displacement;
}

double wrapped(double radians) {
  double const d = radians / degree.si;
  return d < 0.0 ? d + 360.0 : d;
}

template <class Frame>
std::vector<double> spherical(Displacement<Frame> d) {
  return {wrapped(std::atan2(d.m.y, d.m.x)),
          std::atan2(d.m.z, std::hypot(d.m.x, d.m.y)) / degree.si, norm(d) / astronomicalUnit};
}

template <class Frame>
std::vector<double> cartesian(Displacement<Frame> d, Velocity<Frame> v) {
  return {d.m.x, d.m.y, d.m.z, v.m.x, v.m.y, v.m.z};
}

bool isCartesian(OutputFrame frame) { return frame <= OutputFrame::Itrf; }

// A state, its velocity by central differences where corrections make it more than a derivative.
State stateOf(const Ephemeris& e, const EphemerisRequest& r, BodyId body, Instant t) {
  if (r.correction == CorrectionLevel::Geometric && !r.site) return e.state(body, r.centre.id, t);
  Duration const h = 30.0 * second;  // truncation below 1e-6 m/s, rounding 1e-4 m/s at 30 au
  auto const before = placeAt(e, r, body, t - h), after = placeAt(e, r, body, t + h);
  return {placeAt(e, r, body, t), {(after.m - before.m) / (2.0 * h.si)}};
}

// In the rotating frame the axes' own turning adds to the velocity.
std::vector<double> terrestrial(State s, Instant t, const DeltaT& deltaT) {
  auto const spin = itrsFromIcrs(t, deltaT);
  auto const place = spin(s.position);
  auto velocity = spin(s.velocity);
  velocity.m -= glm::cross(glm::dvec3(0.0, 0.0, kEarthAngularVelocity.si), place.m);
  return cartesian(place, velocity);
}

}  // namespace

NamedBody bodyFromCommandName(const std::string& name, const std::string& where) {
  for (const auto& known : kCommandNames)
    if (lower(name) == lower(known.name)) return {known.name, known.id};
  // Moons and whatever else the ephemeris knows under one name only.
  for (BodyId body : allBodies()) {
    auto const plain = nameOf(body);
    if (lower(name) == lower(plain) && plain.find("arycentre") == std::string::npos)
      return {plain, body};
  }
  std::vector<std::string> allowed;
  for (const auto& known : kCommandNames) allowed.emplace_back(known.name);
  for (BodyId body : allBodies()) {
    auto const plain = nameOf(body);
    bool const listed = std::any_of(std::begin(kCommandNames), std::end(kCommandNames),
                                    [&](const CommandName& k) { return k.id == body; });
    if (!listed) allowed.push_back(plain);
  }
  throw InputError(fmt::format("{}: found unknown body \"{}\"; allowed: {}", where, name,
                               fmt::join(allowed, ", ")));
}

std::vector<NamedBody> bodiesFromList(const std::string& list, const std::string& where) {
  std::vector<NamedBody> bodies;
  if (lower(list) == "all") {
    for (const char* name : {"Sun", "Moon", "Mercury", "Venus", "Mars", "Jupiter", "Saturn",
                             "Uranus", "Neptune", "Pluto"})
      bodies.push_back(bodyFromCommandName(name, where));
    return bodies;
  }
  for (std::size_t start = 0; start <= list.size();) {
    auto const end = std::min(list.find(',', start), list.size());
    bodies.push_back(bodyFromCommandName(list.substr(start, end - start), where));
    start = end + 1;
  }
  return bodies;
}

std::vector<Epoch> epochsFromFile(const std::string& file, TimeScale scale, const DeltaT& deltaT,
                                  const std::string& where) {
  std::ifstream opened;
  if (file != "-") {
    if (std::filesystem::is_directory(file))
      throw InputError(
          fmt::format("{}: found \"{}\", which is a folder; allowed: a file of Julian dates, one a "
                      "line, or - for standard input",
                      where, file));
    opened.open(file);
    if (!opened)
      throw InputError(
          fmt::format("{}: found \"{}\", which cannot be read; allowed: a file of Julian dates, "
                      "one a line, or - "
                      "for standard input",
                      where, file));
  }
  std::istream& in = file == "-" ? std::cin : opened;
  std::vector<Epoch> epochs;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    line = line.substr(0, line.find('#'));
    auto const begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    std::string const text = line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
    std::string const place = fmt::format("{}:{}", file, number), at = place + ": Julian date";
    auto const date = splitJulianDate(text, at);
    if (std::fabs(date.value()) > 1e8)
      throw InputError(fmt::format("{}: found {}; allowed: -1e8 to 1e8", at, text));
    epochs.push_back({Instant::from(scale, date, deltaT),
                      text.find_first_of("eE+") == std::string::npos
                          ? echoed(text)
                          : fmt::format("{:.9f}", date.value()),
                      place, fmt::format("{} {}", text, nameOf(scale))});
  }
  if (epochs.empty())
    throw InputError(fmt::format("{}: holds no date; allowed: one Julian date per line", file));
  return epochs;
}

std::vector<Epoch> epochsFromRange(Instant first, Instant last, Duration step, TimeScale scale,
                                   const DeltaT& deltaT) {
  if (last < first) throw InputError("--to: lies before --from; allowed: a later date");
  if (!(step.si > 0.0))
    throw InputError(
        fmt::format("--step: found {:g} days; allowed: a time longer than zero", step / day));
  // Steps are even in the scale that is printed. A millionth of a step is forgiven at the end: TDB
  // and TT run 30 microseconds apart in a day.
  auto const start = first.in(scale, deltaT), end = last.in(scale, deltaT);
  double const length = (end.whole - start.whole) + (end.fraction - start.fraction);
  double const count = std::floor(length / (step / day) + 1e-6) + 1.0;
  if (count > static_cast<double>(kMaxRows))
    throw InputError(
        fmt::format("--step: found {:g} days, which makes {:.6g} dates; allowed: at most {} dates",
                    step / day, count, kMaxRows));
  std::vector<Epoch> epochs;
  for (double i = 0.0; i < count; i += 1.0) {
    JulianDate const date{start.whole, start.fraction + i * (step / day)};
    auto const t = Instant::from(scale, date, deltaT);
    double const whole = std::floor(date.whole + 0.5),
                 fraction = (date.whole - whole) + date.fraction;
    double day = std::floor(whole + fraction);
    double rest = (whole - day) + fraction;
    if (rest >= 1.0 - 5e-13) {
      day += 1.0;
      rest = 0.0;
    }
    auto const text = fmt::format("{:.0f}{}", day, fmt::format("{:.12f}", rest).substr(1));
    epochs.push_back({t, text, "--from, --to", fmt::format("{} {}", text, nameOf(scale))});
  }
  return epochs;
}

std::vector<Column> valueColumns(const EphemerisRequest& r) {
  std::vector<Column> c;
  if (isCartesian(r.frame)) {
    for (const char* name : {"x_m", "y_m", "z_m"}) c.push_back({name, 3});
    for (const char* name : {"vx_m_s", "vy_m_s", "vz_m_s"}) c.push_back({name, 6});
  } else if (r.frame == OutputFrame::EquatorialOfDate) {
    c = {{"ra_deg", 9}, {"dec_deg", 9}, {"distance_au", 12}};
  } else if (r.frame == OutputFrame::EclipticOfDate) {
    c = {{"ecl_lon_deg", 9}, {"ecl_lat_deg", 9}, {"distance_au", 12}};
  } else {
    c = {{"az_deg", 9}, {"alt_deg", 9}, {"distance_au", 12}};
  }
  if (r.site || r.frame == OutputFrame::Itrf) c.push_back({"delta_t_s", 3});
  return c;
}

namespace {

// The rows of one epoch, appended.
void appendRows(const Ephemeris& e, const EphemerisRequest& r, const std::vector<BodyId>& ids,
                const Epoch& epoch, std::vector<EphemerisRow>& rows) {
  Instant const t = epoch.instant;
  std::vector<std::vector<double>> values(ids.size());
  if (isCartesian(r.frame)) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      State const s = stateOf(e, r, ids[i], t);
      if (r.frame == OutputFrame::Icrf) {
        values[i] = cartesian(s.position, s.velocity);
      } else if (r.frame == OutputFrame::Itrf) {
        values[i] = terrestrial(s, t, r.deltaT);
      } else if (r.frame == OutputFrame::EquatorJ2000) {
        auto const turn = equatorJ2000FromIcrs();
        values[i] = cartesian(turn(s.position), turn(s.velocity));
      } else {
        auto const turn = eclipticJ2000FromIcrs();
        values[i] = cartesian(turn(s.position), turn(s.velocity));
      }
    }
  } else {
    Observer const eye =
        r.site ? observerAt(e, *r.site, t, r.deltaT) : observerAt(e, r.centre.id, t);
    auto const places = apparentPlaces(e, ids, eye, t, correctionsOf(r.correction));
    auto const ofDate = trueEquatorOfDateFromIcrs(t);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      auto const place = places[i].displacement;
      if (r.frame == OutputFrame::EquatorialOfDate) {
        values[i] = spherical(ofDate(place));
      } else if (r.frame == OutputFrame::EclipticOfDate) {
        values[i] = spherical(trueEclipticOfDateFromIcrs(t)(place));
      } else {
        auto const toHorizon =
            enuFromItrs(*r.site) * itrsFromTrueEquatorOfDate(t, r.deltaT) * ofDate;
        auto const h = horizontalFromEnu(directionOf(toHorizon(place)));
        Angle const lift = r.refraction ? refractionAt(h.altitude, *r.refraction) : Angle();
        values[i] = {h.azimuth / degree, (h.altitude + lift) / degree,
                     norm(place) / astronomicalUnit};
      }
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (r.site || r.frame == OutputFrame::Itrf) values[i].push_back(r.deltaT.at(t) / second);
    rows.push_back({&epoch, &r.bodies[i], std::move(values[i]),
                    e.theoryName(ids[i], r.centre.id, t),
                    e.errorBound(ids[i], r.centre.id, t) / arcsecond});
  }
}

}  // namespace

std::vector<EphemerisRow> ephemerisRows(const Ephemeris& e, const EphemerisRequest& r,
                                        const std::vector<Epoch>& epochs) {
  std::vector<EphemerisRow> rows;
  rows.reserve(epochs.size() * r.bodies.size());
  std::vector<BodyId> ids;
  for (const auto& body : r.bodies) ids.push_back(body.id);
  for (const auto& epoch : epochs) {
    try {
      appendRows(e, r, ids, epoch, rows);
    } catch (const SpanError& error) {
      throw InputError(fmt::format("{}: found the Julian date {} ({}); allowed by {}: {} to {}{}",
                                   epoch.source, epoch.given,
                                   formatIso(epoch.instant, TimeScale::Tt, 0), error.theory(),
                                   formatIso(error.span().first, TimeScale::Tt, 0),
                                   formatIso(error.span().last, TimeScale::Tt, 0),
                                   error.extrapolable() ? "; --extrapolate answers outside" : ""));
    }
  }
  return rows;
}

std::vector<std::string> unmetErrors(const Ephemeris& e, const EphemerisRequest& r,
                                     const std::vector<EphemerisRow>& rows, Angle requested) {
  std::vector<std::string> lines;
  for (const auto& body : r.bodies) {
    const EphemerisRow* first = nullptr;
    double largest = 0.0;
    for (const auto& row : rows) {
      if (row.body != &body) continue;
      if (!first && row.errorBoundArcseconds > requested / arcsecond) first = &row;
      largest = std::max(largest, row.errorBoundArcseconds);
    }
    if (!first) continue;
    auto const& epoch = *first->epoch;
    double const reachable =
        e.untruncatedErrorBound(body.id, r.centre.id, epoch.instant) / arcsecond;
    lines.push_back(fmt::format(
        "{}: requested {:g} arcsec; from {} ({}) its error_bound_arcsec is {:.4f}, at most {:.4f} "
        "in these rows; reachable there with every term of {}: {:.4f} arcsec",
        body.name, requested / arcsecond, epoch.source, epoch.given, first->errorBoundArcseconds,
        largest, first->theory, reachable));
  }
  return lines;
}

}  // namespace antumbra
