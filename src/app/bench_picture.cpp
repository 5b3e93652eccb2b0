// `antumbra-bench picture SCENE`: each pass of a picture in fill units and milliseconds, the memory
// of each table and map, and the time to precompute.
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/bench_commands.h"
#include "app/draw_timing.h"
#include "app/scene_session.h"
#include "document/paths.h"
#include "document/text_output.h"
#include "gl/context.h"
#include "picture/picture_renderer.h"

namespace antumbra {
namespace {

struct Options {
  std::vector<std::string> scenes;
  SceneOverrides overrides;
  int repeats = 7;
  bool processorTime = false;
  std::string json;
};

// Maps without a decoder: raw texels that tools/bundle laid beside the catalogue
// (`<file>.raw`: width, height, components as 32-bit integers, then bytes), else a checkered plate
// of 2048x1024, which costs the same to sample.
DecodedImage rawImage(const std::string& file, bool& synthetic) {
  DecodedImage image;
  std::ifstream stream(catalogsFolder() / (file + ".raw"), std::ios::binary);
  std::int32_t head[3] = {};
  if (stream.read(reinterpret_cast<char*>(head), sizeof head)) {
    image.width = head[0];
    image.height = head[1];
    image.components = head[2];
    if (image.width < 1 || image.height < 1 || image.components < 1 || image.components > 4)
      throw InputError(
          fmt::format("{}.raw: found {}x{} with {} components; allowed: what "
                      "tools/bundle writes",
                      file, head[0], head[1], head[2]));
    image.texels.resize(static_cast<std::size_t>(head[0]) * static_cast<std::size_t>(head[1]) *
                        static_cast<std::size_t>(head[2]));
    if (!stream.read(reinterpret_cast<char*>(image.texels.data()),
                     static_cast<std::streamsize>(image.texels.size())))
      throw InputError(fmt::format("{}.raw: shorter than its header says", file));
    return image;
  }
  synthetic = true;
  image = {2048, 1024, 3, std::vector<unsigned char>(2048u * 1024u * 3u)};
  for (std::size_t i = 0; i < image.texels.size(); ++i)
    image.texels[i] = static_cast<unsigned char>(60 + 37 * (i / 96 % 3) + i / 393216 * 20);
  return image;
}

nlohmann::json benchScene(const std::string& file, const Options& options) {
  SceneSession const session(file, options.overrides);
  auto const moment = session.at(0);
  const Projection& picture = moment.scene.picture;
  DrawClock const clock = options.processorTime ? DrawClock::Processor : DrawClock::Wall;
  double const unit = fillUnitSeconds(picture.width, picture.height, clock);

  bool synthetic = false;
  auto const start = std::chrono::steady_clock::now();
  PictureRenderer renderer(
      [&](const std::string& name, const std::string&) { return rawImage(name, synthetic); });
  renderer.finish(moment.scene, moment.placed, moment.plan);
  double const firstPicture =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  nlohmann::json result;
  result["scene"] = file;
  result["width"] = picture.width;
  result["height"] = picture.height;
  result["quality"] = moment.scene.quality;
  result["clock"] = options.processorTime ? "processor" : "wall";
  result["fill_unit_ms"] = unit * 1e3;
  result["maps"] = synthetic ? "synthetic" : "real";
  result["first_picture_ms"] = firstPicture * 1e3;
  fmt::print("{}  {}x{}  {}  fill unit {:.2f} ms{}\n", file, picture.width, picture.height,
             moment.scene.quality, unit * 1e3, synthetic ? "  (synthetic maps)" : "");
  fmt::print("  {:<34} {:>10} {:>10}\n", "pass", "fill units", "ms");
  double total = 0.0;
  renderer.observePasses([&](const std::string& name, const std::function<void()>& draw) {
    double const seconds = medianSeconds(draw, options.repeats, clock);
    total += seconds;
    fmt::print("  {:<34} {:>10.2f} {:>10.2f}\n", name, seconds / unit, seconds * 1e3);
    result["passes"].push_back(
        {{"name", name}, {"fill_units", seconds / unit}, {"ms", seconds * 1e3}});
  });
  renderer.finish(moment.scene, moment.placed, moment.plan);
  fmt::print("  {:<34} {:>10.2f} {:>10.2f}\n", "all passes", total / unit, total * 1e3);
  result["all_passes"] = {{"fill_units", total / unit}, {"ms", total * 1e3}};
  for (auto const& [name, seconds] : renderer.precomputeSeconds()) {
    fmt::print("  precompute {:<23} {:>10} {:>10.1f}\n", name, "", seconds * 1e3);
    result["precompute"].push_back({{"name", name}, {"ms", seconds * 1e3}});
  }
  for (auto const& [name, bytes] : renderer.residentBytes()) {
    fmt::print("  memory {:<40} {:>9.2f} MiB\n", name, static_cast<double>(bytes) / 1048576.0);
    result["memory"].push_back({{"name", name}, {"bytes", bytes}});
  }
  return result;
}

void benchPictures(const Options& options) {
  gl::HeadlessContext const context;
  gl::prepareContext();
  auto const device = gl::describeDevice();
  nlohmann::json all;
  all["device"] = device.renderer;
  all["opengl"] = device.version;
  fmt::print("{}  {}\n", device.renderer, device.version);
  for (auto const& scene : options.scenes) all["scenes"].push_back(benchScene(scene, options));
  if (options.json.empty()) return;
  writeTextFile(options.json, all.dump(2) + "\n");
}

}  // namespace

void addPictureBench(CLI::App& program) {
  auto const options = std::make_shared<Options>();
  auto* command = program.add_subcommand("picture", "Time the passes of scenes");
  command->add_option("scenes", options->scenes, "Scene files")->required();
  command->add_option("--size", options->overrides.size, "WIDTHxHEIGHT instead of the scene's");
  command->add_option("--time", options->overrides.time, "Instant instead of the scene's");
  command->add_option("--quality", options->overrides.quality, "draft, balanced or accurate");
  command->add_option("--repeat", options->repeats, "Runs of each pass, at least 7");
  command->add_flag("--processor-time", options->processorTime,
                    "Time by the processor time of all threads: for a software renderer on a busy "
                    "machine");
  command->add_option("--json", options->json, "Write the figures to this file as well");
  command->footer(
      "Example:\n  antumbra-bench picture configs/scenes/from_space.toml --size 1280x720");
  command->callback([options] { benchPictures(*options); });
}

}  // namespace antumbra
