// What is drawn over a picture, and why; what the clock reads.
#include "plan/overlay_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/input_error.h"
#include "document/paths.h"
#include "plan/explanation.h"
#include "plan/render_plan.h"

namespace antumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Scene shipped(const char* name) {
  return readScene(configsFolder() / "scenes" / (std::string(name) + ".toml"));
}

RenderPlan planOf(const Scene& scene, const std::string& time) {
  return makeRenderPlan(scene,
                        placeScene(scene, parseInstant(time, "test"), BodyCatalogue::standard(),
                                   Ephemeris::standard(), DeltaT::standard()));
}

constexpr const char* kGreatest = "2027-08-02T10:06:41Z";

TEST(OverlayPlan, ASceneWithoutOverlaysHasNoneAndSaysSo) {
  RenderPlan const plan = planOf(shipped("from_space"), kGreatest);
  EXPECT_TRUE(plan.overlays.passes.empty());
  EXPECT_TRUE(plan.overlays.curves.shapes.empty());
  EXPECT_TRUE(plan.overlays.solids.empty());
  EXPECT_THAT(explain(plan), HasSubstr("the scene asks for none"));
}

TEST(OverlayPlan, NamesTheEclipseAndCountsItsCurves) {
  RenderPlan const plan = planOf(shipped("path_on_globe"), kGreatest);
  EXPECT_THAT(explain(plan), AllOf(HasSubstr("overlay curves     eclipse of 2027-08-02"),
                                   HasSubstr("contacts of the eclipse of 2027-08-02")));
  EXPECT_GT(plan.overlays.curves.words.size(), 10u);
}

TEST(OverlayPlan, ADayWithoutEclipseIsExplained) {
  Scene scene = shipped("path_on_globe");
  RenderPlan const plan = planOf(scene, "2027-06-02T10:00:00Z");
  EXPECT_TRUE(plan.overlays.passes.empty());
  EXPECT_THAT(explain(plan), AllOf(HasSubstr("no solar eclipse within a day"),
                                   Not(HasSubstr("overlay curves     eclipse"))));
  // Unless the scene names one: the curves belong to the whole day.
  scene.overlays.eclipse = "2027-08-02";
  EXPECT_FALSE(planOf(scene, "2027-06-02T10:00:00Z").overlays.passes.empty());
  scene.overlays.eclipse = "2027-08-03";
  try {
    planOf(scene, "2027-06-02T10:00:00Z");
    ADD_FAILURE() << "an eclipse that does not exist was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("eclipse"), HasSubstr("2027-08-02")));
  }
}

TEST(OverlayPlan, ConesAreThoseOfBodiesOfTheScene) {
  Scene scene = shipped("cones");
  RenderPlan const plan = planOf(scene, kGreatest);
  ASSERT_EQ(plan.overlays.cones.size(), 1u);
  auto const& cone = plan.overlays.cones.front();
  EXPECT_EQ(cone.receiver, "Earth");
  // Umbra: Moon's radius 1738.1 km over the Sun's 695 700 less that, at 151.4e6 km from it.
  double const length = 1738.1 * 151.4e6 / (695700.0 - 1738.1);
  EXPECT_NEAR((cone.apex - cone.base) / kilometre / length, 1.0, 0.003);
  EXPECT_THAT(explain(plan), HasSubstr("shadow meets Earth"));
  for (const char* wrong : {"Mars", "Sun", "Vulcan"}) {
    scene.overlays.cones = {wrong};
    EXPECT_THROW(planOf(scene, kGreatest), InputError) << wrong;
  }
  // However it is written.
  scene.overlays.cones = {"Moon", "moon"};
  try {
    planOf(scene, kGreatest);
    ADD_FAILURE() << "one body's cone was accepted twice";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("cones"), HasSubstr("Moon twice")));
  }
}

TEST(OverlayPlan, AConeCutShortMeetsNothing) {
  Scene scene = shipped("cones");
  scene.overlays.coneLength = 100000.0 * kilometre;
  RenderPlan const plan = planOf(scene, kGreatest);
  ASSERT_EQ(plan.overlays.cones.size(), 1u);
  EXPECT_EQ(plan.overlays.cones.front().receiver, "");
  EXPECT_TRUE(plan.overlays.cones.front().fades);
  EXPECT_THAT(explain(plan), HasSubstr("shown over 100000 km"));
}

TEST(OverlayPlan, TheClockReadsTheContactsOfItsPlace) {
  Scene scene = shipped("luxor_dome");
  scene.overlays.clock = true;
  auto const texts = [](const Drawing& drawing) {
    std::string all;
    for (auto const& words : drawing.words) all += words.text + "\n";
    return all;
  };
  // `antumbra eclipse at 2027-08-02 --site=25.687,32.640,76 --convention iau`, UTC.
  std::string const total = texts(planOf(scene, "2027-08-02T10:05:17Z").overlays.clock);
  EXPECT_THAT(total, AllOf(HasSubstr("C1\n08:40:1"), HasSubstr("C2\n10:02:0"),
                           HasSubstr("10:05:17 UTC"), HasSubstr("total")));
  std::string const before = texts(planOf(scene, "2027-08-02T08:00:00Z").overlays.clock);
  EXPECT_THAT(before, HasSubstr("not eclipsed"));
  // Where the eclipse is not seen there is no clock, and a reason.
  scene.camera.latitude = -60.0 * degree;
  scene.camera.longitude = -100.0 * degree;
  RenderPlan const elsewhere = planOf(scene, "2027-08-02T10:05:17Z");
  EXPECT_TRUE(elsewhere.overlays.clock.shapes.empty());
  EXPECT_THAT(explain(elsewhere), HasSubstr("is not seen at 60.00°S 100.00°W"));
  // From far above: the contacts of the whole Earth.
  scene.camera.height = 10000.0 * kilometre;
  EXPECT_THAT(texts(planOf(scene, "2027-08-02T10:05:17Z").overlays.clock),
              AllOf(HasSubstr("P1\n07:30:1"), HasSubstr("umbra on Earth")));
}

TEST(OverlayPlan, WordsKeepClearOfEachOther) {
  RenderPlan const plan = planOf(shipped("path_on_globe"), kGreatest);
  auto const& words = plan.overlays.curves.words;
  for (std::size_t i = 0; i < words.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      bool const marks = words[i].anchor == DrawnWords::Anchor::Middle &&
                         words[k].anchor == DrawnWords::Anchor::Middle;
      if (!marks) continue;  // the legend stands by itself
      glm::dvec2 const apart = glm::abs(words[i].at - words[k].at);
      EXPECT_TRUE(apart.x > 1.2 * words[i].size || apart.y > 0.8 * words[i].size)
          << words[i].text << " on " << words[k].text;
    }
}

}  // namespace
}  // namespace antumbra
