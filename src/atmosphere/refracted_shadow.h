// Sunlight in the shadow of a body with air: the umbra is lit by what the air bends into it.
//
// Every ray from a point of the Sun crosses the body's limb at a distance b from its centre, is
// bent by the angle that the refractivity gives it and dimmed by what it crosses (limb_rays.h). At
// a distance L behind the centre it meets the plane across the shadow's axis at
//   y(b) = (b + L sin p) / cos p,   p = asin(b / D) - bending(b),   D the Sun's distance,
// negative where it has crossed the axis: the light of the ring b..b+db lies on the ring y..y+dy,
// focused and spread as that may be. A point of the Sun off the axis moves this pattern by L / D
// times its own distance from it. Summed over the limb-darkened disc, the irradiance over that of
// the free Sun at a distance rho from the axis is
//   (1 + L/D)^2 integral of T(b) b db  times  integral over the turn of I(|y - rho| D/L),
// without any caustic left. What passes above the air is the geometric penumbra, in the same sum,
// so that both join without a seam. Each wavelength has its own bending: dispersion.
//
// Independent check: rays traced through their differential equation and binned by brute force,
// within their noise, 3 % in the umbra and 1 % in the penumbra
// (tests/atmosphere/refracted_shadow_test.cpp).
//
// To be honest: the limb is a circle with the same air everywhere, so that clouds and aerosol dim
// it evenly; light scattered toward the shadow by the lit rim (about 2e-7 of sunlight at the Moon,
// less than 1 % of what is refracted except in the blue) is left out, and so are multiple turns
// about the body, and the Sun's lower limb darkened further by the Moon's own place off the ring.
#pragma once

#include <array>
#include <vector>

#include "atmosphere/limb_rays.h"
#include "eclipse/limb_darkening.h"
#include "medium/medium.h"

namespace antumbra {

// Where a shadow is asked for.
struct ShadowStation {
  Length sunRadius;
  Length sunDistance;  // from the Sun's centre to the caster's
  Length behind;       // from the caster's centre along the axis to the plane of the receiver
};

class RefractedShadow {
 public:
  // `ground`: the caster's radius; heights of the medium count from there.
  RefractedShadow(const Medium& medium, Length ground, const std::vector<Length>& wavelengths,
                  LimbDarkeningLaw law);
  // Irradiance across the Sun's direction over that of the free Sun, at each wavelength.
  std::vector<double> lightAt(const ShadowStation& station, Length distance) const;
  // Beyond this distance from the axis all light is free: the outer edge of the penumbra.
  Length reach(const ShadowStation& station) const;
  // Edge of the umbra of a solid body as high as the air; beyond that umbra's apex, 0.01 of the
  // reach.
  Length rim(const ShadowStation& station) const;
  const std::vector<Length>& wavelengths() const { return wavelengths_; }

 private:
  struct Disc {
    double exponent;
    std::array<double, 6> polynomial;
    double mean;
    std::array<double, 6> powers;  // cos^exponent of the arcs' nodes
  };
  double ringLight(const Disc& disc, double ring, double distance, double radius) const;
  double freeLight(const Disc& disc, double inner, double distance, double radius) const;

  std::vector<Length> wavelengths_;
  double ground_, top_;
  std::vector<std::vector<LimbNode>> nodes_;
  std::vector<Disc> discs_;
};

}  // namespace antumbra
