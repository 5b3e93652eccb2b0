// The solar eclipse that a scene's overlays speak of, with its curves on the globe.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "eclipse/eclipse_curves.h"
#include "scene/placed_scene.h"
#include "scene/scene.h"

namespace antumbra {

struct EclipseAtHand {
  SolarEvent event;
  ShadowRadii radii;
  EclipseCurves curves;  // central line and limits; the others where asked for; marks where asked
};

// The eclipse that the scene names, or else the one whose greatest instant lies within a day of the
// picture's; nothing where there is none. Its convention and delta T are those of the scene. The
// results of the last calls are kept: a function of its arguments, at 0.5 s for the first picture
// with contours and 0.05 s without. Throws InputError for a date without eclipse.
std::shared_ptr<const EclipseAtHand> eclipseAtHand(const Scene& scene, const PlacedScene& placed);

}  // namespace antumbra
