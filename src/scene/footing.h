// A place on a body's spheroid (geodetic latitude, height along the normal; through GeographicLib)
// and the horizon there.
#pragma once

#include "frame/frames.h"
#include "quantity/vector.h"
#include "scene/body_catalogue.h"

namespace antumbra {

struct Footing {
  Displacement<BodyFixed> fromCentre;
  Rotation<Enu, BodyFixed> enuFromBody;  // east, north, up by the spheroid's normal
};

Footing footingOn(const Body& body, Angle latitude, Angle longitude, Length height);

}  // namespace antumbra
