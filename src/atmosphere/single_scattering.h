// Sunlight scattered once, or reflected once by the ground, along a straight ray through spherical
// air: the deterministic reference.
//
//   L / E0 = integral of T(camera, x) sum_c s_c(x) p_c(angle) T(x, Sun) share(x) ds
//          + T(camera, ground) (albedo / pi) cos(Sun) T(ground, Sun) share(ground)
//
// by adaptive Gauss-Legendre quadrature between the places where the integrand has kinks: heights
// of the profiles, the perigee, the edge of the body's own shadow, the cones of the occulters.
// Relative tolerance 1e-5 of the integral; optical depths within 4e-5 (spectral_medium.h). A Sun
// with a disc is summed over 4 x 8 directions. In a medium that refracts, sunlight comes along bent
// rays (bent_sunlight.h); the camera's ray is straight. No polarisation.
#pragma once

#include "atmosphere/spectral_medium.h"
#include "atmosphere/sunlight.h"

namespace antumbra {

// Share of light at `wavelength` that crosses the air from `point` to space along `direction`: 0
// where the ground is in the way. Adaptive to 1e-6 in the optical depth; any point, inside or
// outside the air or below the ground's sphere (then the ground lies at the point).
double transmittance(const Medium& medium, Position<AirFrame> point, Direction<AirFrame> direction,
                     Length wavelength);

class SingleScattering {
 public:
  // `groundRadius`: as for SpectralMedium.
  SingleScattering(const Medium& medium, const Sunlight& sun, Length wavelength,
                   Length groundRadius);
  // L / E0 in 1/sr of the ray that leaves `camera` along `direction`. The Sun's disc itself is not
  // in it. Any camera; one below the ground sees the ground.
  double radiance(Position<AirFrame> camera, Direction<AirFrame> direction) const;
  // Irradiance over E0 of a surface with this normal, by the Sun's direct light.
  double directIrradiance(Position<AirFrame> point, Direction<AirFrame> normal) const;
  // And by light scattered (or reflected) once, summed over hemisphereNodes.
  double diffuseIrradiance(Position<AirFrame> point, Direction<AirFrame> normal) const;

 private:
  SpectralMedium air_;
  std::vector<SunRay> rays_;
  SunShadow shadow_;
};

}  // namespace antumbra
