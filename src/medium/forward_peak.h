// A phase function as a smooth rest, of which a few Legendre moments tell enough, and a forward
// peak that hardly turns the light: the separation by which few moments do for thick hazes.
//
//   p = rest + peak,  peak(angle) = p(angle) - p(edge) inside `edge`, 0 outside
//
// (truncation: Potter 1970, J. Atmos. Sci. 27, 943). The edge is where the peak holds the share f
// of the light that the delta-M method would (Wiscombe 1977, J. Atmos. Sci. 34, 1408): the first
// Legendre moment that the tables leave out. Light scattered many times counts the peak as no
// scattering at all; light scattered once keeps it, spread as the peaks on its way spread it
// (`blurredPeak`).
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

 private:
  PhaseFunction phase_;
  Length wavelength_;
  double share_ = 0.0, edgeCosine_ = 1.0, edgeValue_ = 0.0;
  std::vector<double> restMoments_, peakMoments_;
};

// The peak of one constituent after light has crossed peaks of the optical depth t (all
// constituents', along the Sun's way and the camera's together). Of n peaks passed each is the
// scattering in hand once in n times, so that in Legendre moments, with q those of the constituent
// and m the mean of all,
//   K_l = q_l exp(-t) (exp(t m_l) - 1) / (t m_l),
// exact for small angles and even depth. Times f, 1/sr; at the cosines given. Light that passes no
// peak is left out: exp(-t).
std::vector<double> blurredPeak(const ForwardPeak& own, const std::vector<double>& meanMoments,
                                double depth, const std::vector<double>& cosines);

}  // namespace antumbra
