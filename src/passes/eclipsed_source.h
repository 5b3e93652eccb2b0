// Multiply scattered light inside the shadows on a body with air, for each caster as a grid that
// travels with the shadow's axis (shaders/interface/eclipsed_air.glsl).
//
// Grids are computed (EclipsedSolver) at fixed nodes over what changes in the course of an eclipse
// (eclipse/shadow_nodes.h), once each; an instant's grid is interpolated between the nodes around
// it. So it depends on the shadow alone, not on what was drawn before, and costs no solution of its
// own. What interpolation adds to the error: tests/passes/eclipsed_sky_gl_test.cpp. What several
// shadows leave together: eclipsed_union.h.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "passes/eclipsed_solver.h"
#include "passes/eclipsed_union.h"

namespace antumbra {

class EclipsedSource {
 public:
  // `casters`: how many shadows; those beyond what a volume holds leave scattered light as it is.
  // `betweenNodes`: false solves for each shadow itself, for measuring what interpolation costs.
  EclipsedSource(const AirTables& tables, LimbDarkeningLaw law, std::size_t casters,
                 bool betweenNodes = true);
  // `pairs`: about the body's centre, m, in the order of the shadows' block; `flattening`: polar
  // over equatorial radius. Returns how many nodes had to be computed.
  int update(const AirTables& tables, const std::vector<glsl::ShadowPair>& pairs,
             double flattening);
  // Of the programs that look the grids up.
  gl::Definitions definitions() const;
  // Uniform block 9, texture unit 10, and 14 where there are several casters.
  void bind() const;
  std::size_t bytes() const;
  double seconds() const { return seconds_; }  // of all nodes computed so far

 private:
  using Key = std::pair<std::array<double, 2>, std::array<long, 4>>;  // radii of Sun and caster
  struct Node {
    gl::Texture grid;
    long lastUse = 0;
  };
  const gl::Texture& node(const AirTables& tables, const Key& key, const glsl::ShadowPair& pair);

  LimbDarkeningLaw law_;
  int casters_, turns_;
  bool betweenNodes_;
  std::unique_ptr<EclipsedSolver> solver_;
  std::unique_ptr<EclipsedUnion> union_;  // of several casters
  std::map<Key, Node> nodes_;
  gl::Program mix_;
  gl::Buffer block_;
  gl::Texture grid_;
  long uses_ = 0;
  double seconds_ = 0.0;
};

}  // namespace antumbra
