// `antumbra render`: a scene to pictures, without any display.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>

#include "app/commands.h"
#include "app/luminance_track.h"
#include "app/scene_session.h"
#include "document/document.h"
#include "document/paths.h"
#include "gl/context.h"
#include "output/image_file.h"
#include "picture/picture_renderer.h"
#include "plan/explanation.h"

namespace antumbra {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> outputs;
  SceneOverrides overrides;
  std::string frames;
  bool explain = false;
};

std::atomic<bool> interrupted = false;
void onInterrupt(int) { interrupted = true; }

// "A:B" with both ends drawn, or one number.
std::pair<int, int> frameRange(const std::string& text, int count) {
  if (text.empty()) return {0, count - 1};
  auto const colon = text.find(':');
  long const first = parseInteger(text.substr(0, colon), "--frames");
  long const last =
      colon == std::string::npos ? first : parseInteger(text.substr(colon + 1), "--frames");
  if (first < 0 || last < first || last >= count)
    throw InputError(
        fmt::format("--frames: found \"{}\"; allowed: FIRST:LAST within 0:{}", text, count - 1));
  return {static_cast<int>(first), static_cast<int>(last)};
}

// Puts the frame's number where the name has a "%d" or "%0Nd".
std::string fileOfFrame(const std::string& pattern, int frame) {
  auto const start = pattern.find('%');
  if (start == std::string::npos) return pattern;
  auto const end = pattern.find('d', start);
  std::string const width =
      end == std::string::npos ? "?" : pattern.substr(start + 1, end - start - 1);
  if (width.size() > 3 || width.find_first_not_of("0123456789") != std::string::npos)
    throw InputError(fmt::format(
        "-o: found \"{}\"; allowed: a name with at most one %d or %0Nd for the frame's number",
        pattern));
  int const digits = width.empty() ? 1 : static_cast<int>(parseInteger(width, "-o"));
  std::string const rest = pattern.substr(end + 1);
  if (rest.find('%') != std::string::npos)
    throw InputError(fmt::format("-o: found \"{}\"; allowed: at most one %d or %0Nd", pattern));
  return pattern.substr(0, start) + fmt::format("{:0{}}", frame, digits) + rest;
}

// "dome.png" to "dome_ev+2.png" for a bracket of two stops more.
std::filesystem::path fileOfBracket(const std::filesystem::path& file, double stops) {
  return file.parent_path() /
         fmt::format("{}_ev{:+g}{}", file.stem().string(), stops, file.extension().string());
}

void writeAll(const std::vector<std::string>& outputs, int frame, const FinishedPicture& picture,
              const std::vector<double>& bracketsStops, const Metadata& metadata) {
  for (auto const& pattern : outputs) {
    std::filesystem::path const file = fileOfFrame(pattern, frame);
    if (file.extension() != ".png") {
      writeExr(file, picture.width, picture.height, picture.linear, metadata);
      continue;
    }
    writePng(file, picture.width, picture.height, picture.srgb, metadata);
    for (std::size_t i = 0; i < picture.brackets.size(); ++i)
      writePng(fileOfBracket(file, bracketsStops[i]), picture.width, picture.height,
               picture.brackets[i], metadata);
  }
}

void render(const Options& options) {
  SceneSession const session(options.scene, options.overrides);
  auto const [first, last] = frameRange(options.frames, session.scene().frames);
  if (options.explain) fmt::print("{}", explain(session.at(first).plan));
  if (options.outputs.empty()) {
    if (options.explain) return;
    throw InputError("-o: missing; a picture file (.png or .exr) or --explain is required");
  }
  for (auto const& pattern : options.outputs) {
    if (std::count(options.outputs.begin(), options.outputs.end(), pattern) > 1)
      throw InputError(fmt::format("-o: found \"{}\" twice; allowed: each file once", pattern));
    checkOutputFile(fileOfFrame(pattern, first), "-o");
    if (last > first && fileOfFrame(pattern, first) == fileOfFrame(pattern, last))
      throw InputError(fmt::format(
          "-o: found \"{}\" for {} frames; allowed: a name with %d or %0Nd, as picture_%02d.png",
          pattern, last - first + 1));
  }

  gl::HeadlessContext const context;
  gl::prepareContext();
  ImageSource const images = [](const std::string& file, const std::string& where) {
    return readImage(catalogsFolder() / file, where);
  };
  PictureRenderer renderer(images);
  std::optional<LuminanceTrack> track;
  if (session.scene().display.eye) track.emplace(session, images);
  std::signal(SIGINT, onInterrupt);
  for (int frame = first; frame <= last; ++frame) {
    auto const start = std::chrono::steady_clock::now();
    auto const moment = session.at(frame);
    std::optional<EyeState> eye;
    if (track) eye = track->eyeAtFrame(frame);
    FinishedPicture const picture =
        renderer.finish(moment.scene, moment.placed, moment.plan, eye ? &*eye : nullptr);
    writeAll(options.outputs, frame, picture, session.scene().display.bracketsStops,
             session.metadata(moment));
    std::chrono::duration<double> const took = std::chrono::steady_clock::now() - start;
    fmt::print("{}{} {:.2f} s\n",
               last > first ? fmt::format("[{}/{}] ", frame - first + 1, last - first + 1) : "",
               fileOfFrame(options.outputs.front(), frame), took.count());
    std::fflush(stdout);
    if (interrupted)
      throw std::runtime_error(
          fmt::format("interrupted after frame {} of {}; finished frames stay", frame, last));
  }
}

}  // namespace

void addRenderCommand(CLI::App& program) {
  auto const options = std::make_shared<Options>();
  auto* command =
      program.add_subcommand("render", "Render a scene to PNG or EXR, without a display");
  command->add_option("scene", options->scene, "Scene file, as configs/scenes/luxor_dome.toml")
      ->required();
  command->add_option("-o,--output", options->outputs,
                      "Picture file, .png (sRGB) or .exr (absolute luminance); may be given twice; "
                      "%02d takes the frame's number; each of a scene's brackets makes a PNG of "
                      "its own, as dome_ev+2.png");
  command->add_option("--time", options->overrides.time,
                      "Instant instead of the scene's: 2027-08-02T10:05:06Z, or a contact, as "
                      "\"C2 2027-08-02 @25.687,32.640\"");
  command->add_option("--size", options->overrides.size, "WIDTHxHEIGHT, as 2048x2048");
  command->add_option("--projection", options->overrides.projection,
                      "perspective, fisheye or equirectangular");
  command->add_option("--quality", options->overrides.quality,
                      "draft, balanced, accurate or reference");
  command->add_option("--look", options->overrides.look, "natural or illustrative");
  command->add_option("--delta-t", options->overrides.deltaT,
                      "TT - UT1 in seconds instead of the table's");
  command->add_option("--frames", options->frames, "FIRST:LAST of an animation, both drawn");
  command->add_flag("--explain", options->explain,
                    "Print what the picture needs and why; with no -o, print only that");
  command->footer(
      "Example:\n  antumbra render configs/scenes/luxor_dome.toml -o dome.png -o dome.exr");
  command->callback([options] { render(*options); });
}

}  // namespace antumbra
