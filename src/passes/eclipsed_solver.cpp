#include "passes/eclipsed_solver.h"

#include <algorithm>
#include <cmath>

#include "eclipse/shadow_nodes.h"
#include "passes/gauss_legendre.h"

namespace antumbra {
namespace {

constexpr double kScaleOfTop = 0.35;    // of distances beyond the umbra's edge
constexpr double kInsideUmbra = 0.3;    // share of the distances
constexpr int kUneclipsedHeights = 64;  // of the Sun, without the eclipse
constexpr int kMostSlabs = 2048;        // least that OpenGL 4.5 grants a volume

gl::Definitions with(const AirTables& tables, std::initializer_list<const char*> flags) {
  auto d = tables.definitions();
  for (const char* flag : flags) d.emplace_back(flag, "");
  d.emplace_back("WHOLE_TURN", "");
  return d;
}

gl::Definitions inShadow(const AirTables& tables, std::initializer_list<const char*> flags) {
  auto d = with(tables, flags);
  d.emplace_back("SHADOW_PAIRS", "1");
  d.emplace_back("ECLIPSED_SOURCE", "1");
  d.emplace_back("ECLIPSED_TURNS_IN", std::to_string(tables.quality().eclipseTurns));
  d.emplace_back("ECLIPSED_TURNS", std::to_string(eclipsedTurns(tables.quality())));
  d.emplace_back("ECLIPSED_FORMAT", "rgba16f");
  return d;
}

GLuint groups(int count, int size) { return static_cast<GLuint>((count + size - 1) / size); }

// Directions whose light fits one volume: whole rings of a zenith angle.
int directionsAtOnce(const AirTables& tables) {
  auto const& q = tables.quality();
  int const ring = q.eclipseTurns * q.eclipseHeights * tables.layers();
  return std::clamp(kMostSlabs / ring, 1, q.eclipseZeniths) * q.eclipseTurns;
}

}  // namespace

Length axisDistance(const glsl::ShadowPair& pair, double flattening) {
  glm::dvec3 const stretch(1.0, 1.0, 1.0 / flattening);
  glm::dvec3 const foot = glsl::fromCasterSpace(pair, pair.foot) * stretch;
  glm::dvec3 const axis = glsl::fromCasterSpace(pair, pair.axis) * stretch;
  return Length(glm::length(glm::cross(foot, glm::normalize(axis))));
}

EclipsedAxisBlock eclipsedAxisBlock(const glsl::ShadowPair& pair, double flattening,
                                    const AirTables& tables) {
  double const away = glm::length(pair.foot), top = tables.top().si;
  glm::dvec3 across = away > 1.0 ? pair.foot / away : glm::dvec3(1.0, 0.0, 0.0);
  across -= pair.axis * glm::dot(across, pair.axis);
  if (glm::length(across) < 1e-6) across = glm::cross(pair.axis, glm::dvec3(0.0, 1.0, 0.0));
  across = glm::normalize(across);
  Length const distance = axisDistance(pair, flattening);
  double const share = std::min(distance / tables.groundRadius(), 1.0);
  glm::dvec3 const forward = -share * pair.axis - std::sqrt(1.0 - share * share) * across;
  double const umbra = umbraOnGround(pair, distance, tables.groundRadius()).si;
  return {glm::vec4(glm::vec3(across), static_cast<float>(umbra)),
          glm::vec4(glm::vec3(glm::cross(pair.axis, across)),
                    static_cast<float>(1.02 * pair.penumbraRadius + 3.0 * top)),
          glm::vec4(glm::vec3(forward), 0.0f)};
}

glm::vec4 eclipsedShape(const AirTables& tables) {
  auto const& q = tables.quality();
  return glm::vec4(kScaleOfTop * tables.top().si, q.eclipseHeights, kInsideUmbra,
                   q.eclipseAzimuths);
}

gl::Texture eclipsedGrid(const AirTables& tables, GLenum format, int casters) {
  auto const& q = tables.quality();
  return gl::Texture::volume(format, q.eclipseDistances, eclipsedTurns(q) * q.eclipseAzimuths,
                             casters * kEclipsedSlabs * tables.layers() * q.eclipseHeights);
}

EclipsedSolver::EclipsedSolver(const AirTables& tables, LimbDarkeningLaw law,
                               const glsl::ShadowPair& pair)
    : shadows_({pair}, 1.0, law, tables.wavelengths(), tables.groundRadius() + tables.top()),
      single_(gl::Program::compute("precompute/eclipsed_radiance.comp",
                                   inShadow(tables, {"AIR_SINGLE", "AIR_CUTS"}))),
      next_(gl::Program::compute("precompute/eclipsed_radiance.comp",
                                 inShadow(tables, {"AIR_VOLUME", "AIR_CUTS"}))),
      volumeProgram_(gl::Program::compute("precompute/eclipsed_volume.comp", inShadow(tables, {}))),
      hold_(gl::Program::compute("precompute/eclipsed_hold.comp", inShadow(tables, {}))),
      shares_(gl::Program::compute("precompute/eclipsed_shares.comp", inShadow(tables, {}))),
      nodes_(tables.quality().eclipseSamples) {
  auto const& q = tables.quality();
  int const layers = tables.layers(), rows = q.eclipseAzimuths * q.eclipseHeights;
  int const width = std::max(q.eclipseDistances, kUneclipsedHeights);
  radiances_ =
      gl::Texture::layers(GL_RGBA32F, width, rows, q.eclipseZeniths * q.eclipseTurns * layers);
  auto const cells = [&](int count) {
    return gl::Texture::layers(GL_RGBA32F, q.eclipseDistances, rows, count);
  };
  held_ = cells(2 * layers);
  first_ = cells(q.eclipseZeniths * q.eclipseTurns * layers);
  light_ = cells(q.eclipseZeniths * q.eclipseTurns * layers);
  lastStep_ = cells(2 * layers);
  volume_ = gl::Texture::volume(GL_RGBA32F, q.eclipseDistances, q.eclipseAzimuths,
                                directionsAtOnce(tables) * layers * q.eclipseHeights);
  std::vector<glm::vec4> zeniths(64, glm::vec4(0.0f));
  auto const half = gaussLegendre(q.eclipseZeniths / 2);
  std::copy(half.begin(), half.end(), zeniths.begin());
  zeniths_.write(std::span<const glm::vec4>(zeniths));
  findUneclipsed(tables);
}

void EclipsedSolver::gather(const AirTables& tables, const gl::Program& program, glm::ivec3 cells,
                            bool volume) {
  auto const& q = tables.quality();
  int const all = q.eclipseZeniths * q.eclipseTurns;
  int const most = volume ? directionsAtOnce(tables) : all;
  glm::ivec2 const directions(q.eclipseZeniths, q.eclipseTurns);
  for (int firstOne = 0; firstOne < all; firstOne += most) {
    auto const count = static_cast<GLuint>(std::min(most, all - firstOne));
    auto const dispatch = [&](const gl::Program& own, GLuint slabs) {
      own.set("directionCount", directions)
          .set("cellCount", cells)
          .set("firstDirection", firstOne)
          .use();
      glDispatchCompute(groups(cells.x, 8), groups(cells.y * cells.z, 4), slabs);
      glMemoryBarrier(GL_ALL_BARRIER_BITS);
    };
    if (volume) {
      volume_.bindImage(0, GL_WRITE_ONLY);
      dispatch(volumeProgram_, count / static_cast<GLuint>(q.eclipseTurns));
    }
    radiances_.bindImage(0, GL_WRITE_ONLY);
    dispatch(program, count);
  }
}

void EclipsedSolver::findUneclipsed(const AirTables& tables) {
  auto const& q = tables.quality();
  auto const layers = static_cast<GLuint>(tables.layers());
  glm::ivec2 const directions(q.eclipseZeniths, q.eclipseTurns);
  glm::ivec3 const cells(kUneclipsedHeights, 1, q.eclipseHeights);
  int const rows = q.eclipseZeniths + kEclipsedRises;
  auto const program = [&](const char* path, std::initializer_list<const char*> flags) {
    auto found = gl::Program::compute(path, inShadow(tables, flags));
    found.set("directionCount", directions).set("cellCount", cells);
    return found;
  };
  auto const phases = program("precompute/eclipsed_phases.comp", {"UNECLIPSED"});
  auto const radiance =
      program("precompute/eclipsed_radiance.comp", {"AIR_SINGLE", "AIR_SOURCE", "UNECLIPSED"});
  auto const hold = program("precompute/eclipsed_hold.comp", {"UNECLIPSED"});
  auto const shares = program("precompute/eclipsed_shares.comp", {"AIR_SOURCE", "UNECLIPSED"});
  phases_ = gl::Texture::layers(GL_RGBA32F, q.eclipseZeniths, rows,
                                (q.eclipseTurns + 1) * cells.z * tables.layers());
  uneclipsed_ = gl::Texture::layers(GL_RGBA32F, cells.x, cells.z, 2 * tables.layers());
  scattered_ = gl::Texture::layers(GL_RGBA32F, cells.x, cells.z,
                                   2 * kEclipsedRises * eclipsedTurns(q) * tables.layers());
  tables.bind();
  nodes_.bind();
  zeniths_.bindUniform(4);
  phases.use();
  phases_.bindImage(0, GL_WRITE_ONLY);
  glDispatchCompute(groups(rows, 8), static_cast<GLuint>(cells.z), layers);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  gather(tables, radiance, cells, false);
  hold.use();
  radiances_.bindImage(0, GL_READ_ONLY);
  uneclipsed_.bindImage(1, GL_READ_WRITE);
  glDispatchCompute(groups(cells.x, 8), groups(cells.z, 4), layers);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  shares.use();
  radiances_.bind(10);
  phases_.bind(14);
  scattered_.bindImage(0, GL_WRITE_ONLY);
  glDispatchCompute(groups(cells.x, 8), groups(cells.z, 4), kEclipsedRises);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

gl::Texture EclipsedSolver::solve(const AirTables& tables, const glsl::ShadowPair& pair) {
  auto const& q = tables.quality();
  glm::ivec3 const cells(q.eclipseDistances, q.eclipseAzimuths, q.eclipseHeights);
  glm::ivec2 const directions(q.eclipseZeniths, q.eclipseTurns);
  GLuint const columns = groups(cells.x, 8), rows = groups(cells.y * cells.z, 4);
  struct Block {
    EclipsedAxisBlock axis;
    glm::vec4 shape;
  };
  block_.write(Block{eclipsedAxisBlock(pair, 1.0, tables), eclipsedShape(tables)});
  shadows_.update({pair});
  tables.bind();
  shadows_.bind();
  nodes_.bind();
  zeniths_.bindUniform(4);
  block_.bindUniform(9);
  light_.bind(10);
  uneclipsed_.bind(11);
  held_.bind(12);
  volume_.bind(13);
  phases_.bind(14);
  auto const hold = [&](int stage) {
    hold_.set("directionCount", directions).set("cellCount", cells).set("stage", stage).use();
    radiances_.bindImage(0, GL_READ_ONLY);
    held_.bindImage(1, GL_READ_WRITE);
    first_.bindImage(2, GL_READ_WRITE);
    lastStep_.bindImage(3, GL_READ_WRITE);
    light_.bindImage(4, GL_WRITE_ONLY);
    glDispatchCompute(columns, rows, static_cast<GLuint>(tables.layers()));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glFlush();
  };
  gather(tables, single_, cells, false);
  hold(1);
  for (int order = 2; order <= q.eclipseOrders; ++order) {
    gather(tables, next_, cells, true);
    hold(order < q.eclipseOrders ? 2 : 3);
  }
  gl::Texture grid = eclipsedGrid(tables, GL_RGBA16F, 1);
  shares_.set("directionCount", directions).set("cellCount", cells).use();
  scattered_.bind(13);
  lastStep_.bindImage(3, GL_READ_ONLY);
  grid.bindImage(4, GL_WRITE_ONLY);
  glDispatchCompute(columns, rows, kEclipsedRises);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  glFlush();
  return grid;
}

}  // namespace antumbra
