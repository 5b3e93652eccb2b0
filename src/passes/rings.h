// Rings of a planet: their own light and transparency, and their shadow on the globe.
//
// The rings are drawn from pixel direction in any projection (shaders/passes/rings.frag): light
// scattered once, on the lit and the unlit side (shaders/shared/rings.glsl), in the oblate globe's
// shadow with its penumbra, filtered over the pixel. Their shadow on the globe is the light that
// passes them, exp(-depth / sine of the Sun's height), averaged over the limb-darkened disc: a
// table over the radius and the width of the Sun's disc on the rings. Error of the table against
// rays to the disc: tests/picture/rings_gl_test.cpp.
#pragma once

#include <glm/glm.hpp>

#include "eclipse/limb_darkening.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "plan/planned_body.h"
#include "view/projection.h"

namespace antumbra {

enum class RingsHalf { BeyondGlobe, BeforeGlobe };

class Rings {
 public:
  // `wavelengths`: a multiple of four, those of the body's program. `exact`: tabulated for the very
  // instant; otherwise the table may be that of a slightly earlier one (live).
  Rings(const RingSystem& system, LimbDarkeningLaw law, const std::vector<Length>& wavelengths,
        const gl::Definitions& colourDefinitions, bool exact);
  // Geometry of the instant, and the picture's projection.
  void update(const PlannedBody& body, const Projection& picture);
  // Draws one half into the bound framebuffer; view block at 0, colours at 1, body block at 2.
  void draw(const PixelBounds& bounds, RingsHalf half, glm::ivec2 tileOrigin,
            glm::ivec2 targetSize) const;
  // For the globe's program: texture unit 13, and the block at 13.
  void bindShadow() const;
  bool belongsTo(LimbDarkeningLaw law) const { return law == law_; }
  std::size_t bytes() const { return profile_.bytes() + shadow_.bytes(); }

 private:
  void tabulateShadow(double sine);

  RingSystem system_;
  LimbDarkeningLaw law_;
  std::vector<Length> wavelengths_;
  gl::Definitions colourDefinitions_;
  bool exact_;
  std::map<ProjectionKind, gl::Program> programs_;
  ProjectionKind kind_ = ProjectionKind::Perspective;
  gl::Buffer block_, shadowBlock_;
  gl::Texture profile_, shadow_;
  double tabulatedSine_ = -1.0;
};

// Factor that gives (pi - phase)^n a mean of 1 over the sphere.
double ringPhaseNorm(double exponent);

}  // namespace antumbra
