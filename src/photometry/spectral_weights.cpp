#include "photometry/spectral_weights.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "document/input_error.h"
#include "photometry/colour.h"
#include "photometry/standard_spectra.h"

namespace antumbra {
namespace {

constexpr int kTrainingSpectra = 800;
// Strength of the pull towards the plain quadrature, relative to one training spectrum of unit
// luminance; small enough not to cost accuracy, large enough to keep 64 weights determined.
constexpr double kPull = 1e-5;

// Midpoints of 2 nm cells over the visible span and, there, 683 E0 (x, y, z) and 1700 E0 V'.
struct VisibleGrid {
  std::vector<Length> wavelengths;
  std::vector<glm::dvec4> response;  // X, Y, Z, scotopic; times the cell width
};

const VisibleGrid& visibleGrid() {
  static const VisibleGrid grid = [] {
    VisibleGrid g;
    double const stepNm = 2.0;
    for (double nm = 361.0; nm < 830.0; nm += stepNm) {
      Length const w = nm * nanometre;
      double const sun = solarIrradiance(w) * stepNm;
      g.wavelengths.push_back(w);
      g.response.emplace_back(kPhotopicEfficacy * sun * colourMatching(w),
                              kScotopicEfficacy * sun * scotopicEfficiency(w));
    }
    return g;
  }();
  return grid;
}

std::vector<double> sampled(const RelativeSpectrum& f, const std::vector<Length>& wavelengths) {
  std::vector<double> values;
  for (Length w : wavelengths) values.push_back(f(w));
  return values;
}

// Training spectra on the grid and their exact X, Y, Z, scotopic integrals.
struct Training {
  std::vector<RelativeSpectrum> spectra;
  std::vector<glm::dvec4> integrals;
};

const Training& training() {
  static const Training set = [] {
    Training t;
    auto const& grid = visibleGrid();
    for (int seed = 0; seed < kTrainingSpectra; ++seed) {
      t.spectra.push_back(exampleSkySpectrum(seed));
      glm::dvec4 sum(0.0);
      for (size_t i = 0; i < grid.wavelengths.size(); ++i)
        sum += t.spectra.back()(grid.wavelengths[i]) * grid.response[i];
      t.integrals.push_back(sum);
    }
    return t;
  }();
  return set;
}

// Weights of the quadrature that interpolates f linearly between the wavelengths and holds it
// constant outside.
std::vector<glm::dvec4> quadrature(const std::vector<Length>& wavelengths) {
  std::vector<glm::dvec4> weights(wavelengths.size(), glm::dvec4(0.0));
  auto const& grid = visibleGrid();
  for (size_t i = 0; i < grid.wavelengths.size(); ++i) {
    Length const w = grid.wavelengths[i];
    size_t after = 0;
    while (after < wavelengths.size() && wavelengths[after] < w) ++after;
    if (after == 0) {
      weights.front() += grid.response[i];
    } else if (after == wavelengths.size()) {
      weights.back() += grid.response[i];
    } else {
      double const t = (w - wavelengths[after - 1]) / (wavelengths[after] - wavelengths[after - 1]);
      weights[after - 1] += (1.0 - t) * grid.response[i];
      weights[after] += t * grid.response[i];
    }
  }
  return weights;
}

// Solves the symmetric positive definite system a x = b in place by Cholesky's factorisation.
void solve(std::vector<std::vector<double>>& a, std::vector<glm::dvec4>& b) {
  size_t const n = b.size();
  for (size_t j = 0; j < n; ++j) {
    for (size_t k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
    a[j][j] = std::sqrt(a[j][j]);
    for (size_t i = j + 1; i < n; ++i) {
      for (size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      a[i][j] /= a[j][j];
    }
  }
  for (size_t i = 0; i < n; ++i) {
    for (size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = i + 1; k < n; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
}

// Weights to X, Y, Z and scotopic luminance.
std::vector<glm::dvec4> fittedWeights(const std::vector<Length>& wavelengths) {
  size_t const n = wavelengths.size();
  if (n < 1 || n > 64)
    throw InputError(fmt::format("wavelengths: found {}; allowed: 1 to 64 of them", n));
  for (size_t i = 0; i < n; ++i) {
    if (!(wavelengths[i] >= kVisibleFirst && wavelengths[i] <= kVisibleLast))
      throw InputError(fmt::format("wavelengths: found {:g} nm; allowed: {:g} to {:g} nm",
                                   wavelengths[i] / nanometre, kVisibleFirst / nanometre,
                                   kVisibleLast / nanometre));
    if (i > 0 && !(wavelengths[i - 1] < wavelengths[i]))
      throw InputError(fmt::format("wavelengths: found {:g} nm after {:g} nm; allowed: ascending",
                                   wavelengths[i] / nanometre, wavelengths[i - 1] / nanometre));
  }
  auto weights = quadrature(wavelengths);
  auto const& set = training();
  // Minimise over d: sum_k |F_k (w0 + d) - t_k|^2 / Y_k^2 + pull |d|^2, F scaled by Y of sunlight.
  double const unit = 1.0 / 127000.0;  // lx of the unattenuated Sun: brings weights to order one
  std::vector<std::vector<double>> normal(n, std::vector<double>(n, 0.0));
  std::vector<glm::dvec4> right(n, glm::dvec4(0.0));
  for (size_t k = 0; k < set.spectra.size(); ++k) {
    auto f = sampled(set.spectra[k], wavelengths);
    glm::dvec4 const t = set.integrals[k] / set.integrals[k].y;
    glm::dvec4 residual = t;
    for (size_t i = 0; i < n; ++i) {
      f[i] /= set.integrals[k].y * unit;
      residual -= f[i] * weights[i] * unit;
    }
    for (size_t i = 0; i < n; ++i) {
      right[i] += f[i] * residual;
      for (size_t j = 0; j <= i; ++j) normal[i][j] += f[i] * f[j];
    }
  }
  for (size_t i = 0; i < n; ++i) normal[i][i] += kPull * kTrainingSpectra;
  solve(normal, right);
  for (size_t i = 0; i < n; ++i) weights[i] += right[i] / unit;
  return weights;
}

}  // namespace

RelativeSpectrum exampleSkySpectrum(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed) * 2654435761u + 12345u);
  auto const uniform = [&](double from, double to) {
    return from + (to - from) * std::generate_canonical<double, 32>(random);
  };
  auto const logarithmic = [&](double from, double to) {
    return from * std::pow(to / from, uniform(0.0, 1.0));
  };
  // Vertical columns of Earth's air: molecules (Bucholtz 1995), 300 Dobson units of ozone.
  double const moleculesPerSquareMetre = 2.15e29, ozonePerSquareMetre = 300.0 * 2.687e20;
  bool const twilight = uniform(0.0, 1.0) < 0.4;
  // How much air the sunlight has crossed before, and crosses after, being scattered.
  double const airBefore = twilight ? uniform(0.0, 12.0) : logarithmic(0.3, 12.0);
  double const ozoneBefore = twilight ? uniform(1.0, 25.0) : logarithmic(0.3, 12.0);
  double const airAfter = logarithmic(0.02, 38.0);
  double const haze = uniform(0.0, 1.0) < 0.3 ? 0.0 : logarithmic(0.01, 0.6);
  double const hazeBefore = twilight ? haze * uniform(0.0, 3.0) : haze * airBefore;
  double const angstrom = uniform(-0.2, 1.8);
  double const hazeShare = uniform(0.0, 3.0);
  double const kind = uniform(0.0, 1.0);
  // A coloured surface or dust: reflectance or single-scattering albedo rising (or falling) through
  // the visible about some wavelength.
  double const edgeNm = uniform(430.0, 720.0), edgeWidthNm = logarithmic(15.0, 120.0);
  double const low = uniform(0.02, 0.9), high = uniform(0.02, 1.0);
  double const dustTransmitted = uniform(0.0, 4.0);
  return [=](Length wavelength) {
    double const molecules = moleculesPerSquareMetre * rayleighCrossSection(wavelength);
    double const aerosol = std::pow(wavelength.si / 550e-9, -angstrom);
    double const ozone = ozonePerSquareMetre * ozoneCrossSection(wavelength);
    double const sunlight =
        std::exp(-airBefore * molecules - ozoneBefore * ozone - hazeBefore * aerosol);
    double const ramp =
        low + (high - low) / (1.0 + std::exp(-(wavelength / nanometre - edgeNm) / edgeWidthNm));
    if (kind < 0.06) return 1.0;
    if (kind < 0.12) return sunlight;
    if (kind < 0.25) return sunlight * ramp;
    if (kind < 0.33) return ramp * std::exp(-dustTransmitted * (1.0 - ramp));
    double const view = airAfter * (molecules + haze * aerosol);
    double const share = (molecules + hazeShare * haze * aerosol) / (molecules + haze * aerosol);
    return sunlight * share * -std::expm1(-view);
  };
}

std::vector<glm::dvec3> linearSrgbWeights(const std::vector<Length>& wavelengths) {
  std::vector<glm::dvec3> rgb;
  for (glm::dvec4 const& w : fittedWeights(wavelengths))
    rgb.push_back(linearSrgbFromXyz(glm::dvec3(w)));
  return rgb;
}

std::vector<double> scotopicWeights(const std::vector<Length>& wavelengths) {
  std::vector<double> weights;
  for (glm::dvec4 const& w : fittedWeights(wavelengths)) weights.push_back(w.w);
  return weights;
}

std::vector<Length> defaultWavelengths(int count) {
  if (count < 1 || count > 64)
    throw InputError(fmt::format("wavelengths: found {}; allowed: 1 to 64 of them", count));
  std::vector<double> nm;
  if (count == 3)
    nm = {455, 550, 615};
  else if (count == 4)
    nm = {444, 521, 571, 632};
  else if (count == 8)
    nm = {415, 441, 468, 505, 524, 560, 610, 648};
  else
    for (int i = 0; i < count; ++i)
      nm.push_back(count == 1 ? 550.0 : 390.0 + 300.0 * i / (count - 1));
  std::vector<Length> wavelengths;
  for (double w : nm) wavelengths.push_back(w * nanometre);
  return wavelengths;
}

}  // namespace antumbra
