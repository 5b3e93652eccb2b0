// The drawn sky at the extremes: any medium, camera, Sun and direction, and a furnace.
//
// The suite takes a few media; a million radiances:
//   ANTUMBRA_FUZZ=800 build/release/test_passes_gl --gtest_filter='SkyExtremes*'
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "atmosphere/single_scattering.h"
#include "passes/gauss_legendre.h"
#include "passes/sky_sampler.h"
#include "shared/as_cpp.h"
#include "tests/support/any_medium.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using SkyExtremesGlTest = testsupport::GlTest;
using testsupport::AnyMedium;

double cosineToSun(Angle sunZenith, const SkyDirection& seen) {
  return cos(sunZenith) * cos(seen.viewZenith) +
         sin(sunZenith) * sin(seen.viewZenith) * cos(seen.relativeAzimuth);
}

// What no sky outshines under a Sun of unit irradiance, 1/sr. Each order's source per extinction is
// at most the phase function convolved with itself as often, for a ray collects at most the
// greatest source on its way; the orders share the light, so that the brightest convolution stands
// for all of the peak. Henyey-Greenstein's convolve to g^n; Cornette-Shanks is at most 1.5 times
// that. Light that has lost its direction adds less than 1: a white ground below conservative air
// has 1 / pi, conservative air deep within 0.5.
double brightestPossible(const Medium& medium, Length wavelength, double cosine) {
  double most = 0.0;
  for (auto const& c : medium.constituents) {
    most = std::max(most, c.phase.at(wavelength, cosine));
    bool const exact = c.phase.kind() == PhaseFunction::Kind::kHenyeyGreenstein;
    if (!exact && c.phase.kind() != PhaseFunction::Kind::kCornetteShanks) continue;
    double const g = c.phase.forwardG().at(wavelength);
    for (double power = g * g; std::fabs(power) > 1e-3; power *= g)
      most = std::max(most, (exact ? 1.0 : 1.5) * glsl::henyeyGreensteinPhase(cosine, power));
  }
  return most + 1.0;
}

TEST_F(SkyExtremesGlTest, StaysFiniteForAnyMedium) {
  const char* const given = std::getenv("ANTUMBRA_FUZZ");
  int const media = given ? std::atoi(given) : 8;
  const char* const begin = std::getenv("ANTUMBRA_FUZZ_FIRST");
  const char* const preset = std::getenv("SKY_PRESET");
  AirQuality const quality = AirQuality::preset(preset ? preset : "draft");
  constexpr int kViews = 20, kDirections = 64;
  Length const wavelength = 550.0 * nanometre;
  long bad = 0, count = 0, notFinite = 0, negative = 0, tooBright = 0;
  int const first = begin ? std::atoi(begin) : 0;
  for (int i = first; i < first + media; ++i) {
    AnyMedium any(static_cast<unsigned>(i));
    Medium const medium = any.medium();
    double const factor = any.factor();
    Angle const sunRadius(any.oneOf({0.0, 0.00465, 0.05}));
    SkySampler sampler(medium, {wavelength}, quality, sunRadius);
    for (int view = 0; view < kViews; ++view) {
      SkyRequest request;
      request.altitude = any.altitude(medium);
      request.sunZenith = any.zenithAngle(medium, request.altitude);
      request.sunRadius = sunRadius;
      request.wavelengths = {wavelength};
      for (int d = 0; d < kDirections; ++d)
        request.directions.push_back({any.zenithAngle(medium, request.altitude), any.azimuth()});
      request.directions[0] = {request.sunZenith, Angle(0.0)};
      request.directions[1] = {180.0 * degree - request.sunZenith, 180.0 * degree};
      auto const found = sampler.sample(request);
      for (int d = 0; d < kDirections; ++d, ++count) {
        double const value = found[static_cast<std::size_t>(d)];
        auto const& seen = request.directions[static_cast<std::size_t>(d)];
        double const most =
            brightestPossible(medium, wavelength, cosineToSun(request.sunZenith, seen));
        if (value >= 0.0 && value <= most && std::isfinite(value)) continue;
        (std::isfinite(value) ? value < 0.0 ? negative : tooBright : notFinite)++;
        if (++bad > 20) continue;
        auto const& look = request.directions[static_cast<std::size_t>(d)];
        ADD_FAILURE() << "medium " << i << ": radiance " << value << " (at most " << most
                      << "), factor " << factor << ", radius " << medium.radius / metre << ", top "
                      << medium.topHeight / metre << ", altitude " << request.altitude / metre
                      << ", Sun " << request.sunZenith / degree << ", view "
                      << look.viewZenith / degree << " azimuth " << look.relativeAzimuth / degree;
      }
    }
  }
  EXPECT_EQ(bad, 0) << "of " << count << " radiances";
  std::printf("%ld radiances in %d media: %ld not finite, %ld negative, %ld too bright\n", count,
              media, notFinite, negative, tooBright);
}

// Finite is not enough: sunlight scattered once, against the integrator, in any medium.
TEST_F(SkyExtremesGlTest, FollowsTheIntegratorInAnyMedium) {
  constexpr double kDensest = 10.0;
  const char* const given = std::getenv("ANTUMBRA_FUZZ");
  int const media = given ? std::atoi(given) : 30;
  const char* const preset = std::getenv("SKY_PRESET");
  AirQuality quality = AirQuality::preset(preset ? preset : "balanced");
  quality.orders = 0;
  Length const wavelength = 550.0 * nanometre;
  std::vector<double> errors;
  for (int i = 0; i < media; ++i) {
    AnyMedium any(static_cast<unsigned>(i));
    Medium const medium = any.medium();
    if (any.factor() == 0.0 || any.factor() > kDensest) continue;
    SkySampler sampler(medium, {wavelength}, quality);
    for (int view = 0; view < 4; ++view) {
      SkyRequest request;
      request.altitude = std::max(any.altitude(medium), 0.0 * metre);
      request.sunZenith = any.zenithAngle(medium, request.altitude);
      request.wavelengths = {wavelength};
      for (int d = 0; d < 6; ++d)
        request.directions.push_back({any.zenithAngle(medium, request.altitude), any.azimuth()});
      auto const found = sampler.sample(request);
      Sunlight sun;
      sun.toSun.u = {sin(request.sunZenith), 0.0, cos(request.sunZenith)};
      SingleScattering const integrator(medium, sun, wavelength, medium.radius);
      for (std::size_t d = 0; d < found.size(); ++d) {
        auto const& look = request.directions[d];
        Angle const z = look.viewZenith;
        double const expected = integrator.radiance(
            {{0.0, 0.0, (medium.radius + request.altitude).si}}, airDirectionOf(look));
        // What is dark, and edges that a float does not resolve, say nothing.
        double const edge = AnyMedium::horizon(medium, request.altitude) / degree;
        if (!(expected > 1e-9) || std::fabs(z / degree - edge) < 1e-3) continue;
        errors.push_back(std::fabs(found[d] / expected - 1.0));
        if (std::getenv("SHOW_SKY_ERRORS") && errors.back() > 0.1)
          std::printf(
              "medium %d factor %g radius %.4g top %.4g g %.2f altitude %.9g Sun %.7f view %.7f az "
              "%.1f: %.4g for %.4g\n",
              i, any.factor(), medium.radius.si, medium.topHeight.si,
              medium.constituents[1].phase.meanCosine(wavelength), request.altitude.si,
              request.sunZenith / degree, z / degree, look.relativeAzimuth / degree, found[d],
              expected);
      }
    }
  }
  ASSERT_GT(errors.size(), 100u);
  std::sort(errors.begin(), errors.end());
  auto const share = [&](double s) {
    return errors[static_cast<std::size_t>(s * static_cast<double>(errors.size() - 1))];
  };
  // Measured over 200 media: 0.07 % and 8 %. The rest are layers thinner than the steps, backward
  // peaks of g near -1, and sunlight that grazes a body of which the air is a millionth.
  EXPECT_LT(share(0.5), 0.01);
  EXPECT_LT(share(0.9), 0.20);
  std::printf("%zu radiances: half within %.2g %%, 90 %% within %.2g %%, 99 %% within %.2g %%\n",
              errors.size(), 100.0 * share(0.5), 100.0 * share(0.9), 100.0 * share(0.99));
}

// A furnace: air and ground that absorb nothing return all sunlight. The flux that leaves the top,
// of every place and in every direction, and what passes the ground by unscattered, over that of
// the sphere's cross section.
double returnedShare(const Medium& medium, const AirQuality& quality) {
  Length const wavelength = 550.0 * nanometre;
  double const ground = medium.radius.si, top = medium.topRadius().si;
  SkySampler sampler(medium, {wavelength}, quality);
  SkyRequest request;
  request.altitude = medium.topHeight + 1e-6 * medium.topRadius();
  request.wavelengths = {wavelength};
  // Directions that sink, as places x of [0, 1]: below the horizon's zenith angle and above it.
  auto const nodes = gaussLegendre(12);
  constexpr int turns = 8;
  double const edge = (ground / top) * (ground / top);  // sine squared of the horizon's nadir angle
  std::vector<double> weights;
  for (auto const& [from, to] : {std::pair{0.0, edge}, {edge, 1.0}})
    for (auto const& node : nodes)
      for (int turn = 0; turn < turns; ++turn) {
        // Flux through the horizontal is pi times the mean over the sine squared.
        double const x = static_cast<double>(node.x), square = from + (to - from) * x;
        request.directions.push_back({Angle(std::numbers::pi - std::asin(std::sqrt(square))),
                                      Angle(std::numbers::pi * (turn + 0.5) / turns)});
        weights.push_back(std::numbers::pi * (to - from) * static_cast<double>(node.y) / turns);
      }
  double scattered = 0.0;
  auto const places = gaussLegendre(10);
  for (auto const& [from, to] : {std::pair{-1.0, 0.0}, {0.0, 1.0}})
    for (auto const& place : places) {
      double const cosine = from + (to - from) * static_cast<double>(place.x);
      request.sunZenith = Angle(std::acos(cosine));
      auto const radiances = sampler.sample(request);
      double flux = 0.0;
      for (std::size_t i = 0; i < weights.size(); ++i) flux += weights[i] * radiances[i];
      scattered += 2.0 * (to - from) * static_cast<double>(place.y) * flux;
    }
  double passing = 0.0;
  constexpr int rings = 400;
  for (int i = 0; i < rings; ++i) {
    double const b = ground + (top - ground) * (i + 0.5) / rings;
    passing += transmittance(medium, {{b, 0.0, 2.0 * top}}, {{0.0, 0.0, -1.0}}, wavelength) * 2.0 *
               b * (top - ground) / rings;
  }
  return scattered + passing / (top * top);
}

TEST_F(SkyExtremesGlTest, FurnaceReturnsAllLight) {
  struct Case {
    const char* name;
    double radiusKm, topKm, scaleKm, g, depth;
  };
  for (auto const& c : {Case{"Earth, molecules", 6371.0, 100.0, 8.0, 0.0, 0.1},
                        {"Earth, haze", 6371.0, 60.0, 1.2, 0.7, 0.5},
                        {"thick, clear", 1000.0, 200.0, 30.0, 0.0, 0.3},
                        {"shell of depth 10", 1000.0, 60.0, 10.0, 0.0, 10.0},
                        {"cloud of depth 10", 6371.0, 60.0, 5.0, 0.8, 10.0}}) {
    Medium m;
    m.radius = c.radiusKm * kilometre;
    m.topHeight = c.topKm * kilometre;
    m.groundAlbedo = Spectrum(1.0);
    m.constituents.push_back(
        {"gas", DensityProfile::exponential(c.scaleKm * kilometre),
         Spectrum(c.depth / (c.scaleKm * 1e3)), Spectrum(0.0),
         c.g == 0.0 ? PhaseFunction::rayleigh() : PhaseFunction::henyeyGreenstein(Spectrum(c.g))});
    for (const char* preset : {"balanced"}) {
      double const share = returnedShare(m, AirQuality::preset(preset));
      std::printf("furnace %-18s %-9s %+.2f %%\n", c.name, preset, 100.0 * (share - 1.0));
      EXPECT_NEAR(share, 1.0, 0.01) << c.name;
    }
  }
}

// A thick shell, flat by its radius, that absorbs nothing over ground that absorbs all lets through
// the share 4 / (3 (1 - g) depth + 4.26) of the light that a sphere takes from the Sun (van de
// Hulst 1980, Multiple Light Scattering, ch. 14: t = 1 / (0.75 (1 - g) b + 1.065)).
TEST_F(SkyExtremesGlTest, ThickAirReflectsAsByItsDiffusion) {
  for (auto const& [depth, g] : {std::pair{10.0, 0.0}, {40.0, 0.0}, {40.0, 0.75}}) {
    Medium m;
    m.radius = 100000.0 * kilometre;
    m.topHeight = 60.0 * kilometre;
    m.groundAlbedo = Spectrum(0.0);
    m.constituents.push_back(
        {"cloud", DensityProfile::exponential(8.0 * kilometre), Spectrum(depth / 8e3),
         Spectrum(0.0),
         g == 0.0 ? PhaseFunction::isotropic() : PhaseFunction::henyeyGreenstein(Spectrum(g))});
    double const through = 1.0 - returnedShare(m, AirQuality::preset("balanced"));
    double const expected = 4.0 / (3.0 * (1.0 - g) * depth + 4.26);
    std::printf("depth %.0f g %.2f: %.4f through for %.4f\n", depth, g, through, expected);
    // Of all light; the formula itself errs by 0.002 at a scaled depth of 10. With forward peaks
    // the cloud reflects 1.5 % too little.
    EXPECT_NEAR(through, expected, g > 0.0 ? 0.018 : 0.003) << depth << " " << g;
  }
}

}  // namespace
}  // namespace antumbra
