// The shadow of one body as it stands in space, as seen from the camera.
//
// Cones are those of the picture's apparent places (light time and aberration about the body that
// the camera belongs to), as the discs are. To be honest: seen from another body than the one that
// the shadow meets, the axis passes there up to the aberration (20" of the caster's distance: 40 km
// at the Earth, seen from the Moon) beside the shadow on the ground. An oblate caster is drawn as
// the sphere of its equatorial radius, and light that its air bends is left out.
#pragma once

#include <string>

#include "eclipse/shadow_pair.h"
#include "scene/placed_scene.h"
#include "scene/scene.h"

namespace antumbra {

struct PlannedCone {
  std::string caster;
  std::string receiver;   // empty where the shadow meets no body of the scene
  glsl::ShadowPair pair;  // along camera axes, from the camera
  Length base;            // along the axis from the pair's foot: the caster's centre,
  Length apex;            // the tip of the umbra,
  Length end;             // where the cones are cut
  bool fades = false;     // toward the end: it is no surface
};

// Of the bodies that the scene's overlays name. Throws InputError for a body that the scene does
// not hold, and for the Sun.
std::vector<PlannedCone> planCones(const Scene& scene, const PlacedScene& placed);

}  // namespace antumbra
