// The order in which a picture is drawn, from stars to tone map, each pass with its reason.
#pragma once

#include <string>

#include "plan/render_plan.h"

namespace antumbra {

// Below this diameter in pixels a body is a point of light.
constexpr double kPointPixels = 0.5;
// A size in pixels as reasons print it.
std::string sizeInPixels(double p);

// Fills `passes` up to the tone map, and what of them is left out, from all that the plan holds
// else.
void planPasses(const Scene& scene, Instant when, RenderPlan& plan);

}  // namespace antumbra
