// The Sun's disc: limb darkened in every channel by the named law, absolute, antialiased. Its flux
// is the illuminance asked for within 0.5 % from three pixels of diameter up and 1 % at one, and a
// crescent's within 1 % of the closed form (measured: tests/passes/sun_gl_test.cpp); fields from
// 0.01 deg to a whole sphere. Bodies that cover it take part here, so that no light leaks where a
// pixel holds both limbs. Smaller than a pixel it is a star (passes/stars.h).
#pragma once

#include <span>

#include "gl/program.h"
#include "passes/sun_plane.h"
#include "view/projection.h"

namespace antumbra {

class SunPass {
 public:
  explicit SunPass(ProjectionKind kind);

  // Adds the disc to the bound framebuffer, whose viewport is the whole target and begins at
  // `tileOrigin` of the picture; alpha stays. The view block is bound at 0. `silhouettes` are those
  // of the plane. Leaves blending and depth and scissor tests off. To be drawn after the bodies
  // that have no air (their pixels are then exact) and before those that have (which dim it).
  // Returns false, and draws nothing, where the disc is not in the picture.
  bool draw(const Projection& projection, const SunInView& sun, const SunPlane& plane,
            std::span<const Silhouette> silhouettes, glm::ivec2 tileOrigin = {0, 0});

 private:
  gl::Program program_;
};

// Limits drawing to the pixels of a cap of directions. Returns false where none is in the target
// (whose size is the viewport's). The caller disables GL_SCISSOR_TEST afterwards.
bool scissorToCap(const Projection& projection, Direction<CameraAxes> centre, Angle radius,
                  glm::ivec2 tileOrigin);

// Adds colours, keeps alpha, no depth: for light that comes on top.
void blendAdditively();

}  // namespace antumbra
