#include "passes/sun.h"

#include <algorithm>
#include <cmath>

#include "gl/view_block.h"

namespace antumbra {

bool scissorToCap(const Projection& projection, Direction<CameraAxes> centre, Angle radius,
                  glm::ivec2 tileOrigin) {
  PixelBounds const bounds = boundsOfCap(projection, centre, radius);
  GLint viewport[4] = {};
  glGetIntegerv(GL_VIEWPORT, viewport);
  int const x0 = std::max(bounds.x0 - tileOrigin.x, 0);
  int const y0 = std::max(bounds.y0 - tileOrigin.y, 0);
  int const x1 = std::min(bounds.x1 - tileOrigin.x, viewport[2]);
  int const y1 = std::min(bounds.y1 - tileOrigin.y, viewport[3]);
  if (x1 <= x0 || y1 <= y0) return false;
  glEnable(GL_SCISSOR_TEST);
  glScissor(x0, y0, x1 - x0, y1 - y0);
  return true;
}

void blendAdditively() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
}

SunPass::SunPass(ProjectionKind kind)
    : program_(gl::Program::fullScreen("passes/sun.frag", gl::projectionDefinition(kind))) {}

bool SunPass::draw(const Projection& projection, const SunInView& sun, const SunPlane& plane,
                   std::span<const Silhouette> silhouettes, glm::ivec2 tileOrigin) {
  double const pixel = projection.pixelAngle() / plane.angularRadius();
  Angle const reach = plane.angularRadius() + 2.0 * projection.pixelAngle();
  if (!scissorToCap(projection, plane.centre(), reach, tileOrigin)) return false;
  blendAdditively();
  setSunPlane(program_, projection.kind, plane, sun.law, silhouettes);
  // Samples so that an edge is known to 1/100 of the disc's radius at least.
  int const samples = std::clamp(static_cast<int>(std::ceil(8.0 + 36.0 * pixel)), 8, 16);
  program_.set("finestSamples", samples);
  program_.use();
  gl::drawFullScreen();
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  return true;
}

}  // namespace antumbra
