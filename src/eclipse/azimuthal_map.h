// The ground of an eclipse's map: the Lambert azimuthal equal-area projection about a place, the
// land of catalogs/eclipse/coastline.txt (Natural Earth) and the graticule.
#pragma once

#include <glm/glm.hpp>

#include "eclipse/drawing.h"
#include "eclipse/drawn_labels.h"
#include "geodesy/site.h"

namespace antumbra {

class AzimuthalMap {
 public:
  // Place on the map in polar form: `radius` in pixels from its centre, `bearing` clockwise from
  // north.
  struct Polar {
    double radius = 0.0, bearing = 0.0;
  };

  // A disc of `radius` pixels about `pixelCentre` that reaches `reach` from `centre` (less than
  // 180 degrees).
  AzimuthalMap(const Site& centre, Angle reach, glm::dvec2 pixelCentre, double radius);

  Polar polar(double latitudeDegrees, double longitudeDegrees) const;
  glm::dvec2 pixel(const Polar& p) const;
  glm::dvec2 pixel(const Site& s) const;
  bool shows(const Site& s) const;
  double radius() const { return radius_; }
  glm::dvec2 pixelCentre() const { return pixelCentre_; }
  const Site& centre() const { return centre_; }
  // A circle about the map's centre, in pixels.
  std::vector<glm::dvec2> circle(double radius) const;

 private:
  Site centre_;
  glm::dvec2 pixelCentre_;
  double radius_, scale_;
};

// Throws InputError if the file of the coast cannot be read.
void addLand(Drawing& drawing, const AzimuthalMap& map);
void addGraticule(Drawing& drawing, const AzimuthalMap& map);
// The numbers of the graticule, where they are free of what is already written.
void labelGraticule(DrawnLabels& labels, const AzimuthalMap& map);

}  // namespace antumbra
