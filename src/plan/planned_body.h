// One body as a pass draws it: geometry from the camera, in double precision and camera axes, ready
// to be narrowed to floats; nothing here is a difference of large numbers that a shader would redo.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "eclipse/shadow_pair.h"
#include "frame/frames.h"
#include "quantity/vector.h"
#include "scene/ring_system.h"
#include "view/projection.h"

namespace antumbra {

struct PlannedBody {
  std::string name;
  // From the camera to the body's centre: apparent (light time and aberration), camera axes.
  Displacement<CameraAxes> centre;
  Rotation<BodyFixed, CameraAxes> bodyFromCamera;
  Length equatorialRadius;
  Length polarRadius;
  // From the body's centre to the Sun as its light arrives there, body-fixed axes.
  Displacement<BodyFixed> sun;
  // What hides the Sun from it: casters with a live shadow, positions from the body's centre as
  // their shadow arrives, body-fixed axes.
  struct Caster {
    std::string name;
    Displacement<BodyFixed> centre;
    ShadowRadii radii;
    CasterFigure figure;
    std::string atmosphere;  // medium of its air, which bends light into the shadow, or empty
  };
  std::vector<Caster> casters;

  // Rings in its equatorial plane that are drawn, or whose shadow on it is.
  struct Rings {
    RingSystem system;
    PixelBounds bounds;       // empty: only their shadow is seen
    bool shadeGlobe = false;  // the globe is in the picture
    ShadowRadii globe;        // of the Sun and the globe, for its shadow on the rings
  };
  std::optional<Rings> rings;

  // Height of the camera above the spheroid in the space in which the body is a sphere of its
  // equatorial radius (axes scaled by equatorial/polar along the pole), from a double subtraction.
  Length cameraHeight;
  Angle angularRadius;        // as seen from the camera
  double diameterPixels = 0;  // in the picture
  PixelBounds bounds;         // of its disc (with its air)

  std::string map;            // file under catalogs/, or empty
  std::string atmosphere;     // medium file stem under catalogs/atmospheres, or empty
  glm::vec3 albedo{0.0f};     // linear sRGB Bond-like albedo where there is no map
  std::string waterMask;      // file under catalogs/, or empty: where the map shows water
  std::string nightMap;       // file under catalogs/, or empty
  double nightLuminance = 0;  // cd/m2 of the night map's full scale
  glm::vec3 mapFactor{1.0f};  // on the map's linear values, where the map is relative
  bool lommelSeeliger = false;
  // Light of the whole body at its phase angle from the camera over that at full phase, by its
  // magnitude law: what a Lommel-Seeliger sphere is scaled to.
  double phaseLight = 1.0;
  // Sunlight reflected toward it by the body that sends most: direction to that, body-fixed axes,
  // and illuminance in lux (0: none worth drawing).
  std::string shineFrom;
  Direction<BodyFixed> shineDirection{{0.0, 0.0, 1.0}};
  double shineLux = 0.0;
  bool cameraInAir = false;

  // Drawn after the Sun, which its air or rings dim.
  bool coversSunItself() const { return !atmosphere.empty() || rings; }
};

}  // namespace antumbra
