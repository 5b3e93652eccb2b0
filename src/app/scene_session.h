// What every command that draws a scene does first: read it, find its instant, place its bodies,
// plan.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ephemeris/playback.h"
#include "plan/render_plan.h"
#include "scene/placed_scene.h"
#include "scene/scene.h"
#include "time/instant.h"

namespace antumbra {

// What the command line says over the scene's own words; empty or absent: the scene's.
struct SceneOverrides {
  std::string time;
  std::string size;  // "WxH"
  std::string projection;
  std::string quality;
  std::string look;
  std::string deltaT;  // TT - UT1 in seconds
};

class SceneSession {
 public:
  // Throws InputError: the scene file, an option.
  SceneSession(const std::string& file, const SceneOverrides& overrides);
  // Live: places come from segments fitted ahead of the clock, which runs at `rate` seconds of the
  // scene per second and stands at `offset`, so that no frame waits for a series.
  void follow(Duration offset, double rate);

  const Scene& scene() const { return scene_; }
  Instant start() const { return start_; }  // of offset 0
  // One frame of the scene's animation, placed and planned.
  struct Moment {
    Scene scene;
    PlacedScene placed;
    RenderPlan plan;
  };
  Moment at(int frame) const;
  Moment at(const Scene& scene, Duration offset) const;
  // What the picture shows, for its file.
  std::vector<std::pair<std::string, std::string>> metadata(const Moment& moment) const;
  const DeltaT& deltaT() const { return deltaT_; }

 private:
  Scene scene_;
  DeltaT deltaT_;
  Instant start_;
  std::shared_ptr<const PlaybackEphemeris> playback_;  // only when followed
};

// "WxH" into the picture; throws InputError that opens with `where`.
void applySize(const std::string& text, const std::string& where, Projection& picture);

}  // namespace antumbra
