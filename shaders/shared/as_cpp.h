// The shared GLSL as C++ in double precision: one formula for shader, plan, prediction and test.
// C++ includes this file, never a .glsl file. Files that look tables up declare the look-ups they
// need; such a file is not listed here but included by the one .cpp that supplies its tables,
// inside `namespace antumbra::glsl`, between GLSL_AS_CPP's definition and its end.
#pragma once

#include <glm/glm.hpp>

#define GLSL_AS_CPP
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-const-variable"
// Types and names are the program's; the functions are compiled into each file that uses them.
namespace antumbra::glsl {
using Number = double;
using Angle = double;
using Length = double;
using Area = double;
using InverseLength = double;
using Position = glm::dvec3;
using Direction = glm::dvec3;
using Spectrum = glm::dvec4;
using Coefficients = glm::dvec4;
using Colour = glm::dvec3;
using TableCoordinates = glm::dvec2;
using Index = int;
using glm::abs;
using glm::acos;
using glm::asin;
using glm::atan;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::exp2;
using glm::floor;
using glm::length;
using glm::log;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::sin;
using glm::smoothstep;
using glm::sqrt;
using glm::step;
using glm::tan;
#include "shared/eclipse_types.glsl"
#include "shared/quantities.glsl"
namespace {
#include "shared/air_geometry.glsl"
#include "shared/corona.glsl"
#include "shared/eclipse.glsl"
#include "shared/glare.glsl"
#include "shared/limb_darkening.glsl"
#include "shared/night_vision.glsl"
#include "shared/phase.glsl"
#include "shared/pixel_scale.glsl"
#include "shared/point_spread.glsl"
#include "shared/projection.glsl"
#include "shared/refracted_shadow.glsl"
#include "shared/several_casters.glsl"
#include "shared/shadow_cone.glsl"
#include "shared/surface.glsl"
#include "shared/tone_curve.glsl"
}  // namespace
}  // namespace antumbra::glsl
#pragma GCC diagnostic pop
#undef GLSL_AS_CPP
