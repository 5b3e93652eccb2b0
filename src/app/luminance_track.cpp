#include "app/luminance_track.h"

#include <algorithm>
#include <cmath>

namespace antumbra {

EyeState eyeAtFrame(const SceneSession& session, int frame, PictureRenderer& meter) {
  Scene scene = session.scene().atFrame(frame);
  constexpr int kWidth = 96;
  int const width = std::min(scene.picture.width, kWidth);
  scene.picture.height = std::max(
      1, static_cast<int>(std::lround(double(scene.picture.height) * width / scene.picture.width)));
  scene.picture.width = width;
  scene.quality = "draft";
  std::vector<TrackedReading> track;
  for (double seconds : trackSecondsBefore()) {
    Duration const before(seconds);
    auto const moment = session.at(scene, session.scene().offsetAt(frame) - before);
    track.push_back({before, meter.meter(moment.scene, moment.placed, moment.plan)});
  }
  return eyeAfter(track, {scene.display.compensationStops});
}

}  // namespace antumbra
