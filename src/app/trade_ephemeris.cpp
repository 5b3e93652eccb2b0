// `antumbra trade ephemeris`: requested error against terms, measured error and time.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/processor_clock.h"
#include "app/trade_front.h"
#include "document/document.h"
#include "document/text_output.h"
#include "ephemeris/ephemeris.h"
#include "ephemeris/tier_measurement.h"

namespace antumbra {
namespace {

struct Options {
  long dates = 100000;
  std::vector<std::string> errors{"10arcsec", "1arcsec", "0.1arcsec"};
  std::string format = "table", output = "-";
};

// Place and velocity of one body from the Earth: median of nine rounds, processor time.
double timeOf(const Ephemeris& e, BodyId body) {
  std::vector<double> rounds;
  volatile double sink = 0.0;
  for (int round = 0; round < 9; ++round) {
    double const start = threadMicroseconds();
    for (int i = 0; i < 60; ++i)
      sink = sink +
             e.state(body, BodyId::Earth, Instant::fromTt({2451545.0 + 7.1 * i, 0.0})).position.m.x;
    rounds.push_back((threadMicroseconds() - start) / 60.0);
  }
  std::nth_element(rounds.begin(), rounds.begin() + 4, rounds.end());
  return rounds[4];
}

void run(const Options& o) {
  if (o.dates < 100 || o.dates > 10'000'000)
    throw InputError(fmt::format("--dates: found {}; allowed: 100 to 10000000", o.dates));
  requireTradeOutput(o.format, o.output);
  std::vector<Angle> errors;
  for (auto const& text : o.errors) {
    errors.push_back(parseAngle(text, "--error"));
    if (!(errors.back().si > 0.0))
      throw InputError(fmt::format("--error: found \"{}\"; allowed: a positive angle", text));
  }
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  std::string table = fmt::format(
      "Truncated series against the full ones, {} random dates of 1900-2100, one thread\n"
      "{:<8} {:>10} {:>6} {:>12} {:>12} {:>12} {:>9}\n",
      o.dates, "body", "requested\"", "terms", "largest\"", "rms\"", "dropped sum\"", "us");
  std::string csv =
      "body,requested_arcsec,terms,largest_error_arcsec,rms_error_arcsec,dropped_sum_arcsec,time_"
      "us\n";
  for (const auto& body : tierBodies()) {
    TierMeasurer const measurer(body, TierSpan::NearPresent, static_cast<std::size_t>(o.dates), 1);
    auto const id = bodyFromName(body + "Barycentre").value_or(*bodyFromName(body));
    for (Angle const error : errors) {
      auto const tier = tierFor(body, TierSpan::NearPresent, error);
      auto const m = measurer.measure(tier.thresholdRadians);
      Ephemeris const e({.theory = Theory::Series, .error = error});
      double const time = timeOf(e, id);
      table += fmt::format("{:<8} {:>10g} {:>6} {:>12.4f} {:>12.4f} {:>12.2f} {:>9.2f}\n", body,
                           error / arcsecond, m.terms, m.worst() / arcsecond,
                           m.geocentricRms / arcsecond, m.droppedSum / arcsecond, time);
      csv += fmt::format("{},{:g},{},{:.6f},{:.6f},{:.6f},{:.3f}\n", body, error / arcsecond,
                         m.terms, m.worst() / arcsecond, m.geocentricRms / arcsecond,
                         m.droppedSum / arcsecond, time);
      rows.push_back({{"body", body},
                      {"requested_arcsec", error / arcsecond},
                      {"terms", m.terms},
                      {"largest_error_arcsec", m.worst() / arcsecond},
                      {"rms_error_arcsec", m.geocentricRms / arcsecond},
                      {"dropped_sum_arcsec", m.droppedSum / arcsecond},
                      {"time_us", time}});
    }
    fmt::print(stderr, "measured {}\n", body);
  }
  Ephemeris const full({.theory = Theory::Series});
  Ephemeris const tabulated({.theory = Theory::Table});
  for (const auto& body : tierBodies()) {
    auto const id = bodyFromName(body + "Barycentre").value_or(*bodyFromName(body));
    auto const t = Instant();
    for (const auto* e : {&full, &tabulated}) {
      std::string const name = e == &full ? "full" : "table";
      double const bound = e->errorBound(id, BodyId::Earth, t) / arcsecond, time = timeOf(*e, id);
      table +=
          fmt::format("{:<8} {:>10} {:>6} {:>12} {:>12} {:>12} {:>9.2f}   within {:g}\" of DE431\n",
                      body, name, "", "", "", "", time, bound);
      csv += fmt::format("{},{},,{:g},,,{:.3f}\n", body, name, bound, time);
      rows.push_back({{"body", body},
                      {"requested_arcsec", name},
                      {"largest_error_arcsec", bound},
                      {"time_us", time}});
    }
  }
  writeTextFile(o.output, o.format == "json"  ? rows.dump(1) + "\n"
                          : o.format == "csv" ? csv
                                              : table);
}

}  // namespace

void addTradeEphemeris(CLI::App& trade) {
  auto const o = std::make_shared<Options>();
  auto* command =
      trade.add_subcommand("ephemeris", "Requested error of positions against terms and time");
  command->add_option("--dates", o->dates, "Random dates of 1900-2100 (default 100000)");
  command->add_option("--error", o->errors, "Requested errors, as 10arcsec 1arcsec 0.1arcsec");
  command->add_option("--format", o->format, "table, csv or json");
  command->add_option("-o,--output", o->output, "File instead of standard output");
  command->footer("Example:\n  antumbra trade ephemeris --dates 10000");
  command->callback([o] { run(*o); });
}

}  // namespace antumbra
