// The magnitude laws of catalogs/bodies against the test output published with them.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "document/paths.h"
#include "scene/body_catalogue.h"

namespace antumbra {
namespace {

TEST(PlanetMagnitude, ReproducesThePublishedTestOutput) {
  std::ifstream file(rootFolder() / "tests/authorities/planet_magnitudes_2018.csv");
  ASSERT_TRUE(file);
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("body,")) continue;
    std::istringstream in(line);
    std::string name;
    double r, d, phase, tilt, magnitude;
    char comma;
    std::getline(in, name, ',');
    in >> r >> comma >> d >> comma >> phase >> comma >> tilt >> comma >> magnitude;
    ASSERT_TRUE(in) << line;
    auto const found = BodyCatalogue::standard()
                           .body(name, "test")
                           .magnitude.apparent(phase * degree, r * astronomicalUnit,
                                               d * astronomicalUnit, tilt * degree);
    ASSERT_TRUE(found) << line;
    // Printed to 0.001. The catalogue leaves out what turns with Mars and its seasons (0.1) and the
    // sub-observer latitude of Uranus (0.00084 a degree, to 82 degrees).
    double const tolerance = name == "Mars" ? 0.1 : name == "Uranus" ? 0.07 : 0.0006;
    EXPECT_NEAR(*found, magnitude, tolerance) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 17);
}

// The brightness at zero phase, the geometric albedo and the radius say the same thing twice: p =
// 10^(0.4 (V_sun - V)) (au / R)^2, with the Sun at V = -26.76 (Willmer 2018) and R the mean radius.
TEST(PlanetMagnitude, AgreesWithTheGeometricAlbedo) {
  for (auto const& [key, body] : BodyCatalogue::standard().all()) {
    if (body.kind == "star") continue;
    auto const v = body.magnitude.apparent(Angle(), astronomicalUnit, astronomicalUnit);
    ASSERT_TRUE(v) << key;
    double const radii =
        std::cbrt(std::pow(body.equatorialRadius / metre, 2) * (body.polarRadius / metre));
    double const albedo =
        std::pow(10.0, 0.4 * (-26.76 - *v)) * std::pow(astronomicalUnit / metre / radii, 2);
    // Mercury's polynomial starts at 2 degrees and misses the surge of the albedo's 0.142; the
    // giants' albedo refers to the disc, the mean radius to the volume; Saturn has its rings.
    double const tolerance = key == "saturn" ? 0.12 : 0.1;
    EXPECT_NEAR(albedo / body.surface.geometricAlbedo, 1.0, tolerance) << key;
  }
}

}  // namespace
}  // namespace antumbra
