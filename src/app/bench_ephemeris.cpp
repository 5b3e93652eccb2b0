// `antumbra-bench ephemeris`: what positions cost, as times and as ratios to a plain loop over
// libm, and the calibration of the error tiers.
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/bench_commands.h"
#include "app/processor_clock.h"
#include "document/document.h"
#include "document/paths.h"
#include "document/text_output.h"
#include "ephemeris/playback.h"
#include "ephemeris/tier_measurement.h"

namespace antumbra {
namespace {

constexpr BodyId kTen[] = {BodyId::Sun,
                           BodyId::Moon,
                           BodyId::Mercury,
                           BodyId::Venus,
                           BodyId::Mars,
                           BodyId::JupiterBarycentre,
                           BodyId::SaturnBarycentre,
                           BodyId::UranusBarycentre,
                           BodyId::NeptuneBarycentre};
constexpr int kRounds = 9;

// Microseconds of one call: the median of nine rounds of processor time of this thread, so that
// other programs on the machine do not count.
template <class Call>
double microseconds(int calls, Call call) {
  std::vector<double> rounds;
  for (int round = 0; round < kRounds; ++round) {
    double const start = threadMicroseconds();
    for (int i = 0; i < calls; ++i) call(round * calls + i);
    rounds.push_back((threadMicroseconds() - start) / calls);
  }
  std::nth_element(rounds.begin(), rounds.begin() + kRounds / 2, rounds.end());
  return rounds[kRounds / 2];
}

// A time every eleven minutes from 2000: frames of a time-lapse.
Instant frame(int i) { return Instant::fromTt({2451545.0, i / 131.0}); }
// Dates all over 1900-2100.
Instant scattered(int i) { return Instant::fromTt({2415021.0 + (i * 7919) % 73000, 0.37}); }

volatile double sink;

struct Line {
  std::string what;
  double microseconds = 0.0;
  double ratio = 0.0;  // to the plain loop of the same sums; 0 where it has none
};

// The plain loop and the vector sums over the same terms: Sun (Earth), Moon, seven planets.
template <class Sum>
double fullSeries(Sum sum) {
  static const SeriesCatalogue planets(catalogsFolder() / "ephemeris" / "vsop87b.bin");
  static const SeriesCatalogue moon(catalogsFolder() / "ephemeris" / "elpmpp02.bin");
  return microseconds(3, [&](int i) {
    double const days = 0.37 * i;
    double total = 0.0;
    for (int p = 0; p < kPlanets; ++p)
      for (const char* v : {"L", "B", "R"})
        total += sum(planets.series(nameOf(static_cast<Planet>(p)), v), days / 365250.0);
    for (const char* v : {"L", "B", "R"}) total += sum(moon.series("Moon", v), days / 36525.0);
    sink = total;
  });
}

std::vector<Line> measure() {
  std::vector<Line> lines;
  double const plain = fullSeries(valueByLibm);
  double const plainRates =
      fullSeries([](const TermSeries& s, double t) { return evaluateByLibm(s, t).rate; });
  lines.push_back({"full series, plain libm loop", plain, 1.0});
  lines.push_back({"full series, plain libm loop, with velocities", plainRates, 1.0});
  std::vector<VectorUnit> units{VectorUnit::Plain};
  if (bestVectorUnit() >= VectorUnit::Avx2) units.push_back(VectorUnit::Avx2);
  if (bestVectorUnit() >= VectorUnit::Avx512) units.push_back(VectorUnit::Avx512);
  for (VectorUnit unit : units) {
    double const values =
        fullSeries([&](const TermSeries& s, double t) { return valueOn(unit, s, t); });
    double const rates =
        fullSeries([&](const TermSeries& s, double t) { return evaluateOn(unit, s, t).rate; });
    lines.push_back({"full series, " + nameOf(unit), values, plain / values});
    lines.push_back(
        {"full series, " + nameOf(unit) + ", with velocities", rates, plainRates / rates});
  }
  std::array<State, std::size(kTen)> out;
  auto const all = [&](const Ephemeris& e, int calls, auto when) {
    return microseconds(calls, [&](int i) {
      e.states(kTen, BodyId::Earth, when(i), out);
      sink = out[3].position.m.x;
    });
  };
  for (const char* error : {"0.1arcsec", "1arcsec", "10arcsec"}) {
    Ephemeris const e({.theory = Theory::Series, .error = parseAngle(error, "bench")});
    lines.push_back({fmt::format("series within {}, places and velocities", error),
                     all(e, 200, frame), plainRates / all(e, 200, frame)});
  }
  Ephemeris const table({.theory = Theory::Table});
  lines.push_back({"table, playback, places and velocities", all(table, 5000, frame), 0.0});
  lines.push_back(
      {"table, scattered dates, places and velocities", all(table, 5000, scattered), 0.0});
  Ephemeris const series({.theory = Theory::Series});
  PlaybackEphemeris const playback(series);
  playback.prepare(frame(0), frame(5000 * kRounds));
  lines.push_back({"cache of the full series, playback, places and velocities",
                   all(playback, 5000, frame), 0.0});
  return lines;
}

// From nothing to the first place of the Sun, milliseconds of processor time: mapping the
// catalogues, selecting terms, one evaluation. The file system has the pages already.
double startUpMilliseconds(Ephemeris::Options options) {
  return microseconds(1,
                      [&](int) {
                        Ephemeris const e(options);
                        sink = e.state(BodyId::Sun, BodyId::Earth, frame(0)).position.m.x;
                      }) /
         1e3;
}

void calibrate(const std::string& file) {
  std::string out =
      "# Largest error of truncated series, arcseconds, against the full ones; columns: body, "
      "span\n"
      "# (near: |t| <= 1 century, 1e5 random dates; whole: -50..10 centuries, 1e4), threshold in\n"
      "# radians, terms left, error. Written by `antumbra-bench ephemeris --calibrate FILE`.\n";
  for (TierSpan span : {TierSpan::NearPresent, TierSpan::Whole}) {
    bool const near = span == TierSpan::NearPresent;
    for (const auto& body : tierBodies()) {
      TierMeasurer const measurer(body, span, near ? 100000 : 10000, 20170821);
      std::size_t before = 0;
      int const perDecade = near ? 20 : 8;
      for (int step = 0; step <= 6 * perDecade; ++step) {
        double const threshold =
            1e-3 * std::pow(10.0, -static_cast<double>(step) / static_cast<double>(perDecade));
        auto const m = measurer.measure(threshold);
        if (m.terms == before) continue;
        before = m.terms;
        out += fmt::format("{} {} {:.4e} {} {:.6g}\n", body, near ? "near" : "whole", threshold,
                           m.terms, m.worst() / arcsecond);
      }
      fmt::print(stderr, "calibrated {} ({})\n", body, near ? "near" : "whole");
    }
  }
  writeTextFile(file, out);
}

struct Options {
  std::string calibrate, json;
};

void run(const Options& o) {
  if (!o.calibrate.empty()) return calibrate(o.calibrate);
  auto const lines = measure();
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  fmt::print("Sun, Moon and seven planets from the Earth, one thread, {} chosen\n",
             nameOf(bestVectorUnit()));
  fmt::print("{:<60} {:>12} {:>22}\n", "", "microseconds", "times the plain loop");
  for (const auto& line : lines) {
    fmt::print("{:<60} {:>12.2f} {:>22}\n", line.what, line.microseconds,
               line.ratio > 0.0 ? fmt::format("{:.1f}", line.ratio) : "-");
    rows.push_back(
        {{"what", line.what}, {"microseconds", line.microseconds}, {"ratio", line.ratio}});
  }
  fmt::print("{:<60} {:>12}\n", "", "milliseconds");
  Ephemeris::Options const within1{.theory = Theory::Series, .error = 1.0 * arcsecond};
  for (auto const& [what, options] :
       {std::pair{"start-up to the first place, table",
                  Ephemeris::Options{.theory = Theory::Table}},
        std::pair{"start-up to the first place, full series",
                  Ephemeris::Options{.theory = Theory::Series}},
        std::pair{"start-up to the first place, series within 1arcsec", within1}}) {
    double const milliseconds = startUpMilliseconds(options);
    fmt::print("{:<60} {:>12.3f}\n", what, milliseconds);
    rows.push_back({{"what", what}, {"milliseconds", milliseconds}});
  }
  if (!o.json.empty()) writeTextFile(o.json, rows.dump(1) + "\n");
}

}  // namespace

void addEphemerisBench(CLI::App& program) {
  auto const o = std::make_shared<Options>();
  auto* command = program.add_subcommand("ephemeris", "Times of positions, against a plain loop");
  command->add_option("--json", o->json, "Also write the table as JSON");
  command->add_option("--calibrate", o->calibrate,
                      "Measure the error tiers and write catalogs/ephemeris/tiers.txt (minutes)");
  command->callback([o] { run(*o); });
}

}  // namespace antumbra
