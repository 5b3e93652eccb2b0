// Density over height above the ground, relative to a reference density: dimensionless, finite and
// never negative.
#pragma once

#include <vector>

#include "quantity/quantity.h"

namespace antumbra {

class DensityProfile {
 public:
  enum class Kind { kExponential, kLinearTable, kLogarithmicTable };
  // exp(-height / scaleHeight). Throws InputError unless scaleHeight is positive and finite.
  static DensityProfile exponential(Length scaleHeight);
  // Straight lines between the nodes, zero outside them: a tent, a slab, any layer. Two or more
  // nodes, strictly ascending heights, densities finite and not negative.
  static DensityProfile table(std::vector<Length> heights, std::vector<double> densities);
  // As above with straight lines in the logarithm (densities positive); below the first node as
  // there, above the last zero.
  static DensityProfile logarithmicTable(std::vector<Length> heights,
                                         std::vector<double> densities);

  // Heights below zero count as zero.
  double at(Length height) const;
  double atMetres(double heightMetres) const;
  // Change of the density per metre of height; at a node that of the piece above it, outside a
  // table zero.
  double slopeAtMetres(double heightMetres) const;
  // Integral of the density over height; exact but for rounding.
  Length column(Length from, Length to) const;

  Kind kind() const { return kind_; }
  Length scaleHeight() const { return Length(scaleHeightMetres_); }  // of an exponential
  const std::vector<double>& nodeHeightsMetres() const { return heightsMetres_; }  // of a table
  const std::vector<double>& nodeDensities() const { return densities_; }

 private:
  Kind kind_ = Kind::kExponential;
  double scaleHeightMetres_ = 1.0;
  std::vector<double> heightsMetres_;
  std::vector<double> densities_;
};

}  // namespace antumbra
