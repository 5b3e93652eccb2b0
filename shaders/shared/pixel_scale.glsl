// Solid angle of a pixel, sr, for each projection: what turns an illuminance into the luminance of
// the pixel that holds it. The midpoint value of the exact density; within 1e-5 of the pixel's
// integral for pixels below a degree.
//   perspective      d(omega) = dx dy / (1 + x^2 + y^2)^(3/2) for tangents x, y
//   fisheye          sin(off) / off for an azimuthal equidistant map
//   equirectangular  cos(latitude)
#ifndef SHARED_PIXEL_SCALE_GLSL
#define SHARED_PIXEL_SCALE_GLSL
#include "shared/quantities.glsl"

// `ray` has z = -1, as perspectiveRay makes it; width and height in pixels.
Number perspectivePixelSolidAngle(Direction ray, Number extentX, Number extentY, Number width,
                                  Number height) {
  Number squared = dot(ray, ray);
  return 4.0 * extentX * extentY / (width * height * squared * sqrt(squared));
}

// `radius` is the distance from the image's centre, 1 at `halfAperture`.
Number fisheyePixelSolidAngle(Number radius, Angle halfAperture, Number width, Number height) {
  Angle off = min(radius * halfAperture, kPi);
  Number stretch = off > 1.0e-3 ? sin(off) / off : 1.0 - off * off / 6.0;
  return 4.0 * halfAperture * halfAperture * stretch / (width * height);
}

// `ray` is a unit vector, y up.
Number equirectangularPixelSolidAngle(Direction ray, Number width, Number height) {
  Number cosLatitude = sqrt(ray.x * ray.x + ray.z * ray.z);
  return 2.0 * kPi * kPi * cosLatitude / (width * height);
}
#endif
