#include "eclipse/corona_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "document/input_error.h"

namespace antumbra {
namespace {

constexpr int kKnots = 512;       // over the logarithm of the radius, from 1 to kCoronaEnd
constexpr int kAngles = 8;        // of a quarter turn of the flattened profile
constexpr int kTurns = 192;       // of half a turn about the Sun
constexpr double kLeast = 1e-12;  // of the Sun, below which the logarithm is not taken

// Where a fit of degree n - 1 on [0, 1] touches the function: Chebyshev's nodes.
template <std::size_t n>
std::array<double, n> chebyshevNodes() {
  std::array<double, n> nodes{};
  for (std::size_t i = 0; i < n; ++i)
    nodes[i] = 0.5 - 0.5 * std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) /
                                    static_cast<double>(n));
  return nodes;
}

// Coefficients of the polynomial through the values at the nodes, the constant first (Newton's
// divided differences, multiplied out).
template <std::size_t n>
std::array<double, n> polynomialThrough(const std::array<double, n>& nodes,
                                        std::array<double, n> values) {
  for (std::size_t k = 1; k < n; ++k)
    for (std::size_t i = n - 1; i >= k; --i)
      values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - k]);
  std::array<double, n> c{};
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t i = n - 1; i > 0; --i) c[i] = c[i - 1] - nodes[k] * c[i];
    c[0] = values[k] - nodes[k] * c[0];
  }
  return c;
}

}  // namespace

CoronaLight::CoronaLight(double activity, LimbDarkeningLaw law) : activity_(activity), law_(law) {
  if (!(activity >= 0.0 && activity <= 1.0))
    throw InputError(fmt::format(
        "corona: activity: found {}; allowed: 0 (minimum of the solar cycle) to 1", activity));
  Length const luminance = kSolarLuminanceWavelength;
  double const centreOverMean =
      glsl::solarBrightness(limbDarkening(law, {luminance, luminance, luminance, luminance}), 1.0)
          .x;
  double const flattening = glsl::flatteningOfActivity(activity);
  double const step = std::log(glsl::kCoronaEnd) / (kKnots - 1);
  std::array<double, kAngles> sines{};
  for (int i = 0; i < kAngles; ++i)
    sines[static_cast<std::size_t>(i)] = std::sin(0.5 * std::numbers::pi * (i + 0.5) / kAngles);
  // Light of a ring over the logarithm of its radius.
  auto const density = [&](double logarithm) {
    double const r = std::exp(logarithm);
    double sum = 0.0;
    for (double sine : sines) sum += glsl::coronaBrightness(r, sine, flattening);
    return 2.0 * r * r * (sum / kAngles) * glsl::coronaFade(r) * centreOverMean;
  };
  cumulative_.assign(kKnots, 0.0);
  slope_.assign(kKnots, 0.0);
  for (int i = kKnots - 1; i >= 0; --i) {
    auto const k = static_cast<std::size_t>(i);
    slope_[k] = -step * density(step * i);
    if (i == kKnots - 1) continue;
    double const middle = -step * density(step * (i + 0.5));  // Simpson's rule
    cumulative_[k] = cumulative_[k + 1] - (slope_[k] + 4.0 * middle + slope_[k + 1]) / 6.0;
  }
}

double CoronaLight::beyond(double radius) const {
  double const x = std::log(radius) / std::log(glsl::kCoronaEnd) * (kKnots - 1);
  if (x >= kKnots - 1) return 0.0;
  auto const k = static_cast<std::size_t>(std::max(x, 0.0));
  double const t = std::max(x, 0.0) - static_cast<double>(k), u = 1.0 - t;
  return u * u * ((1.0 + 2.0 * t) * cumulative_[k] + t * slope_[k]) +
         t * t * ((1.0 + 2.0 * u) * cumulative_[k + 1] - u * slope_[k + 1]);
}

double CoronaLight::past(double ratio, double separation) const {
  // Each direction from the Sun's centre sees the disc from one distance to another; 0 is the
  // direction of its centre.
  double const d = std::max(separation, 0.0);
  if (ratio <= 0.0 || d - ratio >= glsl::kCoronaEnd) return whole();
  bool const inside = d < ratio;
  // Where the Sun's centre lies outside the disc, it fills this angle to either side.
  double const span = inside ? std::numbers::pi : std::asin(ratio / d);
  double hidden = 0.0;
  for (int i = 0; i < kTurns; ++i) {
    // Dense at the tangents, where what is hidden falls as a square root.
    double const t = std::numbers::pi * (i + 0.5) / kTurns;
    double const angle = inside ? t : span * 0.5 * (1.0 - std::cos(t));
    double const width = inside ? 1.0 : 0.5 * span * std::sin(t);
    double const across = d * std::sin(angle);
    double const half = std::sqrt(std::max(ratio * ratio - across * across, 0.0));
    double const to = d * std::cos(angle) + half;
    double const from = inside ? 1.0 : d * std::cos(angle) - half;
    if (to > 1.0) hidden += width * (beyond(std::max(from, 1.0)) - beyond(to)) / kTurns;
  }
  return whole() - hidden;
}

double CoronaLight::past(const glsl::DiscPair& discs) const {
  return past(1.0 + discs.excess / discs.sun, (discs.gap + discs.excess) / discs.sun);
}

glsl::CoronaFit CoronaLight::fit(const glsl::ShadowPair& pair, Length reach) const {
  auto const alongs = chebyshevNodes<3>();
  auto const squares = chebyshevNodes<4>();
  std::array<std::array<double, 3>, 4> coefficients{};  // by power across
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t a = 0; a < 3; ++a) {
    double const along = glsl::alongAxisAt(alongs[a], reach.si);
    double const umbra = std::max(glsl::umbraRadiusAt(pair, along), 0.0);
    std::array<double, 4> values{};
    for (std::size_t q = 0; q < 4; ++q)
      values[q] = std::log2(
          std::max(past(glsl::discsAt(pair, along, std::sqrt(squares[q]) * umbra)), kLeast));
    rows[a] = polynomialThrough(squares, values);
  }
  for (std::size_t q = 0; q < 4; ++q)
    coefficients[q] = polynomialThrough(alongs, {rows[0][q], rows[1][q], rows[2][q]});
  auto const power = [&](std::size_t a) {
    return glm::dvec4(coefficients[0][a], coefficients[1][a], coefficients[2][a],
                      coefficients[3][a]);
  };
  return {power(0), power(1), power(2)};
}

std::array<float, 12> packedForShader(const glsl::CoronaFit& fit) {
  std::array<float, 12> packed{};
  std::size_t i = 0;
  for (auto const& c : {fit.constant, fit.linear, fit.square})
    for (int k = 0; k < 4; ++k) packed[i++] = static_cast<float>(c[k]);
  return packed;
}

}  // namespace antumbra
