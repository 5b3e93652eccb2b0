#include "plan/planned_passes.h"

#include <fmt/format.h>

namespace antumbra {
namespace {

// How the Sun's surroundings look, and by whose word.
std::string coronaReason(const Scene& scene, Instant when) {
  SunSettings const& sun = scene.sun;
  return fmt::format(
      "{} at {:.2f} of the solar cycle ({}){}",
      sun.streamers ? "invented streamers about the measured mean" : "smooth",
      sun.activity.value_or(solarActivity(when)), sun.activity ? "the scene's" : "of the date",
      sun.prominences == 0 ? std::string()
                           : fmt::format(", {} invented prominences", sun.prominences));
}

Reason toneMapReason(const Scene& scene) {
  DisplaySettings const& display = scene.display;
  if (display.eye)
    return {"tone map", "for an eye adapted to the half hour before, metered from small pictures"};
  std::string why = display.automaticExposure ? "to the display, exposed by its own meter"
                                              : fmt::format("to the display, white at {:g} cd/m2",
                                                            display.whiteLuminance);
  if (!display.bracketsStops.empty())
    why += fmt::format(", and {} more exposures around that", display.bracketsStops.size());
  return {"tone map", why};
}

}  // namespace

std::string sizeInPixels(double p) {
  return p >= 10 ? fmt::format("{:.0f} px", p) : fmt::format("{:.2f} px", p);
}

void planPasses(const Scene& scene, Instant when, RenderPlan& plan) {
  auto& passes = plan.passes;
  bool const shown = scene.sun.drawn;
  passes.push_back(
      {"stars", scene.display.eye
                    ? "the sky behind everything; daylight drowns them, and the eye's own threshold"
                    : "the sky behind everything; air and daylight drown them by luminance"});
  if (!plan.points.empty())
    passes.push_back(
        {"points", fmt::format("{} bodies smaller than {} px", plan.points.size(), kPointPixels)});
  // The Sun comes after what is farther than any air, and before the air that dims it.
  bool sunPassed = false;
  auto const passSun = [&] {
    if (plan.drawSun && !sunPassed) {
      passes.push_back({"sun", "disc and corona; nothing covers all of it"});
      passes.push_back({"corona", coronaReason(scene, when)});
    }
    sunPassed = true;
  };
  if (!plan.drawSun)
    plan.leftOut.push_back({"sun", !shown ? "left out by the scene; its light stays"
                                   : plan.sun.hiddenByBody ? "wholly behind " + plan.sun.hiddenBy
                                                           : "outside the picture"});
  for (auto const& b : plan.bodies) {
    if (b.coversSunItself()) passSun();
    bool const rings = b.rings && !b.rings->bounds.empty();
    if (rings) passes.push_back({"rings beyond " + b.name, "their far half lies behind the globe"});
    passes.push_back(
        {"body " + b.name,
         fmt::format("{}{}{}",
                     b.cameraInAir ? "the camera is in its air"
                                   : "a disc of " + sizeInPixels(b.diameterPixels),
                     b.atmosphere.empty() ? "" : ", with air",
                     b.casters.empty() ? "" : fmt::format(", shaded by {}", b.casters.size()))});
    if (rings) passes.push_back({"rings before " + b.name, "their near half covers the globe"});
  }
  passSun();
  if (plan.queryOcclusion)
    passes.push_back({"occlusion query", "the Sun's disc is in the picture and not wholly hidden"});
  else
    plan.leftOut.push_back({"occlusion query", !shown ? "the Sun is left out by the scene"
                                               : !plan.sun.inPicture
                                                   ? "the Sun is not in the picture"
                                               : plan.sun.hiddenByBody
                                                   ? "the Sun is wholly behind " + plan.sun.hiddenBy
                                                   : "the illustrative look has no glare"});
  if (plan.queryOcclusion) passes.push_back({"glare", "the uncovered part of the Sun dazzles"});
  if (plan.glareFromOutside)
    passes.push_back({"glare", "the Sun beside the picture dazzles; its visible part by outlines"});
  passes.push_back(toneMapReason(scene));
}

}  // namespace antumbra
