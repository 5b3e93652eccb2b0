// `antumbra view`: a scene in a window, with the mouse to look around and the keys to move in time.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <chrono>

#include "app/commands.h"
#include "app/scene_session.h"
#include "app/view_controls.h"
#include "document/paths.h"
#include "gl/context.h"
#include "output/image_file.h"
#include "output/window.h"
#include "picture/picture_renderer.h"

namespace antumbra {
namespace {

struct Options {
  std::string scene;
  SceneOverrides overrides;
  int quitAfter = 0;
};

// The horizontal direction in which the camera looks.
std::pair<Angle, Angle> lookOf(const PlacedScene& placed) {
  auto const forward =
      (placed.enuFromIcrs * placed.cameraFromIcrs.inverse())(Direction<CameraAxes>{{0, 0, -1}});
  return {Angle(std::atan2(forward.u.x, forward.u.y)),
          Angle(std::atan2(forward.u.z, std::hypot(forward.u.x, forward.u.y)))};
}

void view(const Options& options) {
  SceneSession session(options.scene, options.overrides);
  ViewControls controls(session.scene());
  Window window("antumbra", session.scene().picture.width, session.scene().picture.height);
  gl::prepareContext();
  PictureRenderer renderer(
      [](const std::string& file, const std::string& where) {
        return readImage(catalogsFolder() / file, where);
      },
      PictureRenderer::Mode::Live);
  controls.resize(window.width(), window.height());
  auto moment = session.at(controls.scene(), controls.timeOffset());

  window.listen({
      .onKey =
          [&](int key) {
            switch (key) {
              case GLFW_KEY_SPACE:
                controls.togglePause();
                break;
              case GLFW_KEY_COMMA:
                controls.step(-1);
                break;
              case GLFW_KEY_PERIOD:
                controls.step(+1);
                break;
              case GLFW_KEY_LEFT_BRACKET:
                controls.changeRate(-1);
                break;
              case GLFW_KEY_RIGHT_BRACKET:
                controls.changeRate(+1);
                break;
              case GLFW_KEY_ESCAPE:
              case GLFW_KEY_Q:
                window.close();
                break;
              default:
                break;
            }
          },
      .onDrag =
          [&](double dx, double dy) {
            if (!moment.scene.camera.target.empty()) {
              auto const [azimuth, altitude] = lookOf(moment.placed);
              controls.lookFrom(azimuth, altitude);
            }
            controls.drag(dx, dy);
          },
      .onWheel = [&](double steps) { controls.zoom(steps); },
      .onResize = [&](int width, int height) { controls.resize(width, height); },
  });

  auto last = std::chrono::steady_clock::now();
  for (int frame = 0; window.open(); ++frame) {
    if (options.quitAfter && frame >= options.quitAfter) window.close();
    auto const now = std::chrono::steady_clock::now();
    Duration const passed(std::chrono::duration<double>(now - last).count());
    last = now;
    controls.advance(passed);
    session.follow(controls.timeOffset(), controls.paused() ? 0.0 : controls.rate());
    moment = session.at(controls.scene(), controls.timeOffset());
    renderer.show(moment.scene, moment.placed, moment.plan, 0, passed);
    window.setTitle(fmt::format("{}  {}  {}", moment.scene.title,
                                formatIso(moment.placed.when, TimeScale::Utc, session.deltaT(), 0),
                                controls.status()));
    window.showAndPoll();
  }
  fmt::print("last instant {} {}\n",
             formatIso(moment.placed.when, TimeScale::Utc, session.deltaT(), 0), controls.status());
}

}  // namespace

void addViewCommand(CLI::App& program) {
  auto const options = std::make_shared<Options>();
  auto* command = program.add_subcommand("view", "Open a scene in a window");
  command->add_option("scene", options->scene, "Scene file, as configs/scenes/from_space.toml")
      ->required();
  command->add_option("--time", options->overrides.time, "Instant instead of the scene's");
  command->add_option("--size", options->overrides.size, "WIDTHxHEIGHT of the window");
  command->add_option("--projection", options->overrides.projection,
                      "perspective, fisheye or equirectangular");
  command->add_option("--quality", options->overrides.quality,
                      "draft, balanced, accurate or reference");
  command->add_option("--look", options->overrides.look, "natural or illustrative");
  command->add_option("--quit-after", options->quitAfter, "Close after so many frames (0: never)")
      ->check(CLI::NonNegativeNumber);
  command->footer(
      "Mouse: drag to look, wheel to zoom. Keys: space runs and pauses; , and . step back and\n"
      "forward; [ and ] slow down and speed up (through zero to backwards); q quits.\n"
      "Example:\n  antumbra view configs/scenes/from_space.toml");
  command->callback([options] { view(*options); });
}

}  // namespace antumbra
