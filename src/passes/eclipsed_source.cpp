#include "passes/eclipsed_source.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "passes/gauss_legendre.h"

namespace antumbra {
namespace {

constexpr int kQuantities = 10;
// How far the axis may move across the body, relative to the body's radius, and the umbra relative
// to itself and the top of the air, before the grid is computed anew.
constexpr double kAxisTolerance = 0.004;
constexpr double kUmbraTolerance = 0.01;

gl::Definitions with(const AirTables& tables, const BodyShadows& shadows,
                     std::initializer_list<const char*> flags) {
  auto d = tables.definitions();
  auto const s = shadows.definitions();
  d.insert(d.end(), s.begin(), s.end());
  auto const e = EclipsedSource::definitions();
  d.insert(d.end(), e.begin(), e.end());
  for (const char* flag : flags) d.emplace_back(flag, "");
  return d;
}

}  // namespace

EclipsedSource::EclipsedSource(const AirTables& tables, const BodyShadows& shadows, bool exact)
    : baseProgram_(gl::Program::compute(
          "precompute/eclipsed_radiance.comp",
          with(tables, shadows,
               {"AIR_SINGLE", "AIR_SOURCE", "UNECLIPSED", "AIR_CUTS", "WHOLE_TURN"}))),
      firstProgram_(
          gl::Program::compute("precompute/eclipsed_radiance.comp",
                               with(tables, shadows, {"AIR_SINGLE", "AIR_CUTS", "WHOLE_TURN"}))),
      nextProgram_(gl::Program::compute(
          "precompute/eclipsed_radiance.comp",
          with(tables, shadows, {"AIR_SOURCE", "ECLIPSED_HARMONICS", "AIR_CUTS", "WHOLE_TURN"}))),
      moments_(gl::Program::compute("precompute/eclipsed_moments.comp",
                                    with(tables, shadows, {"WHOLE_TURN"}))),
      nodes_(tables.quality().eclipseSamples),
      exact_(exact) {
  auto const& q = tables.quality();
  int const layers = tables.layers();
  auto const volume = [&] {
    return gl::Texture::volume(GL_RGBA32F, q.eclipseDistances, q.eclipseAzimuths,
                               q.eclipseHeights * kQuantities * layers);
  };
  grid_ = volume();
  other_ = volume();
  int const rows = q.eclipseAzimuths * q.eclipseHeights;
  auto const cells = [&](int count) {
    return gl::Texture::layers(GL_RGBA32F, q.eclipseDistances, rows, count);
  };
  radiances_ = cells(q.eclipseZeniths * q.eclipseTurns * layers);
  base_ = cells(2 * layers);
  first_ = cells(kQuantities * layers);
  std::vector<glm::vec4> zeniths(64, glm::vec4(0.0f));
  auto const half = gaussLegendre(q.eclipseZeniths / 2);
  std::copy(half.begin(), half.end(), zeniths.begin());
  zeniths_.write(std::span<const glm::vec4>(zeniths));
}

bool EclipsedSource::update(const AirTables& tables, const BodyShadows& shadows,
                            const glsl::ShadowPair& pair, const glm::dvec3& sun) {
  double const radius = tables.groundRadius().si;
  double const away = glm::length(pair.foot);
  glm::dvec3 across = away > 1.0 ? pair.foot / away : glm::dvec3(0.0, 0.0, 1.0);
  across = glm::normalize(across - pair.axis * glm::dot(across, pair.axis));
  glm::dvec3 const side = glm::cross(pair.axis, across);
  struct Block {
    glm::vec4 across, side, sun;
  };
  block_.write(
      Block{glm::vec4(glm::vec3(across), static_cast<float>(0.6 * tables.top().si)),
            glm::vec4(glm::vec3(side),
                      static_cast<float>(1.02 * pair.penumbraRadius + 3.0 * tables.top().si)),
            glm::vec4(glm::vec3(sun), static_cast<float>(tables.quality().eclipseHeights))});
  double const slack = exact_ ? 0.0 : 1.0;
  bool const near =
      computed_ &&
      std::fabs(away - glm::length(computedFor_.foot)) <= slack * kAxisTolerance * radius &&
      std::fabs(pair.umbraRadius - computedFor_.umbraRadius) <=
          slack * kUmbraTolerance * (std::fabs(computedFor_.umbraRadius) + tables.top().si) &&
      std::fabs(pair.penumbraRadius - computedFor_.penumbraRadius) <=
          slack * kUmbraTolerance * computedFor_.penumbraRadius;
  if (near) return false;
  computedFor_ = pair;
  computed_ = true;
  compute(tables, shadows);
  return true;
}

void EclipsedSource::compute(const AirTables& tables, const BodyShadows& shadows) {
  glFinish();
  auto const start = std::chrono::steady_clock::now();
  auto const& q = tables.quality();
  glm::ivec2 const directions(q.eclipseZeniths, q.eclipseTurns);
  glm::ivec3 const cells(q.eclipseDistances, q.eclipseAzimuths, q.eclipseHeights);
  auto const groupsX = static_cast<GLuint>((cells.x + 7) / 8);
  auto const groupsY = static_cast<GLuint>((cells.y * cells.z + 3) / 4);
  tables.bind();
  shadows.bind();
  nodes_.bind();
  zeniths_.bindUniform(4);
  block_.bindUniform(9);
  auto const pass = [&](const gl::Program& program, int stage) {
    grid_.bind(10);
    program.set("directionCount", directions).set("cellCount", cells).use();
    radiances_.bindImage(0, GL_WRITE_ONLY);
    glDispatchCompute(groupsX, groupsY, static_cast<GLuint>(directions.x * directions.y));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    moments_.set("directionCount", directions).set("cellCount", cells).set("stage", stage).use();
    radiances_.bindImage(0, GL_READ_ONLY);
    base_.bindImage(1, GL_READ_WRITE);
    first_.bindImage(2, GL_READ_WRITE);
    other_.bindImage(3, GL_WRITE_ONLY);
    glDispatchCompute(groupsX, groupsY, static_cast<GLuint>(tables.layers()));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    if (stage > 0) std::swap(grid_, other_);
    glFlush();
  };
  pass(baseProgram_, 0);
  pass(firstProgram_, 1);
  for (int order = 2; order <= q.eclipseOrders; ++order) pass(nextProgram_, 2);
  glFinish();
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void EclipsedSource::bind() const {
  block_.bindUniform(9);
  grid_.bind(10);
}

}  // namespace antumbra
