// How a picture maps to directions: perspective, fisheye (the dome master) or equirectangular. The
// formulas are those of shaders/shared/projection.glsl, in double.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "quantity/vector.h"

namespace antumbra {

// Camera axes: x right, y up, the camera looks along -z. To be honest: a picture's pixels are
// sampled at their centres; nothing integrates over them but the analytic edges.
struct CameraAxes {};

enum class ProjectionKind { Perspective, Fisheye, Equirectangular };

struct Projection {
  ProjectionKind kind = ProjectionKind::Perspective;
  // Perspective: horizontal field, below 180 deg. Fisheye: full aperture, to 360 deg.
  Angle field{60.0 * degree.si};
  int width = 1280;
  int height = 720;

  // Throws InputError (opened by `where`) unless size and field are drawable.
  void check(const std::string& where) const;
  // Angle of a pixel at the centre of the picture.
  Angle pixelAngle() const;
  // Tangents of the half fields (perspective), half aperture in x (fisheye).
  glm::dvec2 extent() const;
  // Direction of a point in pixels (0, 0 the lower left corner); nothing in a fisheye's mask.
  std::optional<Direction<CameraAxes>> directionAt(double x, double y) const;
  // Pixel of a direction, nothing where the projection does not show it. May lie outside the size.
  std::optional<glm::dvec2> pixelOf(Direction<CameraAxes> direction) const;
};

const char* nameOf(ProjectionKind kind);

// Smallest rectangle of pixels, clipped to the picture, that holds a cap of directions.
struct PixelBounds {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // half open
  bool empty() const { return x1 <= x0 || y1 <= y0; }
};
PixelBounds boundsOfCap(const Projection& projection, Direction<CameraAxes> centre, Angle radius);

}  // namespace antumbra
