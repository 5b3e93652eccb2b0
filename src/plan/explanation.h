// What a picture needs and why, for people (`render --explain`).
#pragma once

#include <string>

#include "plan/render_plan.h"

namespace antumbra {

// A section for bodies, atmosphere tables, ways of sunlight in air, shadow pairs, passes, the same
// air in numbers and what is left out; a line for each entry.
std::string explain(const RenderPlan& plan);

}  // namespace antumbra
