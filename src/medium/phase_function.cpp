#include "medium/phase_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "document/input_error.h"
#include "shared/as_cpp.h"

namespace antumbra {
namespace {

constexpr double kPi = std::numbers::pi;

void checkRange(const Spectrum& s, const char* name, double low, double high, bool open) {
  auto const check = [&](double v) {
    bool const inside = open ? v > low && v < high : v >= low && v <= high;
    if (!inside)
      throw InputError(fmt::format("{}: found {}; allowed: {} to {}{}", name, v, low, high,
                                   open ? ", both excluded" : ""));
  };
  if (s.isConstant()) check(s.at(550.0 * nanometre));
  for (double v : s.values()) check(v);
}

}  // namespace

PhaseFunction PhaseFunction::rayleigh() {
  PhaseFunction p;
  p.kind_ = Kind::kRayleigh;
  return p;
}

PhaseFunction PhaseFunction::henyeyGreenstein(Spectrum g) {
  checkRange(g, "g", -1.0, 1.0, true);
  PhaseFunction p;
  p.kind_ = Kind::kHenyeyGreenstein;
  p.forwardG_ = std::move(g);
  return p;
}

PhaseFunction PhaseFunction::cornetteShanks(Spectrum g) {
  PhaseFunction p = henyeyGreenstein(std::move(g));
  p.kind_ = Kind::kCornetteShanks;
  return p;
}

PhaseFunction PhaseFunction::doubleHenyeyGreenstein(Spectrum forwardG, Spectrum backwardG,
                                                    Spectrum forwardShare) {
  checkRange(forwardG, "forward_g", -1.0, 1.0, true);
  checkRange(backwardG, "backward_g", -1.0, 1.0, true);
  checkRange(forwardShare, "forward_share", 0.0, 1.0, false);
  PhaseFunction p;
  p.kind_ = Kind::kDoubleHenyeyGreenstein;
  p.forwardG_ = std::move(forwardG);
  p.backwardG_ = std::move(backwardG);
  p.forwardShare_ = std::move(forwardShare);
  return p;
}

PhaseFunction PhaseFunction::table(std::vector<Angle> angles, std::vector<double> values) {
  if (angles.size() < 2 || angles.size() != values.size())
    throw InputError(
        fmt::format("phase table: found {} angles and {} values; allowed: two or more, "
                    "as many of each",
                    angles.size(), values.size()));
  PhaseFunction p;
  p.kind_ = Kind::kTable;
  for (size_t i = 0; i < angles.size(); ++i) {
    double const a = angles[i] / radian;
    if (i > 0 && !(a > p.angles_.back()))
      throw InputError(
          fmt::format("phase table: found angle {:g} deg after {:g} deg; allowed: ascending",
                      angles[i] / degree, angles[i - 1] / degree));
    if (!std::isfinite(values[i]) || values[i] < 0.0)
      throw InputError(
          fmt::format("phase table: found value {}; allowed: finite, zero or more", values[i]));
    p.angles_.push_back(a);
  }
  if (std::abs(p.angles_.front()) > 1e-12 || std::abs(p.angles_.back() - kPi) > 1e-9)
    throw InputError(
        fmt::format("phase table: found angles {:g} to {:g} deg; allowed: 0 to 180 deg",
                    angles.front() / degree, angles.back() / degree));
  p.angles_.front() = 0.0;
  p.angles_.back() = kPi;
  // Integral over the sphere of the straight lines, exactly: of (v + k (x - a)) sin x.
  double integral = 0.0;
  for (size_t i = 0; i + 1 < values.size(); ++i) {
    double const a = p.angles_[i], b = p.angles_[i + 1];
    double const k = (values[i + 1] - values[i]) / (b - a);
    // cos a - cos b without cancellation.
    double const band = 2.0 * std::sin((a + b) / 2.0) * std::sin((b - a) / 2.0);
    double const rise = std::sin(b) - std::sin(a) - (b - a) * std::cos(b);
    integral += 2.0 * kPi * (values[i] * band + k * rise);
  }
  if (!(integral > 0.0))
    throw InputError("phase table: found only zeros; allowed: a positive value");
  for (double v : values) p.values_.push_back(v / integral);
  return p;
}

PhaseFunction PhaseFunction::legendre(std::vector<double> moments) {
  if (moments.empty() || std::abs(moments[0] - 1.0) > 1e-9)
    throw InputError("Legendre moments: the first must be 1");
  std::vector<Angle> angles;
  std::vector<double> values;
  // Fine enough for the highest moment: 40 nodes per oscillation.
  auto const count = static_cast<int>(std::max<size_t>(721, 40 * moments.size()));
  for (int i = 0; i <= count; ++i) {
    double const angle = kPi * i / count, x = std::cos(angle);
    double before = 1.0, legendre = x, sum = moments[0];
    for (size_t l = 1; l < moments.size(); ++l) {
      auto const n = static_cast<double>(l);
      sum += (2.0 * n + 1.0) * moments[l] * legendre;
      double const next = ((2.0 * n + 1.0) * x * legendre - n * before) / (n + 1.0);
      before = legendre;
      legendre = next;
    }
    if (!(sum >= -1e-9))
      throw InputError(
          fmt::format("Legendre moments: phase function {:g} at {:g} deg; allowed: zero or "
                      "more everywhere",
                      sum, angle * 180.0 / kPi));
    angles.push_back(angle * radian);
    values.push_back(std::max(sum, 0.0));
  }
  return table(std::move(angles), std::move(values));
}

double PhaseFunction::at(Length wavelength, double cosine) const {
  switch (kind_) {
    case Kind::kIsotropic:
      return 1.0 / (4.0 * kPi);
    case Kind::kRayleigh:
      return glsl::rayleighPhase(cosine);
    case Kind::kHenyeyGreenstein:
      return glsl::henyeyGreensteinPhase(cosine, forwardG_.at(wavelength));
    case Kind::kCornetteShanks:
      return glsl::cornetteShanksPhase(cosine, forwardG_.at(wavelength));
    case Kind::kDoubleHenyeyGreenstein:
      return glsl::doubleHenyeyGreensteinPhase(cosine, forwardG_.at(wavelength),
                                               backwardG_.at(wavelength),
                                               forwardShare_.at(wavelength));
    case Kind::kTable:
      break;
  }
  double const angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  auto const after = std::upper_bound(angles_.begin() + 1, angles_.end() - 1, angle);
  auto const i = static_cast<size_t>(after - angles_.begin());
  double const t = (angle - angles_[i - 1]) / (angles_[i] - angles_[i - 1]);
  return values_[i - 1] + t * (values_[i] - values_[i - 1]);
}

double PhaseFunction::meanCosine(Length wavelength) const {
  switch (kind_) {
    case Kind::kIsotropic:
    case Kind::kRayleigh:
      return 0.0;
    case Kind::kHenyeyGreenstein:
      return forwardG_.at(wavelength);
    case Kind::kCornetteShanks: {
      double const g = forwardG_.at(wavelength);
      return g * (12.0 + 3.0 * g * g) / (10.0 + 5.0 * g * g);
    }
    case Kind::kDoubleHenyeyGreenstein: {
      double const share = forwardShare_.at(wavelength);
      return share * forwardG_.at(wavelength) + (1.0 - share) * backwardG_.at(wavelength);
    }
    case Kind::kTable:
      break;
  }
  // Simpson's rule over each straight line.
  double sum = 0.0;
  auto const f = [&](double a) { return std::sin(a) * std::cos(a); };
  for (size_t i = 0; i + 1 < angles_.size(); ++i) {
    int const parts = 16;
    for (int k = 0; k < parts; ++k) {
      double const w = (angles_[i + 1] - angles_[i]) / parts, a = angles_[i] + k * w;
      double const v0 = values_[i] + (values_[i + 1] - values_[i]) * k / parts;
      double const v1 = values_[i] + (values_[i + 1] - values_[i]) * (k + 1) / parts;
      sum += w / 6.0 * (v0 * f(a) + 2.0 * (v0 + v1) * f(a + w / 2.0) + v1 * f(a + w));
    }
  }
  return 2.0 * kPi * sum;
}

Length PhaseFunction::firstWavelength() const {
  return std::max({forwardG_.first(), backwardG_.first(), forwardShare_.first()});
}
Length PhaseFunction::lastWavelength() const {
  return std::min({forwardG_.last(), backwardG_.last(), forwardShare_.last()});
}

}  // namespace antumbra
