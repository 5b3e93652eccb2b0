#include "passes/cone_pass.h"

#include <algorithm>
#include <stdexcept>

#include "gl/view_block.h"

namespace antumbra {
namespace {

constexpr std::size_t kMostCones = 4;
constexpr std::size_t kMostSolids = 16;

struct ConesBlock {  // std140, shaders/passes/cones.frag
  struct Cone {
    glm::vec4 foot, axis, umbra, penumbra;
  } cones[kMostCones];
  int count;
  int unused[3];
};

struct SolidsBlock {  // std140, shaders/interface/solids.glsl
  struct Solid {
    glm::vec4 scaledFromCamera[3], up, heights;
  } solids[kMostSolids];
  int count;
  int unused[3];
};

SolidsBlock::Solid solidOf(const PlannedBody& body) {
  SolidsBlock::Solid solid{};
  double const radius = body.equatorialRadius.si;
  double const stretch = body.equatorialRadius / body.polarRadius;
  glm::dmat3 const scaled =
      glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, stretch) * body.bodyFromCamera.matrix;
  for (int i = 0; i < 3; ++i) solid.scaledFromCamera[i] = glm::vec4(glm::vec3(scaled[i]), 0.0f);
  glm::dvec3 const camera = scaled * -body.centre.m;
  double const above = std::max(body.cameraHeight.si, 0.01);
  solid.up = glm::vec4(glm::vec3(glm::normalize(camera)), static_cast<float>(radius + above));
  solid.heights =
      glm::vec4(above, above * (2.0 * radius + above), radius, above > 0.4 * radius ? 1.0 : 0.0);
  return solid;
}

}  // namespace

ConePass::ConePass(ProjectionKind kind)
    : program_(gl::Program::fullScreen("passes/cones.frag", gl::projectionDefinition(kind))) {}

void ConePass::prepare(const std::vector<PlannedCone>& cones,
                       const std::vector<PlannedBody>& bodies) {
  if (cones.size() > kMostCones) throw std::logic_error("more cones than the shader holds");
  ConesBlock block{};
  for (auto const& cone : cones) {
    auto const& pair = cone.pair;
    block.cones[block.count++] = {
        glm::vec4(glm::vec3(pair.foot), cone.fades ? 1.0f : 0.0f),
        glm::vec4(glm::vec3(pair.axis), static_cast<float>(cone.base.si)),
        glm::vec4(pair.umbraRadius, -pair.umbraTangent, cone.apex.si, cone.end.si),
        glm::vec4(pair.penumbraRadius, pair.penumbraTangent, 0.0, 0.0)};
  }
  cones_.write(block);
  std::vector<const PlannedBody*> largest;
  for (auto const& body : bodies) largest.push_back(&body);
  std::sort(largest.begin(), largest.end(), [](const PlannedBody* a, const PlannedBody* b) {
    return a->diameterPixels > b->diameterPixels;
  });
  if (largest.size() > kMostSolids) largest.resize(kMostSolids);
  SolidsBlock solids{};
  for (auto const* body : largest) solids.solids[solids.count++] = solidOf(*body);
  solids_.write(solids);
}

void ConePass::draw() const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  cones_.bindUniform(12);
  solids_.bindUniform(11);
  program_.use();
  gl::drawFullScreen();
  glDisable(GL_BLEND);
}

}  // namespace antumbra
