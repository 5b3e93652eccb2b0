// The programs' sky under the Moon's shadow against the Monte Carlo reference.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "document/paths.h"
#include "passes/sky_sampler.h"
#include "quantity/constants.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using EclipsedSky = testsupport::GlTest;

// The reference's geometry: observer at sea level, the Sun 35 degrees from the zenith in azimuth 0,
// the Moon's disc 1.0515 of the Sun's as seen from where the axis meets the horizontal plane,
// `shift` metres to the side.
glsl::ShadowPair referencePair(double radius, double shift, double sunZenithDegrees = 35.0,
                               double ratio = 1.0515) {
  double const z = sunZenithDegrees * degree.si;
  glm::dvec3 const toSun(std::sin(z), 0.0, std::cos(z));
  double const sunAngle = 0.004653, moonRadius = 1737.4e3;
  double const sunDistance = kSolarRadiusIau.si / sunAngle;
  double const moonDistance = moonRadius / (ratio * sunAngle);
  glm::dvec3 const place(0.0, shift, radius);
  return shadowPairMetres(place + sunDistance * toSun, place + moonDistance * toSun,
                          {kSolarRadiusIau, Length(moonRadius), Length(moonRadius)});
}

struct Row {
  std::string text;
  bool irradiance;
  double wavelengthNm, viewZenith, azimuth, value;
};

// Rows by distance from the axis in km; -1 without the eclipse.
std::map<double, std::vector<Row>> referenceRows() {
  std::ifstream in(rootFolder() / "tests/authorities/eclipse_mc_reference.csv");
  std::map<double, std::vector<Row>> rows;
  std::string line;
  while (std::getline(in, line)) {
    if (line.rfind("radiance", 0) != 0 && line.rfind("diffuse", 0) != 0) continue;
    if (line.find("max") != std::string::npos || line.find("uniform") != std::string::npos)
      continue;
    std::stringstream fields(line);
    std::vector<std::string> f;
    for (std::string s; std::getline(fields, s, ',');) f.push_back(s);
    bool const irradiance = f[0] != "radiance";
    rows[std::stod(f[2]) > 0.0 ? std::stod(f[3]) : -1.0].push_back(
        {line.substr(0, line.rfind(',')), irradiance, std::stod(f[1]),
         irradiance ? 0.0 : std::stod(f[4]), irradiance ? 0.0 : std::stod(f[5]), std::stod(f[6])});
  }
  return rows;
}

// Bars: irradiance within 10 % at every row although it spans a factor of 2000, radiance in
// totality within 12 % in the mean and 35 % in any direction. SKY_ALL_ROWS=1 tries every distance.
TEST_F(EclipsedSky, FollowsTheMonteCarloReference) {
  auto const medium = readMedium(mediumFile("reference_bruneton2017"));
  AirQuality quality;
  if (const char* preset = std::getenv("SKY_PRESET")) quality = AirQuality::preset(preset);
  double radianceSum = 0.0;
  int radianceCount = 0;
  std::vector<Length> const wavelengths{440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre};
  SkySampler sampler(medium, wavelengths, quality);
  for (auto const& [shift, rows] : referenceRows()) {
    if (!std::getenv("SKY_ALL_ROWS") && shift > 0.0 && shift != 100.0 && shift != 500.0) continue;
    SkyRequest request;
    request.altitude = Length(0.0);
    request.sunZenith = 35.0 * degree;
    request.wavelengths = wavelengths;
    if (shift >= 0.0) request.casters = {referencePair(medium.radius.si, shift * 1e3)};
    for (auto const& row : rows)
      request.directions.push_back({row.viewZenith * degree, row.azimuth * degree});
    std::vector<SkyIrradiance> irradiances;
    std::vector<double> radiances;
    if (rows.front().irradiance)
      irradiances = sampler.irradiance(request);
    else
      radiances = sampler.sample(request);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto const w = rows[i].wavelengthNm < 500.0 ? 0u : rows[i].wavelengthNm < 600.0 ? 1u : 2u;
      double const found = rows[i].irradiance ? irradiances[w].diffuse : radiances[i * 3 + w];
      double const error = found / rows[i].value - 1.0;
      std::printf("%s: %.4g, %+.1f %%\n", rows[i].text.c_str(), found, 100.0 * error);
      if (rows[i].irradiance) {
        EXPECT_LT(std::fabs(error), 0.10) << rows[i].text;
      } else {
        EXPECT_LT(std::fabs(error), shift < 0.0 ? 0.02 : 0.35) << rows[i].text;
        if (shift >= 0.0) radianceSum += std::fabs(error), ++radianceCount;
      }
    }
  }
  std::printf("radiance in totality: mean %.1f %%\n", 100.0 * radianceSum / radianceCount);
  EXPECT_LT(radianceSum / radianceCount, 0.12);
}

// Low and high Sun, wide, narrow and annular shadows: rows of the path tracer. Measured with
// `balanced`: irradiance within 3.5 % (but for twice the rows' own 0.7 %), radiance 2.7 % in the
// mean, 8 % at worst. SKY_ALL_ROWS=1 tries every row.
TEST_F(EclipsedSky, FollowsThePathTracerInOtherEclipses) {
  auto const medium = readMedium(mediumFile("reference_bruneton2017"));
  AirQuality quality;
  if (const char* preset = std::getenv("SKY_PRESET")) quality = AirQuality::preset(preset);
  std::vector<Length> const wavelengths{440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre};
  SkySampler sampler(medium, wavelengths, quality);
  std::ifstream in(rootFolder() / "tests/authorities/eclipse_path_traced.csv");
  struct Place {
    double sunZenith, ratio, shiftKm;
    auto operator<=>(const Place&) const = default;
  };
  std::map<Place, std::vector<Row>> places;
  std::string line;
  while (std::getline(in, line)) {
    std::stringstream fields(line);
    std::vector<std::string> f;
    for (std::string s; std::getline(fields, s, ',');) f.push_back(s);
    if (f[0] != "radiance" && f[0] != "irradiance") continue;
    bool const irradiance = f[0] == "irradiance";
    places[{std::stod(f[2]), std::stod(f[3]), std::stod(f[4])}].push_back(
        {line, irradiance, std::stod(f[7]), irradiance ? 0.0 : std::stod(f[8]),
         irradiance ? 0.0 : std::stod(f[9]), std::stod(f[10])});
  }
  ASSERT_GE(places.size(), 8u);
  double sum = 0.0, worst = 0.0, worstIrradiance = 0.0;
  int count = 0, number = 0;
  for (auto const& [place, rows] : places) {
    if (++number % 2 && !std::getenv("SKY_ALL_ROWS")) continue;
    SkyRequest request;
    request.altitude = Length(0.0);
    request.sunZenith = place.sunZenith * degree;
    request.wavelengths = wavelengths;
    request.casters = {
        referencePair(medium.radius.si, place.shiftKm * 1e3, place.sunZenith, place.ratio)};
    for (auto const& row : rows)
      request.directions.push_back({row.viewZenith * degree, row.azimuth * degree});
    auto const radiances = sampler.sample(request);
    auto const irradiances = sampler.irradiance(request);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto const w = rows[i].wavelengthNm < 500.0 ? 0u : rows[i].wavelengthNm < 600.0 ? 1u : 2u;
      double const found = rows[i].irradiance ? irradiances[w].diffuse : radiances[i * 3 + w];
      double const error = std::fabs(found / rows[i].value - 1.0);
      EXPECT_LT(error, rows[i].irradiance ? 0.06 : 0.15) << rows[i].text << ": " << found;
      if (rows[i].irradiance) {
        worstIrradiance = std::max(worstIrradiance, error);
      } else {
        worst = std::max(worst, error);
        sum += error;
        ++count;
      }
    }
  }
  std::printf("irradiance within %.1f %%; radiance mean %.1f %%, worst %.1f %%\n",
              100.0 * worstIrradiance, 100.0 * sum / count, 100.0 * worst);
  EXPECT_LT(sum / count, 0.04);
}

}  // namespace
}  // namespace antumbra
