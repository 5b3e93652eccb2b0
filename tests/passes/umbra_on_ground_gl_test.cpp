// The umbra where pixels put it, against predictions: windows of latitude and longitude at 0.02
// degrees a pixel, shaded by the shaders' own shadow, and the rows of an independent program.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <fstream>
#include <sstream>

#include "eclipse/shadow_convention.h"
#include "ephemeris/ephemeris.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "passes/body_shadows.h"
#include "quantity/constants.h"
#include "scene/placed_scene.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using GlTest = testsupport::GlTest;

struct CentralPoint {
  double jdTt, deltaT, latitude, longitude, widthKm;
  double left[2], right[2];  // limits: latitude, longitude
};

std::vector<CentralPoint> readCentralLine() {
  std::ifstream file("tests/authorities/solar_central_line_2017.csv");
  std::vector<CentralPoint> rows;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || !std::isdigit(static_cast<unsigned char>(line[0]))) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream in(line);
    CentralPoint p;
    in >> p.jdTt >> p.deltaT >> p.latitude >> p.longitude >> p.widthKm >> p.left[0] >> p.left[1] >>
        p.right[0] >> p.right[1];
    EXPECT_TRUE(in) << line;
    rows.push_back(p);
  }
  return rows;
}

TEST_F(GlTest, UmbraFallsWhereItIsPredicted) {
  auto const rows = readCentralLine();
  ASSERT_EQ(rows.size(), 3u);
  constexpr int kSize = 300;
  constexpr double kStep = 0.02;
  auto const target = gl::Texture::plane(GL_RGBA32F, kSize, kSize);
  gl::Framebuffer const framebuffer({&target});
  auto const& geodesic = GeographicLib::Geodesic::WGS84();

  for (auto const& row : rows) {
    Scene scene;
    scene.file = "test";
    scene.bodies = {"Earth", "Moon", "Sun"};
    scene.camera.height = 1000.0 * kilometre;
    auto const placed =
        placeScene(scene, Instant::fromTt({row.jdTt, 0.0}), BodyCatalogue::standard(),
                   Ephemeris::standard(), DeltaT::fixed(row.deltaT * second));
    const PlacedBody& earth = placed.bodies[placed.anchor];
    ASSERT_EQ(earth.neighbours.size(), 1u);
    auto const radii = ShadowConvention::named("nasa", "test").radiiOf("Moon", Length(1.0));
    BodyShadows const shadows({shadowPair(earth.bodyFromIcrs(earth.sunFromBody),
                                          earth.bodyFromIcrs(earth.neighbours[0].fromBody), radii)},
                              earth.body->polarRadius / earth.body->equatorialRadius,
                              LimbDarkeningLaw::Hestroffer,
                              std::vector<Length>(4, 550.0 * nanometre), 6460.0 * kilometre);

    auto const program = gl::Program::fullScreen("bench/shadow_window.frag", shadows.definitions());
    // Off the lattice's symmetry, which would hide errors below a pixel.
    double const west = row.longitude - kStep * (kSize / 2 + 0.23);
    double const south = row.latitude - kStep * (kSize / 2 - 0.31);
    program.set("window", glm::vec4(west, south, kStep, kStep));
    program.set("spheroid", glm::vec2(kEarthEquatorialRadius.si, kEarthFlattening));
    framebuffer.bind();
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    shadows.bind();
    program.use();
    gl::drawFullScreen();
    auto const pixels = target.readRgba();

    // Of the window in kilometres: x along the limits' line from left to right, y across it.
    double limitAzimuth = 0, unused = 0, limitLine = 0;
    geodesic.Inverse(row.left[0], row.left[1], row.right[0], row.right[1], limitLine, limitAzimuth,
                     unused);
    double const turn = limitAzimuth * degree.si;
    double least = 1e9, most = -1e9, sumX = 0, sumY = 0;
    double between = 0;
    int inner = 0, dark = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4)
      between = std::min<double>(between, pixels[i + 1]);
    ASSERT_LT(between, 0.0) << "no umbra in the window";
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const float* p = &pixels[static_cast<std::size_t>(y * kSize + x) * 4];
        if (p[1] > 0.0f) {
          EXPECT_GT(p[0], 0.0f);
          continue;
        }
        EXPECT_EQ(p[0], 0.0f) << "light in a sealed umbra";
        ++dark;
        double distance = 0, azimuth = 0;
        geodesic.Inverse(row.latitude, row.longitude, south + (y + 0.5) * kStep,
                         west + (x + 0.5) * kStep, distance, azimuth, unused);
        double const a = azimuth * degree.si - turn;
        double const along = distance / 1e3 * std::cos(a), across = distance / 1e3 * std::sin(a);
        least = std::min(least, along);
        most = std::max(most, along);
        if (p[1] > 0.8 * between) continue;
        sumX += along;
        sumY += across;
        ++inner;
      }
    double const centreError = std::hypot(sumX / inner, sumY / inner);
    // A pixel is 2.2 km by 2.2 km cos(latitude): on average half of one is lost at either edge.
    double const pixel = 2.22 * 0.5 * (1.0 + std::cos(row.latitude * degree.si));
    double const width = most - least + pixel;
    RecordProperty("centre_error_m", static_cast<int>(centreError * 1e3));
    RecordProperty("width_error_m", static_cast<int>((width - row.widthKm) * 1e3));
    std::printf("JD %.5f  centre off by %.4f km (%d), width %.2f km for %.2f km (%d dark pixels)\n",
                row.jdTt, centreError, inner, width, row.widthKm, dark);
    EXPECT_LT(centreError, 3.0) << row.jdTt;
    EXPECT_NEAR(width, row.widthKm, 0.03 * row.widthKm) << row.jdTt;
  }
}

}  // namespace
}  // namespace antumbra
