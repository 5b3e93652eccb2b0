// `antumbra trade sky SCENE`: the knobs of the air, their error against the reference path tracer
// and their cost.
//
// Each point draws the scene's air by the programs of `render` (time of the sky table and of the
// body with its air; tables' memory and time to compute) and asks the same programs for the light
// of fixed directions of the picture (passes/sky_sampler.h; the ground has the medium's albedo).
// First every knob alone is turned about a base, then all together to their cheapest values whose
// errors alone stay within a margin of the base's.
#include <fmt/format.h>

#include <map>
#include <set>

#include "app/commands.h"
#include "app/draw_timing.h"
#include "app/processor_clock.h"
#include "app/trade_front.h"
#include "app/trade_sky_knobs.h"
#include "app/trade_sky_view.h"
#include "document/document.h"
#include "document/paths.h"
#include "document/text_output.h"
#include "gl/buffer.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "gl/view_block.h"
#include "output/image_file.h"
#include "passes/air_tables.h"
#include "passes/bodies.h"
#include "passes/sky_sampler.h"

namespace antumbra {
namespace {

// Costs within this share of each other count as equal: times repeat no better.
constexpr double kCostTolerance = 0.05;
// Errors alone within these of the base's, percent, for the knobs turned together.
constexpr double kMargins[] = {0.02, 0.05, 0.1, 0.2, 0.5, 1.0};

struct Options {
  std::string scene, base = "balanced", format = "table", output = "-", error = "1.5%", reference;
  std::vector<std::string> presets{"draft", "balanced", "accurate"};
  std::vector<std::string> knobs{"all"};
  SceneOverrides overrides;
  long directions = 24, repeats = 7;
  bool processorTime = false;
};

struct Cost {
  double fillUnits, milliseconds, precomputeSeconds, mebibytes;
};

struct Point {
  std::string name;
  AirQuality quality;
};

struct Measured {
  Point point;
  SkyError error;
  Cost cost;
};

// Draws and samples the view at any quality.
class AirMeter {
 public:
  AirMeter(const AirView& view, const Options& options)
      : view_(view),
        repeats_(static_cast<int>(options.repeats)),
        clock_(options.processorTime ? DrawClock::Processor : DrawClock::Wall),
        target_(gl::Texture::plane(GL_RGBA32F, view.picture.width, view.picture.height)),
        framebuffer_({&target_}) {
    viewBlock_.write(gl::viewBlockOf(view.picture));
  }

  Measured measure(const Point& point, const ReferenceSky& reference) {
    BodiesPass bodies(
        [this](const std::string& file, const std::string& where) {
          auto& image = images_[file];
          if (image.texels.empty()) image = readImage(catalogsFolder() / file, where);
          return image;
        },
        point.quality);
    Measured m{point, {}, {}};
    PlannedBody plain = view_.body;  // maps are no part of the time to compute tables
    plain.map = plain.waterMask = plain.nightMap = "";
    double const before = processorSeconds();
    bodies.prepare(plain, view_.picture, {});
    m.cost.precomputeSeconds = processorSeconds() - before;
    bodies.prepare(view_.body, view_.picture, {});
    if (clock_ == DrawClock::Wall) {
      m.cost.precomputeSeconds = 0.0;
      for (auto const& [name, seconds] : bodies.precomputeSeconds())
        m.cost.precomputeSeconds += seconds;
    }
    std::size_t bytes = 0;
    for (auto const& [name, count] : bodies.residentBytes())
      if (!name.starts_with("map ")) bytes += count;
    m.cost.mebibytes = static_cast<double>(bytes) / 1048576.0;

    double const unit = fillUnitSeconds(view_.picture.width, view_.picture.height, clock_);
    double seconds = 0.0;
    if (bodies.repeatSky(view_.body))
      seconds += medianSeconds([&] { bodies.repeatSky(view_.body); }, repeats_, clock_);
    seconds += medianSeconds(
        [&] {
          framebuffer_.bind();
          viewBlock_.bindUniform(0);
          bodies.draw(view_.body, view_.picture, {0, 0},
                      {view_.picture.width, view_.picture.height});
        },
        repeats_, clock_);
    m.cost.milliseconds = 1e3 * seconds;
    m.cost.fillUnits = seconds / unit;

    const AirTables* const tables = bodies.airOf(view_.body);
    SkySampler sampler(view_.question.medium, *tables);
    SkyRequest request;
    request.altitude = Length(view_.question.camera.m.z) - view_.question.medium.radius;
    request.sunZenith = view_.sunZenith;
    request.sunRadius = view_.question.sun.discRadius;
    for (auto const& d : view_.question.directions)
      request.directions.push_back(
          {arcTangent(std::hypot(d.u.x, d.u.y), d.u.z), arcTangent(d.u.y, d.u.x)});
    m.error =
        errorAgainst(reference, coloursOf(view_, tables->wavelengths(), sampler.sample(request)));
    return m;
  }

 private:
  const AirView& view_;
  int repeats_;
  DrawClock clock_;
  std::map<std::string, DecodedImage> images_;
  gl::Texture target_;
  gl::Framebuffer framebuffer_;
  gl::Buffer viewBlock_;
};

RowTable::Row rowOf(const Measured& m, const AirView& view) {
  auto const& u = view.question.directions[m.error.worstDirection].u;
  return {{"point", m.point.name},
          {"luminance_error_percent", cell(100.0 * m.error.luminance, 3)},
          {"worst_percent", cell(100.0 * m.error.worst, 2)},
          {"worst_view_zenith_deg", cell(arcTangent(std::hypot(u.x, u.y), u.z) / degree, 2)},
          {"worst_rel_azimuth_deg", cell(arcTangent(u.y, u.x) / degree, 1)},
          {"delta_e2000", cell(m.error.deltaE, 3)},
          {"worst_delta_e2000", cell(m.error.worstDeltaE, 3)},
          {"fill_units", cell(m.cost.fillUnits, 3)},
          {"draw_ms", cell(m.cost.milliseconds, 2)},
          {"precompute_s", cell(m.cost.precomputeSeconds, 3)},
          {"memory_mib", cell(m.cost.mebibytes, 2)}};
}

std::vector<AirKnob> chosenKnobs(const Options& o, const AirView& view) {
  std::set<std::string> wanted(o.knobs.begin(), o.knobs.end());
  bool const all = wanted.contains("all");
  std::string known = "all, none";
  std::vector<AirKnob> knobs;
  bool const low = view.question.camera.m.z - view.question.medium.radius.si <
                   0.2 * view.question.medium.topHeight.si;
  for (auto const& knob : airKnobs()) {
    known += ", " + knob.name;
    // What this camera's programs do not read.
    bool const idle = low ? knob.name == "view_samples" || knob.name == "ground_samples"
                          : knob.name == "sky_samples" || knob.name == "sky";
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
      if (found == alone.end() || 100.0 * found->error.luminance > baseError + margin) continue;
      setting.set(point.quality);
      if (!(only == base)) point.name += (point.name.empty() ? "" : "; ") + setting.text;
      break;
    }
  return point;
}

double errorOption(const std::string& text) {
  std::string number = text;
  bool const percent = !number.empty() && number.back() == '%';
  if (percent) number.pop_back();
  double const error = parseNumber(number, "--stderr") * (percent ? 0.01 : 1.0);
  if (!(error >= 1e-4 && error <= 0.2))
    throw InputError(fmt::format("--stderr: found {}; allowed: 0.01% to 20%", text));
  return error;
}

void run(const Options& o) {
  requireTradeOutput(o.format, o.output);
  if (o.directions < 4 || o.directions > 4096)
    throw InputError(fmt::format("--directions: found {}; allowed: 4 to 4096", o.directions));
  if (o.repeats < 7 || o.repeats > 1000)
    throw InputError(fmt::format("--repeat: found {}; allowed: 7 to 1000", o.repeats));
  SceneSession const session(o.scene, o.overrides);
  auto const moment = session.at(0);
  AirView view = airViewOf(moment, static_cast<std::size_t>(o.directions));
  view.question.tracing.relativeError = errorOption(o.error);
  std::vector<Point> points;
  for (auto const& preset : o.presets) {
    if (preset == "none") continue;
    if (!std::filesystem::exists(configsFolder() / "quality" / (preset + ".toml")))
      throw InputError(fmt::format(
          "--presets: found \"{}\"; allowed: none, or names of configs/quality", preset));
    points.push_back({preset, AirQuality::preset(preset)});
  }
  if (!std::filesystem::exists(configsFolder() / "quality" / (o.base + ".toml")))
    throw InputError(
        fmt::format("--base: found \"{}\"; allowed: names of configs/quality", o.base));
  AirQuality const base = AirQuality::preset(o.base);
  auto const has = [&](const AirQuality& q) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Point& p) { return p.quality == q; });
  };
  if (!has(base)) points.push_back({o.base, base});
  auto const knobs = chosenKnobs(o, view);
  for (auto const& knob : knobs)
    for (auto const& setting : knob.settings) {
      Point point{setting.text, base};
      setting.set(point.quality);
      if (!has(point.quality)) points.push_back(point);
    }
  bool const combine = knobs.size() > 1;

  gl::HeadlessContext const context;
  gl::prepareContext();
  auto const device = gl::describeDevice();
  TradeProgress progress("trade sky", points.size() + 1 + (combine ? std::size(kMargins) : 0));
  ReferenceSky const reference = referenceSky(view, o.reference, [&](double share) {
    if (TradeProgress::interrupted())
      throw std::runtime_error("interrupted before the reference was known; nothing is written");
    progress.at("reference", std::min(share, 1.0));
  });
  double const noise = 100.0 * reference.meanRelativeError();
  progress.finished(fmt::format("reference, standard error {:.2f} %", noise));

  AirMeter meter(view, o);
  std::vector<Measured> measured;
  auto const walk = [&](const Point& point) {
    if (TradeProgress::interrupted()) return false;
    progress.at(point.name, 0.0);
    measured.push_back(meter.measure(point, reference));
    progress.finished(point.name);
    return true;
  };
  bool complete = true;
  for (auto const& point : points) complete = complete && walk(point);
  if (combine && complete) {
    auto const own = std::find_if(measured.begin(), measured.end(),
                                  [&](const Measured& m) { return m.point.quality == base; });
    double const baseError = 100.0 * own->error.luminance;
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
  front.alsoCost("precompute_s");
  front.alsoCost("memory_mib");
  // The mean over directions that the reference knows is itself uncertain by this much.
  front.tolerate(kCostTolerance, noise / std::sqrt(static_cast<double>(o.directions)));
  front.note("scene", o.scene);
  front.note("device", device.renderer);
  front.note("picture", fmt::format("{}x{}", view.picture.width, view.picture.height));
  front.note("view", fmt::format("{}, camera {:.6g} km above the ground, Sun {:.2f} deg from the "
                                 "zenith",
                                 view.body.atmosphere, view.body.cameraHeight / kilometre,
                                 view.sunZenith / degree));
  front.note("reference",
             fmt::format("Monte Carlo path tracer, {} directions at {} wavelengths, standard error "
                         "of a luminance {:.2f} % in the mean",
                         view.question.directions.size(), view.question.wavelengths.size(), noise));
  front.note("base", o.base);
  front.note("times", o.processorTime
                          ? "processor time of all threads, tables with the compilation "
                            "of their programs"
                          : "wall clock");
  for (auto const& m : measured) front.add(rowOf(m, view));
  if (!complete) front.markIncomplete();
  writeTextFile(o.output, front.text(o.format));
}

}  // namespace

void addTradeSky(CLI::App& trade) {
  auto const o = std::make_shared<Options>();
  auto* command = trade.add_subcommand(
      "sky", "Knobs of the air: error against the reference path tracer, time, memory");
  command->add_option("scene", o->scene, "Scene file, as configs/scenes/day_sky.toml")->required();
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
      "Control-C ends the walk with the points it has.\n"
      "Example:\n  antumbra trade sky configs/scenes/day_sky.toml --format json -o sky.json\n"
      "  tools/plot sky.json -o sky.svg --x fill_units --y luminance_error_percent --label point");
  command->callback([o] { run(*o); });
}

}  // namespace antumbra
