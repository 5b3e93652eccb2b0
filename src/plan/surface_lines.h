// Lines on a body's spheroid as a picture shows them: cut to pieces so fine that no chord strays
// from its curve by more than a tenth of a pixel, hidden behind the body's horizon and behind other
// bodies, parted where a projection parts. All in doubles from the camera's place, so that a line
// lies on the ground from two metres up as from the distance of the Moon.
//
// A point of the surface is seen exactly if the camera stands above its tangent plane: in the space
// in which the spheroid is a unit sphere, n . c > 1 with n the point and c the camera. Ends at the
// horizon are found to a fiftieth of a pixel. To be honest: refraction, which lifts a horizon by
// 0.6 degrees, is left out, as in the ground's own pixels; the ground is the spheroid.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geodesy/site.h"
#include "plan/planned_body.h"
#include "view/projection.h"

namespace antumbra {

// A curve along the surface of a body, as unit vectors of the space in which its spheroid is a unit
// sphere. Smooth ones run through their points as a cubic (Catmull & Rom 1974, by chord length);
// others straight from one to the next.
struct SurfaceCurve {
  std::vector<glm::dvec3> points;
  bool smooth = false;

  // `place` counts points from 0; precondition: 0 <= place <= points.size() - 1.
  glm::dvec3 at(double place) const;
};

class SurfaceLines {
 public:
  // `body` is one of `bodies`; the others may hide it.
  SurfaceLines(const Projection& picture, const PlannedBody& body,
               const std::vector<PlannedBody>& bodies);

  // Of a geodetic place at height 0 on the body's spheroid.
  glm::dvec3 unitOf(const Site& site) const;
  SurfaceCurve curveOf(const std::vector<Site>& sites, bool smooth) const;

  // What the picture shows of a curve, in pixels with y down from the upper left corner; points may
  // lie up to half the picture's size beyond its edges.
  std::vector<std::vector<glm::dvec2>> shown(const SurfaceCurve& curve) const;
  // Nothing where it is hidden or outside.
  std::optional<glm::dvec2> shownPoint(const glm::dvec3& unit) const;

 private:
  struct Seen {
    bool visible = false;
    glm::dvec3 unit{0.0};
    glm::dvec2 pixel{0.0};
    glm::dvec3 fromCamera{0.0};  // m
    double rise = 0.0;           // n . c - 1: above the horizon where positive
  };
  struct Occluder {
    glm::dmat3 unitFromCamera;
    glm::dvec3 camera;
  };
  Seen see(const glm::dvec3& unit) const;
  void trace(const SurfaceCurve& curve, double from, const Seen& a, double to, const Seen& b,
             int depth, std::vector<std::vector<glm::dvec2>>& strips) const;

  Projection picture_;
  glm::dmat3 cameraFromUnit_;  // metres of camera axes from units of the sphere
  glm::dvec3 camera_;          // units of the sphere
  double radius_ = 0.0;
  double flat_ = 1.0;
  std::vector<Occluder> occluders_;
};

}  // namespace antumbra
