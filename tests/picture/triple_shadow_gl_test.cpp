// Three shadows on Jupiter in pixels against straight lines through barycentric places: each ray
// leaves the Sun, passes the moon and meets the planet at the times that the speed of light gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "document/paths.h"
#include "eclipse/limb_darkening.h"
#include "picture/picture_renderer.h"
#include "quantity/constants.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

using TripleShadow = testsupport::GlTest;

DecodedImage greyMap(const std::string&, const std::string&) {
  return {4, 2, 3, std::vector<unsigned char>(4 * 2 * 3, 200)};
}

glm::dvec3 barycentric(BodyId body, Instant t) {
  return Ephemeris::standard().state(body, BodyId::SolarSystemBarycentre, t).position.m;
}

// Where the line from the Sun through a moon meets Jupiter's spheroid, for light seen at `when`
// from `eye`; ICRS metres from Jupiter's centre as seen.
glm::dvec3 shadowSpot(BodyId moon, const PlacedBody& jupiter, const glm::dvec3& eye, Instant when) {
  Duration toEye = 2000.0 * second;
  glm::dvec3 spot(0.0), centre(0.0);
  for (int i = 0; i < 20; ++i) {
    Instant const at = when - toEye;
    centre = barycentric(BodyId::Jupiter, at);
    glm::dvec3 const point = centre + spot;
    glm::dvec3 moonPlace = barycentric(moon, at), sunPlace = barycentric(BodyId::Sun, at);
    for (int k = 0; k < 4; ++k) {
      moonPlace =
          barycentric(moon, at - Duration(glm::length(point - moonPlace) / kSpeedOfLight.si));
      sunPlace =
          barycentric(BodyId::Sun, at - Duration(glm::length(point - sunPlace) / kSpeedOfLight.si));
    }
    // Spheroid: stretch along the pole.
    glm::dvec3 const pole = jupiter.bodyFromIcrs.inverse()(Direction<BodyFixed>{{0, 0, 1}}).u;
    double const squash = jupiter.body->equatorialRadius / jupiter.body->polarRadius - 1.0;
    auto const stretched = [&](const glm::dvec3& v) { return v + pole * (squash * dot(pole, v)); };
    glm::dvec3 const from = stretched(moonPlace - centre), ray = stretched(moonPlace - sunPlace);
    double const a = dot(ray, ray), b = dot(from, ray);
    double const c = dot(from, from) - std::pow(jupiter.body->equatorialRadius.si, 2.0);
    spot = moonPlace - centre + (moonPlace - sunPlace) * ((-b - std::sqrt(b * b - a * c)) / a);
    toEye = Duration(glm::length(centre + spot - eye) / kSpeedOfLight.si);
  }
  return spot + barycentric(BodyId::Jupiter, when - toEye) - eye;
}

TEST_F(TripleShadow, SpotsFallWhereLightWouldMissThem) {
  Scene scene = readScene(configsFolder() / "scenes" / "jupiter_triple_shadow.toml");
  scene.bodies = {"Sun", "Earth", "Jupiter", "Io", "Europa", "Callisto"};
  scene.picture.width = 640;
  scene.picture.height = 480;
  scene.quality = "draft";
  Instant const when = parseInstant(scene.time, "test");
  auto const placed =
      placeScene(scene, when, BodyCatalogue::standard(), Ephemeris::standard(), DeltaT::standard());
  auto const plan = makeRenderPlan(scene, placed);
  ASSERT_EQ(plan.shadows.size(), 3u);
  PictureRenderer renderer(greyMap);
  auto const picture = renderer.finish(scene, placed, plan);
  EXPECT_EQ(renderer.counters().shadowPairs, 3);

  auto const jupiter = std::find_if(placed.bodies.begin(), placed.bodies.end(),
                                    [](auto const& b) { return b.body->name == "Jupiter"; });
  // Dark places; the largest is the sky.
  int const width = picture.width, height = picture.height;
  std::vector<bool> dark(static_cast<std::size_t>(width * height));
  auto const luminance = [&](int x, int y) {
    return picture.linear[static_cast<std::size_t>(y * width + x) * 3 + 1];
  };
  double const bright = luminance(width / 2, height / 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      dark[static_cast<std::size_t>(y * width + x)] = luminance(x, y) < 0.06 * bright;
  std::vector<glm::dvec2> spots;
  for (int start = 0; start < width * height; ++start) {
    if (!dark[static_cast<std::size_t>(start)]) continue;
    std::vector<int> open{start};
    glm::dvec2 sum(0.0);
    int count = 0;
    while (!open.empty()) {
      int const at = open.back();
      open.pop_back();
      if (!dark[static_cast<std::size_t>(at)]) continue;
      dark[static_cast<std::size_t>(at)] = false;
      sum += glm::dvec2(at % width + 0.5, at / width + 0.5);
      ++count;
      for (int step : {-1, 1, -width, width})
        if (at + step >= 0 && at + step < width * height) open.push_back(at + step);
    }
    if (count > 3 && count < 2000) spots.push_back(sum / double(count));
  }
  ASSERT_EQ(spots.size(), 3u);

  glm::dvec3 const eye = barycentric(BodyId::Earth, when) + placed.cameraFromAnchor.m;
  auto const pixelOf = [&](const glm::dvec3& icrs) {
    glm::dvec3 const d = placed.cameraFromIcrs.matrix * icrs;
    double const scale = 0.5 * width / std::tan(0.5 * scene.picture.field.si) / -d.z;
    return glm::dvec2(0.5 * width + d.x * scale, 0.5 * height - d.y * scale);
  };
  // The view looks at Jupiter's apparent centre; aberration moves planet and spots together.
  Duration toCentre = 2000.0 * second;
  glm::dvec3 centre(0.0);
  for (int i = 0; i < 5; ++i) {
    centre = barycentric(BodyId::Jupiter, when - toCentre) - eye;
    toCentre = Duration(glm::length(centre) / kSpeedOfLight.si);
  }
  glm::dvec2 const drift = pixelOf(jupiter->fromCamera.m) - pixelOf(centre);
  for (BodyId moon : {BodyId::Io, BodyId::Europa, BodyId::Callisto}) {
    glm::dvec2 const expected = pixelOf(shadowSpot(moon, *jupiter, eye, when)) + drift;
    double nearest = 1e9;
    for (auto const& spot : spots) nearest = std::min(nearest, glm::length(spot - expected));
    std::printf("%s: %.2f px of 330 km off its predicted place\n", nameOf(moon).c_str(), nearest);
    // Half a pixel of the spot's own rim, and its slant.
    EXPECT_LT(nearest, 0.7) << nameOf(moon);
  }
}

// Where Callisto's and Io's shadows overlap a little earlier, pixels keep what the union of the
// moons' discs leaves.
TEST_F(TripleShadow, OverlappingShadowsHideTheUnion) {
  Scene scene = readScene(configsFolder() / "scenes" / "jupiter_triple_shadow.toml");
  scene.bodies = {"Sun", "Earth", "Jupiter", "Io", "Callisto"};
  scene.picture.width = 640;
  scene.picture.height = 480;
  scene.quality = "draft";
  auto const placed =
      placeScene(scene, parseInstant("2015-01-24T05:49:40Z", "test"), BodyCatalogue::standard(),
                 Ephemeris::standard(), DeltaT::standard());
  auto plan = makeRenderPlan(scene, placed);
  std::erase_if(plan.bodies, [](auto const& b) { return b.name != "Jupiter"; });
  ASSERT_EQ(plan.bodies.size(), 1u);
  auto& jupiter = plan.bodies.front();
  ASSERT_EQ(jupiter.casters.size(), 2u);
  PictureRenderer renderer(greyMap);
  auto const with = renderer.finish(scene, placed, plan);
  std::vector<glsl::ShadowPair> pairs;
  for (auto const& c : jupiter.casters)
    pairs.push_back(shadowPair(jupiter.sun, c.centre, c.radii, c.figure));
  jupiter.casters.clear();
  auto const without = renderer.finish(scene, placed, plan);
  auto const law =
      limbDarkening(LimbDarkeningLaw::Hestroffer,
                    {560.0 * nanometre, 560.0 * nanometre, 560.0 * nanometre, 560.0 * nanometre});
  glm::dvec3 const stretch(1.0, 1.0, jupiter.equatorialRadius / jupiter.polarRadius);
  glm::dmat3 const turn = jupiter.bodyFromCamera.matrix;
  glm::dvec3 const o = turn * -jupiter.centre.m;
  double worst = 0.0, productErr = 0.0;
  int shared = 0;
  for (int y = 0; y < with.height; ++y)
    for (int x = 0; x < with.width; ++x) {
      auto const i = static_cast<std::size_t>(y * with.width + x) * 3 + 1;
      glm::dvec3 const d = turn * scene.picture.directionAt(x + 0.5, with.height - y - 0.5)->u;
      double const a = dot(d * stretch, d * stretch), b = dot(o * stretch, d * stretch);
      double const c = dot(o * stretch, o * stretch) - std::pow(jupiter.equatorialRadius.si, 2.0);
      if (b * b < a * c || without.linear[i] < 1.0f) continue;
      glm::dvec3 const point = o + d * ((-b - std::sqrt(b * b - a * c)) / a);
      double product = 1.0;
      int covering = 0;
      for (auto const& pair : pairs) {
        double const one = glsl::visibleSunlight(pair, law, point).x;
        covering += one < 0.99;
        product *= one;
      }
      if (covering < 2) continue;
      ++shared;
      double const expected = visibleSunlight(pairs, law, point).x;
      worst = testsupport::larger(worst, std::fabs(with.linear[i] / without.linear[i] - expected));
      productErr = std::max(productErr, std::fabs(product - expected));
    }
  std::printf("%d pixels behind both moons: within %.4f of sunlight (their product %.3f)\n", shared,
              worst, productErr);
  EXPECT_GT(shared, 10);
  EXPECT_GT(productErr, 0.03);
  // A float's place at Jupiter's distance, and one wavelength for a luminance.
  EXPECT_LT(worst, 0.01);
}

}  // namespace
}  // namespace antumbra
