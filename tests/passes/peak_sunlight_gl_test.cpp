// Sunlight turned by forward peaks alone, against the path tracer in a medium whose only scattering
// those peaks are: its light from all directions and the Sun's own, at a point and on the ground.
#include "passes/peak_sunlight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "atmosphere/path_tracer.h"
#include "passes/air_tables.h"
#include "passes/gauss_legendre.h"
#include "shared/as_cpp.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using PeakSunlightGlTest = testsupport::GlTest;
Length const kWavelength = 550.0 * nanometre;
constexpr double kPi = std::numbers::pi;

// Haze of a vertical depth; it bends light by nothing that could be measured, so that tables hold
// the ground's sunlight.
Medium hazeOf(double depth, PhaseFunction phase, double scattered) {
  Medium medium;
  medium.name = "haze";
  medium.radius = 6360.0 * kilometre;
  medium.topHeight = 60.0 * kilometre;
  medium.groundAlbedo = Spectrum(0.0);
  double const perMetre = depth / 2000.0;
  medium.constituents.push_back({"haze", DensityProfile::exponential(2.0 * kilometre),
                                 Spectrum(perMetre * scattered),
                                 Spectrum(perMetre * (1.0 - scattered)), std::move(phase)});
  medium.refractivity = Spectrum(1e-12);
  medium.refractingConstituent = "haze";
  return medium;
}

// The same with nothing scattered but by the peak.
Medium peaksOf(double depth, const ForwardPeak& split) {
  std::vector<Angle> angles;
  std::vector<double> values;
  for (int i = 0; i <= 600; ++i) {
    double const x = i / 600.0;
    angles.emplace_back(kPi * x * x);
    values.push_back(split.peak(std::cos(angles.back().si)));
  }
  return hazeOf(depth, PhaseFunction::table(angles, values), split.share());
}

double lookUp(const std::vector<float>& texels, const gl::Texture& table, int layer, double x,
              double y) {
  double const u = x * (table.width() - 1), v = y * (table.height() - 1);
  int const i = std::min(static_cast<int>(u), table.width() - 2);
  int const k = std::clamp(static_cast<int>(v), 0, std::max(table.height() - 2, 0));
  auto const at = [&](int a, int b) {
    return static_cast<double>(
        texels[static_cast<std::size_t>(((layer * table.height() + b) * table.width() + a) * 4)]);
  };
  double const s = u - i, t = table.height() > 1 ? v - k : 0.0;
  int const next = table.height() > 1 ? k + 1 : k;
  return (1.0 - t) * ((1.0 - s) * at(i, k) + s * at(i + 1, k)) +
         t * ((1.0 - s) * at(i, next) + s * at(i + 1, next));
}

TEST_F(PeakSunlightGlTest, FollowsThePathTracer) {
  AirQuality const quality;
  for (auto const& [g, depth] : {std::pair{0.9, 1.0}, {0.98, 0.6}}) {
    auto const phase = PhaseFunction::henyeyGreenstein(Spectrum(g));
    ForwardPeak const split(phase, kWavelength, quality.hazeDegree);
    Medium const medium = hazeOf(depth, phase, 1.0), peaks = peaksOf(depth, split);
    AirTables const tables(medium, medium.radius, {kWavelength}, quality, Angle(0.0));
    ASSERT_TRUE(tables.hazy() && tables.bent());
    auto const depths = tables.depths().readRgba();
    glsl::AirShell shell{};
    shell.radius = medium.radius.si;
    shell.top = medium.topHeight.si;
    shell.widest = std::sqrt(shell.top * (2.0 * shell.radius + shell.top));
    shell.overWidest = 1.0 / shell.widest;
    shell.overTop = 1.0 / shell.top;
    for (double sunZenith : {75.0, 85.0})
      for (double height : {0.0, 2e3}) {
        Sunlight sun;
        double const zenith = sunZenith * degree.si;
        sun.toSun.u = {std::sin(zenith), 0.0, std::cos(zenith)};
        PathTracer const tracer(peaks, sun, kWavelength, peaks.radius);
        PathTracerSettings settings;
        settings.relativeError = 0.03;
        settings.maxPaths = 1 << 15;
        Position<AirFrame> const at{{0.0, 0.0, shell.radius + std::max(height, 0.1)}};
        auto const place = glsl::depthCoordinatesOf(shell, glsl::depthRow(shell, height),
                                                    (shell.radius + height) * std::cos(zenith));
        double const own = std::exp(-lookUp(depths, tables.depths(), 3, place.x, place.y));
        double const drawn = std::exp(-lookUp(depths, tables.depths(), 2, place.x, place.y));
        // As if peaks turned nothing.
        double const straight = std::pow(own, 1.0 - split.share());
        // Directions: cosine of the turn dense forward, and azimuths about the Sun.
        double turned = 0.0;
        auto const nodes = gaussLegendre(10);
        constexpr int turns = 8;
        for (auto const& node : nodes)
          for (int i = 0; i < turns; ++i) {
            double const x = static_cast<double>(node.x), angle = 1.4 * x * x;
            double const around = kPi * (i + 0.5) / turns;
            glm::dvec3 const up(-std::cos(zenith), 0.0, std::sin(zenith)), side(0.0, 1.0, 0.0);
            Direction<AirFrame> look;
            look.u = std::cos(angle) * sun.toSun.u +
                     std::sin(angle) * (std::cos(around) * up + std::sin(around) * side);
            double const weight =
                static_cast<double>(node.y) * 2.8 * x * std::sin(angle) * 2.0 * kPi / turns;
            turned += weight * tracer.radiance(at, look, settings).value;
          }
        std::printf(
            "g %.2f depth %.1f Sun %.0f at %.0f km: own %.4g, turned %.4g; drawn %+.1f %%, "
            "straight %+.1f %%\n",
            g, depth, sunZenith, height / 1e3, own, turned, 100.0 * (drawn / (own + turned) - 1.0),
            100.0 * (straight / (own + turned) - 1.0));
        // 3 % of it is what the reference's own directions and paths leave open.
        EXPECT_NEAR(drawn, own + turned, 0.045 * (own + turned) + 0.008);
      }
  }
}

}  // namespace
}  // namespace antumbra
