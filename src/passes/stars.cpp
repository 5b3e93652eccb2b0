#include "passes/stars.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "gl/view_block.h"
#include "passes/sun.h"
#include "photometry/colour.h"

namespace antumbra {

StarsPass::StarsPass(ProjectionKind kind)
    : kind_(kind),
      program_(gl::Program::render("passes/stars.vert", "passes/stars.frag",
                                   gl::projectionDefinition(kind))),
      halo_(gl::Program::render("passes/star_halo.vert", "passes/star_halo.frag",
                                gl::projectionDefinition(kind))) {
  glCreateVertexArrays(1, &vertexArray_);
  for (GLuint attribute : {0u, 1u}) {
    glEnableVertexArrayAttrib(vertexArray_, attribute);
    glVertexArrayAttribFormat(
        vertexArray_, attribute, 3, GL_FLOAT, GL_FALSE,
        attribute == 0 ? offsetof(StarPoint, direction) : offsetof(StarPoint, illuminanceLux));
    glVertexArrayAttribBinding(vertexArray_, attribute, 0);
  }
  glVertexArrayBindingDivisor(vertexArray_, 0, 1);
}

StarsPass::~StarsPass() { glDeleteVertexArrays(1, &vertexArray_); }

void StarsPass::drawInstances(std::span<const StarPoint> points, const gl::Program& program,
                              int rounds) {
  vertices_.write(points, GL_STREAM_DRAW);
  glVertexArrayVertexBuffer(vertexArray_, 0, vertices_.id(), 0, sizeof(StarPoint));
  GLint viewport[4] = {};
  GLint previousArray = 0;
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &previousArray);
  glBindVertexArray(vertexArray_);
  blendAdditively();
  program.use();
  program.set("targetSize", glm::vec2(viewport[2], viewport[3]));
  for (int round = 0; round < rounds; ++round) {
    program.set("copySide", static_cast<float>(round));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(points.size()));
  }
  glDisable(GL_BLEND);
  glBindVertexArray(static_cast<GLuint>(previousArray));
}

void StarsPass::draw(std::span<const StarPoint> points) {
  if (points.empty()) return;
  drawInstances(points, program_, kind_ == ProjectionKind::Equirectangular ? 2 : 1);
}

int StarsPass::drawHalos(const Projection& projection, std::span<const StarPoint> points,
                         const Eye& eye, double faintestLuminance) {
  // 13.6 / t^3 for t in degrees is the glare function beyond half a degree (star_halo.vert).
  double const threePixels = 3.0 * projection.pixelAngle() / degree;
  double const least =
      faintestLuminance * eye.magnification * threePixels * threePixels * threePixels / 13.6;
  std::vector<StarPoint> bright;
  for (StarPoint const& p : points)
    if (luminanceOf(glm::dvec3(p.illuminanceLux)) > least) bright.push_back(p);
  if (bright.empty()) return 0;
  halo_.set("magnification", static_cast<float>(eye.magnification))
      .set("agingFourth", static_cast<float>(std::pow(eye.ageYears / 70.0, 4.0)))
      .set("pigmentation", static_cast<float>(eye.pigmentation))
      .set("faintest", static_cast<float>(faintestLuminance));
  drawInstances(bright, halo_, 1);
  return static_cast<int>(bright.size());
}

}  // namespace antumbra
