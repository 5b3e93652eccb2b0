// Poisson series: sums of t^power * A_i * cos(p0_i + p1_i t + p2_i t^2 ...), the form of the
// planetary theory VSOP87 (two phase coefficients) and the lunar theory ELP/MPP02 (five).
//
// The terms lie in columns in the mapped catalogue, sorted by falling amplitude, so that a
// truncated series is a prefix. Sums run over vectors of 8 (AVX-512), 4 (AVX2) or 1 doubles, chosen
// when the program starts; cosine and sine by one reduction to [-pi/2, pi/2] and polynomials of
// degree 16 and 17 (errors below 5e-18 and 1.2e-16 before rounding). The variants agree to a few
// units in the last place of the largest partial sum (tests/ephemeris/term_series_test.cpp).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ephemeris/mapped_catalogue.h"

namespace antumbra {

// One block of terms with the same power of time.
struct TermBlock {
  const double* columns = nullptr;  // amplitude, phase0, phase1, ... one after another
  std::size_t stride = 0;           // doubles per column, a multiple of 8; padded with zeros
  std::uint32_t phases = 0;         // number of phase coefficients, 2 or 5
  std::uint32_t power = 0;
  std::uint32_t terms = 0;  // terms in use: at most those of the catalogue
};

struct SeriesValue {
  double value = 0.0;
  double rate = 0.0;  // per unit of t
};

// A variable of a theory: its blocks by ascending power.
class TermSeries {
 public:
  std::vector<TermBlock> blocks;
  std::size_t terms() const;
  // Keeps the terms whose amplitude times |tMax|^power is at least `threshold`. Returns the sum of
  // what is left out, at tMax: a rigorous bound of the error.
  double truncate(double threshold, double tMax);
  SeriesValue evaluate(double t) const;  // value and rate
  double value(double t) const;          // value only: about half the cost
};

enum class VectorUnit { Plain, Avx2, Avx512 };
VectorUnit bestVectorUnit();
std::string nameOf(VectorUnit unit);
// For tests and benchmarks: sums on the given unit. Plain also uses the polynomials above.
SeriesValue evaluateOn(VectorUnit unit, const TermSeries& series, double t);
double valueOn(VectorUnit unit, const TermSeries& series, double t);
// The same sum by a loop over std::cos and std::sin: the yardstick of accuracy and speed.
SeriesValue evaluateByLibm(const TermSeries& series, double t);
double valueByLibm(const TermSeries& series, double t);

// A catalogue written by tools/build_series_catalogue (layout there).
class SeriesCatalogue {
 public:
  explicit SeriesCatalogue(const std::filesystem::path& file);
  // Throws InputError if the catalogue lacks this variable of this body.
  const TermSeries& series(const std::string& body, const std::string& variable) const;

 private:
  MappedCatalogue file_;
  std::map<std::pair<std::string, std::string>, TermSeries> series_;
};

}  // namespace antumbra
