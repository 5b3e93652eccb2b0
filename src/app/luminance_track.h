// The light that an eye has lived in before a picture: metered from small pictures of the same view
// at instants before it, so that the eye's state is a function of scene and instant alone.
#pragma once

#include <map>
#include <vector>

#include "app/scene_session.h"
#include "picture/picture_renderer.h"

namespace antumbra {

class LuminanceTrack {
 public:
  // Needs an OpenGL context. `session` must outlive it.
  LuminanceTrack(const SceneSession& session, ImageSource images);
  // The camera stands and looks as in that frame all the time before. Small pictures are 96 pixels
  // wide and of draft quality; frames of one camera share them.
  EyeState eyeAtFrame(int frame);

 private:
  const SceneSession& session_;
  PictureRenderer meter_;
  // By what keyframes move (place, aim and field), and by seconds since J2000.0.
  std::map<std::vector<double>, MeterReading> readings_;
};

}  // namespace antumbra
