// Multiply scattered light inside a shadow: the source of scattering on a grid fixed to the
// shadow's axis (distance from it, azimuth about it, height), found by iterating the orders with
// the Sun's visible fraction at every scattering point. On the axis of a total eclipse this is all
// the light there is, from the air beyond the umbra, hundreds of kilometres away.
//
// The mean radiance and the irradiance are held as shares of their values without the eclipse, both
// found with the same directions and samples, so that the grid joins the uneclipsed air at its
// edge; the other moments up to degree 2 as ratios to the mean. The grid belongs to one place of
// the axis over the body (its distance from the centre, and the cones' radii): it is computed anew
// when those have moved by more than the tolerances below, not when the shadow merely travels.
// Several casters: the grid is the first one's; the visible fraction is that of all.
#pragma once

#include <glm/glm.hpp>

#include "eclipse/shadow_pair.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "passes/air_tables.h"
#include "passes/body_shadows.h"

namespace antumbra {

class EclipsedSource {
 public:
  // `exact`: computed anew whenever the shadow differs at all, so that a picture depends on nothing
  // drawn before it.
  EclipsedSource(const AirTables& tables, const BodyShadows& shadows, bool exact);
  // `pair`: the first caster's, receiver-centred metres; `sun`: unit vector in scaled space. The
  // shadows are up to date. Returns whether the grid was computed.
  bool update(const AirTables& tables, const BodyShadows& shadows, const glsl::ShadowPair& pair,
              const glm::dvec3& sun);
  // Of the programs that look the grid up.
  static gl::Definitions definitions() { return {{"ECLIPSED_SOURCE", ""}}; }
  // Uniform block 9, texture unit 10.
  void bind() const;
  std::size_t bytes() const { return grid_.bytes() + other_.bytes(); }
  double seconds() const { return seconds_; }  // of the last computation

 private:
  void compute(const AirTables& tables, const BodyShadows& shadows);

  gl::Program baseProgram_, firstProgram_, nextProgram_, moments_;
  QuadratureBlock nodes_;
  gl::Buffer block_, zeniths_;
  gl::Texture grid_, other_, radiances_, base_, first_;
  glsl::ShadowPair computedFor_{};
  bool exact_;
  bool computed_ = false;
  double seconds_ = 0.0;
};

}  // namespace antumbra
