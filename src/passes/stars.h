// Point sources: stars, and planets below a pixel. Each is spread over 4x4 pixels by a kernel that
// conserves flux and centroid (shaders/shared/point_spread.glsl) and divided by the pixel's own
// solid angle, so that the sum of luminance times solid angle over the picture is its illuminance
// in every projection. Measured (tests/passes/stars_gl_test.cpp): flux within 0.1 % (0.5 % beside
// the pole of an equirectangular picture), position within 0.02 pixel. Nothing hides a star by day
// but the sky.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "gl/buffer.h"
#include "gl/program.h"
#include "passes/glare.h"
#include "view/projection.h"

namespace antumbra {

// As it lies in the vertex buffer.
struct StarPoint {
  glm::vec3 direction;       // unit vector towards the apparent place, camera axes
  glm::vec3 illuminanceLux;  // linear sRGB, on a surface facing it
};

class StarsPass {
 public:
  explicit StarsPass(ProjectionKind kind);
  ~StarsPass();
  StarsPass(const StarsPass&) = delete;
  StarsPass& operator=(const StarsPass&) = delete;

  // Adds the points to the bound framebuffer, whose viewport is the whole target; alpha stays. The
  // view block is bound at 0. Leaves blending and depth test off.
  void draw(std::span<const StarPoint> points);

  // Adds the halos (shaders/shared/glare.glsl) of the points whose light the eye spreads over more
  // than three pixels at `faintestLuminance`: what makes a bright star look larger than a faint
  // one. On top of `draw`, which keeps all of a point's light: up to a quarter of it more.
  // Conditions as for `draw`; returns how many halos there are.
  int drawHalos(const Projection& projection, std::span<const StarPoint> points,
                const Eye& eye = {}, double faintestLuminance = 1.0e-4);

 private:
  void drawInstances(std::span<const StarPoint> points, const gl::Program& program, int rounds);
  ProjectionKind kind_;
  gl::Program program_, halo_;
  gl::Buffer vertices_;
  GLuint vertexArray_ = 0;
};

}  // namespace antumbra
