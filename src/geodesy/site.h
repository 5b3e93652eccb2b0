// Places on the Earth's ellipsoid (WGS84, through GeographicLib; accurate to 10 nm near the
// surface).
#pragma once

#include "frame/frames.h"
#include "quantity/vector.h"

namespace antumbra {

// Geodetic latitude and longitude (east positive), height above the ellipsoid.
struct Site {
  Angle latitude;
  Angle longitude;
  Length height;
};

Position<Itrs> itrsFromSite(const Site& site);
// The height may be anything above the centre's caustic (about 43 km); longitude in [-180, 180].
Site siteFromItrs(Position<Itrs> position);
Rotation<Enu, Itrs> enuFromItrs(const Site& site);

// Reads "LAT,LON,HEIGHT" in degrees, degrees (east positive) and metres; the height may be left
// out. Throws InputError: latitude -90 to 90, longitude -180 to 360, height -12 000 to 1e9 m.
Site parseSite(std::string_view text, const std::string& where);

// Azimuth from north through east in [0, 360) degrees, and altitude above the horizontal plane.
struct HorizontalDirection {
  Angle azimuth;
  Angle altitude;
};
HorizontalDirection horizontalFromEnu(Direction<Enu> direction);
Direction<Enu> enuFromHorizontal(HorizontalDirection h);

// How far the geometric horizon lies below the horizontal plane, for an eye at this height above a
// sphere of this radius: acos(R / (R + h)), in a form that keeps its digits for small h.
Angle horizonDip(Length heightAboveSphere, Length sphereRadius);
// Radius of curvature of WGS84 at this latitude in this azimuth (Euler): of the sphere that
// osculates there.
Length curvatureRadius(Angle latitude, Angle azimuth);

}  // namespace antumbra
