// Corona and chromosphere as radiance around the Sun (shaders/shared/corona.glsl: profiles,
// sources, errors). They are always there; the photosphere, the sky and the display decide whether
// they show.
#pragma once

#include <span>

#include "gl/program.h"
#include "passes/sun_plane.h"
#include "view/projection.h"

namespace antumbra {

struct CoronaLook {
  // Phase of the solar cycle: 0 at minimum (flattened), 1 at maximum (round).
  double activity = 0.5;
  bool streamers = false;  // coronaStructure
  int prominences = 0;
};

class CoronaPass {
 public:
  explicit CoronaPass(ProjectionKind kind);

  // Adds to the bound framebuffer, before or after the disc; conditions as for SunPass::draw. The
  // corona ends at glsl::kCoronaEnd solar radii. Returns false where it is not in the picture.
  bool draw(const Projection& projection, const SunInView& sun, const SunPlane& plane,
            std::span<const Silhouette> silhouettes, const CoronaLook& look,
            glm::ivec2 tileOrigin = {0, 0});

 private:
  gl::Program program_;
};

}  // namespace antumbra
