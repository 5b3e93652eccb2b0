#include "app/luminance_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antumbra {

LuminanceTrack::LuminanceTrack(const SceneSession& session, ImageSource images)
    : session_(session), meter_(std::move(images)) {}

EyeState LuminanceTrack::eyeAtFrame(int frame) {
  Scene scene = session_.scene().atFrame(frame);
  constexpr int kWidth = 96;
  int const width = std::min(scene.picture.width, kWidth);
  scene.picture.height = std::max(
      1, static_cast<int>(std::lround(double(scene.picture.height) * width / scene.picture.width)));
  scene.picture.width = width;
  scene.quality = "draft";
  auto const& c = scene.camera;
  std::vector<double> key{c.height.si,  c.latitude.si, c.longitude.si,
                          c.azimuth.si, c.altitude.si, scene.picture.field.si};
  key.push_back(0.0);
  double const start = (session_.start() - Instant()).si;
  double const now = start + session_.scene().offsetAt(frame).si;
  std::vector<TrackedReading> track;
  for (double const seconds : meteredSeconds(now)) {
    key.back() = seconds;
    auto known = readings_.find(key);
    if (known == readings_.end()) {
      auto const moment = session_.at(scene, Duration(seconds - start));
      known = readings_.emplace(key, meter_.meter(moment.scene, moment.placed, moment.plan)).first;
    }
    track.push_back({Duration(now - seconds), known->second});
  }
  return eyeAfter(track, {scene.display.compensationStops});
}

}  // namespace antumbra
