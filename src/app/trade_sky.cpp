// `antumbra trade sky SCENE...`: the knobs of the air, their error against the reference path
// tracer and their cost.
//
// Each point draws the air of each scene by the programs of `render` (time of the sky table and of
// the body with its air; tables' memory and time to compute) and asks the same programs for the
// light of fixed directions of the picture (passes/sky_sampler.h; the ground has the medium's
// albedo). Errors and times of several scenes are averaged. Measured are the presets; every knob
// alone, turned about a base; all together at their cheapest values whose errors alone stay within
// a margin of the base's; and every other preset with one knob a step lower, the only neighbours
// that could beat it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/commands.h"
#include "app/error_option.h"
#include "app/trade_front.h"
#include "app/trade_sky_knobs.h"
#include "app/trade_sky_meter.h"
#include "document/document.h"
#include "document/paths.h"
#include "document/text_output.h"
#include "gl/context.h"

namespace antumbra {
namespace {

// Costs within this share of each other count as equal: times repeat no better.
constexpr double kCostTolerance = 0.05;
// Errors alone within these of the base's, percent, for the knobs turned together.
constexpr double kMargins[] = {0.02, 0.05, 0.1, 0.2, 0.5, 1.0};

struct Options {
  std::vector<std::string> scenes;
  std::string base = "balanced", format = "table", output = "-", error = "1.5%", reference;
  std::vector<std::string> presets{"draft", "balanced", "accurate"};
  std::vector<std::string> knobs{"all"};
  SceneOverrides overrides;
  long directions = 24, repeats = 7;
  bool processorTime = false;
};

struct Point {
  std::string name;
  AirQuality quality;
};

struct Measured {
  Point point;
  std::vector<AirMeasurement> views;
  AirMeasurement all;
};

std::string stemOf(const AirView& view) { return std::filesystem::path(view.scene).stem(); }

RowTable::Row rowOf(const Measured& m, const std::vector<AirView>& views) {
  auto const& e = m.all.error;
  auto const worst = std::find_if(m.views.begin(), m.views.end(), [&](const AirMeasurement& v) {
    return v.error.worst == e.worst;
  });
  auto const& view = views[static_cast<std::size_t>(worst - m.views.begin())];
  auto const look = skyDirectionOf(view.question.directions[worst->error.worstDirection]);
  RowTable::Row row{{"point", m.point.name},
                    {"luminance_error_percent", cell(100.0 * e.luminance, 3)},
                    {"worst_percent", cell(100.0 * e.worst, 2)},
                    {"worst_view_zenith_deg", cell(look.viewZenith / degree, 2)},
                    {"worst_rel_azimuth_deg", cell(look.relativeAzimuth / degree, 1)},
                    {"delta_e2000", cell(e.deltaE, 3)},
                    {"worst_delta_e2000", cell(e.worstDeltaE, 3)},
                    {"scale_error_percent", cell(100.0 * m.all.scale.luminance, 4)},
                    {"scale_worst_percent", cell(100.0 * m.all.scale.worst, 3)},
                    {"scale_worst_delta_e2000", cell(m.all.scale.worstDeltaE, 3)},
                    {"fill_units", cell(m.all.cost.fillUnits, 3)},
                    {"draw_ms", cell(m.all.cost.milliseconds, 2)},
                    {"precompute_s", cell(m.all.cost.precomputeSeconds, 3)},
                    {"memory_mib", cell(m.all.cost.mebibytes, 2)}};
  if (views.size() > 1) {
    row.insert(row.begin() + 3, {"worst_scene", stemOf(view)});
    for (std::size_t i = 0; i < views.size(); ++i) {
      row.emplace_back(stemOf(views[i]) + "_error_percent",
                       cell(100.0 * m.views[i].error.luminance, 3));
      row.emplace_back(stemOf(views[i]) + "_fill_units", cell(m.views[i].cost.fillUnits, 3));
    }
  }
  return row;
}

std::vector<AirKnob> chosenKnobs(const Options& o, const std::vector<AirView>& views) {
  std::set<std::string> wanted(o.knobs.begin(), o.knobs.end());
  bool const all = wanted.contains("all");
  std::string known = "all, none";
  std::vector<AirKnob> knobs;
  auto const isLow = [](const AirView& view) {
    return view.question.camera.m.z - view.question.medium.radius.si <
           0.2 * view.question.medium.topHeight.si;
  };
  bool const anyLow = std::any_of(views.begin(), views.end(), isLow);
  bool const allLow = std::all_of(views.begin(), views.end(), isLow);
  for (auto const& knob : airKnobs()) {
    known += ", " + knob.name;
    // What these cameras' programs do not read.
    bool const idle = knob.name == "view_samples" || knob.name == "ground_samples" ? allLow
                      : knob.name == "sky_samples" || knob.name == "sky"           ? !anyLow
                                                                                   : false;
    if (wanted.erase(knob.name) || (all && !idle)) knobs.push_back(knob);
  }
  wanted.erase("all");
  wanted.erase("none");
  if (!wanted.empty())
    throw InputError(fmt::format("--knobs: found \"{}\"; allowed: {}", *wanted.begin(), known));
  return knobs;
}

// The knobs' cheapest settings that alone err within `margin` of the base.
Point together(const std::vector<AirKnob>& knobs, const std::vector<Measured>& alone,
               const AirQuality& base, double baseError, double margin) {
  Point point{"", base};
  for (auto const& knob : knobs)
    for (auto const& setting : knob.settings) {
      AirQuality only = base;
      setting.set(only);
      auto const found = std::find_if(alone.begin(), alone.end(),
                                      [&](const Measured& m) { return m.point.quality == only; });
      if (found == alone.end() || 100.0 * found->all.error.luminance > baseError + margin) continue;
      setting.set(point.quality);
      if (!(only == base)) point.name += (point.name.empty() ? "" : "; ") + setting.text;
      break;
    }
  return point;
}

// One knob each a step below a point's.
std::vector<Point> stepsDown(const std::vector<AirKnob>& knobs, const Point& from) {
  std::vector<Point> points;
  for (auto const& knob : knobs) {
    const KnobSetting* next = nullptr;
    for (auto const& setting : knob.settings)
      if (setting.size < knob.size(from.quality)) next = &setting;
    if (!next) continue;
    points.push_back({from.name + "; " + next->text, from.quality});
    next->set(points.back().quality);
  }
  return points;
}

// A preset's knobs as its file has them, for whoever reads the numbers later.
std::string settingsOf(const std::string& preset) {
  std::ifstream in(configsFolder() / "quality" / (preset + ".toml"));
  std::string line, all;
  while (std::getline(in, line))
    if (line.find(" = ") != std::string::npos && !line.starts_with('#') &&
        !line.starts_with("eclipse"))
      all += (all.empty() ? "" : "; ") + line;
  return all;
}

void requirePreset(const std::string& name, const std::string& option,
                   const std::string& otherwise) {
  if (name.find('/') != std::string::npos ||
      !std::filesystem::exists(configsFolder() / "quality" / (name + ".toml")))
    throw InputError(fmt::format("{}: found \"{}\"; allowed: {}names of configs/quality", option,
                                 name, otherwise));
}

void run(const Options& o) {
  requireTradeOutput(o.format, o.output);
  if (o.directions < 4 || o.directions > 4096)
    throw InputError(fmt::format("--directions: found {}; allowed: 4 to 4096", o.directions));
  if (o.repeats < 7 || o.repeats > 1000)
    throw InputError(fmt::format("--repeat: found {}; allowed: 7 to 1000", o.repeats));
  std::vector<AirView> views;
  double const relativeError = errorOption(o.error, 1e-4, 0.2);
  for (auto const& scene : o.scenes) {
    SceneSession const session(scene, o.overrides);
    views.push_back(airViewOf(session.at(0), static_cast<std::size_t>(o.directions)));
    views.back().question.tracing.relativeError = relativeError;
    for (std::size_t i = 0; i + 1 < views.size(); ++i)
      if (stemOf(views[i]) == stemOf(views.back()))
        throw InputError(fmt::format("{}: found a second scene called {}; allowed: different names",
                                     scene, stemOf(views[i])));
  }
  std::vector<Point> points;
  for (auto const& preset : o.presets) {
    if (preset == "none") continue;
    requirePreset(preset, "--presets", "none, or ");
    points.push_back({preset, AirQuality::preset(preset)});
  }
  requirePreset(o.base, "--base", "");
  AirQuality const base = AirQuality::preset(o.base);
  auto const has = [&](const AirQuality& q) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Point& p) { return p.quality == q; });
  };
  if (!has(base)) points.push_back({o.base, base});
  std::vector<Point> const presets = points;
  auto const knobs = chosenKnobs(o, views);
  for (auto const& knob : knobs)
    for (auto const& setting : knob.settings) {
      Point point{setting.text, base};
      setting.set(point.quality);
      if (!has(point.quality)) points.push_back(point);
    }
  for (auto const& preset : presets)
    if (!(preset.quality == base))
      for (auto const& step : stepsDown(knobs, preset))
        if (!has(step.quality)) points.push_back(step);
  bool const combine = knobs.size() > 1;

  gl::HeadlessContext const context;
  gl::prepareContext();
  auto const device = gl::describeDevice();
  TradeProgress progress("trade sky", points.size() + 1 + (combine ? std::size(kMargins) : 0));
  auto const references = referenceSkies(views, o.reference, [&](std::size_t view, double share) {
    if (TradeProgress::interrupted())
      throw std::runtime_error("interrupted before the reference was known; nothing is written");
    progress.at("reference of " + stemOf(views[view]),
                (static_cast<double>(view) + share) / static_cast<double>(views.size()));
  });
  double noise = 0.0;
  for (auto const& reference : references)
    noise += 100.0 * reference.meanRelativeError() / static_cast<double>(references.size());
  progress.finished(fmt::format("reference, standard error {:.2f} %", noise));

  AirMeter meter(views, references, static_cast<int>(o.repeats),
                 o.processorTime ? DrawClock::Processor : DrawClock::Wall);
  std::vector<Measured> measured;
  auto const walk = [&](const Point& point) {
    if (TradeProgress::interrupted()) return false;
    progress.at(point.name, 0.0);
    auto const of = meter.measure(point.quality);
    measured.push_back({point, of, overall(of)});
    progress.finished(point.name);
    return true;
  };
  bool complete = true;
  for (auto const& point : points) complete = complete && walk(point);
  if (combine && complete) {
    auto const own = std::find_if(measured.begin(), measured.end(),
                                  [&](const Measured& m) { return m.point.quality == base; });
    double const baseError = 100.0 * own->all.error.luminance;
    std::vector<Measured> const alone = measured;
    for (double margin : kMargins) {
      Point const point = together(knobs, alone, base, baseError, margin);
      bool const known = std::any_of(measured.begin(), measured.end(), [&](const Measured& m) {
        return m.point.quality == point.quality;
      });
      if (known)
        progress.finished("nothing new");
      else
        complete = complete && walk(point);
    }
  }

  TradeFront front("sky", "fill_units", "luminance_error_percent", noise);
  front.alsoCost("delta_e2000");
  front.alsoCost("precompute_s");
  front.alsoCost("memory_mib");
  // The mean over directions that the reference knows is itself uncertain by this much.
  front.tolerate(kCostTolerance,
                 noise / std::sqrt(static_cast<double>(o.directions * std::ssize(views))));
  front.note("scene", fmt::format("{}", fmt::join(o.scenes, " ")));
  front.note("device", device.renderer);
  for (auto const& view : views)
    front.note("view " + stemOf(view),
               fmt::format("{}x{}, {}, camera {:.6g} km above the ground, Sun {:.2f} deg from the "
                           "zenith",
                           view.picture.width, view.picture.height, view.body.atmosphere,
                           view.body.cameraHeight / kilometre, view.sunZenith / degree));
  front.note("reference",
             fmt::format(
                 "Monte Carlo path tracer, {} directions a scene at {} wavelengths, standard error "
                 "of a luminance {:.2f} % in the mean",
                 o.directions, views.front().question.wavelengths.size(), noise));
  front.note("base", o.base);
  for (auto const& preset : presets) front.note("preset " + preset.name, settingsOf(preset.name));
  front.note("times", o.processorTime
                          ? "processor time of all threads, tables with the compilation "
                            "of their programs"
                          : "wall clock");
  for (auto const& m : measured) front.add(rowOf(m, views));
  if (!complete) front.markIncomplete();
  writeTextFile(o.output, front.text(o.format));
}

}  // namespace

void addTradeSky(CLI::App& trade) {
  auto const o = std::make_shared<Options>();
  auto* command = trade.add_subcommand(
      "sky", "Knobs of the air: error against the reference path tracer, time, memory");
  command
      ->add_option("scene", o->scenes,
                   "Scene files, as configs/scenes/day_sky.toml; errors and times of several are "
                   "averaged")
      ->required();
  command->add_option("--base", o->base, "Preset about which each knob is turned (balanced)");
  command
      ->add_option("--presets", o->presets,
                   "Presets measured as well, or none (draft,balanced,accurate)")
      ->delimiter(',');
  std::string names;
  for (auto const& knob : airKnobs()) names += ", " + knob.name;
  command->add_option("--knobs", o->knobs, "Knobs to turn: all, none" + names)->delimiter(',');
  command->add_option("--directions", o->directions, "Directions of the picture (24)");
  command->add_option("--stderr", o->error,
                      "Standard error of the reference in each direction and wavelength (1.5%)");
  command->add_option("--reference", o->reference,
                      "File that keeps the reference: read where it exists, else written");
  command->add_option("--size", o->overrides.size, "WIDTHxHEIGHT instead of the scene's");
  command->add_option("--time", o->overrides.time, "Instant instead of the scene's");
  command->add_option("--repeat", o->repeats, "Runs of each drawing, at least 7");
  command->add_flag("--processor-time", o->processorTime,
                    "Time by the processor time of all threads: for a software renderer on a busy "
                    "machine");
  command->add_option("--format", o->format, "table, json or csv");
  command->add_option("-o,--output", o->output, "File instead of standard output");
  command->footer(
      "Errors are those of luminance, mean over directions and scenes, against a Monte Carlo path\n"
      "tracer of all orders; delta_e2000 that of colour; scale_* those of all pixels with "
      "air_scale\n"
      "against a sample for each. Costs: the time of the sky table and of "
      "the\n"
      "body with its air in fill units (README, Times), the time to compute the air's tables, and\n"
      "their memory. A point is on the front unless another is no worse in the error and in every\n"
      "cost and better in one. Control-C ends the walk with the points it has.\n"
      "Example:\n  antumbra trade sky configs/scenes/day_sky.toml --format json -o sky.json\n"
      "  tools/plot sky.json -o sky.svg --x fill_units --y luminance_error_percent --label point");
  command->callback([o] { run(*o); });
}

}  // namespace antumbra
