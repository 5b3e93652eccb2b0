#include "medium/density.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/input_error.h"

namespace antumbra {
namespace {

void check(const std::vector<double>& heights, const std::vector<double>& densities,
           bool positive) {
  if (heights.size() < 2 || heights.size() != densities.size())
    throw InputError(
        fmt::format("density: found {} heights and {} values; allowed: two or more, as "
                    "many of each",
                    heights.size(), densities.size()));
  for (size_t i = 0; i < heights.size(); ++i) {
    if (!std::isfinite(heights[i]) || (i > 0 && !(heights[i] > heights[i - 1])))
      throw InputError(
          fmt::format("density: found height {} m; allowed: finite, ascending", heights[i]));
    if (!std::isfinite(densities[i]) || densities[i] < 0.0 || (positive && densities[i] == 0.0))
      throw InputError(fmt::format("density: found {}; allowed: a finite number, {}", densities[i],
                                   positive ? "positive" : "zero or more"));
  }
}

}  // namespace

DensityProfile DensityProfile::exponential(Length scaleHeight) {
  if (!(scaleHeight / metre > 0.0) || !std::isfinite(scaleHeight / metre))
    throw InputError(
        fmt::format("scale height: found {} m; allowed: positive, finite", scaleHeight / metre));
  DensityProfile p;
  p.scaleHeightMetres_ = scaleHeight / metre;
  return p;
}

DensityProfile DensityProfile::table(std::vector<Length> heights, std::vector<double> densities) {
  DensityProfile p;
  p.kind_ = Kind::kLinearTable;
  for (Length h : heights) p.heightsMetres_.push_back(h / metre);
  p.densities_ = std::move(densities);
  check(p.heightsMetres_, p.densities_, false);
  return p;
}

DensityProfile DensityProfile::logarithmicTable(std::vector<Length> heights,
                                                std::vector<double> densities) {
  DensityProfile p;
  p.kind_ = Kind::kLogarithmicTable;
  for (Length h : heights) p.heightsMetres_.push_back(h / metre);
  p.densities_ = std::move(densities);
  check(p.heightsMetres_, p.densities_, true);
  return p;
}

double DensityProfile::at(Length height) const { return atMetres(height / metre); }

double DensityProfile::atMetres(double heightMetres) const {
  double const h = std::max(heightMetres, 0.0);
  if (kind_ == Kind::kExponential) return std::exp(-h / scaleHeightMetres_);
  if (h > heightsMetres_.back()) return 0.0;
  if (h <= heightsMetres_.front())
    return kind_ == Kind::kLogarithmicTable || h == heightsMetres_.front() ? densities_.front()
                                                                           : 0.0;
  auto const after = std::upper_bound(heightsMetres_.begin() + 1, heightsMetres_.end() - 1, h);
  auto const i = static_cast<size_t>(after - heightsMetres_.begin());
  double const t = (h - heightsMetres_[i - 1]) / (heightsMetres_[i] - heightsMetres_[i - 1]);
  if (kind_ == Kind::kLogarithmicTable)
    return densities_[i - 1] * std::pow(densities_[i] / densities_[i - 1], t);
  return densities_[i - 1] + t * (densities_[i] - densities_[i - 1]);
}

double DensityProfile::slopeAtMetres(double heightMetres) const {
  double const h = std::max(heightMetres, 0.0);
  if (kind_ == Kind::kExponential) return -std::exp(-h / scaleHeightMetres_) / scaleHeightMetres_;
  if (h < heightsMetres_.front() || h >= heightsMetres_.back()) return 0.0;
  auto const after = std::upper_bound(heightsMetres_.begin() + 1, heightsMetres_.end() - 1, h);
  auto const i = static_cast<size_t>(after - heightsMetres_.begin());
  double const width = heightsMetres_[i] - heightsMetres_[i - 1];
  return kind_ == Kind::kLogarithmicTable
             ? atMetres(h) * std::log(densities_[i] / densities_[i - 1]) / width
             : (densities_[i] - densities_[i - 1]) / width;
}

Length DensityProfile::column(Length from, Length to) const {
  double const a = std::max(from / metre, 0.0), b = std::max(to / metre, a);
  if (kind_ == Kind::kExponential)
    return Length(-scaleHeightMetres_ * std::exp(-a / scaleHeightMetres_) *
                  std::expm1((a - b) / scaleHeightMetres_));
  double sum = 0.0;
  if (kind_ == Kind::kLogarithmicTable)
    sum += densities_.front() * std::max(0.0, std::min(b, heightsMetres_.front()) - a);
  for (size_t i = 0; i + 1 < heightsMetres_.size(); ++i) {
    double const h0 = std::max(a, heightsMetres_[i]), h1 = std::min(b, heightsMetres_[i + 1]);
    if (!(h0 < h1)) continue;
    double const width = heightsMetres_[i + 1] - heightsMetres_[i];
    auto const part = [&](double h) {
      double const t = (h - heightsMetres_[i]) / width;
      return kind_ == Kind::kLogarithmicTable
                 ? densities_[i] * std::pow(densities_[i + 1] / densities_[i], t)
                 : densities_[i] + t * (densities_[i + 1] - densities_[i]);
    };
    double const d0 = part(h0), d1 = part(h1), ratio = d0 > 0.0 ? d1 / d0 : 0.0;
    bool const straight = kind_ == Kind::kLinearTable || std::abs(ratio - 1.0) < 1e-6;
    sum += (h1 - h0) * (straight ? (d0 + d1) / 2.0 : (d1 - d0) / std::log(ratio));
  }
  return Length(sum);
}

}  // namespace antumbra
