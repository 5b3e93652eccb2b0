#include "plan/overlay_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/contact_clock.h"
#include "plan/curve_overlay.h"

namespace antumbra {
namespace {

constexpr double kTextShare = 1.0 / 40.0;  // of the picture's smaller side
constexpr double kSmallestText = 8.0;
constexpr double kConePixels = 0.5;  // a penumbra narrower than this everywhere is not seen

double textSizeOf(const Scene& scene) {
  int const side = std::min(scene.picture.width, scene.picture.height);
  return scene.overlays.textSize.value_or(std::max(kTextShare * side, kSmallestText));
}

void addCurves(const Scene& scene, const PlacedScene& placed,
               const std::vector<PlannedBody>& bodies, const EclipseAtHand* eclipse,
               PlannedOverlays& overlays) {
  if (!scene.overlays.lines()) return;
  auto const out = [&](const std::string& why) {
    overlays.leftOut.push_back({"overlay curves", why});
  };
  if (!eclipse) return out("no solar eclipse within a day of the instant");
  auto const earth = std::find_if(bodies.begin(), bodies.end(),
                                  [](const PlannedBody& b) { return b.name == "Earth"; });
  if (earth == bodies.end()) return out("the Earth is not in the picture as a disc");
  SurfaceLines const lines(scene.picture, *earth, bodies);
  CurveOverlay made = curveOverlay(scene, *eclipse, placed.when, lines, textSizeOf(scene));
  std::string const which = fmt::format("eclipse of {}", eclipse->event.eclipse.id);
  if (made.drawing.shapes.empty() && made.drawing.words.empty())
    return out(made.curves == 0
                   ? which + ": it has no such curve"
                   : which + ": its curves lie outside the picture or behind the horizon");
  overlays.curves = std::move(made.drawing);
  overlays.passes.push_back({"overlay curves", fmt::format("{}: {} of {} curves in the picture",
                                                           which, made.shown, made.curves)});
}

void addCones(const Scene& scene, const PlacedScene& placed, const std::vector<PlannedBody>& bodies,
              PlannedOverlays& overlays) {
  for (auto& cone : planCones(scene, placed)) {
    std::string const what = "overlay cone " + cone.caster;
    // Widest where it ends; seen from at least as near as its nearest point.
    double const from = std::clamp(0.0, cone.base.si, cone.end.si);
    double const nearest = std::hypot(glm::length(cone.pair.foot), from);
    double const widest = glsl::penumbraRadiusAt(cone.pair, cone.end.si);
    if (nearest > widest && 2.0 * widest / nearest < kConePixels * scene.picture.pixelAngle().si) {
      overlays.leftOut.push_back({what, "thinner than half a pixel everywhere"});
      continue;
    }
    overlays.passes.push_back(
        {what, fmt::format("umbra {:.0f} km long, shadow {}", (cone.apex - cone.base) / kilometre,
                           cone.receiver.empty() ? fmt::format("shown over {:.0f} km",
                                                               (cone.end - cone.base) / kilometre)
                                                 : "meets " + cone.receiver)});
    overlays.cones.push_back(std::move(cone));
  }
  if (!overlays.cones.empty()) overlays.solids = bodies;
}

}  // namespace

PlannedOverlays planOverlays(const Scene& scene, const PlacedScene& placed,
                             const std::vector<PlannedBody>& bodies) {
  PlannedOverlays overlays;
  if (!scene.overlays.any()) {
    overlays.leftOut.push_back({"overlays", "the scene asks for none"});
    return overlays;
  }
  std::shared_ptr<const EclipseAtHand> eclipse;
  if (scene.overlays.lines() || scene.overlays.clock) eclipse = eclipseAtHand(scene, placed);
  addCones(scene, placed, bodies, overlays);
  addCurves(scene, placed, bodies, eclipse.get(), overlays);
  if (scene.overlays.clock) {
    if (!eclipse) {
      overlays.leftOut.push_back({"overlay clock", "no solar eclipse within a day of the instant"});
    } else {
      ContactClock made = contactClock(scene, placed, *eclipse, textSizeOf(scene));
      overlays.clock = std::move(made.drawing);
      (overlays.clock.shapes.empty() ? overlays.leftOut : overlays.passes)
          .push_back({"overlay clock", made.says});
    }
  }
  return overlays;
}

}  // namespace antumbra
