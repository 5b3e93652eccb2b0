// Draws cones of shadow as translucent bodies over a picture in display colours, from each pixel's
// direction: any projection, from outside and from inside alike. Bodies in front hide them.
#pragma once

#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "plan/planned_body.h"
#include "plan/planned_cone.h"
#include "view/projection.h"

namespace antumbra {

class ConePass {
 public:
  explicit ConePass(ProjectionKind kind);
  // At most 4 cones; of the bodies the 16 largest in the picture take part.
  void prepare(const std::vector<PlannedCone>& cones, const std::vector<PlannedBody>& bodies);
  // Draws what was prepared last into the bound framebuffer; the view block is bound at 0. Blends
  // sRGB values as they are; leaves blending off.
  void draw() const;

 private:
  gl::Program program_;
  gl::Buffer cones_, solids_;
};

}  // namespace antumbra
