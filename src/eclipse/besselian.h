// Besselian elements: the shadow on the plane through the geocentre across its axis, x to the east
// and y to the north, in equatorial radii of the Earth (Explanatory Supplement, 3rd edition, 11.3).
#pragma once

#include <array>

#include "eclipse/eclipse_search.h"

namespace antumbra {

struct BesselianElements {
  double x = 0.0, y = 0.0;    // equatorial radii
  double dDegrees = 0.0;      // declination of the axis
  double muDegrees = 0.0;     // hour angle of the axis at Greenwich, true
  double l1 = 0.0, l2 = 0.0;  // radii of penumbra and umbra; l2 negative where total
  double tanF1 = 0.0, tanF2 = 0.0;
};
BesselianElements besselianElements(const SunMoonTrack& track, const ShadowRadii& radii,
                                    double seconds);

// Polynomials of hours from a whole hour of TT near greatest eclipse, through least squares over
// three hours on either side: x, y, d, mu, l1 and l2 of third degree.
struct BesselianPolynomials {
  Instant reference;
  // In the order x, y, d, mu, l1, l2; coefficients of ascending powers.
  std::array<std::array<double, 4>, 6> coefficients{};
  std::array<double, 6> largestResidual{};  // in the units of each element
  double tanF1 = 0.0, tanF2 = 0.0;          // at the reference
  Duration deltaT;
};
BesselianPolynomials besselianPolynomials(const SolarEvent& event, const ShadowRadii& radii);

}  // namespace antumbra
