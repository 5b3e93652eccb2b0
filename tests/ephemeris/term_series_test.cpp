// The vector units against a plain loop over libm's cosine.
#include "ephemeris/term_series.h"

#include <gtest/gtest.h>
#include <cmath>

#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra {
namespace {

std::vector<VectorUnit> units() {
  std::vector<VectorUnit> u{VectorUnit::Plain};
  if (bestVectorUnit() != VectorUnit::Plain) u.push_back(VectorUnit::Avx2);
  if (bestVectorUnit() == VectorUnit::Avx512) u.push_back(VectorUnit::Avx512);
  return u;
}

TEST(TermSeries, VectorUnitsAgreeWithLibm) {
  SeriesCatalogue const planets(catalogsFolder() / "ephemeris/vsop87b.bin");
  SeriesCatalogue const moon(catalogsFolder() / "ephemeris/elpmpp02.bin");
  struct Case {
    const TermSeries& series;
    double t, amplitude;
  };
  for (double t : {-4.9, -0.0987654, 0.027, 0.98}) {
    for (const Case& c : {Case{planets.series("Mercury", "L"), t, 10.0},
                          Case{planets.series("Uranus", "R"), t, 20.0},
                          Case{moon.series("Moon", "L"), 10.0 * t, 30000.0},
                          Case{moon.series("Moon", "R"), 10.0 * t, 410000.0}}) {
      auto const libm = evaluateByLibm(c.series, c.t);
      for (VectorUnit unit : units()) {
        auto const mine = evaluateOn(unit, c.series, c.t);
        // A phase of 1e5 rad per unit of t is rounded to 2.2e-16 of itself, in either sum.
        double const tolerance = c.amplitude * (1e-13 + 1e5 * std::fabs(c.t) * 2.2e-16);
        EXPECT_NEAR(mine.value, libm.value, tolerance) << nameOf(unit);
        EXPECT_NEAR(mine.rate, libm.rate, 3e4 * tolerance) << nameOf(unit);
        EXPECT_NEAR(valueOn(unit, c.series, c.t), mine.value, 1e-14 * c.amplitude);
      }
    }
  }
}

TEST(TermSeries, TruncationStaysWithinItsBoundAndTheTailOfAVectorIsMasked) {
  SeriesCatalogue const planets(catalogsFolder() / "ephemeris/vsop87b.bin");
  auto const& full = planets.series("Mars", "L");
  auto cut = full;
  double const bound = cut.truncate(1e-7, 0.1);
  EXPECT_LT(cut.terms(), full.terms() / 5);
  for (double t : {-0.1, -0.033, 0.0, 0.05, 0.1}) {
    EXPECT_LT(std::fabs(cut.value(t) - full.value(t)), bound);
    for (VectorUnit unit : units()) EXPECT_NEAR(valueOn(unit, cut, t), valueByLibm(cut, t), 1e-12);
  }
}

TEST(TermSeries, RefusesBrokenCatalogues) {
  std::string const file = testing::TempDir() + "broken.bin";
  FILE* out = fopen(file.c_str(), "wb");
  fputs("ANTSERI1\x05", out);
  fclose(out);
  EXPECT_THROW(SeriesCatalogue{file}, InputError);
  EXPECT_THROW(SeriesCatalogue{"/nonexistent"}, InputError);
}

}  // namespace
}  // namespace antumbra
