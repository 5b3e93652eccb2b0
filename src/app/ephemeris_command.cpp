// `antumbra ephemeris`: positions of bodies as CSV or JSON.
#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/ephemeris_rows.h"
#include "document/document.h"
#include "document/text_output.h"

namespace antumbra {
namespace {

// Eleven days: the parabola of Morrison & Stephenson 2004 gives 7e4 s at -3000, and no rotation of
// the Earth in the theories' span comes near this.
constexpr double kLargestDeltaTSeconds = 1e6;

struct Options {
  std::string bodies = "all", center = "Earth", frame = "icrf", correction = "geometric";
  std::string jdTdb, jdTt, jdUt1, from, to, step;
  std::string theory = "auto", error = "best", format = "csv", output = "-";
  std::string site, deltaT, earthOrientation;
  std::vector<std::string> refraction;
  bool refract = false, extrapolate = false;
};

template <class Value>
Value choose(const std::string& text, const std::string& where,
             const std::vector<std::pair<std::string, Value>>& allowed) {
  std::vector<std::string> names;
  for (const auto& [name, value] : allowed) {
    if (name == text) return value;
    names.push_back(name);
  }
  throw InputError(
      fmt::format("{}: found \"{}\"; allowed: {}", where, text, fmt::join(names, ", ")));
}

Ephemeris::Options ephemerisOptions(const Options& o) {
  Ephemeris::Options e;
  e.theory = choose<Theory>(
      o.theory, "--theory",
      {{"auto", Theory::Auto}, {"series", Theory::Series}, {"table", Theory::Table}});
  e.extrapolate = o.extrapolate;
  if (o.error == "best") return e;
  if (o.theory == "table")
    throw InputError(fmt::format(
        "--error: found \"{}\" with --theory table; allowed: best (the table has one accuracy)",
        o.error));
  // "full" means every term of the series. A requested error is met by the table, where auto finds
  // that it covers the date, and by the terms it selects elsewhere.
  if (o.error == "full") e.theory = Theory::Series;
  if (o.error != "full") {
    e.error = parseAngle(o.error, "--error (best, full or an angle like 1arcsec)");
    if (!(e.error->si > 0.0))
      throw InputError(
          fmt::format("--error: found \"{}\"; allowed: best, full or a positive angle", o.error));
  }
  return e;
}

// Whether the text is a number and nothing else (nan and inf are; parseNumber refuses them).
bool isNumber(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  auto const end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
  return !text.empty() && end == text.data() + text.size();
}

struct Dates {
  std::vector<Epoch> epochs;
  std::string column;
};

Dates readDates(const Options& o, const EphemerisRequest& r) {
  bool const range = !o.from.empty() || !o.to.empty() || !o.step.empty();
  int const given = !o.jdTdb.empty() + !o.jdTt.empty() + !o.jdUt1.empty() + range;
  if (given != 1)
    throw InputError(fmt::format(
        "dates: found {} kinds; allowed: one of --jd-tdb FILE, --jd-tt FILE, --jd-ut1 FILE, or "
        "--from T --to T --step D",
        given));
  if (!o.jdTdb.empty())
    return {epochsFromFile(o.jdTdb, TimeScale::Tdb, r.deltaT, "--jd-tdb"), "jd_tdb"};
  if (!o.jdTt.empty()) return {epochsFromFile(o.jdTt, TimeScale::Tt, r.deltaT, "--jd-tt"), "jd_tt"};
  if (!o.jdUt1.empty())
    return {epochsFromFile(o.jdUt1, TimeScale::Ut1, r.deltaT, "--jd-ut1"), "jd_ut1"};
  if (o.from.empty() || o.to.empty() || o.step.empty())
    throw InputError("--from, --to, --step: one is missing; all three are required together");
  Duration const step = isNumber(o.step)
                            ? parseNumber(o.step, "--step") * day
                            : parseDuration(o.step, "--step (days, or with a unit: 10min)");
  if (!(step.si > 0.0))
    throw InputError(fmt::format(
        "--step: found \"{}\", which is not positive; allowed: a time longer than zero, in days or "
        "with a unit (10min)",
        o.step));
  auto const scale =
      r.frame == OutputFrame::Horizontal ? TimeScale::Ut1
      : r.frame == OutputFrame::EquatorialOfDate || r.frame == OutputFrame::EclipticOfDate
          ? TimeScale::Tt
          : TimeScale::Tdb;
  std::string const column = scale == TimeScale::Ut1  ? "jd_ut1"
                             : scale == TimeScale::Tt ? "jd_tt"
                                                      : "jd_tdb";
  return {epochsFromRange(parseInstant(o.from, "--from", r.deltaT),
                          parseInstant(o.to, "--to", r.deltaT), step, scale, r.deltaT),
          column};
}

EphemerisRequest requestOf(const Options& o) {
  EphemerisRequest r;
  r.bodies = bodiesFromList(o.bodies, "--bodies");
  r.centre = bodyFromCommandName(o.center, "--center");
  r.frame = choose<OutputFrame>(o.frame, "--frame",
                                {{"icrf", OutputFrame::Icrf},
                                 {"equatorial-j2000", OutputFrame::EquatorJ2000},
                                 {"ecliptic-j2000", OutputFrame::EclipticJ2000},
                                 {"itrf", OutputFrame::Itrf},
                                 {"equatorial-of-date", OutputFrame::EquatorialOfDate},
                                 {"ecliptic-of-date", OutputFrame::EclipticOfDate},
                                 {"horizontal", OutputFrame::Horizontal}});
  r.correction = choose<CorrectionLevel>(o.correction, "--correction",
                                         {{"geometric", CorrectionLevel::Geometric},
                                          {"light-time", CorrectionLevel::LightTime},
                                          {"astrometric", CorrectionLevel::Astrometric},
                                          {"apparent", CorrectionLevel::Apparent}});
  if (!o.deltaT.empty() && !o.earthOrientation.empty())
    throw InputError("--delta-t, --eop: both given; allowed: one of them");
  if (!o.deltaT.empty()) {
    double const seconds = parseNumber(o.deltaT, "--delta-t");
    if (std::fabs(seconds) > kLargestDeltaTSeconds)
      throw InputError(fmt::format("--delta-t: found \"{}\"; allowed: {:g} to {:g} seconds",
                                   o.deltaT, -kLargestDeltaTSeconds, kLargestDeltaTSeconds));
    r.deltaT = DeltaT::fixed(seconds * second);
  }
  if (!o.earthOrientation.empty()) r.deltaT = DeltaT::fromEarthOrientationFile(o.earthOrientation);
  if (!o.site.empty()) {
    r.site = parseSite(o.site, "--site");
    if (r.centre.id != BodyId::Earth)
      throw InputError(
          fmt::format("--site, --center: found a site with the centre {}; allowed: the Earth only",
                      r.centre.name));
  }
  bool const horizontal = r.frame == OutputFrame::Horizontal;
  if (horizontal && !r.site)
    throw InputError("--frame: found horizontal without a site; --site=LAT,LON,HEIGHT is required");
  if (o.refract) {
    if (!horizontal)
      throw InputError(fmt::format(
          "--refraction: found with --frame {}; allowed with horizontal only", o.frame));
    SurfaceAir air;
    if (!o.refraction.empty() && !o.refraction.front().empty()) {
      auto const& text = o.refraction.front();
      auto const comma = text.find(',');
      air.pressureHectopascal = parseNumber(text.substr(0, comma), "--refraction pressure");
      if (comma != std::string::npos)
        air.temperatureCelsius = parseNumber(text.substr(comma + 1), "--refraction temperature");
      if (air.pressureHectopascal < 0.0 || air.pressureHectopascal > 2000.0 ||
          air.temperatureCelsius < -150.0 || air.temperatureCelsius > 150.0)
        throw InputError(fmt::format(
            "--refraction: found \"{}\"; allowed: 0 to 2000 hPa and -150 to 150 degrees C", text));
    }
    r.refraction = air;
  }
  return r;
}

std::string csv(const EphemerisRequest& r, const Dates& dates,
                const std::vector<EphemerisRow>& rows) {
  auto const columns = valueColumns(r);
  std::string out = dates.column + ",body";
  for (const auto& c : columns) out += "," + c.name;
  out += ",theory,error_bound_arcsec\n";
  for (const auto& row : rows) {
    fmt::format_to(std::back_inserter(out), "{},{}", row.epoch->julianDate, row.body->name);
    for (std::size_t i = 0; i < columns.size(); ++i)
      fmt::format_to(std::back_inserter(out), ",{:.{}f}", row.values[i], columns[i].decimals);
    fmt::format_to(std::back_inserter(out), ",{},{:.4f}\n", row.theory, row.errorBoundArcseconds);
  }
  return out;
}

std::string json(const Options& o, const EphemerisRequest& r, const Dates& dates,
                 const std::vector<EphemerisRow>& rows) {
  auto const columns = valueColumns(r);
  nlohmann::ordered_json document;
  document["center"] = o.site.empty() ? r.centre.name : "site " + o.site;
  document["frame"] = o.frame;
  document["correction"] = o.correction;
  document["rows"] = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    nlohmann::ordered_json item;
    // As a number, written with every digit of the input.
    item[dates.column] = parseNumber(row.epoch->julianDate, dates.column);
    item["body"] = row.body->name;
    for (std::size_t i = 0; i < columns.size(); ++i) item[columns[i].name] = row.values[i];
    item["theory"] = row.theory;
    item["error_bound_arcsec"] = row.errorBoundArcseconds;
    document["rows"].push_back(std::move(item));
  }
  return document.dump(1) + "\n";
}

void run(const Options& o) {
  bool const asJson = choose<bool>(o.format, "--format", {{"csv", false}, {"json", true}});
  auto const request = requestOf(o);
  auto const options = ephemerisOptions(o);
  Ephemeris const ephemeris(options);
  auto const dates = readDates(o, request);
  auto const rows = ephemerisRows(ephemeris, request, dates.epochs);
  writeTextFile(o.output, asJson ? json(o, request, dates, rows) : csv(request, dates, rows));
  if (!options.error) return;
  for (const auto& line : unmetErrors(ephemeris, request, rows, *options.error))
    fmt::print(stderr, "antumbra: warning: --error: {}\n", line);
}

}  // namespace

void addEphemerisCommand(CLI::App& program) {
  auto const o = std::make_shared<Options>();
  auto* command = program.add_subcommand("ephemeris", "Positions of bodies as CSV or JSON");
  command->add_option("--bodies", o->bodies,
                      "Comma list, or all; Jupiter ... Pluto are the barycentres of the systems, "
                      "Jupiter.center the planet itself");
  command->add_option("--center", o->center, "Body at the origin (default Earth)");
  command->add_option("--frame", o->frame,
                      "icrf, equatorial-j2000, ecliptic-j2000, itrf: metres; equatorial-of-date, "
                      "ecliptic-of-date, horizontal: degrees and au");
  command->add_option("--correction", o->correction,
                      "geometric; light-time and astrometric (the target when the light left it); "
                      "apparent (also aberration and deflection by the Sun)");
  command->add_option("--jd-tdb", o->jdTdb, "File of Julian dates (TDB), one a line; - is stdin");
  command->add_option("--jd-tt", o->jdTt, "The same in TT");
  command->add_option("--jd-ut1", o->jdUt1, "The same in UT1");
  command->add_option("--from", o->from,
                      "First date, as 2027-08-02T10:00:00Z or \"2451545.0 TDB\"");
  command->add_option("--to", o->to, "Last date");
  command->add_option("--step", o->step, "Step in days, or with a unit (10min)");
  command->add_option("--theory", o->theory,
                      "auto (the table 1800-2400, else the series), series or table");
  command->add_option(
      "--error", o->error,
      "best; full (every term of the series); or an angle as 1arcsec: the terms of the series "
      "that keep truncation below it, against the full series. The column error_bound_arcsec is "
      "against JPL DE431: what the full series miss plus what was cut. Where it exceeds the angle, "
      "a warning per body says so and the exit status stays 0");
  command->add_option("--format", o->format, "csv or json");
  command->add_option("-o,--output", o->output, "File instead of standard output");
  command->add_option("--site", o->site,
                      "LAT,LON,HEIGHT: degrees, degrees east, metres above the WGS84 ellipsoid "
                      "(write --site=-33.9,18.4,0)");
  command->add_option("--delta-t", o->deltaT, "TT - UT1 in seconds instead of the table's");
  command->add_option("--eop", o->earthOrientation,
                      "Earth-orientation file: MJD, UT1-UTC [s], x and y of the pole [arcsec]");
  auto* refraction = command->add_option("--refraction", o->refraction,
                                         "Add refraction; optionally PRESSURE_HPA,CELSIUS");
  refraction->expected(0, 1);
  command->add_flag("--extrapolate", o->extrapolate,
                    "Answer outside the theories' span; the theory column says so");
  command->footer(
      "Example:\n  antumbra ephemeris --bodies Sun,Moon --correction apparent --frame horizontal "
      "--site=25.687,32.640,76\n      --from 2027-08-02T09:00Z --to 2027-08-02T11:00Z --step "
      "10min");
  command->callback([o, refraction] {
    o->refract = refraction->count() > 0;
    run(*o);
  });
}

}  // namespace antumbra
