#include "passes/eclipsed_source.h"

#include <algorithm>
#include <chrono>

#include "eclipse/shadow_nodes.h"

namespace antumbra {
namespace {

constexpr int kMostSlabs = 2048;        // least that OpenGL 4.5 grants a volume
constexpr std::size_t kMostNodes = 64;  // kept; those longest unused go first

}  // namespace

EclipsedSource::EclipsedSource(const AirTables& tables, LimbDarkeningLaw law, std::size_t casters,
                               bool betweenNodes)
    : law_(law),
      betweenNodes_(betweenNodes),
      mix_(gl::Program::compute("precompute/eclipsed_mix.comp")) {
  auto const& q = tables.quality();
  int const slabs = kEclipsedSlabs * tables.layers() * q.eclipseHeights;
  casters_ = std::clamp(static_cast<int>(casters), 1, std::max(kMostSlabs / slabs, 1));
  turns_ = eclipsedTurns(q);
  grid_ = eclipsedGrid(tables, GL_RGBA32F, casters_);
}

gl::Definitions EclipsedSource::definitions() const {
  return {{"ECLIPSED_SOURCE", std::to_string(casters_)},
          {"ECLIPSED_TURNS", std::to_string(turns_)}};
}

const gl::Texture& EclipsedSource::node(const AirTables& tables, const Key& key,
                                        const glsl::ShadowPair& pair) {
  auto const found = nodes_.find(key);
  if (found != nodes_.end()) {
    found->second.lastUse = uses_;
    return found->second.grid;
  }
  if (nodes_.size() >= kMostNodes)
    nodes_.erase(std::min_element(nodes_.begin(), nodes_.end(), [](auto const& a, auto const& b) {
      return a.second.lastUse < b.second.lastUse;
    }));
  if (!solver_) solver_ = std::make_unique<EclipsedSolver>(tables, law_, pair);
  return (nodes_[key] = {solver_->solve(tables, pair), uses_}).grid;
}

int EclipsedSource::update(const AirTables& tables, const std::vector<glsl::ShadowPair>& pairs,
                           double flattening) {
  ++uses_;
  ShadowLattice lattice;
  lattice.umbraScale = 0.6 * tables.top();
  auto const& q = tables.quality();
  int computed = 0;
  std::vector<glm::vec4> block;
  for (int caster = 0; caster < casters_; ++caster) {
    auto const& pair = pairs[static_cast<std::size_t>(caster)];
    auto const axis = eclipsedAxisBlock(pair, flattening, tables);
    block.insert(block.end(), {axis.across, axis.side, axis.forward});
    Length const away = axisDistance(pair, flattening);
    if (!betweenNodes_) nodes_.clear();
    auto const nodes = betweenNodes_ ? shadowNodes(pair, away, tables.groundRadius(), lattice)
                                     : std::vector<ShadowNode>{{{}, 1.0, shadowAlone(pair, away)}};
    std::array<const gl::Texture*, 3> grids{};
    glm::vec3 weights(0.0f);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Key const key{{pair.sunRadius, pair.casterRadius}, nodes[i].key};
      bool const missing = !nodes_.count(key);
      auto const start = std::chrono::steady_clock::now();
      if (missing) glFinish();
      grids[i] = &node(tables, key, nodes[i].pair);
      weights[static_cast<int>(i)] = static_cast<float>(nodes[i].weight);
      if (!missing) continue;
      glFinish();
      seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      ++computed;
    }
    int const slabs = kEclipsedSlabs * tables.layers() * q.eclipseHeights;
    for (std::size_t i = 0; i < 3; ++i)
      (i < nodes.size() ? grids[i] : grids[0])->bind(static_cast<int>(i));
    mix_.set("weights", weights).set("firstSlab", caster * slabs).use();
    grid_.bindImage(0, GL_WRITE_ONLY);
    glDispatchCompute(static_cast<GLuint>((q.eclipseDistances + 7) / 8),
                      static_cast<GLuint>((grid_.height() + 3) / 4), static_cast<GLuint>(slabs));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
  }
  block.push_back(eclipsedShape(tables));
  block_.write(std::span<const glm::vec4>(block));
  if (casters_ > 1) {
    std::vector<glsl::ShadowPair> const held(pairs.begin(), pairs.begin() + casters_);
    if (!union_) union_ = std::make_unique<EclipsedUnion>(tables, law_, held, flattening);
    block_.bindUniform(9);
    union_->update(tables, held);
  }
  return computed;
}

void EclipsedSource::bind() const {
  block_.bindUniform(9);
  grid_.bind(10);
  if (union_) union_->bind();
}

std::size_t EclipsedSource::bytes() const {
  std::size_t sum = grid_.bytes() + (union_ ? union_->bytes() : 0);
  for (auto const& [key, node] : nodes_) sum += node.grid.bytes();
  return sum;
}

}  // namespace antumbra
