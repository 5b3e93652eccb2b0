// The phase function of a constituent: an analytic form of shaders/shared/phase.glsl whose
// parameters may depend on wavelength, or a table over the scattering angle, or Legendre moments.
// Always in 1/sr with unit integral over the sphere.
#pragma once

#include <vector>

#include "photometry/spectrum.h"
#include "quantity/quantity.h"

namespace antumbra {

class PhaseFunction {
 public:
  enum class Kind {
    kIsotropic,
    kRayleigh,
    kHenyeyGreenstein,
    kCornetteShanks,
    kDoubleHenyeyGreenstein,
    kTable
  };
  PhaseFunction() = default;  // isotropic
  static PhaseFunction isotropic() { return {}; }
  static PhaseFunction rayleigh();
  // g in (-1, 1) at every wavelength; throws InputError otherwise.
  static PhaseFunction henyeyGreenstein(Spectrum g);
  static PhaseFunction cornetteShanks(Spectrum g);
  static PhaseFunction doubleHenyeyGreenstein(Spectrum forwardG, Spectrum backwardG,
                                              Spectrum forwardShare);
  // Values (any unit; normalised here) at angles from 0 to 180 degrees, linear in the angle
  // between.
  static PhaseFunction table(std::vector<Angle> angles, std::vector<double> values);
  // p = 1/(4 pi) sum_l (2l + 1) moments[l] P_l(cosine), moments[0] = 1; throws where it is
  // negative.
  static PhaseFunction legendre(std::vector<double> moments);

  double at(Length wavelength, double cosine) const;  // 1/sr
  // Mean cosine of the scattering angle; relative error 1e-6 (table: of its interpolation).
  double meanCosine(Length wavelength) const;

  Kind kind() const { return kind_; }
  // Parameters of the analytic kinds: g, or forward and backward g and the share of the forward
  // lobe.
  const Spectrum& forwardG() const { return forwardG_; }
  const Spectrum& backwardG() const { return backwardG_; }
  const Spectrum& forwardShare() const { return forwardShare_; }
  // Nodes of a table, radians and 1/sr.
  const std::vector<double>& anglesRadians() const { return angles_; }
  const std::vector<double>& values() const { return values_; }
  // The span of wavelengths in which the parameters are known.
  Length firstWavelength() const;
  Length lastWavelength() const;

 private:
  Kind kind_ = Kind::kIsotropic;
  Spectrum forwardG_, backwardG_, forwardShare_;
  std::vector<double> angles_, values_;
};

}  // namespace antumbra
