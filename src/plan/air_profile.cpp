#include "plan/air_profile.h"

#include <algorithm>
#include <cmath>

namespace antumbra {
namespace {

constexpr int kHeights = 400, kSteps = 48;

}  // namespace

AirProfile::AirProfile(const Medium& medium, Length wavelength) : top_(medium.topHeight.si) {
  for (int i = 0; i < kHeights; ++i) {
    Length const height(top_ * std::pow(double(i) / (kHeights - 1), 2.0) * 0.999999);
    double scattering = 0.0;
    for (auto const& c : medium.coefficientsAt(height, wavelength)) scattering += c.scattering.si;
    both_.emplace_back(scattering, medium.extinctionAt(height, wavelength).si);
  }
}

glm::dvec2 AirProfile::at(double heightMetres) const {
  double const x = std::sqrt(std::clamp(heightMetres / top_, 0.0, 1.0)) * (kHeights - 1);
  auto const i = std::min(static_cast<std::size_t>(x), both_.size() - 2);
  return glm::mix(both_[i], both_[i + 1], x - static_cast<double>(i));
}

double AirProfile::passed(double radius, double cosine, double ground) const {
  double const nearest = radius * std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  if (cosine < 0.0 && nearest < ground) return 0.0;
  double const highest = ground + top_;
  double const from = radius * cosine;
  double const to = std::sqrt(std::max(highest * highest - nearest * nearest, 0.0));
  double depth = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    // Dense at the lowest point of the way.
    auto const place = [&](double u) {
      return cosine >= 0.0 ? from + (to - from) * u * u
                           : (u < 0.5 ? from * std::pow(1.0 - 2.0 * u, 2.0)
                                      : to * std::pow(2.0 * u - 1.0, 2.0));
    };
    double const a = place(double(i) / kSteps), b = place(double(i + 1) / kSteps);
    depth += at(std::hypot(0.5 * (a + b), nearest) - ground).y * (b - a);
  }
  return std::exp(-depth);
}

}  // namespace antumbra
