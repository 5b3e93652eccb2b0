// The curves of a solar eclipse over a picture of the Earth: central line, limits, isolines, the
// umbra's edge, time marks, with their names. Lines keep their width in pixels; each has a dark
// casing, so that it stands out from sand and from sea.
#pragma once

#include "eclipse/drawing.h"
#include "plan/eclipse_at_hand.h"
#include "plan/surface_lines.h"

namespace antumbra {

struct CurveOverlay {
  Drawing drawing;  // in pixels of the picture, y down
  int curves = 0;   // that the eclipse has, of the kinds asked for
  int shown = 0;    // of them, that the picture shows some of
};

// `textSize` in pixels.
CurveOverlay curveOverlay(const Scene& scene, const EclipseAtHand& eclipse, Instant when,
                          const SurfaceLines& earth, double textSize);

}  // namespace antumbra
