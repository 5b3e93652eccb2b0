#include "passes/stars.h"

#include <cstddef>

#include "gl/view_block.h"

namespace antumbra {

StarsPass::StarsPass(ProjectionKind kind)
    : kind_(kind),
      program_(gl::Program::render("passes/stars.vert", "passes/stars.frag",
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

void StarsPass::draw(std::span<const StarPoint> points) {
  if (points.empty()) return;
  vertices_.write(points, GL_STREAM_DRAW);
  glVertexArrayVertexBuffer(vertexArray_, 0, vertices_.id(), 0, sizeof(StarPoint));
  GLint viewport[4] = {};
  GLint previousArray = 0;
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &previousArray);
  glBindVertexArray(vertexArray_);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
  program_.use();
  program_.set("targetSize", glm::vec2(viewport[2], viewport[3]));
  int const sides = kind_ == ProjectionKind::Equirectangular ? 2 : 1;
  for (int side = 0; side < sides; ++side) {
    program_.set("copySide", static_cast<float>(side));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(points.size()));
  }
  glDisable(GL_BLEND);
  glBindVertexArray(static_cast<GLuint>(previousArray));
}

}  // namespace antumbra
