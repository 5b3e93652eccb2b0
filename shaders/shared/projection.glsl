// Image point to view direction and back, for each projection. Camera axes: x right, y up, forward
// along -z. An image point is in [-1, 1] on both axes, y up; directions that a projection makes are
// exact but for rounding.
//
// Perspective: gnomonic, `extent` the tangents of the half fields.
// Fisheye: azimuthal equidistant (the dome master): angle from the axis proportional to the distance
// from the image's centre, `halfAperture` at distance 1.
// Equirectangular: longitude (to the right of forward) and latitude (up) proportional to x and y.
#ifndef SHARED_PROJECTION_GLSL
#define SHARED_PROJECTION_GLSL
#include "shared/quantities.glsl"

struct ViewRay {
  Direction direction;  // perspective: scaled so that z is -1, else a unit vector
  Number inside;        // 1 within the picture, 0 in a fisheye's mask
};

struct ImagePoint {
  Number x;
  Number y;
  Number inside;  // 1 if the direction falls into the picture's plane (not behind a perspective)
};

ViewRay perspectiveRay(Number x, Number y, Number extentX, Number extentY) {
  ViewRay ray;
  ray.direction = Direction(x * extentX, y * extentY, -1.0);
  ray.inside = 1.0;
  return ray;
}

ViewRay fisheyeRay(Number x, Number y, Angle halfAperture) {
  Number radius = sqrt(x * x + y * y);
  Angle off = min(radius * halfAperture, kPi);
  // sin(off)/radius, finite at the centre.
  Number scale = radius > 1.0e-6 ? sin(off) / radius : halfAperture;
  ViewRay ray;
  ray.direction = Direction(x * scale, y * scale, -cos(off));
  ray.inside = radius <= 1.0 ? 1.0 : 0.0;
  return ray;
}

ViewRay equirectangularRay(Number x, Number y) {
  Angle longitude = x * kPi;
  Angle latitude = y * 0.5 * kPi;
  ViewRay ray;
  ray.direction = Direction(cos(latitude) * sin(longitude), sin(latitude),
                            -cos(latitude) * cos(longitude));
  ray.inside = 1.0;
  return ray;
}

ImagePoint perspectivePoint(Direction d, Number extentX, Number extentY) {
  ImagePoint point;
  Number depth = max(-d.z, 1.0e-12);
  point.x = d.x / (depth * extentX);
  point.y = d.y / (depth * extentY);
  point.inside = d.z < 0.0 ? 1.0 : 0.0;
  return point;
}

ImagePoint fisheyePoint(Direction d, Angle halfAperture) {
  Number across = sqrt(d.x * d.x + d.y * d.y);
  Angle off = atan(across, -d.z);
  Number scale = across > 1.0e-9 ? off / (across * halfAperture) : 1.0 / halfAperture;
  ImagePoint point;
  point.x = d.x * scale;
  point.y = d.y * scale;
  point.inside = off <= halfAperture ? 1.0 : 0.0;
  return point;
}

ImagePoint equirectangularPoint(Direction d) {
  ImagePoint point;
  point.x = atan(d.x, -d.z) / kPi;
  point.y = 2.0 * atan(d.y, sqrt(d.x * d.x + d.z * d.z)) / kPi;
  point.inside = 1.0;
  return point;
}
#endif
