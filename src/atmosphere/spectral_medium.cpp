#include "atmosphere/spectral_medium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "shared/as_cpp.h"

namespace antumbra {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kHeightNodes = 8192;
constexpr int kDepthHeights = 512, kDepthCosines = 64;
// Gauss-Legendre on [-1, 1] with eight nodes (Abramowitz & Stegun 1972, table 25.4).
constexpr std::array<double, 4> kNode{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                      0.9602898564975363};
constexpr std::array<double, 4> kWeight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                        0.1012285362903763};

double drawHenyeyGreenstein(double g, double u) {
  if (std::abs(g) < 1e-4) return 1.0 - 2.0 * u;
  double const t = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return std::clamp((1.0 + g * g - t * t) / (2.0 * g), -1.0, 1.0);
}

// Cubic interpolation through four equally spaced values, t in [0, 1] between the middle two.
void cubicWeights(double t, double w[4]) {
  w[0] = -t * (t - 1.0) * (t - 2.0) / 6.0;
  w[1] = (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0;
  w[2] = -(t + 1.0) * t * (t - 2.0) / 2.0;
  w[3] = (t + 1.0) * t * (t - 1.0) / 6.0;
}

}  // namespace

SpectralPhase::SpectralPhase(const PhaseFunction& phase, Length wavelength) : kind_(phase.kind()) {
  if (kind_ == PhaseFunction::Kind::kTable) {
    angles_ = phase.anglesRadians();
    values_ = phase.values();
    cumulative_.assign(1, 0.0);
    for (size_t i = 0; i + 1 < angles_.size(); ++i)
      cumulative_.push_back(cumulative_.back() +
                            kPi * (values_[i] + values_[i + 1]) *
                                (std::cos(angles_[i]) - std::cos(angles_[i + 1])));
    return;
  }
  if (kind_ == PhaseFunction::Kind::kIsotropic || kind_ == PhaseFunction::Kind::kRayleigh) return;
  g_ = phase.forwardG().at(wavelength);
  if (kind_ == PhaseFunction::Kind::kDoubleHenyeyGreenstein) {
    backwardG_ = phase.backwardG().at(wavelength);
    share_ = phase.forwardShare().at(wavelength);
  }
}

double SpectralPhase::at(double cosine) const {
  switch (kind_) {
    case PhaseFunction::Kind::kIsotropic:
      return 1.0 / (4.0 * kPi);
    case PhaseFunction::Kind::kRayleigh:
      return glsl::rayleighPhase(cosine);
    case PhaseFunction::Kind::kHenyeyGreenstein:
      return glsl::henyeyGreensteinPhase(cosine, g_);
    case PhaseFunction::Kind::kCornetteShanks:
      return glsl::cornetteShanksPhase(cosine, g_);
    case PhaseFunction::Kind::kDoubleHenyeyGreenstein:
      return glsl::doubleHenyeyGreensteinPhase(cosine, g_, backwardG_, share_);
    case PhaseFunction::Kind::kTable:
      break;
  }
  double const angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  auto const after = std::upper_bound(angles_.begin() + 1, angles_.end() - 1, angle);
  auto const i = static_cast<size_t>(after - angles_.begin());
  double const t = (angle - angles_[i - 1]) / (angles_[i] - angles_[i - 1]);
  return values_[i - 1] + t * (values_[i] - values_[i - 1]);
}

double SpectralPhase::drawDensity(double cosine) const {
  if (kind_ == PhaseFunction::Kind::kCornetteShanks) return glsl::henyeyGreensteinPhase(cosine, g_);
  if (kind_ != PhaseFunction::Kind::kTable) return at(cosine);
  double const angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  auto const after = std::upper_bound(angles_.begin() + 1, angles_.end() - 1, angle);
  auto const i = static_cast<size_t>(after - angles_.begin());
  return (values_[i - 1] + values_[i]) / (2.0 * cumulative_.back());
}

double SpectralPhase::draw(double u, double v) const {
  switch (kind_) {
    case PhaseFunction::Kind::kIsotropic:
      return 1.0 - 2.0 * u;
    case PhaseFunction::Kind::kRayleigh: {
      // Inverse of the cumulative cubic (mu^3 + 3 mu + 4) / 8 = u.
      double const q = 4.0 * u - 2.0, root = std::cbrt(std::abs(q) + std::sqrt(q * q + 1.0));
      double const mu = root - 1.0 / root;
      return std::clamp(q < 0.0 ? -mu : mu, -1.0, 1.0);
    }
    case PhaseFunction::Kind::kHenyeyGreenstein:
      return drawHenyeyGreenstein(g_, u);
    case PhaseFunction::Kind::kCornetteShanks:
      return drawHenyeyGreenstein(g_, u);
    case PhaseFunction::Kind::kDoubleHenyeyGreenstein:
      return drawHenyeyGreenstein(v < share_ ? g_ : backwardG_, u);
    case PhaseFunction::Kind::kTable:
      break;
  }
  // A band of angles by its share of the mean of its ends, then uniform in the cosine.
  double const total = cumulative_.back(), target = v * total;
  auto const after = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, target);
  auto const i = static_cast<size_t>(after - cumulative_.begin());
  double const c0 = std::cos(angles_[i - 1]), c1 = std::cos(angles_[i]);
  return c0 + u * (c1 - c0);
}

AirRay::AirRay(const glm::dvec3& start, const glm::dvec3& direction)
    : startRadius(glm::length(start)), along(glm::dot(start, direction)) {
  glm::dvec3 const moment = glm::cross(start, direction);
  perigeeSquared = glm::dot(moment, moment);
}

double AirRay::radiusAt(double s) const {
  return std::sqrt(perigeeSquared + (along + s) * (along + s));
}

double AirRay::heightAt(double s, double sphere) const {
  return (startRadius - sphere) + s * (2.0 * along + s) / (radiusAt(s) + startRadius);
}

bool AirRay::crossings(double sphere, double& first, double& second) const {
  double const perigee = std::sqrt(perigeeSquared);
  double const square = (sphere - perigee) * (sphere + perigee);
  if (!(square >= 0.0)) return false;
  double const half = std::sqrt(square);
  // Of the two roots the one nearer the start by the product of both, free of cancellation.
  double const product = (startRadius - sphere) * (startRadius + sphere);
  if (along > 0.0) {
    first = -along - half;
    second = first != 0.0 ? product / first : 0.0;
  } else {
    second = -along + half;
    first = second != 0.0 ? product / second : 0.0;
  }
  return true;
}

SpectralMedium::SpectralMedium(const Medium& medium, Length wavelength, Length groundRadius)
    : medium_(&medium),
      wavelength_(wavelength.si),
      ground_(std::min(medium.radius, groundRadius) / metre),
      top_(medium.topRadius() / metre),
      albedo_(medium.groundAlbedo.at(wavelength)) {
  double const topHeight = top_ - ground_;
  for (Constituent const& c : medium.constituents) {
    scattering_.push_back(c.scattering.at(wavelength));
    total_.push_back(scattering_.back() + c.absorption.at(wavelength));
    phases_.emplace_back(c.phase, wavelength);
    if (c.density.kind() == DensityProfile::Kind::kExponential)
      for (double scales = 0.5; scales < 40.0; scales *= 2.0)
        breaks_.push_back(scales * (c.density.scaleHeight() / metre));
    for (double h : c.density.nodeHeightsMetres()) breaks_.push_back(h);
  }
  double const below = medium.radius / metre - ground_;  // breaks are heights above `ground_`
  for (double& h : breaks_) h += below;
  if (below > 0.0) breaks_.push_back(below);
  std::sort(breaks_.begin(), breaks_.end());
  std::vector<double> kept;
  for (double h : breaks_)
    if (h > (kept.empty() ? 0.0 : kept.back()) + 1e-6 * topHeight && h < topHeight * (1.0 - 1e-6))
      kept.push_back(h);
  breaks_ = std::move(kept);

  scatteringTables_.assign(phases_.size(), std::vector<double>(kHeightNodes + 1));
  extinctionTable_.assign(kHeightNodes + 1, 0.0);
  for (int i = 0; i <= kHeightNodes; ++i) {
    double const t = static_cast<double>(i) / kHeightNodes, h = topHeight * t * t - below;
    for (size_t c = 0; c < phases_.size(); ++c) {
      double const density = medium.constituents[c].density.atMetres(h);
      scatteringTables_[c][static_cast<size_t>(i)] = density * scattering_[c];
      extinctionTable_[static_cast<size_t>(i)] += density * total_[c];
    }
  }

  meanExtinction_.resize(static_cast<size_t>((kDepthHeights + 1) * (kDepthCosines + 1)));
  for (int i = 0; i <= kDepthHeights; ++i) {
    double const x = static_cast<double>(i) / kDepthHeights, height = topHeight * x * x;
    double const r = ground_ + height;
    double const shortest = topHeight - height, longest = std::sqrt(shortest * (top_ + r));
    for (int k = 0; k <= kDepthCosines; ++k) {
      double const u = static_cast<double>(k) / kDepthCosines;
      double const d = shortest + u * (longest - shortest);
      double mean = extinction(height);
      if (d > 1e-9 * topHeight) {
        // From top^2 = r^2 + d^2 + 2 r d cosine.
        double const cosine = std::clamp((longest * longest - d * d) / (2.0 * r * d), 0.0, 1.0);
        AirRay const ray(glm::dvec3(0.0, 0.0, r),
                         glm::dvec3(std::sqrt((1.0 - cosine) * (1.0 + cosine)), 0.0, cosine));
        mean = quadrature(ray, 0.0, d, [this](double h) { return extinction(h); }) / d;
      }
      meanExtinction_[static_cast<size_t>(i * (kDepthCosines + 1) + k)] = mean;
    }
  }
}

double SpectralMedium::tabulated(const std::vector<double>& table, double height) const {
  double const x = std::sqrt(std::max(height, 0.0) / (top_ - ground_)) * kHeightNodes;
  int const i = std::min(static_cast<int>(x), kHeightNodes - 1);
  double const t = std::min(x - i, 1.0);
  auto const k = static_cast<size_t>(i);
  // Nodes are quadratic in height; so is the place between them.
  double const place = t * (2.0 * i + t) / (2.0 * i + 1.0);
  return table[k] + place * (table[k + 1] - table[k]);
}

double SpectralMedium::extinction(double height) const {
  return tabulated(extinctionTable_, height);
}

double SpectralMedium::scattering(double height, double* each) const {
  double sum = 0.0;
  for (size_t c = 0; c < scatteringTables_.size(); ++c)
    sum += each[c] = tabulated(scatteringTables_[c], height);
  return sum;
}

double SpectralMedium::exactExtinction(double height) const {
  double const h = height - (medium_->radius / metre - ground_);
  double sum = 0.0;
  for (size_t c = 0; c < total_.size(); ++c)
    sum += total_[c] * medium_->constituents[c].density.atMetres(h);
  return sum;
}

double SpectralMedium::depthToTop(double radius, double cosine) const {
  double const topHeight = top_ - ground_, height = std::clamp(radius - ground_, 0.0, topHeight);
  double const r = ground_ + height;
  double const shortest = topHeight - height, product = shortest * (top_ + r);
  double const longest = std::sqrt(product);
  if (!(longest > 0.0)) return 0.0;
  // Distance to the top: the positive root of d^2 + 2 r c d = product, free of cancellation.
  double const rc = r * cosine, d = product / (rc + std::sqrt(rc * rc + product));
  double const width = longest - shortest;
  double const u = width > 0.0 ? std::clamp((d - shortest) / width, 0.0, 1.0) * kDepthCosines : 0.0;
  double const x = std::sqrt(height / topHeight) * kDepthHeights;
  int const i = std::clamp(static_cast<int>(x), 1, kDepthHeights - 2);
  int const k = std::clamp(static_cast<int>(u), 1, kDepthCosines - 2);
  double wx[4], wu[4];
  cubicWeights(x - i, wx);
  cubicWeights(u - k, wu);
  double mean = 0.0;
  for (int a = 0; a < 4; ++a) {
    const double* row =
        &meanExtinction_[static_cast<size_t>((i - 1 + a) * (kDepthCosines + 1) + k - 1)];
    mean += wx[a] * (wu[0] * row[0] + wu[1] * row[1] + wu[2] * row[2] + wu[3] * row[3]);
  }
  return std::max(mean, 0.0) * d;
}

double SpectralMedium::depthBetween(const AirRay& ray, double a, double b) const {
  double const ra = ray.radiusAt(a), rb = ray.radiusAt(b);
  double const ca = ray.cosineAt(a, ra), cb = ray.cosineAt(b, rb);
  double depth;
  if (ca >= 0.0)
    depth = depthToTop(ra, ca) - depthToTop(rb, cb);
  else if (cb <= 0.0)
    depth = depthToTop(rb, -cb) - depthToTop(ra, -ca);
  else
    depth = 2.0 * depthToTop(std::sqrt(ray.perigeeSquared), 0.0) - depthToTop(ra, -ca) -
            depthToTop(rb, cb);
  return std::max(depth, 0.0);
}

double SpectralMedium::depthToSpace(const glm::dvec3& point, double radius,
                                    const glm::dvec3& direction) const {
  if (radius >= top_) {
    // Above the air: through it only if the ray goes down into it.
    AirRay const ray(point, direction);
    Span span;
    if (!spanOf(ray, span)) return 0.0;
    if (span.hitsGround) return std::numeric_limits<double>::infinity();
    return depthBetween(ray, span.enter, span.leave);
  }
  double const cosine = glm::dot(point, direction) / radius;
  if (cosine >= 0.0) return depthToTop(radius, cosine);
  glm::dvec3 const moment = glm::cross(point, direction);
  double const perigee = glm::length(moment);
  if (perigee < ground_) return std::numeric_limits<double>::infinity();
  return std::max(0.0, 2.0 * depthToTop(perigee, 0.0) - depthToTop(radius, -cosine));
}

void SpectralMedium::bendSunlight() {
  if (!BentSunlight::bends(*medium_, Length(ground_))) return;
  BentColour colour{medium_->refractivity.at(Length(wavelength_)), total_};
  bent_ = std::make_shared<const BentSunlight>(*medium_, Length(ground_),
                                               medium_->radius - Length(ground_),
                                               std::vector<BentColour>{std::move(colour)});
}

double SpectralMedium::depthToSun(const glm::dvec3& point, double radius,
                                  const glm::dvec3& toSun) const {
  if (!bent_ || radius >= top_) return depthToSpace(point, radius, toSun);
  return bent_->depth(0, radius - ground_, glm::dot(point, toSun) / radius);
}

glm::dvec3 SpectralMedium::apparentSun(const glm::dvec3& point, double radius,
                                       const glm::dvec3& toSun) const {
  glm::dvec3 const up = point / radius;
  double const cosine = glm::dot(up, toSun);
  glm::dvec3 const level = toSun - cosine * up;
  double const sine = glm::length(level);
  if (!bent_ || radius >= top_ || !(sine > 1e-9)) return toSun;
  double const lift = bent_->lift(0, radius - ground_, cosine);
  return std::cos(lift) * toSun + std::sin(lift) * (sine * up - (cosine / sine) * level);
}

double SpectralMedium::depthByQuadrature(const AirRay& ray, double a, double b) const {
  return quadrature(ray, a, b, [this](double h) { return exactExtinction(h); });
}

template <class Extinction>
double SpectralMedium::quadrature(const AirRay& ray, double a, double b,
                                  const Extinction& extinctionAt) const {
  std::vector<double> cuts{a, b};
  double const perigeeAt = -ray.along;
  if (perigeeAt > a && perigeeAt < b) cuts.push_back(perigeeAt);
  for (double h : breaks_) {
    double first, second;
    if (!ray.crossings(ground_ + h, first, second)) continue;
    if (first > a && first < b) cuts.push_back(first);
    if (second > a && second < b) cuts.push_back(second);
  }
  std::sort(cuts.begin(), cuts.end());
  double sum = 0.0;
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    double const middle = (cuts[i] + cuts[i + 1]) / 2.0, half = (cuts[i + 1] - cuts[i]) / 2.0;
    if (!(half > 0.0)) continue;
    double part = 0.0;
    for (size_t n = 0; n < 4; ++n)
      part += kWeight[n] * (extinctionAt(ray.heightAt(middle - half * kNode[n], ground_)) +
                            extinctionAt(ray.heightAt(middle + half * kNode[n], ground_)));
    sum += half * part;
  }
  return sum;
}

bool SpectralMedium::spanOf(const AirRay& ray, Span& span) const {
  double first, second;
  if (!ray.crossings(top_, first, second) || !(second > 0.0)) return false;
  span.enter = std::max(first, 0.0);
  span.leave = second;
  span.hitsGround = false;
  double down, up;
  if (ray.along < 0.0 && ray.crossings(ground_, down, up) && down >= -1e-9 * ground_) {
    span.leave = std::max(down, span.enter);
    span.hitsGround = true;
  }
  return true;
}

}  // namespace antumbra
