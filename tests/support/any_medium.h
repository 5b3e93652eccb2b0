// Random media, cameras, Suns and directions, extremes among them, for tests of stability: radii of
// 1 km to 1e6 km, scale heights of 10 m to 1000 km, densities of 0, 1e-6 to 100 times that of a
// vertical depth near 0.3, asymmetries of -0.99 to 0.99.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "medium/medium.h"

namespace antumbra::testsupport {

class AnyMedium {
 public:
  explicit AnyMedium(unsigned seed) : random_(seed) {}

  double uniform(double a, double b) {
    return a + (b - a) * std::generate_canonical<double, 53>(random_);
  }
  double logarithmic(double a, double b) { return a * std::pow(b / a, uniform(0.0, 1.0)); }
  template <std::size_t n>
  double oneOf(const double (&values)[n]) {
    return values[random_() % n];
  }

  // Of the density of the last medium: 0, or 1e-6 to 100.
  double factor() const { return factor_; }

  Medium medium() {
    Medium m;
    m.radius = logarithmic(1e3, 1e9) * metre;
    Length const scale = logarithmic(10.0, 1e6) * metre;
    // No thicker than the body: the thickest known, Titan's, is a fifth of it.
    m.topHeight = std::min(scale * uniform(3.0, 12.0), m.radius);
    m.groundAlbedo = Spectrum(oneOf({0.0, 1.0, uniform(0.0, 1.0)}));
    factor_ = oneOf({0.0, 1e-6, 100.0, logarithmic(1e-6, 100.0), logarithmic(0.1, 10.0)});
    double const perMetre = factor_ * 0.3 / std::min(scale / metre, m.topHeight / metre);
    double const g = oneOf({-0.99, 0.99, uniform(-0.99, 0.99)});
    bool const absorbs = random_() % 3 != 0;
    m.constituents.push_back({"molecules", DensityProfile::exponential(scale), Spectrum(perMetre),
                              Spectrum(0.0), PhaseFunction::rayleigh()});
    m.constituents.push_back(
        {"dust",
         random_() % 2 ? DensityProfile::exponential(scale * uniform(0.05, 1.0))
                       : DensityProfile::table({m.topHeight * 0.1, m.topHeight * 0.2}, {1.0, 1.0}),
         Spectrum(perMetre * uniform(0.0, 2.0)), Spectrum(absorbs ? 0.2 * perMetre : 0.0),
         random_() % 2 ? PhaseFunction::henyeyGreenstein(Spectrum(g))
                       : PhaseFunction::cornetteShanks(Spectrum(g))});
    m.constituents.push_back(
        {"layer",
         DensityProfile::table({m.topHeight * 0.2, m.topHeight * 0.4, m.topHeight * 0.9},
                               {0.0, 1.0, 0.0}),
         Spectrum(0.0), Spectrum(absorbs ? 0.3 * perMetre : 0.0), PhaseFunction::isotropic()});
    return m;
  }

  Length altitude(const Medium& m) {
    double const top = m.topHeight / metre, radius = m.radius / metre;
    return Length(oneOf({0.0, 1e-6, 1e-3, 2.0, top - 1.0, top, top + 1.0, 1e9, uniform(0.0, top),
                         top * std::pow(uniform(0.0, 1.0), 4.0), -0.01 * radius, 0.2 * top,
                         top + logarithmic(1e-3, 1e12)}));
  }

  // Zenith angle of the horizon as a camera sees it.
  static Angle horizon(const Medium& m, Length altitude) {
    double const h = std::max(altitude / metre, 0.0), radius = m.radius / metre;
    return Angle(std::atan2(radius, -std::sqrt(h * (2.0 * radius + h))));
  }

  // The zenith, the nadir, level, at the horizon or a little beside it, or anywhere.
  Angle zenithAngle(const Medium& m, Length altitude) {
    double const edge = horizon(m, altitude) / degree;
    double const beside = logarithmic(1e-9, 3.0) * (random_() % 2 ? 1.0 : -1.0);
    return std::clamp(oneOf({0.0, 90.0, 180.0, edge, edge + beside, 90.0 + beside,
                             uniform(0.0, 180.0), uniform(0.0, 180.0)}),
                      0.0, 180.0) *
           degree;
  }
  Angle azimuth() { return oneOf({0.0, 180.0, 90.0, uniform(-180.0, 180.0)}) * degree; }

 private:
  std::mt19937 random_;
  double factor_ = 0.0;
};

}  // namespace antumbra::testsupport
