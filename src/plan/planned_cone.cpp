#include "plan/planned_cone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/input_error.h"
#include "eclipse/shadow_convention.h"

namespace antumbra {
namespace {

const PlacedBody& casterOf(const PlacedScene& placed, const std::string& name,
                           const std::string& where) {
  // Unknown names are explained by the catalogue.
  const Body& body = BodyCatalogue::standard().body(name, where);
  if (body.kind == "star")
    throw InputError(
        fmt::format("{}: found {}, a star; allowed: bodies that cast a shadow", where, body.name));
  for (auto const& placedBody : placed.bodies)
    if (placedBody.body->name == body.name) return placedBody;
  throw InputError(
      fmt::format("{}: found {}, which is not among the scene's bodies", where, body.name));
}

}  // namespace

std::vector<PlannedCone> planCones(const Scene& scene, const PlacedScene& placed) {
  std::vector<PlannedCone> cones;
  if (scene.overlays.cones.empty()) return cones;
  auto const convention = ShadowConvention::named(scene.shadows.convention, scene.file);
  const PlacedBody* sun = nullptr;
  for (auto const& b : placed.bodies)
    if (b.body->kind == "star") sun = &b;
  for (auto const& name : scene.overlays.cones) {
    const PlacedBody& caster = casterOf(placed, name, scene.overlays.conesWhere);
    for (auto const& other : cones)
      if (other.caster == caster.body->name)
        throw InputError(fmt::format("{}: found {} twice; allowed: each body once",
                                     scene.overlays.conesWhere, other.caster));
    PlannedCone cone;
    cone.caster = caster.body->name;
    cone.pair =
        shadowPair(placed.cameraFromIcrs(sun->fromCamera), placed.cameraFromIcrs(caster.fromCamera),
                   convention.radiiOf(caster.body->name, caster.body->equatorialRadius));
    double const base = -cone.pair.casterBehind;
    double const apex = cone.pair.umbraRadius / cone.pair.umbraTangent;
    cone.base = Length(base);
    cone.apex = Length(apex);
    double end = apex + (apex - base);
    cone.fades = true;
    // The nearest body behind the caster that the penumbra touches.
    for (auto const& b : placed.bodies) {
      if (&b == sun || &b == &caster) continue;
      glm::dvec3 const centre = placed.cameraFromIcrs(b.fromCamera).m;
      auto const place = glsl::placeInShadow(cone.pair, centre);
      bool const behind = place.along > base;
      bool const touched = place.distance - b.body->equatorialRadius.si <
                           glsl::penumbraRadiusAt(cone.pair, place.along);
      if (!behind || !touched || place.along > end) continue;
      end = place.along;
      cone.receiver = b.body->name;
      cone.fades = false;
    }
    if (scene.overlays.coneLength) {
      double const asked = base + scene.overlays.coneLength->si;
      if (asked != end) cone.fades = true;
      if (asked < end) cone.receiver.clear();
      end = asked;
    }
    cone.end = Length(end);
    cones.push_back(std::move(cone));
  }
  return cones;
}

}  // namespace antumbra
