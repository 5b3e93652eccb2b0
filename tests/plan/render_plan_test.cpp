// The plan holds what a picture needs, says why, and leaves the rest out.
#include "plan/render_plan.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/paths.h"
#include "plan/explanation.h"

namespace antumbra {
namespace {

using testing::HasSubstr;

RenderPlan planOf(Scene scene, const std::string& time) {
  Instant const when = parseInstant(time, "test");
  auto const placed =
      placeScene(scene, when, BodyCatalogue::standard(), Ephemeris::standard(), DeltaT::standard());
  return makeRenderPlan(scene, placed);
}

Scene shipped(const char* name) {
  return readScene(configsFolder() / "scenes" / (std::string(name) + ".toml"));
}

Scene onTheMoon() {
  Scene s = shipped("luxor_dome");
  s.bodies = {"Moon"};
  s.camera.body = "Moon";
  s.camera.height = 2.0 * metre;
  s.camera.latitude = 0.0 * degree;
  s.camera.longitude = 0.0 * degree;
  return s;
}

TEST(RenderPlan, TotalityAtLuxorHasItsShadowAirAndQuery) {
  RenderPlan const plan = planOf(shipped("luxor_dome"), "2027-08-02T10:05:06Z");
  ASSERT_EQ(plan.tables.size(), 1u);
  EXPECT_EQ(plan.tables[0].what, "earth");
  EXPECT_THAT(plan.tables[0].why, HasSubstr("inside the air"));
  EXPECT_THAT(explain(plan), HasSubstr("bent and thinned by refraction, 3"));
  ASSERT_EQ(plan.shadows.size(), 1u);
  EXPECT_EQ(plan.shadows[0].what, "Moon on Earth");
  EXPECT_TRUE(plan.queryOcclusion);
  ASSERT_FALSE(plan.bodies.empty());
  EXPECT_EQ(plan.bodies.back().name, "Earth");
}

// A Moon of a fifth of a pixel hides the Sun like any other.
TEST(RenderPlan, TheMoonHidesTheSunAtAnySize) {
  Scene small = shipped("luxor_dome");
  small.picture.width = small.picture.height = 32;
  auto const names = [&](const char* time) {
    std::vector<std::string> found;
    for (auto const& body : planOf(small, time).bodies) found.push_back(body.name);
    return found;
  };
  EXPECT_THAT(names("2027-08-02T10:05:06Z"), testing::Contains("Moon"));
  EXPECT_THAT(names("2027-08-02T06:05:06Z"), testing::Not(testing::Contains("Moon")));
}

TEST(RenderPlan, AnAirlessSceneBuildsNoTable) {
  RenderPlan const plan = planOf(onTheMoon(), "2027-08-02T10:05:06Z");
  EXPECT_TRUE(plan.tables.empty());
  EXPECT_THAT(explain(plan), HasSubstr("no body drawn as a disc has air"));
}

TEST(RenderPlan, NoQueryWithoutTheSunInTheView) {
  RenderPlan const space = planOf(shipped("from_space"), "2027-08-02T10:06:40Z");
  EXPECT_FALSE(space.sun.inPicture);
  EXPECT_FALSE(space.queryOcclusion);
  EXPECT_THAT(explain(space), HasSubstr("the Sun is not in the picture"));
  RenderPlan const night = planOf(shipped("luxor_dome"), "2027-08-02T22:05:06Z");
  EXPECT_FALSE(night.queryOcclusion);
  EXPECT_FALSE(night.drawSun);
}

// The corona goes on above the Moon's horizon until 45 solar radii (12 degrees) are below it.
TEST(RenderPlan, TheCoronaSetsAfterTheSun) {
  Scene const scene = onTheMoon();
  int twilights = 0, nights = 0;
  for (int hour = 0; hour < 24 * 30; hour += 6) {
    RenderPlan const plan =
        planOf(scene, fmt::format("2027-08-{:02d}T{:02d}:00:00Z", 1 + hour / 24, hour % 24));
    ASSERT_FALSE(plan.bodies.empty());
    Angle const fromNadir =
        angleBetween(directionOf(plan.bodies.back().centre), plan.sun.direction);
    double const depression = 90.0 - fromNadir / degree;
    if (depression > 4.0 && depression < 11.5) {
      EXPECT_FALSE(plan.sun.hiddenByBody) << depression;
      ++twilights;
    }
    if (depression > 12.5) {
      EXPECT_TRUE(plan.sun.hiddenByBody) << depression;
      EXPECT_FALSE(plan.drawSun) << depression;
      ++nights;
    }
  }
  EXPECT_GE(twilights, 4);
  EXPECT_GE(nights, 20);
}

TEST(RenderPlan, NoShadowPairWithoutAnEclipse) {
  RenderPlan const plan = planOf(shipped("luxor_dome"), "2027-07-20T10:05:06Z");
  EXPECT_TRUE(plan.shadows.empty());
  for (auto const& body : plan.bodies) EXPECT_TRUE(body.casters.empty()) << body.name;
}

TEST(RenderPlan, ALunarEclipsePutsTheEarthBeforeTheMoonsSun) {
  Scene scene = shipped("luxor_sun");
  scene.camera.target = "Moon";
  // Greatest eclipse of 2028-12-31, 16:52 UT.
  RenderPlan const plan = planOf(scene, "2028-12-31T16:52:00Z");
  ASSERT_THAT(plan.shadows, testing::SizeIs(1));
  EXPECT_EQ(plan.shadows[0].what, "Earth on Moon");
}

TEST(RenderPlan, PlanetsFromTheGroundArePointsWithTheirMagnitude) {
  RenderPlan const plan = planOf(shipped("luxor_dome"), "2027-08-02T10:05:06Z");
  bool venus = false;
  for (auto const& p : plan.points)
    if (p.name == "Venus") {
      venus = true;
      // Venus of magnitude -3.9 gives 2.54e-6 lx * 10^(0.4 * 3.9) = 9.2e-5 lx.
      EXPECT_NEAR(p.illuminance, 9.2e-5, 1.5e-5);
    }
  EXPECT_TRUE(venus);
}

TEST(RenderPlan, RefusesACameraInsideABody) {
  Scene scene = shipped("luxor_dome");
  scene.camera.height = -100.0 * kilometre;
  EXPECT_THAT([&] { planOf(scene, "2027-08-02T10:05:06Z"); },
              testing::ThrowsMessage<InputError>(
                  testing::AllOf(HasSubstr("inside Earth"), HasSubstr(".toml:"))));
}

TEST(RenderPlan, RefusesToStandOnTheSunAndNamesTheLine) {
  Scene scene = shipped("luxor_dome");
  scene.camera.body = "Sun";
  EXPECT_THAT([&] { planOf(scene, "2027-08-02T10:05:06Z"); },
              testing::ThrowsMessage<InputError>(
                  testing::AllOf(HasSubstr("luxor_dome.toml:"), HasSubstr("a star"))));
  scene.camera.body = "Earth";
  scene.camera.height = -5.0 * kilometre;
  EXPECT_THROW(planOf(scene, "2027-08-02T10:05:06Z"), InputError);
}

// In totality the Moon shows its night side to us, and the full Earth to it: 10 to 20 lx, sixty
// times a full Moon's 0.25 lx on the Earth (area 13.4, albedo about 3.5 to 5).
TEST(RenderPlan, TheMoonIsLitByTheFullEarthInTotality) {
  RenderPlan const plan = planOf(shipped("luxor_dome"), "2027-08-02T10:05:06Z");
  bool found = false;
  for (auto const& body : plan.bodies)
    if (body.name == "Moon") {
      found = true;
      EXPECT_EQ(body.shineFrom, "Earth");
      EXPECT_GT(body.shineLux, 10.0);
      EXPECT_LT(body.shineLux, 20.0);
    } else {
      EXPECT_EQ(body.shineLux, 0.0) << body.name;  // the Earth has air
    }
  EXPECT_TRUE(found);
  EXPECT_THAT(explain(plan), HasSubstr("also lit by Earth"));
}

TEST(RenderPlan, SceneChoosesTheAirThatIsSeenAndThatCasts) {
  Scene scene = shipped("lunar_eclipse");
  scene.air["Earth"] = "earth_volcanic";
  RenderPlan plan = planOf(scene, "2028-12-31T16:52:00Z");
  EXPECT_THAT(explain(plan), HasSubstr("earth_volcanic, light refracted"));
  for (auto const& body : plan.bodies) {
    if (body.name == "Earth") {
      EXPECT_EQ(body.atmosphere, "earth_volcanic");
    }
    if (body.name == "Moon") {
      EXPECT_EQ(body.casters.at(0).atmosphere, "earth_volcanic");
    }
  }
  scene.air["Earth"] = "";
  plan = planOf(scene, "2028-12-31T16:52:00Z");
  EXPECT_TRUE(plan.tables.empty());
}

TEST(RenderPlan, SaysHowToAskForTheSameSky) {
  Scene scene = shipped("luxor_dome");
  auto const plan = planOf(scene, "2027-08-02T10:05:06Z");
  ASSERT_EQ(plan.sky.size(), 2u);
  // The Sun of Luxor at greatest eclipse: altitude 81.77, azimuth 196.1 deg (antumbra eclipse at).
  EXPECT_THAT(
      plan.sky[0].why,
      testing::AllOf(HasSubstr("--medium catalogs/atmospheres/earth.toml"),
                     HasSubstr("--body Earth --latitude 25.68"), HasSubstr("--sun-zenith 8.2"),
                     HasSubstr("--sun-azimuth 19"), HasSubstr("--method balanced")));
  EXPECT_THAT(plan.sky[1].why, HasSubstr("eclipses"));
  EXPECT_TRUE(planOf(onTheMoon(), "2027-08-17T10:05:06Z").sky.empty());
}

TEST(RenderPlan, LeavesOutTheSunAndTheMapsWhereTheSceneSaysSo) {
  Scene scene = shipped("luxor_dome");
  scene.sun.drawn = false;
  scene.surface["Earth"] = 0.25;
  auto const plan = planOf(scene, "2027-08-02T09:05:06Z");
  EXPECT_FALSE(plan.drawSun || plan.queryOcclusion || plan.glareFromOutside);
  EXPECT_THAT(explain(plan), HasSubstr("left out by the scene"));
  auto const& earth = plan.bodies.back();
  EXPECT_EQ(earth.map + earth.waterMask + earth.nightMap, "");
  EXPECT_EQ(earth.albedo, glm::vec3(0.25f));
  EXPECT_FALSE(earth.casters.empty());  // its light is eclipsed all the same
}

TEST(RenderPlan, SaysHowTheCoronaAndTheDisplayCameAbout) {
  Scene scene = shipped("luxor_corona");
  std::string const corona = explain(planOf(scene, "2027-08-02T10:05:06Z"));
  EXPECT_THAT(corona, HasSubstr("invented streamers"));
  EXPECT_THAT(corona, HasSubstr("of the date"));
  EXPECT_THAT(corona, HasSubstr("7 invented prominences"));
  EXPECT_THAT(corona, HasSubstr("1 more exposures"));
  scene.display.bracketsStops.clear();
  scene.display.eye = true;
  scene.sun.activity = 0.25;
  std::string const eye = explain(planOf(scene, "2027-08-02T10:05:06Z"));
  EXPECT_THAT(eye, HasSubstr("an eye adapted"));
  EXPECT_THAT(eye, HasSubstr("0.25 of the solar cycle (the scene's)"));
}

TEST(RenderPlan, SaysHowMuchTheCoronaLights) {
  Scene scene = shipped("luxor_dome");
  RenderPlan plan = planOf(scene, "2027-08-02T10:05:06Z");
  // A Moon of 1.079 solar radii leaves 0.8e-6 of 133 klx, at 1.015 au.
  EXPECT_THAT(explain(plan), HasSubstr("the corona sends 0.11 lx"));
  EXPECT_TRUE(plan.coronaLight);
  EXPECT_FALSE(planOf(scene, "2027-08-05T10:05:06Z").coronaLight);  // nothing casts a shadow
  scene.sun.coronaLight = false;
  plan = planOf(scene, "2027-08-02T10:05:06Z");
  EXPECT_FALSE(plan.coronaLight);
  EXPECT_THAT(explain(plan), HasSubstr("corona_light = false"));
  EXPECT_THAT(explain(plan), Not(HasSubstr("corona sends")));
  scene.sun.coronaLight = true;
  scene.display.illustrative = true;
  EXPECT_FALSE(planOf(scene, "2027-08-02T10:05:06Z").coronaLight);
}

TEST(RenderPlan, TheSunBesideThePictureDazzlesUnlessItIsBehindTheCamera) {
  Scene scene = onTheMoon();
  scene.bodies = {};
  scene.picture = {ProjectionKind::Perspective, 20.0 * degree, 64, 64};
  scene.camera.target = "Sun";
  std::string const day = "2027-08-17T10:05:06Z";  // full Moon: the Sun is up on the near side
  EXPECT_FALSE(planOf(scene, day).glareFromOutside);
  scene.camera.tilt = 30.0 * degree;
  EXPECT_TRUE(planOf(scene, day).glareFromOutside);
  scene.camera.tilt = 120.0 * degree;
  EXPECT_FALSE(planOf(scene, day).glareFromOutside);
}

}  // namespace
}  // namespace antumbra
