// Twilight under sunlight that the air bends, as drawn: against rays followed by their differential
// equation, against the path tracer, and against measured zeniths.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "atmosphere/single_scattering.h"
#include "document/paths.h"
#include "passes/bent_sun_texels.h"
#include "passes/sky_sampler.h"
#include "photometry/colour.h"
#include "photometry/magnitude.h"
#include "photometry/spectral_weights.h"
#include "shared/as_cpp.h"
#include "tests/support/csv.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ray_equation.h"

namespace antumbra {
namespace {

using BentSunlightGlTest = testsupport::GlTest;

Medium catalogue(const std::string& name) { return readMedium(mediumFile(name)); }

// Zenith radiance over E0 at the ground by sunlight scattered once: rays of the differential
// equation to heights 1 km apart.
double zenithByRays(const Medium& medium, Length wavelength, double sunZenith) {
  testsupport::RayEquation const rays(medium, wavelength);
  double const cosine = std::cos(sunZenith), step = 1e3;
  double sum = 0.0;
  for (double h = 0.5 * step; h < medium.topHeight.si; h += step) {
    double scattered = 0.0, depth = 0.0;
    for (auto const& c : medium.constituents) {
      double const scattering = c.scattering.at(wavelength);
      depth += (scattering + c.absorption.at(wavelength)) *
               (c.density.column(Length(0.0), Length(h)) / metre);
      if (scattering > 0.0)
        scattered +=
            scattering * c.density.atMetres(h) * SpectralPhase(c.phase, wavelength).at(cosine);
    }
    sum += step * scattered * std::exp(-depth) * rays.lightOf(h, sunZenith);
  }
  return sum;
}

// The texels of the presets against rays followed for each of a disc's slices.
TEST(BentSunTexels, FollowTheRayEquationOverTheDisc) {
  Medium const medium = catalogue("earth");
  double const sunRadius = 0.00465, radius = medium.radius.si, top = medium.topHeight.si;
  constexpr int slices = 8;
  struct Point {
    double height, zenith, light[2];  // at 450 and 650 nm
  };
  std::vector<Length> const wavelengths{450.0 * nanometre, 650.0 * nanometre};
  std::vector<Point> points;
  for (double h : {0.0, 3e3, 14e3, 33e3})
    for (double zenith = 88.0; zenith <= 100.0; zenith += 1.5)
      points.push_back({h, zenith * degree.si, {0.0, 0.0}});
  std::vector<BentColour> colours(4);
  for (std::size_t w = 0; w < 2; ++w) {
    colours[w].refractivity = medium.refractivity.at(wavelengths[w]);
    for (auto const& c : medium.constituents)
      colours[w].extinction.push_back(c.scattering.at(wavelengths[w]) +
                                      c.absorption.at(wavelengths[w]));
    colours[w + 2] = colours[w];
    testsupport::RayEquation const rays(medium, wavelengths[w]);
    for (auto& point : points)
      for (int k = 0; k < slices; ++k) {
        double const phi = M_PI * (k + 0.5) / slices;
        point.light[w] += 2.0 / slices * std::sin(phi) * std::sin(phi) *
                          rays.lightOf(point.height, point.zenith + sunRadius * std::cos(phi));
      }
  }
  glsl::AirShell shell{};
  shell.radius = radius;
  shell.top = top;
  shell.widest = std::sqrt(top * (2.0 * radius + top));
  shell.overWidest = 1.0 / shell.widest;
  for (std::string const preset : {"draft", "balanced", "accurate"}) {
    AirQuality const quality = AirQuality::preset(preset);
    int const width = quality.depthWidth, height = quality.depthHeight;
    auto const texels =
        bentSunTexels(medium, medium.radius, Angle(sunRadius), colours, width, height, 64);
    auto const lightAt = [&](double h, double zenith, int channel) {
      auto const place = glsl::sunCoordinatesOf(
          shell, glsl::depthRow(shell, h), (radius + h) * std::cos(zenith), 1.0 / texels.reach);
      double const x = place.x * (width - 1), y = place.y * (height - 1);
      int const x0 = std::min(static_cast<int>(x), width - 2);
      int const y0 = std::min(static_cast<int>(y), height - 2);
      auto const at = [&](int i, int k) {
        return static_cast<double>(
            texels.depths[static_cast<std::size_t>(((y0 + k) * width + x0 + i) * 4 + channel)]);
      };
      double const s = x - x0, t = y - y0;
      return std::exp(-((1.0 - t) * ((1.0 - s) * at(0, 0) + s * at(1, 0)) +
                        t * ((1.0 - s) * at(0, 1) + s * at(1, 1))));
    };
    double worst = 0.0, sum = 0.0;
    for (auto const& point : points)
      for (int w : {0, 1}) {
        double const error = std::fabs(lightAt(point.height, point.zenith, w) - point.light[w]);
        worst = std::max(worst, error);
        sum += error / static_cast<double>(2 * points.size());
      }
    std::printf("%-8s mean %.4f, worst %.4f of the free Sun's light\n", preset.c_str(), sum, worst);
    // Linear steps between texels.
    EXPECT_LT(sum, 0.002) << preset;
    EXPECT_LT(worst, preset == "draft" ? 0.02 : 0.01) << preset;
  }
}

TEST_F(BentSunlightGlTest, SingleScatteringFollowsTheRayEquation) {
  Medium const medium = catalogue("earth");
  std::vector<Length> const wavelengths{450.0 * nanometre, 650.0 * nanometre};
  AirQuality quality;
  quality.orders = 0;
  SkySampler sampler(medium, wavelengths, quality);
  for (double sunZenith : {92.0, 97.0}) {
    SkyRequest request;
    request.sunZenith = sunZenith * degree;
    request.directions = {{0.0 * degree, 0.0 * degree}};
    auto const drawn = sampler.sample(request);
    Sunlight sun;
    sun.toSun.u = {sin(request.sunZenith), 0.0, cos(request.sunZenith)};
    for (std::size_t w = 0; w < 2; ++w) {
      double const expected = zenithByRays(medium, wavelengths[w], sunZenith * degree.si);
      double const reference = SingleScattering(medium, sun, wavelengths[w], medium.radius)
                                   .radiance({{0.0, 0.0, medium.radius.si}}, {{0.0, 0.0, 1.0}});
      std::printf("Sun %.0f, %.0f nm: %.4g; integrator %+.2f %%, drawn %+.2f %%\n", sunZenith,
                  wavelengths[w] / nanometre, expected, 100.0 * (reference / expected - 1.0),
                  100.0 * (drawn[w] / expected - 1.0));
      // Steps of a kilometre, and those of `balanced`.
      EXPECT_NEAR(reference / expected, 1.0, 0.015);
      EXPECT_NEAR(drawn[w] / expected, 1.0, 0.03);
    }
  }
}

// From sunset to nautical twilight, all orders. SKY_PRESET=NAME chooses one preset,
// SHOW_SKY_ERRORS=1 lists rows.
TEST_F(BentSunlightGlTest, TwilightFollowsThePathTracer) {
  std::map<double, std::vector<CsvRow>> suns;
  for (auto const& row : readCsv(rootFolder() / "tests/authorities/twilight_path_tracer.csv"))
    suns[row.number("sun_zenith_deg")].push_back(row);
  std::vector<Length> const wavelengths{450.0 * nanometre, 550.0 * nanometre, 650.0 * nanometre};
  const char* const only = std::getenv("SKY_PRESET");
  bool const shown = std::getenv("SHOW_SKY_ERRORS") != nullptr;
  for (std::string const preset : {"draft", "balanced", "accurate"}) {
    if (only && preset != only) continue;
    SkySampler sampler(catalogue("earth"), wavelengths, AirQuality::preset(preset));
    for (auto const& [sunZenith, rows] : suns) {
      SkyRequest request;
      request.altitude = 30.0 * metre;
      request.sunZenith = sunZenith * degree;
      for (std::size_t i = 0; i < rows.size(); i += wavelengths.size())
        request.directions.push_back({rows[i].number("view_zenith_deg") * degree,
                                      rows[i].number("rel_azimuth_deg") * degree});
      auto const found = sampler.sample(request);
      ASSERT_EQ(found.size(), rows.size());
      double mean = 0.0, worst = 0.0, zenith = 0.0;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].number("wavelength_nm"), wavelengths[i % 3] / nanometre);
        double const error = found[i] / rows[i].number("radiance") - 1.0;
        mean += std::fabs(error) / static_cast<double>(rows.size());
        if (std::fabs(error) > std::fabs(worst)) worst = error;
        if (rows[i].number("view_zenith_deg") == 0.0 && i % 3 == 1) zenith = error;
        if (shown)
          std::printf("%s Sun %g, view %s az %s, %s nm: %+.1f %%\n", preset.c_str(), sunZenith,
                      rows[i].text("view_zenith_deg").c_str(),
                      rows[i].text("rel_azimuth_deg").c_str(),
                      rows[i].text("wavelength_nm").c_str(), 100.0 * error);
      }
      std::printf("%-8s Sun %5.1f: mean %.1f %%, worst %+.1f %%; zenith at 550 nm %+.1f %%\n",
                  preset.c_str(), sunZenith, 100.0 * mean, 100.0 * worst, 100.0 * zenith);
      // The path tracer's own error is 1 to 3 %. The rest is that of few directions and, in
      // `draft`, few harmonics. Light interpolated by itself between cells of the source, and
      // directions in square steps, erred by 35 % in the mean and 70 % at worst.
      bool const coarse = preset == "draft";
      EXPECT_LT(mean, coarse ? 0.22 : 0.09) << preset << " " << sunZenith;
      EXPECT_LT(std::fabs(worst), coarse ? 0.50 : 0.18) << preset << " " << sunZenith;
      EXPECT_LT(std::fabs(zenith), coarse ? 0.18 : 0.14) << preset << " " << sunZenith;
    }
  }
}

// Magnitudes per square arc second of the zenith as drawn, between what was measured at two
// mountains; and in Maryland.
TEST_F(BentSunlightGlTest, ZenithTwilightLiesBetweenThePublishedOnes) {
  std::map<std::string, std::map<double, double>> published;
  for (auto const& row : readCsv(rootFolder() / "tests/authorities/twilight_zenith_published.csv"))
    if (!row.empty("luminance_cd_m2"))
      published[row.text("source")][row.number("sun_zenith_deg")] =
          surfaceBrightnessOfLuminance(row.number("luminance_cd_m2"));
  // Koomen's table has every third degree; twilight falls evenly between.
  auto const mountainOf = [&](double sunZenith) {
    auto const& rows = published.at("koomen1952_sacpeak");
    auto const after = rows.lower_bound(sunZenith);
    if (after->first == sunZenith) return after->second;
    auto const before = std::prev(after);
    double const t = (sunZenith - before->first) / (after->first - before->first);
    return before->second + t * (after->second - before->second);
  };
  for (std::string const preset : {"balanced", "accurate"}) {
    AirQuality const quality = AirQuality::preset(preset);
    auto const wavelengths = defaultWavelengths(quality.wavelengths);
    auto const weights = linearSrgbWeights(wavelengths);
    auto const magnitude = [&](SkySampler& sampler, double heightMetres, double sunZenith) {
      SkyRequest request;
      request.altitude = Length(heightMetres);
      request.sunZenith = sunZenith * degree;
      request.wavelengths = wavelengths;
      request.directions = {{0.0 * degree, 0.0 * degree}};
      auto const found = sampler.sample(request);
      glm::dvec3 rgb(0.0);
      for (std::size_t w = 0; w < weights.size(); ++w) rgb += weights[w] * found[w];
      return surfaceBrightnessOfLuminance(luminanceOf(rgb));
    };
    SkySampler high(catalogue("earth_high_site"), wavelengths, quality);
    for (double sunZenith = 93.0; sunZenith <= 101.0; sunZenith += 2.0) {
      double const koomen = mountainOf(sunZenith);
      double const sacramento = magnitude(high, 165.0, sunZenith);
      // Patat's fit begins at 95 degrees, 0.8 mag brighter than Koomen's zenith there.
      auto const patat = published.at("patat2006").find(sunZenith);
      bool const fitted = patat != published.at("patat2006").end();
      double const brightest = fitted ? patat->second : koomen - 0.8;
      double const paranal = fitted ? magnitude(high, 0.0, sunZenith) : sacramento;
      std::printf("%-8s Sun %3.0f: 2635 m %.2f, Patat %.2f; 2800 m %.2f, Koomen %.2f\n",
                  preset.c_str(), sunZenith, paranal, fitted ? patat->second : NAN, sacramento,
                  koomen);
      EXPECT_GT(paranal, brightest) << sunZenith;
      EXPECT_LT(paranal, koomen) << sunZenith;
      EXPECT_GT(sacramento, brightest) << sunZenith;
      EXPECT_LT(sacramento, koomen) << sunZenith;
    }
    SkySampler low(catalogue("earth"), wavelengths, quality);
    for (double sunZenith : {93.0, 96.0, 99.0}) {
      double const maryland = published.at("koomen1952_maryland").at(sunZenith);
      double const found = magnitude(low, 30.0, sunZenith);
      std::printf("%-8s Sun %3.0f: 30 m %.2f, Koomen %.2f\n", preset.c_str(), sunZenith, found,
                  maryland);
      // Koomen's readings have one or two figures (a "2" may be up to 0.3 mag brighter); the path
      // tracer's zenith is the drawn one, 0.3 mag fainter than his with the Sun 3 and 6 degrees
      // down.
      EXPECT_NEAR(found, maryland, 0.32) << sunZenith;
    }
  }
}

}  // namespace
}  // namespace antumbra
