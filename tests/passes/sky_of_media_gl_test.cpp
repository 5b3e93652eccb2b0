// The sky of many media, thick hazes and other planets' among them, against the path tracer.
//
// tests/authorities/sky_of_media.csv holds the path tracer's values with their standard errors and
// says how they were made. SKY_PRESET=NAME chooses the preset, SHOW_SKY_ERRORS=PERCENT lists rows.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "document/paths.h"
#include "passes/sky_sampler.h"
#include "tests/support/csv.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using SkyOfMediaGlTest = testsupport::GlTest;

struct Sum {
  int count = 0;
  double absolute = 0.0, worst = 0.0;
  void add(double error) {
    ++count;
    absolute += std::fabs(error);
    if (std::fabs(error) > std::fabs(worst)) worst = error;
  }
  double mean() const { return absolute / count; }
};

TEST_F(SkyOfMediaGlTest, FollowsThePathTracerInAnyAir) {
  const char* const file = std::getenv("SKY_OF_MEDIA");
  std::string const root = rootFolder() / "tests/authorities/";
  auto const rows = readCsv(file ? file : root + "sky_of_media.csv");
  const char* const preset = std::getenv("SKY_PRESET");
  const char* const shown = std::getenv("SHOW_SKY_ERRORS");
  AirQuality const quality = AirQuality::preset(preset ? preset : "balanced");
  std::map<std::string, std::map<std::pair<double, double>, std::vector<CsvRow>>> media;
  for (auto const& row : rows)
    media[row.text("medium")][{row.number("altitude_km"), row.number("sun_zenith_deg")}].push_back(
        row);
  ASSERT_FALSE(media.empty());
  for (auto const& [name, calls] : media) {
    std::string const invented = root + "media/" + name + ".toml";
    Medium const medium = readMedium(
        std::filesystem::exists(invented) ? std::filesystem::path(invented) : mediumFile(name));
    std::vector<Length> const wavelengths{450.0 * nanometre, 650.0 * nanometre};
    SkySampler sampler(medium, wavelengths, quality);
    Sum all;
    std::string groups;
    for (auto const& [place, list] : calls) {
      SkyRequest request;
      request.altitude = place.first * kilometre;
      request.sunZenith = place.second * degree;
      for (auto const& row : list)
        request.directions.push_back(
            {row.number("view_zenith_deg") * degree, row.number("rel_azimuth_deg") * degree});
      auto const found = sampler.sample(request);
      Sum group;
      for (std::size_t i = 0; i < list.size(); ++i)
        for (std::size_t w = 0; w < 2; ++w) {
          double const expected = list[i].number(w ? "radiance_650" : "radiance_450");
          double const sigma = list[i].number(w ? "sigma_650" : "sigma_450");
          double const value = found[2 * i + w];
          ASSERT_TRUE(std::isfinite(value) && value >= 0.0) << name;
          if (!(expected > 1e-7) || sigma > 0.05 * expected) continue;
          double const error = value / expected - 1.0;
          group.add(error);
          all.add(error);
          if (shown && 100.0 * std::fabs(error) > std::atof(shown))
            std::printf("  %s %g km Sun %g view %g az %g, %d nm: %.4g for %.4g: %+.1f %%\n",
                        name.c_str(), place.first, place.second, list[i].number("view_zenith_deg"),
                        list[i].number("rel_azimuth_deg"), w ? 650 : 450, value, expected,
                        100.0 * error);
        }
      if (!group.count) continue;
      char text[80];
      std::snprintf(text, sizeof text, "  %g/%g %.1f(%+.0f)", place.first, place.second,
                    100.0 * group.mean(), 100.0 * group.worst);
      groups += text;
    }
    std::printf("%-14s mean %.2f %% worst %+.1f %% |%s\n", name.c_str(), 100.0 * all.mean(),
                100.0 * all.worst, groups.c_str());
    std::fflush(stdout);
    // 0.5 to 1.4 % and 9 % are found with `balanced`; in thick air, where the path tracer's
    // standard error is 2.5 %, 2.1 to 2.4 % and 7 %, though the ground of Titan has a
    // ten-thousandth of the light left in the blue.
    bool const thick = name == "titan" || name == "venus";
    EXPECT_LT(all.mean(), thick ? 0.03 : 0.02) << name;
    EXPECT_LT(std::fabs(all.worst), 0.12) << name;
  }
}

}  // namespace
}  // namespace antumbra
