// The scene at an instant: every body as it appears from the camera.
//
// Places are apparent, all alike: with light time and stellar aberration about the centre of the
// body that the camera stands on (its anchor), and seen from the camera by subtracting the camera's
// offset from that centre in double precision. To be honest: what a moving surface adds (diurnal
// aberration, 0.3") and the light time across the anchor (21 ms) are left out.
#pragma once

#include <string>
#include <vector>

#include "ephemeris/ephemeris.h"
#include "frame/frames.h"
#include "quantity/vector.h"
#include "scene/body_catalogue.h"
#include "scene/scene.h"
#include "time/delta_t.h"
#include "time/instant.h"
#include "view/projection.h"

namespace antumbra {

struct PlacedBody {
  const Body* body = nullptr;
  Displacement<Icrs> fromCamera;  // to the centre
  Displacement<Icrs> fromAnchor;  // centre of the anchor to the centre
  Rotation<BodyFixed, Icrs> bodyFromIcrs;
  Instant when;                    // at which the light left it
  Displacement<Icrs> sunFromBody;  // apparent, from its own centre at `when`
  // Other bodies near the line to the Sun, whose shadow may fall on it, apparent from its centre at
  // `when`.
  struct Neighbour {
    const Body* body = nullptr;
    Displacement<Icrs> fromBody;
    Direction<Icrs> pole;
  };
  std::vector<Neighbour> neighbours;
};

struct PlacedScene {
  Instant when;
  std::vector<PlacedBody> bodies;  // in the catalogue's order
  std::size_t anchor = 0;          // index of the body the camera stands on
  Displacement<Icrs> cameraFromAnchor;
  Velocity<Icrs> velocity;  // of the anchor about the solar system's barycentre
  Displacement<BodyFixed> cameraOnAnchor;
  Rotation<Enu, Icrs>
      enuFromIcrs;  // the camera's horizon: east, north, up by the spheroid's normal
  Rotation<CameraAxes, Icrs> cameraFromIcrs;
  std::string deltaTSource;
  Duration deltaT;
};

// Throws InputError for unknown bodies, a camera inside a body, dates outside the theory's span.
PlacedScene placeScene(const Scene& scene, Instant when, const BodyCatalogue& catalogue,
                       const Ephemeris& ephemeris, const DeltaT& deltaT);

}  // namespace antumbra
