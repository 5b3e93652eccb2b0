#include "passes/corona.h"

#include <algorithm>
#include <cmath>

#include "gl/view_block.h"
#include "passes/sun.h"

namespace antumbra {

CoronaPass::CoronaPass(ProjectionKind kind)
    : program_(gl::Program::fullScreen("passes/corona.frag", gl::projectionDefinition(kind))) {}

bool CoronaPass::draw(const Projection& projection, const SunInView& sun, const SunPlane& plane,
                      std::span<const Silhouette> silhouettes, const CoronaLook& look,
                      glm::ivec2 tileOrigin) {
  Angle const reach(std::atan(glsl::kCoronaEnd * plane.tangent()));
  if (!scissorToCap(projection, plane.centre(), reach, tileOrigin)) return false;
  blendAdditively();
  setSunPlane(program_, projection.kind, plane, sun.law, silhouettes);
  double const pixel = projection.pixelAngle() / plane.angularRadius();
  glm::dvec4 const centre = glsl::solarBrightness(sun.law, 1.0);
  // Scattered light has the colour of the whole disc, and the profile is in units of the centre.
  glm::dvec3 const centreLuminance = plane.meanLuminance() * centre.w;
  program_.set("flattening", static_cast<float>(glsl::flatteningOfActivity(look.activity)))
      .set("centreLuminance", glm::vec3(centreLuminance))
      .set("streamers", look.streamers ? 1.0f : 0.0f)
      .set("activity", static_cast<float>(look.activity))
      .set("prominenceCount", look.prominences)
      .set("finestSamples", std::clamp(static_cast<int>(std::ceil(4.0 + 36.0 * pixel)), 4, 16));
  program_.use();
  gl::drawFullScreen();
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  return true;
}

}  // namespace antumbra
