#include "scene/footing.h"

#include <GeographicLib/Geocentric.hpp>
#include <vector>

namespace antumbra {

Footing footingOn(const Body& body, Angle latitude, Angle longitude, Length height) {
  double const a = body.equatorialRadius.si;
  GeographicLib::Geocentric const spheroid(a, 1.0 - body.polarRadius.si / a);
  double x = 0, y = 0, z = 0;
  std::vector<double> m(9);
  spheroid.Forward(latitude / degree, longitude / degree, height / metre, x, y, z, m);
  // GeographicLib's matrix is row-major and turns local (east, north, up) into body axes.
  glm::dmat3 const bodyFromEnu{{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}};
  return {{{x, y, z}}, {glm::transpose(bodyFromEnu)}};
}

}  // namespace antumbra
