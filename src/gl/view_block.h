// The uniform block of a view (shaders/interface/view.glsl) and the definition that selects its
// projection in a program.
#pragma once

#include <glm/glm.hpp>

#include "gl/shader_source.h"
#include "view/projection.h"

namespace antumbra::gl {

struct ViewBlock {  // std140
  glm::vec2 imageSize;
  glm::vec2 tileOrigin;
  glm::vec2 extent;
  float pixelAngle;
  float unused;
};

inline ViewBlock viewBlockOf(const Projection& projection, glm::ivec2 tileOrigin = {0, 0}) {
  return {{projection.width, projection.height},
          tileOrigin,
          projection.extent(),
          static_cast<float>(projection.pixelAngle().si),
          0.0f};
}

inline Definitions projectionDefinition(ProjectionKind kind) {
  switch (kind) {
    case ProjectionKind::Fisheye:
      return {{"PROJECTION_FISHEYE", ""}};
    case ProjectionKind::Equirectangular:
      return {{"PROJECTION_EQUIRECTANGULAR", ""}};
    default:
      return {{"PROJECTION_PERSPECTIVE", ""}};
  }
}

// A direction as `viewSineTo` wants it: for a perspective scaled to |z| = 1, so that what the
// shader subtracts are tangents near the axis; else a unit vector.
inline glm::vec3 prepareDirection(ProjectionKind kind, Direction<CameraAxes> direction) {
  if (kind != ProjectionKind::Perspective || std::fabs(direction.u.z) < 1e-3) return direction.u;
  return direction.u / std::fabs(direction.u.z);
}

}  // namespace antumbra::gl
