#include "passes/glare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "document/input_error.h"
#include "gl/view_block.h"
#include "passes/sun.h"

namespace antumbra {
namespace {

constexpr int kNearSide = 96;

float agingFourth(const Eye& eye) { return static_cast<float>(std::pow(eye.ageYears / 70.0, 4.0)); }

}  // namespace

void Eye::check(const std::string& where) const {
  bool const aged = ageYears >= 20.0 && ageYears <= 80.0;
  if (!aged)
    throw InputError(
        fmt::format("{}: found an age of {} years; allowed: 20 to 80", where, ageYears));
  bool const pigmented = pigmentation >= 0.0 && pigmentation <= 1.2;
  if (!pigmented)
    throw InputError(
        fmt::format("{}: found a pigmentation of {}; allowed: 0 to 1.2", where, pigmentation));
  if (!(magnification >= 1.0 && magnification <= 1e5))
    throw InputError(
        fmt::format("{}: found a magnification of {}; allowed: 1 to 100000", where, magnification));
}

double magnificationOf(const Projection& projection) {
  if (projection.kind == ProjectionKind::Equirectangular) return 1.0;
  return std::max(1.0, 60.0 * degree / projection.field);
}

double haloShare(const Eye& eye) {
  // Midpoint sum over the logarithm of the angle, from 1e-4 to pi rad.
  double sum = 0.0;
  constexpr int kSteps = 4000;
  double const first = std::log(1e-4), last = std::log(std::numbers::pi);
  double const step = (last - first) / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    double const angle = std::exp(first + (i + 0.5) * step);
    sum += glsl::eyeHalo(angle * angle, agingFourth(eye), eye.pigmentation) * 2.0 *
           std::numbers::pi * std::sin(angle) * angle * step;
  }
  return sum;
}

GlarePass::GlarePass(ProjectionKind kind)
    : near_(gl::Program::fullScreen("passes/glare_near.frag")),
      halo_(gl::Program::fullScreen("passes/glare.frag", gl::projectionDefinition(kind))),
      nearTable_(gl::Texture::plane(GL_R32F, kNearSide, kNearSide)),
      nearTarget_({&nearTable_}) {}

bool GlarePass::draw(const Projection& projection, const SunPlane& plane, const VisibleSun& visible,
                     glm::dvec3 sunlight, const Eye& eye) {
  glm::dvec3 const lux = sunlight * visible.light;
  if (visible.sources.empty() || !(std::max({lux.x, lux.y, lux.z}) > 0.0)) return false;
  // The angle over which the halo differs from a point's.
  double const scale = std::max(
      plane.tangent(), std::tan(static_cast<double>(glsl::kGlareCore)) / eye.magnification);
  GLint viewport[4] = {}, target = 0;
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  auto const setEye = [&](const gl::Program& program) {
    program.set("agingFourth", agingFourth(eye))
        .set("pigmentation", static_cast<float>(eye.pigmentation))
        .set("magnification", static_cast<float>(eye.magnification))
        .set("nearScale", static_cast<float>(scale));
  };
  std::vector<glm::vec4> sources;
  for (SunSource const& s : visible.sources)
    sources.emplace_back((glm::dvec2(s.place) - visible.centroid) * (plane.tangent() / scale),
                         s.share, 0.0f);
  // Where the halo's core is finer than the sources lie apart, each stands for its neighbourhood.
  double const half = 0.5 * visible.sourceSpacing * plane.tangent();
  double const finer = std::tan(static_cast<double>(glsl::kGlareCore)) / (eye.magnification * half);
  double const sourceSize = half / (1.0 + finer * finer);
  near_.set("sourceCount", static_cast<int>(sources.size()))
      .set("nearSide", static_cast<float>(kNearSide))
      .set("sourceSize", static_cast<float>(sourceSize))
      .setArray("sources", sources.data(), static_cast<int>(sources.size()));
  setEye(near_);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  nearTarget_.bind();
  near_.use();
  gl::drawFullScreen();

  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(target));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  // A frame about the centroid: what is visible of the Sun, not the Sun, is the light.
  glm::dvec3 const axis = glm::normalize(plane.directionAt(visible.centroid));
  glm::dvec3 const across =
      glm::normalize(plane.across().u - glm::dot(plane.across().u, axis) * axis);
  glm::dvec3 const up = glm::cross(across, axis);
  halo_.set("sourceAxis", glm::vec3(axis))
      .set("sourcePrepared", gl::prepareDirection(projection.kind, {axis}))
      .set("sourceAcross", glm::vec3(across / scale))
      .set("sourceUp", glm::vec3(up / scale))
      .set("illuminance", glm::vec3(lux));
  setEye(halo_);
  nearTable_.bind(0);
  blendAdditively();
  halo_.use();
  gl::drawFullScreen();
  glDisable(GL_BLEND);
  return true;
}

}  // namespace antumbra
