// Direct sunlight inside air that bends it: what arrives at a height from a Sun at a true zenith
// angle (that of its straight rays far away).
//
// In spherical air n r sin i = b is constant along a ray (Bouguer), i being its zenith angle. Seen
// from a height, the ray that leaves toward the Sun at the apparent zenith angle i comes from
//   z = i + bending,   bending = - b integral of (dn/dr)/n dr / sqrt(n^2 r^2 - b^2) to the top,
// and through the columns of limb_rays.h. Its irradiance over that of the free Sun, without
// extinction, follows from the energy between neighbouring rays:
//   n^2 (sin i / sin z) di/dz,
// which thins light that grazed dense air (twofold and more a few hundred kilometres past the
// limb). Rays are traced once by Gauss-Legendre quadrature, from their lowest points and from the
// ground; every height has its own list of them, read off into a table over height and z.
//
// Independent check: rays followed by their differential equation, tests/atmosphere
// (bent_sunlight_test.cpp), which also says how closely: light to 0.5 % down to a
// ten-thousandth of it.
//
// To be honest: dispersion is linear in the refractivity between its extremes; where a layering
// shows the Sun in several images only one is kept; an eclipsing Moon is seen along the straight
// way; scattering angles are those of the true Sun, 1.2 degrees off at most, as the drawn Sun is.
#pragma once

#include <cstddef>
#include <vector>

#include "medium/medium.h"

namespace antumbra {

// What one kind of light meets in a medium.
struct BentColour {
  double refractivity = 0.0;       // n - 1 at density 1 of the refracting constituent
  std::vector<double> extinction;  // 1/m at density 1, by constituent of the medium
};

class BentSunlight {
 public:
  // Whether the medium bends light at all, and so little that every ray that clears the ground
  // leaves the air again (not on Venus). Otherwise sunlight is taken to travel straight.
  static bool bends(const Medium& medium, Length ground);

  // `ground`: radius of the sphere below which rays end, `medium` heights count from `above` over
  // it (0 unless the camera is below the medium's own ground). Precondition: bends().
  BentSunlight(const Medium& medium, Length ground, Length above,
               const std::vector<BentColour>& colours);

  // Optical depth, with the logarithm of the thinning taken off; infinite where the ground hides
  // the Sun. `height` above the ground's sphere; `cosine` of the true zenith angle.
  double depth(std::size_t colour, double heightMetres, double cosine) const;
  // True less apparent zenith angle, rad. Precondition: the Sun is not hidden.
  double lift(std::size_t colour, double heightMetres, double cosine) const;
  // Cosine of the true zenith angle of the lowest ray that clears the ground.
  double horizonCosine(std::size_t colour, double heightMetres) const;

 private:
  struct Place;
  Place placeOf(std::size_t colour, double height, double cosine) const;
  double read(const std::vector<double>& table, const Place& place) const;

  double ground_, topHeight_, widest_;
  struct Sheet {
    std::vector<double> lowest;       // r cosine of the horizon's ray, by row
    std::vector<double> depth, lift;  // by row and column
  };
  std::vector<Sheet> sheets_;
};

}  // namespace antumbra
