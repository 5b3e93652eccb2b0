// A phase function as a smooth rest, of which a few Legendre moments tell enough, and a forward
// peak that hardly turns the light: the separation by which few moments do for thick hazes.
//
//   p = rest + peak,  peak(angle) = p(angle) - p(edge) inside `edge`, 0 outside
//
// (truncation: Potter 1970, J. Atmos. Sci. 27, 943). The edge is where the peak holds the share f
// of the light that the delta-M method would (Wiscombe 1977, J. Atmos. Sci. 34, 1408): the first
// Legendre moment that the tables leave out. Light scattered many times counts the peak as no
// scattering at all; light scattered once keeps it, spread as what lies on its way spreads it
// (`blurredPhase`).
#pragma once

#include <vector>

#include "medium/phase_function.h"

namespace antumbra {

class ForwardPeak {
 public:
  // `degree`: of the moments that are kept. `apart`: whether there may be a peak at all. It counts
  // light that the peak turns by some degrees as going straight on, which thin air near a bright
  // horizon forgives less than the moments that are missing.
  ForwardPeak(const PhaseFunction& phase, Length wavelength, int degree, bool apart = true);
  double share() const { return share_; }  // f, 0 to 1
  // Moments 0 to degree of p less f: of what turns the light. Sum to 1 - f at degree 0.
  const std::vector<double>& restMoments() const { return restMoments_; }
  // p without the peak, 1/sr; its integral is 1 - f.
  double rest(double cosine) const;
  // The same with its moments up to `degree` made those of restMoments(): negative here and there.
  double restByMoments(double cosine) const;
  double peak(double cosine) const;  // 1/sr, its integral is f
  // Legendre moments of the peak over f, from 0 until they are small; empty where f is 0.
  const std::vector<double>& peakMoments() const { return peakMoments_; }
  // Those of rest(), as many as are not small; empty likewise.
  const std::vector<double>& allRestMoments() const { return allRestMoments_; }

 private:
  PhaseFunction phase_;
  Length wavelength_;
  double share_ = 0.0, edgeCosine_ = 1.0, edgeValue_ = 0.0;
  std::vector<double> restMoments_, peakMoments_, allRestMoments_;
};

// What lies on the way of light through all constituents together, from the ground to the top.
struct PeaksOnTheWay {
  double depth = 0.0;        // vertical optical depth of their peaks
  std::vector<double> peak;  // peakMoments(), mean by what each scatters into its peak
  std::vector<double> rest;  // allRestMoments(), mean by what each scatters, over the mean share
};

// The phase function by which light scattered once is seen after peaks of the optical depth t on
// its way, the Sun's and the camera's together; at the cosines given, 1/sr.
//
// For small angles and even air the moments of all light that left the Sun's direction are
// exp(-T (1 - p_l)) - exp(-T), T the depth of all scattering. Of them the tables hold what is
// scattered twice and more by moments up to `degree`, exp(-T (1 - f)) (exp(R_l) - 1 - R_l) with
// R_l = T (p_l - f). What this leaves is seen here, over T exp(-T (1 - f)). With m_l the moments
// of the mean peak and d_l = t (1 - m_l) it is, for one constituent (q_l its peak's, r_l its
// rest's),
//   f q_l (exp(-d_l) - exp(-t)) / (t m_l)             light that peaks alone have turned, and
//   r_l + f (1 - q_l) ((1 - exp(-d_l)) / d_l - 1)     for l up to `degree`,
//   r_l exp(-d_l) (exp(X_l) - 1) / X_l                beyond, X_l = t times the mean of r_l over f.
std::vector<double> blurredPhase(const ForwardPeak& own, const PeaksOnTheWay& way, double depth,
                                 const std::vector<double>& cosines);

// Sum of coefficients[l] P_l(x).
double legendreSum(const std::vector<double>& coefficients, double x);

}  // namespace antumbra
