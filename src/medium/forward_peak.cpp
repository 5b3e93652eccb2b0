#include "medium/forward_peak.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antumbra {
namespace {

constexpr double kPi = std::numbers::pi;
// Shares below this are not worth a peak.
constexpr double kLeastShare = 1e-3;
constexpr int kMostMoments = 640;
constexpr int kMostRestMoments = 400;
constexpr double kSmallMoment = 2e-3;
// Depth of the rest behind which nothing is seen.
constexpr double kDark = 20.0;

// Nodes of the sphere, dense forward: cosine = 1 - 2 x^4, midpoints of x in [0, xEnd].
struct Nodes {
  std::vector<double> cosines, areas;  // areas: of a ring over 1 steradian
  Nodes(double xEnd, int count) {
    for (int i = 0; i < count; ++i) {
      double const x = (i + 0.5) / count * xEnd, x3 = x * x * x;
      cosines.push_back(1.0 - 2.0 * x3 * x);
      areas.push_back(2.0 * kPi * 8.0 * x3 * xEnd / count);
    }
  }
  // Of the whole sphere, dense backward too.
  static Nodes whole(int count) {
    Nodes all(std::pow(0.5, 0.25), count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      all.cosines.push_back(-all.cosines[i]);
      all.areas.push_back(all.areas[i]);
    }
    return all;
  }
};

// Sum over nodes of values times P_l, l = 0 to `most`.
std::vector<double> moments(const Nodes& nodes, const std::vector<double>& values, int most) {
  std::vector<double> sum(static_cast<std::size_t>(most) + 1, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    double const x = nodes.cosines[i], v = values[i] * nodes.areas[i];
    double before = 1.0, now = x;
    sum[0] += v;
    for (int l = 1; l <= most; ++l) {
      sum[static_cast<std::size_t>(l)] += v * now;
      double const next = ((2 * l + 1) * x * now - l * before) / (l + 1);
      before = now;
      now = next;
    }
  }
  return sum;
}

}  // namespace

double legendreSum(const std::vector<double>& coefficients, double x) {
  double before = 1.0, now = x, sum = coefficients.empty() ? 0.0 : coefficients[0];
  for (std::size_t l = 1; l < coefficients.size(); ++l) {
    sum += coefficients[l] * now;
    auto const n = static_cast<double>(l);
    double const next = ((2.0 * n + 1.0) * x * now - n * before) / (n + 1.0);
    before = now;
    now = next;
  }
  return sum;
}

ForwardPeak::ForwardPeak(const PhaseFunction& phase, Length wavelength, int degree, bool apart)
    : phase_(phase), wavelength_(wavelength) {
  Nodes const all = Nodes::whole(1200);
  std::vector<double> values;
  for (double c : all.cosines) values.push_back(phase.at(wavelength, c));
  auto found = moments(all, values, degree + 1);
  double const norm = found[0];
  for (double& m : found) m /= norm;
  share_ = found.back();
  found.pop_back();
  restMoments_ = std::move(found);
  edgeValue_ = phase.at(wavelength, 1.0);
  if (!apart || share_ < kLeastShare) {
    share_ = 0.0;
    return;
  }
  // The peak's light inside an edge grows with the edge.
  auto const within = [&](double x) {
    double const edge = phase.at(wavelength, 1.0 - 2.0 * x * x * x * x);
    double sum = 0.0;
    Nodes const inside(x, 400);
    for (std::size_t i = 0; i < inside.cosines.size(); ++i)
      sum += inside.areas[i] * std::max(phase.at(wavelength, inside.cosines[i]) - edge, 0.0);
    return sum;
  };
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    double const middle = 0.5 * (low + high);
    (within(middle) < share_ ? low : high) = middle;
  }
  edgeCosine_ = 1.0 - 2.0 * high * high * high * high;
  edgeValue_ = phase.at(wavelength, edgeCosine_);
  // Light thrown straight back has such a moment too, but no forward peak.
  share_ = within(high);
  if (share_ < kLeastShare) {
    share_ = 0.0;
    return;
  }
  for (double& m : restMoments_) m -= share_;

  Nodes const inside(high, 1200);
  values.clear();
  for (double c : inside.cosines) values.push_back(peak(c));
  peakMoments_ = moments(inside, values, kMostMoments);
  double const total = peakMoments_[0];
  for (double& m : peakMoments_) m /= total;
  while (peakMoments_.size() > 3 && std::abs(peakMoments_.back()) < kSmallMoment)
    peakMoments_.pop_back();
  values.clear();
  for (double c : all.cosines) values.push_back(rest(c));
  allRestMoments_ = moments(all, values, kMostRestMoments);
}

double ForwardPeak::peak(double cosine) const {
  if (share_ == 0.0 || cosine <= edgeCosine_) return 0.0;
  return std::max(phase_.at(wavelength_, cosine) - edgeValue_, 0.0);
}

double ForwardPeak::rest(double cosine) const {
  return phase_.at(wavelength_, cosine) - peak(cosine);
}

double ForwardPeak::restByMoments(double cosine) const {
  double sum = rest(cosine);
  if (share_ == 0.0) return sum;
  std::vector<double> change(restMoments_.size(), 0.0);
  for (std::size_t l = 1; l < change.size(); ++l)
    change[l] =
        -share_ * (2.0 * static_cast<double>(l) + 1.0) / (4.0 * kPi) * (1.0 - peakMoments_[l]);
  return sum + legendreSum(change, cosine);
}

std::vector<double> blurredPhase(const ForwardPeak& own, const PeaksOnTheWay& way, double depth,
                                 const std::vector<double>& cosines) {
  auto const expOver = [](double x) {
    return std::abs(x) < 1e-6 ? 1.0 + 0.5 * x : std::expm1(x) / x;
  };
  auto const momentOf = [](const std::vector<double>& of, std::size_t l) {
    return l < of.size() ? of[l] : 0.0;
  };
  // What crosses no other peak keeps the sharp form; the change of the rest is smooth and summed by
  // moments.
  double const sharp = std::exp(-depth), share = own.share();
  auto const& q = own.peakMoments();
  auto const& r = own.allRestMoments();
  std::vector<double> change;
  for (std::size_t l = 0; l < std::max(q.size(), r.size()); ++l) {
    double const m = momentOf(way.peak, l), turned = depth * (1.0 - m);
    double sum = share * momentOf(q, l) *
                 (m > 0.0 ? std::exp(-turned) * expOver(-depth * m) - sharp
                          : sharp * (expOver(depth * m) - 1.0));
    if (l < own.restMoments().size())
      sum += share * (1.0 - momentOf(q, l)) * (expOver(-turned) - 1.0);
    else
      sum += momentOf(r, l) *
             (std::exp(-turned) * expOver(std::min(depth * momentOf(way.rest, l), kDark)) - 1.0);
    change.push_back((2.0 * static_cast<double>(l) + 1.0) / (4.0 * kPi) * sum);
  }
  while (!change.empty() && std::abs(change.back()) < 1e-6 * std::abs(change.front()))
    change.pop_back();
  std::vector<double> values;
  for (double c : cosines)
    values.push_back(std::max(own.rest(c) + sharp * own.peak(c) + legendreSum(change, c), 0.0));
  return values;
}

}  // namespace antumbra
