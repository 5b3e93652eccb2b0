// The sky table of a camera low in the air: light from every direction, computed anew for each
// camera, Sun and shadow. Its cost does not depend on the picture's size.
#pragma once

#include <glm/glm.hpp>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "passes/air_tables.h"

namespace antumbra {

class AirSky {
 public:
  // `shadowDefinitions`: SHADOW_PAIRS where casters may be seen, else empty.
  AirSky(const AirTables& tables, const gl::Definitions& shadowDefinitions);
  // Cameras up to this height above the ground use the table; higher ones march per pixel.
  static bool serves(const AirTables& tables, Length cameraHeight) {
    return cameraHeight.si < 0.2 * tables.top().si;
  }
  // `up` and `sun`: unit vectors of the zenith and the Sun in scaled space. With shadows, their
  // blocks and tables are bound already. Leaves the air's tables bound.
  void update(const AirTables& tables, Length cameraHeight, const glm::dvec3& up,
              const glm::dvec3& sun);
  // Uniform block 6, texture units 6 and 7.
  void bind() const;
  std::size_t bytes() const { return joint_.bytes() + (peaked_ ? peaked_.bytes() : 0); }

 private:
  gl::Program program_;
  gl::Texture joint_, peaked_;
  gl::Buffer block_;
  QuadratureBlock nodes_;
  bool wholeTurn_;
};

}  // namespace antumbra
