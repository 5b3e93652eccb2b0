#include "eclipse/rays_to_sun.h"

#include <cmath>
#include <numbers>

namespace antumbra {
namespace {

// Adaptive Simpson: the free part of a ring has kinks where a limb touches it, and steps where one
// runs along it.
template <class Function>
double integral(const Function& f, double a, double fa, double m, double fm, double b, double fb,
                double tolerance, int depth) {
  double const l = 0.5 * (a + m), r = 0.5 * (m + b), fl = f(l), fr = f(r);
  double const whole = (b - a) / 6.0 * (fa + 4.0 * fm + fb);
  double const halves = (b - a) / 12.0 * (fa + 4.0 * fl + 2.0 * fm + 4.0 * fr + fb);
  if (depth == 0 || std::fabs(halves - whole) < 15.0 * tolerance)
    return halves + (halves - whole) / 15.0;
  return integral(f, a, fa, l, fl, m, fm, 0.5 * tolerance, depth - 1) +
         integral(f, m, fm, r, fr, b, fb, 0.5 * tolerance, depth - 1);
}

constexpr int kPanels = 48, kDepth = 10;

}  // namespace

bool meets(const OpaqueSpheroid& body, const glm::dvec3& point, const glm::dvec3& direction) {
  double const squash = body.equatorialRadius / body.polarRadius - 1.0;
  auto const stretched = [&](const glm::dvec3& v) {
    return v + body.pole * (squash * glm::dot(body.pole, v));
  };
  glm::dvec3 const toCentre = stretched(body.centre - point), d = stretched(direction);
  if (glm::dot(toCentre, d) <= 0.0) return false;
  glm::dvec3 const moment = glm::cross(toCentre, d);
  return glm::dot(moment, moment) < body.equatorialRadius * body.equatorialRadius * glm::dot(d, d);
}

double visibleLightByRays(const glm::dvec3& point, const glm::dvec3& sunCentre, double sunRadius,
                          std::span<const OpaqueSpheroid> bodies, const LimbProfile& law,
                          double tolerance, int samples) {
  glm::dvec3 const toSun = sunCentre - point;
  double const distance = glm::length(toSun), sine = sunRadius / distance;
  glm::dvec3 const z = toSun / distance;
  glm::dvec3 const x = glm::normalize(
      glm::cross(z, std::fabs(z.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  glm::dvec3 const y = glm::cross(z, x);
  double const step = 2.0 * std::numbers::pi / samples;
  // Free turns of the ring at sin(theta).
  auto const freeShare = [&](double sinTheta) {
    double const cosTheta = std::sqrt(1.0 - sinTheta * sinTheta);
    auto const hidden = [&](double turn) {
      glm::dvec3 const ray = z * cosTheta + (x * std::cos(turn) + y * std::sin(turn)) * sinTheta;
      for (auto const& body : bodies)
        if (meets(body, point, ray)) return true;
      return false;
    };
    double free = 0.0;
    bool const first = hidden(0.0);
    bool before = first;
    for (int k = 0; k < samples; ++k) {
      bool const after = k + 1 == samples ? first : hidden((k + 1) * step);
      if (before == after) {
        free += before ? 0.0 : step;
      } else {
        double low = k * step, high = low + step;
        for (int i = 0; i < 26; ++i) {
          double const middle = 0.5 * (low + high);
          (hidden(middle) == before ? low : high) = middle;
        }
        free += before ? (k + 1) * step - low : low - k * step;
      }
      before = after;
    }
    return free / (2.0 * std::numbers::pi);
  };
  // 2 mu I(mu) over mu, with mu = s^2 for the root at the limb.
  auto const light = [&](double s, bool whole) {
    double const mu = s * s;
    double polynomial = 0.0;
    for (std::size_t i = 6; i-- > 0;) polynomial = polynomial * mu + law.polynomial[i];
    double const weight = 2.0 * s * mu * std::pow(mu, law.exponent) * polynomial;
    return whole || weight == 0.0 ? weight : weight * freeShare(sine * std::sqrt(1.0 - mu * mu));
  };
  auto const over = [&](bool whole) {
    auto const f = [&](double s) { return light(s, whole); };
    double sum = 0.0;
    for (int k = 0; k < kPanels; ++k) {
      double const a = double(k) / kPanels, b = double(k + 1) / kPanels, m = 0.5 * (a + b);
      sum += integral(f, a, f(a), m, f(m), b, f(b), tolerance / kPanels, kDepth);
    }
    return sum;
  };
  return over(false) / over(true);
}

}  // namespace antumbra
