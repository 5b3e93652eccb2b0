#include "passes/thick_air.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antumbra {
namespace {

constexpr int kFine = 16;  // heights between two rows
// Cells darker than this share of the brightest count as if they were as bright.
constexpr double kDark = 1e-3;
// Depth of an interval that scatters nothing.
constexpr double kVoid = 1e-9;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

ThickAirGrid thickAirGrid(const Medium& medium, const std::vector<std::size_t>& order,
                          const AirPhases& phases, const std::vector<Length>& wavelengths,
                          Length groundRadius, std::vector<double> heights,
                          std::vector<double> sunCosines, int slices) {
  ThickAirGrid grid;
  grid.width = static_cast<int>(sunCosines.size());
  grid.height = static_cast<int>(heights.size());
  grid.slices = slices;
  grid.groundRadius = groundRadius;
  grid.heights = std::move(heights);
  grid.sunCosines = std::move(sunCosines);
  grid.fine = kFine;
  std::vector<std::vector<double>> densities;  // by constituent
  for (std::size_t c : order) {
    densities.emplace_back();
    for (std::size_t row = 0; row + 1 < grid.heights.size(); ++row)
      for (int i = 0; i < kFine; ++i)
        densities.back().push_back(medium.constituents[c].density.atMetres(
            std::lerp(grid.heights[row], grid.heights[row + 1], (i + 0.5) / kFine)));
  }
  for (std::size_t w = 0; w < wavelengths.size(); ++w) {
    grid.groundAlbedo.push_back(medium.groundAlbedo.at(wavelengths[w]));
    std::vector<double> extinction(densities.empty() ? 0 : densities[0].size(), 0.0);
    auto scattering = extinction, turned = extinction;
    for (std::size_t c = 0; c < order.size(); ++c) {
      Constituent const& own = medium.constituents[order[c]];
      auto const& moments = phases.of[c][w].restMoments();
      double const on = own.scattering.at(wavelengths[w]);
      double const absorbed = own.absorption.at(wavelengths[w]);
      for (std::size_t i = 0; i < extinction.size(); ++i) {
        extinction[i] += (absorbed + on * moments[0]) * densities[c][i];
        scattering[i] += on * moments[0] * densities[c][i];
        turned[i] += on * moments[1] * densities[c][i];
      }
    }
    grid.extinction.push_back(std::move(extinction));
    grid.scattering.push_back(std::move(scattering));
    grid.turned.push_back(std::move(turned));
  }
  return grid;
}

// The diffusion of a mean radiance c, with f the net upward flux over 4 pi:
//   df/dz + absorption c = source,  dc/dz / 3 + transport extinction f = turned source,
// in volumes about the rows. Depths by row or by the interval above it.
struct ThickAirSolver::Diffusion {
  int rows, columns;
  double albedo, radius;
  std::vector<double> transport, turned, faceArea;    // of intervals
  std::vector<double> absorption, scattering, aside;  // of volumes; aside: m times mean free path
  std::vector<double> share, toNext;  // of columns: of cosines; across their borders
  std::vector<double> factors;        // of the banded matrix

  Diffusion(const ThickAirGrid& grid, int wavelength)
      : rows(grid.height),
        columns(grid.width),
        albedo(grid.groundAlbedo[index(wavelength)]),
        radius(grid.groundRadius.si),
        transport(index(rows), 0.0),
        turned(transport),
        faceArea(transport),
        absorption(transport),
        scattering(transport),
        aside(transport) {
    auto const w = index(wavelength);
    double const top = grid.heights.back();
    double const across = std::sqrt(top * (2.0 * radius + top));
    for (int row = 0; row + 1 < rows; ++row) {
      double const low = grid.heights[index(row)];
      double const step = (grid.heights[index(row + 1)] - low) / grid.fine;
      faceArea[index(row)] = area(low + 0.5 * step * grid.fine);
      for (int i = 0; i < grid.fine; ++i) {
        auto const k = index(row * grid.fine + i);
        double const out = grid.extinction[w][k], on = grid.scattering[w][k];
        double const free = out - grid.turned[w][k];
        double const here = area(low + step * (i + 0.5)) * step;
        transport[index(row)] += free * step;
        turned[index(row)] += grid.turned[w][k] * step;
        auto const volume = index(2 * i < grid.fine ? row : row + 1);
        absorption[volume] += std::max(out - on, 0.0) * here;
        scattering[volume] += on * here;
        aside[volume] += step / (3.0 * free + 3.0 / across);
      }
    }
    for (double& depth : transport) depth = std::max(depth, kVoid);
    std::vector<double> borders{grid.sunCosines.front()};
    for (int x = 0; x + 1 < columns; ++x)
      borders.push_back(0.5 * (grid.sunCosines[index(x)] + grid.sunCosines[index(x + 1)]));
    borders.push_back(grid.sunCosines.back());
    for (int x = 0; x < columns; ++x) {
      share.push_back(borders[index(x + 1)] - borders[index(x)]);
      if (x + 1 == columns) break;
      double const angle =
          std::acos(grid.sunCosines[index(x)]) - std::acos(grid.sunCosines[index(x + 1)]);
      double const edge = borders[index(x + 1)];
      toNext.push_back(std::sqrt(1.0 - edge * edge) / (angle * radius * radius));
    }
    factors = factored();
  }

  double area(double height) const { return std::pow(1.0 + height / radius, 2.0); }
  // Net flux up through the ground: what it returns of a changed irradiance less what it takes
  // away.
  double groundFlux(double c, double irradiance) const {
    return (irradiance * albedo / (2.0 * std::numbers::pi) - 0.5 * (1.0 - albedo) * c) /
           (1.0 + albedo);
  }
  double up(int row) const { return faceArea[index(row)] / (3.0 * transport[index(row)]); }

  // Lower band of the symmetric matrix, columns after each other: element (i, i - k) at i (rows +
  // 1)
  // + k; factored as L D L^T (Golub & Van Loan 2013, Matrix Computations, sect. 4.3).
  std::vector<double> factored() const {
    int const band = rows, all = rows * columns;
    std::vector<double> m(index(all) * index(band + 1), 0.0);
    auto const element = [&](int i, int back) -> double& {
      return m[index(i) * index(band + 1) + index(back)];
    };
    for (int x = 0; x < columns; ++x)
      for (int row = 0; row < rows; ++row) {
        int const i = x * rows + row;
        double const s = share[index(x)];
        element(i, 0) += s * absorption[index(row)];
        if (row == 0) element(i, 0) -= s * groundFlux(1.0, 0.0);
        if (row + 1 == rows) {
          element(i, 0) += s * 0.5 * area(0.0) * faceArea[index(rows - 2)];
        } else {
          element(i, 0) += s * up(row);
          element(i + 1, 0) += s * up(row);
          element(i + 1, 1) -= s * up(row);
        }
        if (x + 1 == columns) continue;
        double const flow = toNext[index(x)] * aside[index(row)];
        element(i, 0) += flow;
        element(i + rows, 0) += flow;
        element(i + rows, rows) -= flow;
      }
    for (int i = 0; i < all; ++i) {
      int const first = std::max(0, i - band);
      for (int j = first; j < i; ++j) {
        double sum = element(i, i - j);
        for (int k = std::max(first, j - band); k < j; ++k)
          sum -= element(i, i - k) * element(j, j - k);
        element(i, i - j) = sum;  // times D
      }
      for (int j = first; j < i; ++j) {
        double const scaled = element(i, i - j) / element(j, 0);
        element(i, 0) -= scaled * element(i, i - j);
        element(i, i - j) = scaled;
      }
    }
    return m;
  }
};

ThickAirSolver::ThickAirSolver(ThickAirGrid grid, std::vector<float> once)
    : grid_(std::move(grid)), light_(once.size(), 0.0f), lacking_(std::move(once)) {
  // Cells weigh by what diffusion makes of each.
  for (int w = 0; w < static_cast<int>(grid_.groundAlbedo.size()); ++w) {
    diffusions_.emplace_back(grid_, w);
    diffuse(w, lacking_);
    std::vector<double> bright;
    for (int row = 0; row < grid_.height; ++row)
      for (int column = 0; column < grid_.width; ++column)
        bright.push_back(static_cast<double>(lacking_[at(w, 0, row, column)]));
    double const dark = std::max(kDark * *std::max_element(bright.begin(), bright.end()), 1e-30);
    for (double& b : bright) b = 1.0 / std::max(b, dark);
    scales_.push_back(std::move(bright));
  }
}

ThickAirSolver::~ThickAirSolver() = default;

std::size_t ThickAirSolver::at(int wavelength, int slice, int row, int column) const {
  int const layered = wavelength / 4 * grid_.slices + slice;
  return index(((layered * grid_.height + row) * grid_.width + column) * 4 + wavelength % 4);
}

void ThickAirSolver::diffuse(int wavelength, std::vector<float>& light) const {
  Diffusion const& d = diffusions_[index(wavelength)];
  int const rows = d.rows, irradiance = grid_.slices - 1;
  auto const given = [&](int slice, int row, int column) {
    return static_cast<double>(light[at(wavelength, slice, row, column)]);
  };
  std::vector<double> c(index(rows * d.columns));
  // Of the interval above a row: flux by the anisotropic part of the source.
  auto const turnedFlux = [&](int row, int column) {
    double const flux = -0.5 / 3.0 * (given(1, row, column) + given(1, row + 1, column));
    return flux * d.turned[index(row)] / d.transport[index(row)];
  };
  for (int column = 0; column < d.columns; ++column)
    for (int row = 0; row < rows; ++row) {
      double sum = d.scattering[index(row)] * given(0, row, column);
      if (row == 0) sum += d.groundFlux(0.0, given(irradiance, 0, column));
      if (row > 0) sum += d.faceArea[index(row - 1)] * turnedFlux(row - 1, column);
      if (row + 1 < rows) sum -= d.faceArea[index(row)] * turnedFlux(row, column);
      c[index(column * rows + row)] = sum * d.share[index(column)];
    }
  auto const& m = d.factors;
  int const all = rows * d.columns;
  auto const element = [&](int i, int back) { return m[index(i) * index(rows + 1) + index(back)]; };
  for (int i = 0; i < all; ++i)
    for (int k = 1; k <= std::min(i, rows); ++k) c[index(i)] -= element(i, k) * c[index(i - k)];
  for (int i = 0; i < all; ++i) c[index(i)] /= element(i, 0);
  for (int i = all - 1; i >= 0; --i)
    for (int k = 1; k <= std::min(i, rows); ++k) c[index(i - k)] -= element(i, k) * c[index(i)];

  for (int column = 0; column < d.columns; ++column) {
    double below = d.groundFlux(c[index(column * rows)], given(irradiance, 0, column));
    std::vector<double> turned;
    for (int row = 0; row + 1 < rows; ++row) turned.push_back(turnedFlux(row, column));
    for (int row = 0; row < rows; ++row) {
      double const mean = c[index(column * rows + row)];
      double above = 0.5 * mean;
      if (row + 1 < rows)
        above = turned[index(row)] -
                (c[index(column * rows + row + 1)] - mean) / (3.0 * d.transport[index(row)]);
      double const flux = 0.5 * (below + above);
      below = above;
      light[at(wavelength, 0, row, column)] += static_cast<float>(mean);
      light[at(wavelength, 1, row, column)] += static_cast<float>(-3.0 * flux);
      light[at(wavelength, irradiance, row, column)] +=
          static_cast<float>(4.0 * std::numbers::pi * (0.25 * mean - 0.5 * flux));
    }
  }
}

double ThickAirSolver::product(int wavelength, const std::vector<float>& a,
                               const std::vector<float>& b) const {
  double sum = 0.0;
  for (int slice = 0; slice < grid_.slices; ++slice)
    for (int row = 0; row < grid_.height; ++row)
      for (int column = 0; column < grid_.width; ++column) {
        auto const k = at(wavelength, slice, row, column);
        double const scale = scales_[index(wavelength)][index(row * grid_.width + column)];
        sum += static_cast<double>(a[k]) * static_cast<double>(b[k]) * scale * scale;
      }
  return sum;
}

double ThickAirSolver::change() const {
  double most = 0.0;
  for (int w = 0; w < static_cast<int>(diffusions_.size()); ++w) {
    double sum = 0.0;
    for (int row = 0; row < grid_.height; ++row)
      for (int column = 0; column < grid_.width; ++column)
        sum += std::pow(static_cast<double>(lacking_[at(w, 0, row, column)]) *
                            scales_[index(w)][index(row * grid_.width + column)],
                        2.0);
    most = std::max(most, std::sqrt(sum / (grid_.width * grid_.height)));
  }
  return most;
}

const std::vector<float>& ThickAirSolver::direction() {
  steps_.push_back({lacking_, {}, std::vector<double>(diffusions_.size(), 0.0)});
  return steps_.back().to;
}

void ThickAirSolver::advance(const std::vector<float>& scattered) {
  Step& now = steps_.back();
  now.gain.resize(light_.size());
  for (std::size_t i = 0; i < light_.size(); ++i) now.gain[i] = now.to[i] - scattered[i];
  for (int w = 0; w < static_cast<int>(diffusions_.size()); ++w) {
    diffuse(w, now.gain);
    auto const add = [&](std::vector<float>& to, double factor, const std::vector<float>& from) {
      for (int slice = 0; slice < grid_.slices; ++slice) {
        std::size_t const first = at(w, slice, 0, 0);
        for (std::size_t i = 0; i < index(grid_.width * grid_.height); ++i)
          to[first + 4 * i] += static_cast<float>(factor) * from[first + 4 * i];
      }
    };
    for (std::size_t i = 0; i + 1 < steps_.size(); ++i) {
      Step const& earlier = steps_[i];
      if (!(earlier.square[index(w)] > 0.0)) continue;
      double const share = -product(w, now.gain, earlier.gain) / earlier.square[index(w)];
      add(now.gain, share, earlier.gain);
      add(now.to, share, earlier.to);
    }
    double const square = now.square[index(w)] = product(w, now.gain, now.gain);
    if (!(square > 0.0)) continue;
    double const length = product(w, lacking_, now.gain) / square;
    add(light_, length, now.to);
    add(lacking_, -length, now.gain);
  }
}

}  // namespace antumbra
