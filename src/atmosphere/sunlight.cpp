#include "atmosphere/sunlight.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "document/input_error.h"
#include "eclipse/shadow_pair.h"

namespace antumbra {
namespace {

// Far enough that the Sun's rays are parallel: the solar distance in units of 1 au.
constexpr double kSunDistance = 1e6 * 149597870700.0;

double raw(const LimbProfile& p, double mu) {
  double polynomial = 0.0;
  for (size_t k = 6; k-- > 0;) polynomial = polynomial * mu + p.polynomial[k];
  return std::pow(std::max(mu, 1e-9), p.exponent) * polynomial;
}

}  // namespace

Occulter occulterByRatio(double ratio, Length radius, Position<AirFrame> axisPoint,
                         const Sunlight& sun) {
  double const angle = ratio * (sun.occultedRadius / radian);
  if (!(ratio > 0.0) || !(angle < std::numbers::pi / 2.0))
    throw InputError(
        fmt::format("occulter ratio: found {}; allowed: positive, with an angular radius "
                    "below 90 deg",
                    ratio));
  if (!(radius > Length(0.0))) throw InputError("occulter radius: allowed: positive");
  // The cone tangent to a sphere: its sine.
  return {axisPoint + (radius / std::sin(angle)) * sun.toSun, radius};
}

SunShadow::SunShadow(const Sunlight& sun, Length wavelength)
    : law_(limbDarkening(sun.law, {wavelength, wavelength, wavelength, wavelength})),
      corona_(sun.corona) {
  for (Occulter const& o : sun.occulters) {
    // The Sun stands beyond the occulter, so far that its rays are parallel.
    ShadowRadii const radii{Length(kSunDistance * std::sin(sun.occultedRadius / radian)), o.radius,
                            o.radius};
    pairs_.push_back(shadowPairMetres(kSunDistance * sun.toSun.u, o.centre.m, radii));
  }
}

double SunShadow::visibleShare(const glm::dvec3& metres) const {
  double const disc = visibleSunlight(pairs_, law_, metres).x;
  if (!corona_ || pairs_.empty()) return disc;
  double least = corona_->whole();
  for (auto const& pair : pairs_)
    least = std::min(least, corona_->past(glsl::discsAt(pair, glsl::placeInShadow(pair, metres))));
  return disc + least;
}

DiscProfile::DiscProfile(LimbDarkeningLaw law, Length wavelength)
    : profile_(limbProfile(law, wavelength)) {
  // Mean over the disc: 2 integral of I(mu) mu dmu, term by term.
  mean_ = 0.0;
  for (size_t k = 0; k < 6; ++k)
    mean_ += 2.0 * profile_.polynomial[k] / (static_cast<double>(k) + 2.0 + profile_.exponent);
}

double DiscProfile::at(double cosine) const { return raw(profile_, cosine) / mean_; }

std::vector<SunRay> sunRays(const Sunlight& sun, Length wavelength, int rings, int spokes) {
  if (sun.discRadius == Angle(0.0)) return {{sun.toSun.u, 1.0}};
  glm::dvec3 const z = sun.toSun.u;
  glm::dvec3 const x = glm::normalize(
      glm::cross(std::abs(z.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), z));
  glm::dvec3 const y = glm::cross(z, x);
  DiscProfile const profile(sun.law, wavelength);
  std::vector<SunRay> rays;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    // Equal areas, each represented at its middle.
    double const area = (i + 0.5) / rings, weight = profile.at(std::sqrt(1.0 - area));
    double const angle = std::sqrt(area) * (sun.discRadius / radian);
    for (int k = 0; k < spokes; ++k) {
      double const turn = 2.0 * std::numbers::pi * (k + 0.5 * (i % 2)) / spokes;
      rays.push_back(
          {std::cos(angle) * z + std::sin(angle) * (std::cos(turn) * x + std::sin(turn) * y),
           weight});
      sum += weight;
    }
  }
  for (auto& ray : rays) ray.weight /= sum;
  return rays;
}

}  // namespace antumbra
