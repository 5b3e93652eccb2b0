#include "atmosphere/refracted_shadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antumbra {
namespace {

constexpr double kPi = std::numbers::pi;

// Six-point Gauss-Legendre rule on [0, 1]: position, weight (Abramowitz & Stegun, table 25.4).
constexpr std::array<std::array<double, 2>, 6> kGauss{{{0.033765242898424, 0.085662246189585},
                                                       {0.169395306766868, 0.180380786524069},
                                                       {0.380690406958402, 0.233956967286345},
                                                       {0.619309593041598, 0.233956967286345},
                                                       {0.830604693233132, 0.180380786524069},
                                                       {0.966234757101576, 0.085662246189585}}};

double polynomialAt(const std::array<double, 6>& p, double x) {
  return p[0] + x * (p[1] + x * (p[2] + x * (p[3] + x * (p[4] + x * p[5]))));
}

// Where a ray with impact parameter b that is bent by `bending` meets the plane.
double landing(double b, double bending, const ShadowStation& at) {
  double const slope = std::asin(b / at.sunDistance.si) - bending;
  return (b + at.behind.si * std::sin(slope)) / std::cos(slope);
}

}  // namespace

RefractedShadow::RefractedShadow(const Medium& medium, Length ground,
                                 const std::vector<Length>& wavelengths, LimbDarkeningLaw law)
    : wavelengths_(wavelengths),
      ground_(ground.si),
      top_(ground.si + medium.topHeight.si),
      nodes_(limbNodes(medium, ground, wavelengths)) {
  for (Length w : wavelengths) {
    LimbProfile const profile = limbProfile(law, w);
    Disc disc{profile.exponent, profile.polynomial, 0.0, {}};
    for (int k = 0; k < 6; ++k)
      disc.mean +=
          2.0 * profile.polynomial[static_cast<std::size_t>(k)] / (profile.exponent + k + 2.0);
    for (std::size_t i = 0; i < 6; ++i)
      disc.powers[i] = std::pow(std::cos(0.5 * kPi * kGauss[i][0]), profile.exponent);
    discs_.push_back(disc);
  }
}

// Integral over the turn of the disc's brightness (over its mean) along a ring about the axis; the
// disc of `radius` is centred at `distance` from the axis.
double RefractedShadow::ringLight(const Disc& disc, double ring, double distance,
                                  double radius) const {
  double const off = std::fabs(ring - distance);
  if (off >= radius) return 0.0;
  double const depth = (radius - off) * (radius + off) / (radius * radius);  // mu^2 at its nearest
  double const spread = 4.0 * ring * distance / (radius * radius);
  double sum = 0.0;
  if (spread > depth) {
    // Part of the ring: sin(phi/2) = s sin(t) takes the roots at its ends away.
    double const s2 = depth / spread, s = std::sqrt(s2), mu0 = std::sqrt(depth);
    double const scale = std::pow(mu0, disc.exponent);
    for (std::size_t i = 0; i < 6; ++i) {
      double const t = 0.5 * kPi * kGauss[i][0], c = std::cos(t), sine = std::sin(t);
      sum += kGauss[i][1] * c / std::sqrt(1.0 - s2 * sine * sine) * disc.powers[i] *
             polynomialAt(disc.polynomial, mu0 * c);
    }
    return 2.0 * kPi * s * scale * sum / disc.mean;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    double const half = std::sin(0.5 * kPi * kGauss[i][0]);
    double const mu = std::sqrt(std::max(depth - spread * half * half, 0.0));
    sum += kGauss[i][1] * std::pow(mu, disc.exponent) * polynomialAt(disc.polynomial, mu);
  }
  return 2.0 * kPi * sum / disc.mean;
}

// Share of the disc's light from outside the ring `inner` about the axis.
double RefractedShadow::freeLight(const Disc& disc, double inner, double distance,
                                  double radius) const {
  if (inner >= distance + radius) return 0.0;
  double sum = 0.0;
  constexpr int kPieces = 6;
  // Whole rings, where the disc holds the axis.
  double const whole = radius - distance;
  if (whole > inner) {
    double const from = std::asin(inner / whole);
    for (int p = 0; p < kPieces; ++p)
      for (auto const& [x, weight] : kGauss) {
        double const t = from + (0.5 * kPi - from) * (p + x) / kPieces;
        double const ring = whole * std::sin(t);
        sum += weight / kPieces * (0.5 * kPi - from) * whole * std::cos(t) * ring *
               ringLight(disc, ring, distance, radius);
      }
  }
  // Arcs.
  double const low = std::fabs(whole), high = distance + radius;
  double const middle = 0.5 * (low + high), half = 0.5 * (high - low);
  double const from = inner > low ? std::acos(std::clamp((middle - inner) / half, -1.0, 1.0)) : 0.0;
  for (int p = 0; p < kPieces; ++p)
    for (auto const& [x, weight] : kGauss) {
      double const t = from + (kPi - from) * (p + x) / kPieces;
      double const ring = middle - half * std::cos(t);
      sum += weight / kPieces * (kPi - from) * half * std::sin(t) * ring *
             ringLight(disc, ring, distance, radius);
    }
  return sum / (kPi * radius * radius);
}

Length RefractedShadow::reach(const ShadowStation& at) const {
  double const radius = at.sunRadius.si * at.behind.si / at.sunDistance.si;
  return Length(landing(top_, 0.0, at) + 1.0001 * radius);
}

Length RefractedShadow::rim(const ShadowStation& at) const {
  double const radius = at.sunRadius.si * at.behind.si / at.sunDistance.si;
  return std::max(Length(landing(top_, 0.0, at) - radius), 0.01 * reach(at));
}

std::vector<double> RefractedShadow::lightAt(const ShadowStation& at, Length distance) const {
  double const rho = distance.si, far = at.behind.si / at.sunDistance.si;
  double const radius = at.sunRadius.si * far;
  double const focus = (1.0 + far) * (1.0 + far) / (kPi * radius * radius);
  double const edge = landing(top_, 0.0, at);
  std::vector<double> light;
  for (std::size_t i = 0; i < wavelengths_.size(); ++i) {
    Disc const& disc = discs_[i];
    double sum = 0.0;
    for (LimbNode const& node : nodes_[i]) {
      if (node.transmittance <= 0.0) continue;
      double const y = std::fabs(landing(node.impactMetres, node.bendingRadians, at));
      double const arcs = ringLight(disc, y, rho, radius);
      if (arcs > 0.0) sum += node.transmittance * node.impactMetres * node.stepMetres * arcs;
    }
    light.push_back(focus * sum + freeLight(disc, edge, rho, radius));
  }
  return light;
}

}  // namespace antumbra
