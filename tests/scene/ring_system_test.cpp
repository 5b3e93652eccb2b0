// Saturn's rings in the catalogue against published boundaries and optical depths.
#include "scene/ring_system.h"

#include <gtest/gtest.h>

#include <cmath>

#include "document/input_error.h"
#include "scene/body_catalogue.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

RingSystem saturn() { return *BodyCatalogue::standard().body("Saturn", "test").rings; }

TEST(RingSystem, SaturnHasItsRingsAndGaps) {
  RingSystem const rings = saturn();
  auto const features = readCsv("tests/authorities/saturn_ring_features.csv");
  int compared = 0;
  // The narrowest feature that holds a radius is what stands there.
  for (double km = 74001.0; km < 137500.0; km += 3.0) {
    double width = 1e9, least = 0.0, largest = 0.0;
    for (auto const& f : features) {
      double const inner = f.number("inner_km"), outer = f.number("outer_km");
      if (km < inner || km >= outer || outer - inner >= width) continue;
      width = outer - inner;
      least = f.number("least_depth");
      largest = f.number("largest_depth");
    }
    // Gaps below 100 km in the Cassini Division and the A ring are not in the table.
    double const depth = rings.opticalDepthAt(km * kilometre);
    bool const narrowGap = depth == 0.0 && km > 118500.0 && width > 4000.0;
    if (narrowGap) continue;
    EXPECT_GE(depth, least) << km;
    EXPECT_LE(depth, largest) << km;
    ++compared;
  }
  EXPECT_GT(compared, 20000);
}

TEST(RingSystem, PassedLightIsTheIntegralOfTransmittance) {
  RingSystem const rings = saturn();
  double sum = 0.0;
  double const sine = 0.3, step = 500.0;
  for (double r = 0.5 * step; rings.inner().si + r < 1.5e8; r += step) {
    sum += step * std::exp(-rings.opticalDepthAt(rings.inner() + Length(r)) / sine);
    if (std::fmod(r, 1000.0 * step) > step) continue;
    // Half a step at each of the edges passed so far.
    EXPECT_NEAR(rings.lightPassedWithin(rings.inner() + Length(r + 0.5 * step), sine).si, sum,
                52.0 * 0.5 * step)
        << r;
  }
}

TEST(RingSystem, RefusesImpossibleRings) {
  auto const read = [](const std::string& text) {
    return readRings(Document::parse("phase_exponent = 3.0\n" + text, "rings.toml").root());
  };
  std::string const part =
      "[[part]]\nname=\"a\"\ninner=\"80000 km\"\nouter=\"90000 km\"\noptical_depth=1.0\n"
      "albedo=[0.5,0.5,0.5]\n";
  EXPECT_EQ(read(part).parts.size(), 1u);
  EXPECT_THROW(read(""), InputError);
  EXPECT_THROW(read(part + part), InputError);  // overlap
  for (auto const& [from, to] : {std::pair{"90000 km", "70000 km"},
                                 {"=1.0", "=-1.0"},
                                 {"[0.5,0.5,0.5]", "[0.5,0.5]"},
                                 {"[0.5", "[1.5"}}) {
    std::string bad = part;
    bad.replace(bad.find(from), std::string(from).size(), to);
    EXPECT_THROW(read(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace antumbra
