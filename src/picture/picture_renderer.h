// Draws a planned picture: stars, points and the Sun, then the bodies from far to near, each with
// its air in front of what lies behind it, then the glare, then the tone map.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gl/decoded_image.h"
#include "plan/render_plan.h"
#include "scene/placed_scene.h"
#include "scene/scene.h"
#include "tonemap/eye_adaptation.h"

namespace antumbra {

struct FinishedPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> srgb;  // three components, first row at the top
  std::vector<float> linear;       // cd/m2 in linear sRGB, first row at the top
  double whiteLuminance = 0.0;     // shown as white, cd/m2
  // As `srgb`, at each of the scene's bracketed exposures.
  std::vector<std::vector<std::uint8_t>> brackets;
};

// What was really done, to hold against the plan.
struct PictureCounters {
  int tablesBuilt = 0;
  int occlusionQueries = 0;
  int shadowPairs = 0;  // caster-receiver pairs handed to a shader in the last picture
};

class PictureRenderer {
 public:
  // Off line every picture is a function of its scene and instant alone; live, glare and exposure
  // come from earlier frames, and nothing waits for the device.
  enum class Mode { OffLine, Live };
  PictureRenderer(ImageSource images, Mode mode = Mode::OffLine);
  ~PictureRenderer();

  // Whole picture to memory, in tiles where the device is smaller. Throws InputError beyond 2^28
  // pixels, and for files that cannot be read.
  // `eye`: the state of the observer's eye; without one, an eye is steady in this picture's light.
  FinishedPicture finish(const Scene& scene, const PlacedScene& placed, const RenderPlan& plan,
                         const EyeState* eye = nullptr);
  // Draws the picture, which is to be small, for its exposure meter alone.
  MeterReading meter(const Scene& scene, const PlacedScene& placed, const RenderPlan& plan);
  // Draws into a framebuffer (0: the window's), of the picture's size.
  void show(const Scene& scene, const PlacedScene& placed, const RenderPlan& plan,
            unsigned framebuffer, Duration sinceLast);

  const PictureCounters& counters() const;
  // Called with each pass's name and a function that draws it once more; for measuring.
  using PassObserver = std::function<void(const std::string&, const std::function<void()>&)>;
  void observePasses(PassObserver observer);
  // Bytes of every resident table and map, by name.
  std::vector<std::pair<std::string, std::size_t>> residentBytes() const;
  // Seconds that each medium's tables took to compute, by medium.
  std::vector<std::pair<std::string, double>> precomputeSeconds() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace antumbra
