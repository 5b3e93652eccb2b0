// Scattered light under two Moons at once: shadows apart, touching, overlapping, one upon the
// other, against the path tracer (tests/authorities/two_shadows_path_traced.csv), whose every
// scattering point sees the union of the discs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "atmosphere/sunlight.h"
#include "document/paths.h"
#include "passes/sky_sampler.h"
#include "tests/support/csv.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using TwoShadows = testsupport::GlTest;

constexpr Length kMoonRadius{1737.4e3};
constexpr Angle kSunZenith{35.0 * degree.si};
std::vector<Length> const kWavelengths{440.0 * nanometre, 680.0 * nanometre};

// Moons by ratio and shift in km, as `antumbra sky --occulter`.
SkyRequest requestOf(const Medium& medium, const std::vector<std::pair<double, double>>& moons) {
  SkyRequest request;
  request.altitude = Length(0.0);
  request.sunZenith = kSunZenith;
  request.wavelengths = kWavelengths;
  Sunlight sun;
  sun.toSun = {{sin(kSunZenith), 0.0, cos(kSunZenith)}};
  for (auto const& [ratio, shift] : moons)
    sun.occulters.push_back(
        occulterByRatio(ratio, kMoonRadius, {{0.0, shift * 1e3, medium.radius / metre}}, sun));
  request.casters = SunShadow(sun, kWavelengths.front()).pairs();
  return request;
}

std::vector<std::pair<double, double>> moonsOf(const CsvRow& row) {
  return {{row.number("ratio1"), row.number("shift1")},
          {row.number("ratio2"), row.number("shift2")}};
}

// Two Moons that hide the Sun between them from either side leave a place under 5e-4 of its light,
// all of it from afar: there the light is not held to the bars of a single Moon.
bool closedFromBothSides(const CsvRow& row) {
  double const near = std::max(row.number("shift1"), -row.number("shift2"));
  return near < 0.0 && near >= -500.0;
}

TEST_F(TwoShadows, LightUnderTheirUnionFollowsThePathTracer) {
  auto const medium = readMedium(mediumFile("reference_bruneton2017"));
  std::map<std::vector<std::pair<double, double>>, std::vector<CsvRow>> places;
  for (auto const& row : readCsv(rootFolder() / "tests/authorities/two_shadows_path_traced.csv"))
    places[moonsOf(row)].push_back(row);
  ASSERT_GE(places.size(), 12u);
  bool const all = std::getenv("SKY_ALL_ROWS");
  const char* const preset = std::getenv("SKY_PRESET");
  const char* const shown = std::getenv("SHOW_SKY_ERRORS");
  SkySampler sampler(medium, kWavelengths, AirQuality::preset(preset ? preset : "balanced"));
  double sum = 0.0, worst = 0.0, worstIrradiance = 0.0, worstClosed = 0.0;
  int count = 0, number = 0;
  for (auto const& [moons, rows] : places) {
    if (!all && number++ % 2) continue;
    SkyRequest request = requestOf(medium, moons);
    std::vector<SkyIrradiance> irradiances;
    for (auto const& row : rows)
      if (row.text("kind") == "radiance")
        request.directions.push_back({row.number("vz") * degree, row.number("az") * degree});
      else if (irradiances.empty())
        irradiances = sampler.irradiance(request);
    auto const radiances = sampler.sample(request);
    std::size_t direction = 0;
    for (auto const& row : rows) {
      bool const irradiance = row.text("kind") == "irradiance";
      std::size_t const w = row.number("wavelength") < 500.0 ? 0 : 1;
      double const found = irradiance ? irradiances[w].diffuse : radiances[2 * direction++ + w];
      double const error = std::fabs(found / row.number("value") - 1.0);
      std::string const what = fmt::format(
          "{} {} km, {} {} km, {} nm {} {}: {:.4g} {:+.1f} %", moons[0].first, moons[0].second,
          moons[1].first, moons[1].second, row.text("wavelength"), row.text("vz"), row.text("az"),
          found, 100.0 * (found / row.number("value") - 1.0));
      if (shown && 100.0 * error > std::atof(shown)) std::printf("%s\n", what.c_str());
      if (closedFromBothSides(row)) {
        // A product of the two shares errs here by factors of up to 44, either way.
        EXPECT_LT(error, 0.75) << what;
        worstClosed = std::max(worstClosed, error);
      } else if (irradiance) {
        EXPECT_LT(error, 0.20) << what;
        worstIrradiance = std::max(worstIrradiance, error);
      } else {
        // 38 % in one red row 1 degree above the horizon; the next is 31 %.
        EXPECT_LT(error, 0.40) << what;
        worst = std::max(worst, error);
        sum += error, ++count;
      }
    }
  }
  std::printf(
      "irradiance within %.1f %%; radiance mean %.1f %%, worst %.1f %% of %d; closed from "
      "both sides: %.0f %%\n",
      100.0 * worstIrradiance, 100.0 * sum / count, 100.0 * worst, count, 100.0 * worstClosed);
  EXPECT_LT(sum / count, 0.12);
}

// Whatever one Moon leaves, a second at the same place leaves too, and one far away takes nothing.
TEST_F(TwoShadows, ASecondMoonBehindTheFirstOrFarAwayChangesNothing) {
  auto const medium = readMedium(mediumFile("reference_bruneton2017"));
  SkySampler sampler(medium, kWavelengths, AirQuality::preset("draft"));
  auto const look = [&](const std::vector<std::pair<double, double>>& moons) {
    SkyRequest request = requestOf(medium, moons);
    request.directions = {{Angle(0.0), Angle(0.0)}, {80.0 * degree, 30.0 * degree}};
    return sampler.sample(request);
  };
  for (double shift : {0.0, 1500.0}) {
    auto const one = look({{1.05, shift}});
    auto const same = look({{1.05, shift}, {1.05, shift}});
    auto const far = look({{1.05, shift}, {1.05, shift + 7500.0}});
    for (std::size_t i = 0; i < one.size(); ++i) {
      // What 16 bits of the map and floats of two equal discs resolve.
      EXPECT_NEAR(same[i] / one[i], 1.0, 0.004) << shift;
      EXPECT_NEAR(far[i] / one[i], 1.0, 0.002) << shift;
    }
  }
}

}  // namespace
}  // namespace antumbra
