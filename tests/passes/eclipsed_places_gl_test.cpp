// Light in the Moon's shadow where eclipses are not central, high or at sea level: a low Sun, wide
// and narrow shadows, partial and annular phases, from 10 km and from above the air, against rows
// of the path tracer (tests/authorities/eclipse_path_traced_places.csv says how they were made);
// and totality under hazes and dust (tests/authorities/eclipse_in_hazes.csv).
//
// Of every four places (twelve) one is tried with `balanced` and one with `accurate`.
// SKY_ALL_ROWS=1 tries every one, SKY_PRESET=NAME with one preset, and SHOW_SKY_ERRORS=PERCENT
// lists rows beyond that.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>

#include "atmosphere/sunlight.h"
#include "document/paths.h"
#include "passes/sky_sampler.h"
#include "tests/support/csv.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using EclipsedPlaces = testsupport::GlTest;

constexpr Length kMoonRadius{1737.4e3};
std::vector<Length> const kWavelengths{440.0 * nanometre, 680.0 * nanometre};

// As `antumbra sky --occulter`.
SkyRequest requestOf(const CsvRow& row, const Medium& medium) {
  SkyRequest request;
  request.altitude = row.number("altitude") * kilometre;
  request.sunZenith = row.number("sun_zenith") * degree;
  request.wavelengths = kWavelengths;
  Sunlight sun;
  sun.toSun = {{sin(request.sunZenith), 0.0, cos(request.sunZenith)}};
  double const azimuth = row.number("azimuth") * (degree / radian);
  double const shift = row.number("shift") * 1e3;
  Position<AirFrame> const axisPoint{{shift * std::cos(azimuth), shift * std::sin(azimuth),
                                      (medium.radius + request.altitude) / metre}};
  sun.occulters.push_back(occulterByRatio(row.number("ratio"), kMoonRadius, axisPoint, sun));
  request.casters = SunShadow(sun, kWavelengths.front()).pairs();
  return request;
}

struct Errors {
  double sum = 0.0, worst = 0.0, worstIrradiance = 0.0;
  int count = 0;
};

// The bars: radiance within 12 % in the mean and 35 % in any direction, irradiance within 10 %
// (`accurate`) and 20 % (`balanced`). Standard errors of the rows: irradiance 1.5 %, radiance 4 %.
void follow(const char* file, int every, double bar) {
  std::map<std::vector<std::string>, std::vector<CsvRow>> places;
  for (auto const& row : readCsv(rootFolder() / "tests/authorities" / file))
    places[{row.text("medium"), row.text("altitude"), row.text("sun_zenith"), row.text("ratio"),
            row.text("shift"), row.text("azimuth")}]
        .push_back(row);
  ASSERT_GE(places.size(), 15u);
  bool const all = std::getenv("SKY_ALL_ROWS");
  const char* const only = std::getenv("SKY_PRESET");
  const char* const shown = std::getenv("SHOW_SKY_ERRORS");
  std::map<std::pair<std::string, std::string>, std::unique_ptr<SkySampler>> samplers;
  std::map<std::string, Errors> errors;
  int number = 0;
  for (auto const& [place, rows] : places) {
    std::string const name = place.front();
    auto const invented = rootFolder() / "tests/authorities/media" / (name + ".toml");
    Medium const medium =
        readMedium(std::filesystem::exists(invented) ? invented : mediumFile(name));
    int const turn = number++ % every;
    for (std::string const preset : {"balanced", "accurate"}) {
      if (only ? preset != only : !all && turn != (preset == "balanced" ? 0 : every / 2)) continue;
      if (only && !all && turn % 2) continue;
      auto& sampler = samplers[{name, preset}];
      if (!sampler)
        sampler = std::make_unique<SkySampler>(medium, kWavelengths, AirQuality::preset(preset));
      SkyRequest request = requestOf(rows.front(), medium);
      std::vector<SkyIrradiance> irradiances;
      for (auto const& row : rows)
        if (row.text("kind") == "radiance")
          request.directions.push_back({row.number("vz") * degree, row.number("az") * degree});
        else if (irradiances.empty())
          irradiances = sampler->irradiance(request);
      auto const radiances = sampler->sample(request);
      std::size_t direction = 0;
      Errors here;
      for (auto const& row : rows) {
        bool const irradiance = row.text("kind") == "irradiance";
        std::size_t const w = row.number("wavelength") < 500.0 ? 0 : 1;
        double const found = irradiance ? irradiances[w].diffuse : radiances[2 * direction++ + w];
        double const error = found / row.number("value") - 1.0;
        std::string what = preset;
        for (auto const& cell : place) what += " " + cell;
        what += fmt::format(": {} {} nm {} {}: {:+.1f} %", row.text("kind"), row.text("wavelength"),
                            row.text("vz"), row.text("az"), 100.0 * error);
        if (shown && std::fabs(error) > 0.01 * std::atof(shown)) std::printf("%s\n", what.c_str());
        if (irradiance) {
          double const own = row.number("sd") / row.number("value");  // of the row
          EXPECT_LT(std::fabs(error), (preset == "accurate" ? 0.10 : 0.20) + own) << what;
          here.worstIrradiance = std::max(here.worstIrradiance, std::fabs(error));
        } else {
          EXPECT_LT(std::fabs(error), 0.35) << what;
          here.sum += std::fabs(error), ++here.count;
          here.worst = std::max(here.worst, std::fabs(error));
        }
      }
      // A place's own mean, of ten rows, keeps the bar of all.
      EXPECT_LT(here.sum / here.count, 0.12) << preset << rows.front().text("sun_zenith");
      auto& total = errors[preset];
      total.sum += here.sum, total.count += here.count;
      total.worst = std::max(total.worst, here.worst);
      total.worstIrradiance = std::max(total.worstIrradiance, here.worstIrradiance);
    }
  }
  for (auto const& [preset, e] : errors) {
    std::printf("%s: irradiance within %.1f %%; radiance mean %.1f %%, worst %.1f %% of %d\n",
                preset.c_str(), 100.0 * e.worstIrradiance, 100.0 * e.sum / e.count, 100.0 * e.worst,
                e.count);
    EXPECT_LT(e.sum / e.count, bar);
  }
}

TEST_F(EclipsedPlaces, FollowThePathTracer) { follow("eclipse_path_traced_places.csv", 4, 0.05); }

TEST_F(EclipsedPlaces, FollowThePathTracerUnderHazes) { follow("eclipse_in_hazes.csv", 12, 0.08); }

}  // namespace
}  // namespace antumbra
