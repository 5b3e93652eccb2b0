// `antumbra trade shadows`: what simpler shadows cost in light and kilometres, and save in time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/commands.h"
#include "app/processor_clock.h"
#include "app/scene_session.h"
#include "app/trade_front.h"
#include "document/paths.h"
#include "document/text_output.h"
#include "plan/shadow_trial.h"

namespace antumbra {
namespace {

// Where no scene is named: the shadows of Callisto and Io overlap on Jupiter.
constexpr const char* kDefaultScene = "jupiter_triple_shadow.toml";
constexpr const char* kDefaultTime = "2015-01-24T05:49:40Z";

struct Options {
  std::string scene;
  SceneOverrides overrides;
  int points = 300;
  std::string format = "table", output = "-";
};

// Nanoseconds of one evaluation of a model: least of nine rounds, so that what else the machine
// does drops out.
double nanosecondsOf(const std::vector<ShadowTrial>& trials, const ShadowModel& model) {
  double least = INFINITY;
  std::size_t points = 0;
  for (auto const& trial : trials) points += trial.points();
  int const repeats = std::max(1, static_cast<int>(2000 / std::max<std::size_t>(points, 1)));
  volatile double sink = 0.0;
  for (int round = 0; round < 9; ++round) {
    double const start = threadMicroseconds();
    for (int i = 0; i < repeats; ++i)
      for (auto const& trial : trials) sink = sink + trial.evaluateAll(model);
    least = std::min(least, threadMicroseconds() - start);
  }
  return 1e3 * least / (repeats * static_cast<double>(points));
}

std::vector<ShadowModel> modelsFor(const std::vector<ShadowReceiver>& receivers, bool darkened,
                                   bool oblate) {
  bool several = false, air = false;
  for (auto const& r : receivers) {
    several = several || r.casters.size() > 1;
    air = air || !r.atmosphere.empty();
  }
  std::vector<ShadowModel> models;
  for (bool spheroid : {true, false})
    for (bool limb : {true, false})
      for (auto rule : {SeveralCasters::Union, SeveralCasters::Minimum, SeveralCasters::Product})
        for (int evaluations : {1, 2, 4, 8, 16})
          for (bool split : {false, true}) {
            if ((!spheroid && !oblate) || (limb && !darkened) ||
                (rule != SeveralCasters::Union && !several) || (evaluations > 1 && !air) ||
                (evaluations == 1 && split))
              continue;
            models.push_back({spheroid, limb, rule, split, evaluations});
          }
  return models;
}

std::optional<double> largest(std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return a ? a : b;
  return std::max(*a, *b);
}

std::optional<double> inKilometres(std::optional<Length> length) {
  return length ? std::optional(*length / kilometre) : std::nullopt;
}

void run(const Options& o) {
  requireTradeOutput(o.format, o.output);
  if (o.points < 20 || o.points > 100000)
    throw InputError(fmt::format("--points: found {}; allowed: 20 to 100000", o.points));
  SceneOverrides overrides = o.overrides;
  std::string file = o.scene;
  if (file.empty()) {
    file = (configsFolder() / "scenes" / kDefaultScene).string();
    if (overrides.time.empty()) overrides.time = kDefaultTime;
  }
  SceneSession const session(file, overrides);
  auto const moment = session.at(0);
  auto const receivers = shadowReceivers(moment.plan);
  if (receivers.empty())
    throw InputError(
        fmt::format("{}: found no shadow at its instant; allowed: a scene whose picture holds one "
                    "(`antumbra render SCENE --explain` lists them)",
                    file));
  auto const named =
      parseLimbDarkeningLaw(moment.scene.shadows.limbDarkening, file + ": [shadows]");
  bool oblate = false;
  for (auto const& r : receivers)
    for (auto const& caster : r.casters) oblate = oblate || caster.figure.polarOverEquatorial < 1.0;
  auto const models = modelsFor(receivers, named != LimbDarkeningLaw::None, oblate);

  TradeProgress progress("shadows", receivers.size() + models.size());
  std::vector<ShadowTrial> trials;
  std::string what;
  std::size_t points = 0, rays = 0;
  for (auto const& r : receivers) {
    progress.at("rays to the Sun from " + r.name, 0.0);
    trials.emplace_back(r, moment.plan.picture, named, o.points);
    points += trials.back().points();
    rays += trials.back().airRays();
    for (auto const& caster : r.casters)
      what += fmt::format("{}{} on {}", what.empty() ? "" : ", ", caster.name, r.name);
    progress.finished("rays to the Sun from " + r.name);
  }
  if (points == 0)
    throw InputError(
        fmt::format("{}: no sunlit place of {} lies in its shadows; allowed: a scene "
                    "where one does",
                    file, receivers.front().name));
  bool const air = rays > 0;
  // What the rays themselves are uncertain by.
  TradeFront front("shadows", "time_ns", "error_percent", 0.02);
  front.note("scene", file);
  front.note("shadows", what);
  front.note("reference",
             fmt::format("rays to the Sun from {} places, limb darkening {}{}", points,
                         moment.scene.shadows.limbDarkening,
                         air ? fmt::format("; in air 96 evaluations along {} rays", rays) : ""));
  front.note("time", "of a pixel's evaluations in doubles, one thread of this machine");
  for (auto const& model : models) {
    std::string const name =
        fmt::format("{}, {}, {}, {}", model.spheroid ? "spheroid" : "sphere",
                    model.limbDarkened ? "limb-darkened" : "uniform", nameOf(model.several),
                    model.evaluations, model.splitAtUmbra ? " beyond the umbra" : "");
    if (TradeProgress::interrupted()) {
      front.markIncomplete();
      break;
    }
    double ground = 0.0, mean = 0.0;
    std::optional<double> inAir, meanAir, half, umbra;
    for (auto const& trial : trials) {
      auto const e = trial.errorsOf(model);
      ground = std::max(ground, e.largestLight);
      mean += e.meanLight * static_cast<double>(trial.points()) / static_cast<double>(points);
      inAir = largest(inAir, e.largestAir);
      if (e.meanAir)
        meanAir = meanAir.value_or(0.0) +
                  *e.meanAir * static_cast<double>(trial.airRays()) / static_cast<double>(rays);
      half = largest(half, inKilometres(e.halfLightEdge));
      umbra = largest(umbra, inKilometres(e.umbraEdge));
    }
    double const one = nanosecondsOf(trials, model);
    double const evaluations = model.evaluations == 1 ? 1.0 : 1.0 + model.evaluations;
    auto const percent = [](std::optional<double> share) {
      return cell(share ? std::optional(100.0 * *share) : std::nullopt, 3);
    };
    front.add({{"caster", std::string(model.spheroid && oblate ? "spheroid" : "sphere")},
               {"disc", std::string(model.limbDarkened ? "limb-darkened" : "uniform")},
               {"several", std::string(nameOf(model.several))},
               {"evaluations_in_air",
                cell(air ? std::optional(double(model.evaluations == 1 ? 0 : model.evaluations))
                         : std::nullopt,
                     0)},
               {"along_ray", air ? Cell(std::string(model.evaluations == 1 ? "ground's"
                                                    : model.splitAtUmbra   ? "beyond umbra"
                                                                           : "whole"))
                                 : Cell()},
               {"time_ns", cell(one * evaluations, 0)},
               {"error_percent", cell(100.0 * std::max(ground, inAir.value_or(0.0)), 3)},
               {"surface_error_percent", percent(ground)},
               {"surface_mean_error_percent", percent(mean)},
               {"air_error_percent", percent(inAir)},
               {"air_mean_error_percent", percent(meanAir)},
               {"half_light_edge_error_km", cell(half, 3)},
               {"umbra_edge_error_km", cell(umbra, 3)}});
    progress.finished(name);
  }
  writeTextFile(o.output, front.text(o.format));
}

}  // namespace

void addTradeShadows(CLI::App& trade) {
  auto const o = std::make_shared<Options>();
  auto* command = trade.add_subcommand(
      "shadows", "Simpler shadows against rays to the Sun: light, edges in km, and time");
  command->add_option("scene", o->scene,
                      "Scene whose shadows are measured (default: the shadows of Callisto and Io "
                      "overlapping on Jupiter)");
  command->add_option("--time", o->overrides.time, "Instant instead of the scene's");
  command->add_option("--points", o->points, "Places in each receiver's shadows (default 300)");
  command->add_option("--format", o->format, "table, csv or json");
  command->add_option("-o,--output", o->output, "File instead of standard output");
  command->footer(
      "Knobs: casters as spheroids or as spheres of their equators; a limb-darkened or a uniform\n"
      "Sun; several casters by the union of their discs, the least of their lights or the "
      "product;\n"
      "in air one light a pixel, the ground's (0 evaluations), or several along the ray, over the\n"
      "whole of it or its part beyond the umbra. Errors in percent of sunlight (in air, of what\n"
      "the ray scatters once in the shadow), largest unless mean; edges where half and a "
      "hundredth\n"
      "of the light is left.\n"
      "Example:\n  antumbra trade shadows configs/scenes/lunar_eclipse.toml \\\n"
      "      --time 2028-12-31T15:50Z --format json -o s.json\n"
      "  tools/plot s.json -o s.svg --x time_ns --y error_percent --label several --group caster");
  command->callback([o] { run(*o); });
}

}  // namespace antumbra
