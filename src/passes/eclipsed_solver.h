// Multiply scattered light about a shadow's axis, found by iterating the orders of scattering with
// the Sun's visible fraction at every scattering point, on a grid of cells (distance from the axis,
// azimuth about it, height). On the axis of a total eclipse this is all the light there is, from
// the air beyond the umbra, hundreds of kilometres away.
//
// An order: for every direction of the quadrature, the light that the cells hold is scattered into
// it once a cell (eclipsed_volume.comp) and gathered along rays (eclipsed_radiance.comp), to be
// held again, by direction (eclipsed_hold.comp). Few harmonics would not do: light comes from a
// narrow band along the horizon, and hazes turn little of it upward. So the phase functions
// themselves are averaged over it (eclipsed_phases.comp), for an order as for the grid, which has
// what is scattered toward each of its directions (eclipsed_shares.comp).
//
// Between cells the logarithms of light are linear, for in the umbra it falls tenfold in tens of
// kilometres. Where much of the Sun is seen the iteration starts from the share of the light
// without the eclipse; orders beyond the last are a geometric series of the last two. The grid
// keeps shares of the light without the eclipse, found with the same directions and samples, so
// that it joins the air around it. Measured errors: configs/quality/README.md.
#pragma once

#include "eclipse/limb_darkening.h"
#include "eclipse/shadow_pair.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "passes/air_tables.h"
#include "passes/body_shadows.h"

namespace antumbra {

// As interface/eclipsed_air.glsl has it.
struct EclipsedAxisBlock {
  glm::vec4 across, side, forward;
};
inline constexpr int kEclipsedRises = 11;  // zenith angles of the directions of a grid
inline constexpr int kEclipsedSlabs = kEclipsedRises + 1;  // of a grid, for each layer and height

// `pair`: about the body's centre; `flattening`: polar over equatorial radius.
EclipsedAxisBlock eclipsedAxisBlock(const glsl::ShadowPair& pair, double flattening,
                                    const AirTables& tables);
// Azimuths of the directions of a grid.
inline int eclipsedTurns(const AirQuality& quality) { return 2 * quality.eclipseTurns; }
// A grid without content.
gl::Texture eclipsedGrid(const AirTables& tables, GLenum format, int casters);
// Of the uniform block: scale of distances, heights, share of x inside the umbra, azimuths.
glm::vec4 eclipsedShape(const AirTables& tables);
// Distance of the shadow's axis from the body's centre in the space in which it is a sphere.
Length axisDistance(const glsl::ShadowPair& pair, double flattening);

class EclipsedSolver {
 public:
  EclipsedSolver(const AirTables& tables, LimbDarkeningLaw law, const glsl::ShadowPair& pair);
  // The grid for a pair in the axes of a ShadowNode.
  gl::Texture solve(const AirTables& tables, const glsl::ShadowPair& pair);

 private:
  void gather(const AirTables& tables, const gl::Program& program, glm::ivec3 cells, bool volume);
  void findUneclipsed(const AirTables& tables);

  BodyShadows shadows_;
  gl::Program single_, next_, volumeProgram_, hold_, shares_;
  QuadratureBlock nodes_;
  gl::Buffer block_, zeniths_;
  gl::Texture phases_, radiances_, light_, held_, first_, lastStep_, volume_, uneclipsed_,
      scattered_;
};

}  // namespace antumbra
