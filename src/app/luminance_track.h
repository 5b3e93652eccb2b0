// The light that an eye has lived in before a picture: metered from small pictures of the same view
// at instants before it, so that the eye's state is a function of scene and instant alone.
#pragma once

#include "app/scene_session.h"
#include "picture/picture_renderer.h"

namespace antumbra {

// `meter`: a renderer of its own, off line; it keeps its tables from one picture to the next. The
// camera stands and looks as in that frame all the time before. Small pictures are 96 pixels wide
// and of draft quality.
EyeState eyeAtFrame(const SceneSession& session, int frame, PictureRenderer& meter);

}  // namespace antumbra
