// The halo that the visible Sun draws in the eye: the CIE glare function without its core
// (shaders/shared/glare.glsl), added in direction space, so that every projection and every channel
// of a dome shows the same. Near the Sun it is the sum over up to 64 parts of what is visible (a
// crescent's halo is a crescent's), elsewhere that of a point at the centroid. Its flux is that of
// the visible sunlight times haloShare, within 2 %; beside a crescent within 3 % of the sum over
// all its points (measured: tests/passes/glare_gl_test.cpp).
#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "passes/sun_occlusion.h"
#include "passes/sun_plane.h"
#include "view/projection.h"

namespace antumbra {

// Whose eye. CIE 135/1: age in years, 20 to 80; pigmentation of the iris from 0 (dark brown) by 0.5
// (brown) and 1 (light blue) to 1.2.
struct Eye {
  double ageYears = 35.0;
  double pigmentation = 0.5;
  // The eye's angle over the sky's, 1 or more: a picture of a small field is a view through a
  // telescope, whose halo is as much smaller.
  double magnification = 1.0;
  // Throws InputError (opened by `where`) outside the function's span.
  void check(const std::string& where) const;
};

// As a picture is mostly looked at: fields below 60 degrees are magnified to that.
double magnificationOf(const Projection& projection);

// Share of a point's light that its halo holds, over the whole sphere.
double haloShare(const Eye& eye);

class GlarePass {
 public:
  explicit GlarePass(ProjectionKind kind);

  // Adds to the bound framebuffer, last of all light; conditions as for SunPass::draw. `sunlight`:
  // what the unhidden Sun would send to the camera through the air before it, lux in linear sRGB.
  // The Sun may lie outside the picture. Returns false, and draws nothing, where nothing of the Sun
  // is visible. Prepares a small table first, for which it binds another framebuffer and back.
  bool draw(const Projection& projection, const SunPlane& plane, const VisibleSun& visible,
            glm::dvec3 sunlight, const Eye& eye = {});

 private:
  gl::Program near_, halo_;
  gl::Texture nearTable_;
  gl::Framebuffer nearTarget_;
};

}  // namespace antumbra
