// `antumbra eclipse list`: every eclipse or transit in a span of years.
#include <fmt/format.h>
#include <unistd.h>

#include "app/eclipse_options.h"
#include "app/row_table.h"
#include "document/input_error.h"
#include "document/text_output.h"
#include "eclipse/jovian.h"
#include "eclipse/transit.h"

namespace antumbra {
namespace {

struct Options {
  std::string kind = "solar";
  long from = 0, to = 0;
  std::string format = "table", output;
  EclipseOptions shared;
};

std::optional<double> jdOf(const std::optional<Instant>& t) {
  return t ? std::optional(t->tt().value()) : std::nullopt;
}

Cell ut1Of(const std::optional<Instant>& t, Duration deltaT) {
  if (!t) return {};
  return ut1Text(*t, deltaT);
}

void addBasis(RowTable::Row& row, const EclipseBasis& basis) {
  row.emplace_back("convention", basis.convention.name);
  row.emplace_back("sun_radius_km", cell(basis.convention.sunRadius / kilometre, 1));
  row.emplace_back("k_umbra", cell(basis.convention.lunarKUmbra, 7));
  row.emplace_back("k_penumbra", cell(basis.convention.lunarKPenumbra, 7));
}

RowTable::Row rowOf(const SolarEclipse& e, const EclipseBasis& basis) {
  RowTable::Row row{{"ecl_id", e.id},
                    {"type", e.type},
                    {"jd_tt_greatest", cell(e.greatest.tt().value(), 8)},
                    {"delta_t_s", cell(e.deltaT / second, 3)},
                    {"gamma", cell(e.gamma, 7)},
                    {"lat_deg", cell(e.place.latitude / degree, 5)},
                    {"lon_deg_east", cell(e.place.longitude / degree, 5)},
                    {"sun_alt_deg", cell(e.seen.sun.altitude / degree, 3)},
                    {"magnitude", cell(e.magnitude, 6)},
                    {"duration_s", e.duration ? cell(*e.duration / second, 2) : Cell()},
                    {"width_km", e.width ? cell(*e.width / kilometre, 3) : Cell()},
                    {"saros", cell(e.saros, 0)},
                    {"lunation", cell(e.lunation, 0)},
                    {"obscuration", cell(e.obscuration, 6)},
                    {"sun_az_deg", cell(e.seen.sun.azimuth / degree, 3)},
                    {"p1_jd_tt", cell(jdOf(e.p1), 8)},
                    {"u1_jd_tt", cell(jdOf(e.u1), 8)},
                    {"c1_jd_tt", cell(jdOf(e.c1), 8)},
                    {"c4_jd_tt", cell(jdOf(e.c4), 8)},
                    {"u4_jd_tt", cell(jdOf(e.u4), 8)},
                    {"p4_jd_tt", cell(jdOf(e.p4), 8)}};
  addBasis(row, basis);
  return row;
}

RowTable::Row rowOf(const LunarEclipse& e, const EclipseBasis& basis) {
  RowTable::Row row{{"ecl_id", e.id},
                    {"type", e.type},
                    {"jd_tt_greatest", cell(e.greatest.tt().value(), 8)},
                    {"delta_t_s", cell(e.deltaT / second, 3)},
                    {"gamma", cell(e.gamma, 6)},
                    {"umbral_magnitude", cell(e.umbralMagnitude, 5)},
                    {"penumbral_magnitude", cell(e.penumbralMagnitude, 5)},
                    {"p1_ut1", ut1Of(e.p1, e.deltaT)},
                    {"u1_ut1", ut1Of(e.u1, e.deltaT)},
                    {"u2_ut1", ut1Of(e.u2, e.deltaT)},
                    {"u3_ut1", ut1Of(e.u3, e.deltaT)},
                    {"u4_ut1", ut1Of(e.u4, e.deltaT)},
                    {"p4_ut1", ut1Of(e.p4, e.deltaT)},
                    {"saros", cell(e.saros, 0)},
                    {"lunation", cell(e.lunation, 0)},
                    {"shadow_enlargement", nameOf(basis.enlargement)}};
  addBasis(row, basis);
  return row;
}

RowTable::Row rowOf(const Transit& e, const EclipseBasis& basis) {
  RowTable::Row row{{"ecl_id", e.id},
                    {"type", nameOf(e.planet)},
                    {"jd_tt_greatest", cell(e.greatest.tt().value(), 8)},
                    {"delta_t_s", cell(e.deltaT / second, 3)},
                    {"separation_arcsec", cell(e.separation / arcsecond, 2)},
                    {"position_angle_deg", cell(e.positionAngle * 180.0 / M_PI, 2)},
                    {"sun_radius_arcsec", cell(e.sunRadius / arcsecond, 2)},
                    {"planet_radius_arcsec", cell(e.planetRadius / arcsecond, 2)},
                    {"i_ut1", ut1Of(e.i, e.deltaT)},
                    {"ii_ut1", ut1Of(e.ii, e.deltaT)},
                    {"greatest_ut1", ut1Of(e.greatest, e.deltaT)},
                    {"iii_ut1", ut1Of(e.iii, e.deltaT)},
                    {"iv_ut1", ut1Of(e.iv, e.deltaT)},
                    {"convention", basis.convention.name},
                    {"sun_radius_km", cell(basis.convention.sunRadius / kilometre, 1)}};
  return row;
}

RowTable::Row rowOf(const JovianEvent& e) {
  return {{"ecl_id", e.id},
          {"type", e.shadowOnJupiter ? "shadow" : "eclipse"},
          {"moon", nameOf(e.moon)},
          {"jd_tt_begin_at_jupiter", cell(e.begin.tt().value(), 6)},
          {"jd_tt_middle_at_jupiter", cell(e.middle.tt().value(), 6)},
          {"jd_tt_end_at_jupiter", cell(e.end.tt().value(), 6)},
          {"light_time_s", cell(e.lightTime / second, 1)},
          {"delta_t_s", cell(e.deltaT / second, 3)},
          {"begin_seen_ut1", ut1Of(e.seen(e.begin), e.deltaT)},
          {"middle_seen_ut1", ut1Of(e.seen(e.middle), e.deltaT)},
          {"end_seen_ut1", ut1Of(e.seen(e.end), e.deltaT)},
          {"least_distance_radii", cell(e.leastDistance, 4)},
          {"shadows_at_once", e.shadowOnJupiter ? cell(e.shadowsAtOnce, 0) : Cell()}};
}

// A line on a terminal's standard error, rewritten as the search goes.
Progress progressLine(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [what, shown = -1](double done) mutable {
    int const percent = static_cast<int>(100.0 * done);
    if (percent == shown) return;
    shown = percent;
    fmt::print(stderr, "\r{}: {} %{}", what, percent, percent == 100 ? "\n" : "");
  };
}

// Calendars of far years would overflow; the theories say themselves how far they reach.
void requireYear(const char* name, long year) {
  if (year < -20000 || year > 20000)
    throw InputError(fmt::format("{}: found {}; allowed: years -20000 to 20000", name, year));
}

void list(const Options& options) {
  requireYear("--from", options.from);
  requireYear("--to", options.to);
  if (options.to < options.from)
    throw InputError(
        fmt::format("--to: found {}, which is before --from {}", options.to, options.from));
  EclipseBasis const basis = options.shared.basis();
  Instant const from = startOfYear(options.from), to = startOfYear(options.to + 1);
  RowTable table;
  Progress const progress = progressLine(options.kind + " eclipses");
  if (options.kind == "solar")
    for (auto const& e : solarEclipses(basis, from, to, progress)) table.add(rowOf(e, basis));
  if (options.kind == "lunar")
    for (auto const& e : lunarEclipses(basis, from, to, progress)) table.add(rowOf(e, basis));
  if (options.kind == "transit")
    for (auto const& e : transits(basis, from, to, progress)) table.add(rowOf(e, basis));
  if (options.kind == "jovian")
    for (auto const& e : jovianEvents(basis, from, to, progress)) table.add(rowOf(e));
  if (options.format == "table") fmt::print("{}\n", describe(basis));
  writeTextFile(options.output, table.text(options.format, {"ecl_id"}));
}

}  // namespace

void addEclipseList(CLI::App& eclipse) {
  auto* const command = eclipse.add_subcommand("list", "every eclipse in a span of years");
  auto options = std::make_shared<Options>();
  command->add_option("--kind", options->kind, "solar, lunar, transit or jovian")
      ->check(CLI::IsMember({"solar", "lunar", "transit", "jovian"}))
      ->capture_default_str();
  command->add_option("--from", options->from, "first year (astronomical: 0 is 1 BC)")->required();
  command->add_option("--to", options->to, "last year, inclusive")->required();
  command->add_option("--format", options->format)
      ->check(CLI::IsMember({"table", "csv", "json"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "file instead of standard output");
  options->shared.addTo(*command);
  command->footer(
      "Example:\n  antumbra eclipse list --kind solar --from 1900 --to 2100 "
      "--convention nasa --format csv");
  command->callback([options] { list(*options); });
}

}  // namespace antumbra
