// What is drawn over a picture, and why: cones of shadow in space, the curves of an eclipse, a
// clock of its contacts. Pure, without OpenGL; costs nothing where the scene asks for nothing.
#pragma once

#include <string>
#include <vector>

#include "eclipse/drawing.h"
#include "plan/planned_body.h"
#include "plan/planned_cone.h"
#include "scene/placed_scene.h"
#include "scene/scene.h"

namespace antumbra {

// A line of an explanation: what, and why.
struct Reason {
  std::string what;
  std::string why;
};

// In the order in which they are drawn.
struct PlannedOverlays {
  std::vector<PlannedCone> cones;
  std::vector<PlannedBody> solids;  // what may hide a part of a cone
  Drawing curves, clock;            // in pixels of the picture, y down; no shapes where absent
  std::vector<Reason> passes, leftOut;
};

// `bodies`: what the picture shows as discs. Throws InputError for an [overlays] eclipse that does
// not exist, and for cones of unknown bodies.
PlannedOverlays planOverlays(const Scene& scene, const PlacedScene& placed,
                             const std::vector<PlannedBody>& bodies);

}  // namespace antumbra
