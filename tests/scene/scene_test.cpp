// Scenes as users write them: what is read, what is refused and in which words.
#include "scene/scene.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/paths.h"

namespace antumbra {
namespace {

const std::string kCamera =
    "[camera]\nbody = \"Earth\"\nlatitude = \"25.687 deg\"\nlongitude = \"32.640 deg\"\n"
    "height = \"76 m\"\ntarget = \"zenith\"\n";
const std::string kPicture =
    "[picture]\nprojection = \"fisheye\"\nfield = \"180 deg\"\nwidth = 512\nheight = 512\n";
const std::string kHead = "title = \"t\"\ntime = \"2027-08-02T10:05:06Z\"\n";

Scene parse(const std::string& text) {
  Document const document = Document::parse(text, "s.toml");
  return readScene(document.root());
}
std::string refusal(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Scene, ReadsPlaceAndPicture) {
  Scene const s = parse(kHead + kCamera + kPicture);
  EXPECT_DOUBLE_EQ(s.camera.latitude / degree, 25.687);
  EXPECT_DOUBLE_EQ(s.camera.height / metre, 76.0);
  EXPECT_EQ(s.picture.kind, ProjectionKind::Fisheye);
  EXPECT_EQ(s.frames, 1);
}

TEST(Scene, RefusesWithFileLineAndWhatIsAllowed) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(refusal(kHead +
                      "[camera]\nlatitude = \"95 deg\"\nlongitude = \"0 deg\"\n"
                      "height = \"1 m\"\ntarget = \"zenith\"\n" +
                      kPicture),
              AllOf(HasSubstr("s.toml:4"), HasSubstr("95"), HasSubstr("-90 to 90")));
  EXPECT_THAT(refusal(kHead + kCamera +
                      "[picture]\nprojection = \"fisheye\"\nfield = \"180 deg\"\n"
                      "width = 0\nheight = 512\n"),
              AllOf(HasSubstr("width"), HasSubstr("found 0"), HasSubstr("1 to 65536")));
  EXPECT_THAT(refusal(kHead + kCamera +
                      "[picture]\nprojection = \"mercator\"\nfield = \"1 deg\"\n"
                      "width = 1\nheight = 1\n"),
              AllOf(HasSubstr("mercator"), HasSubstr("fisheye")));
  EXPECT_THAT(refusal(kHead + kCamera + kPicture + "[display]\nexposure = \"fixed\"\nwhite = -1\n"),
              HasSubstr("not positive"));
  EXPECT_THAT(refusal(kHead + kCamera + kPicture + "[dispaly]\n"),
              AllOf(HasSubstr("dispaly"), HasSubstr("unknown key")));
  EXPECT_THAT(refusal(kHead + kCamera + "azimuth = \"3 deg\"\n" + kPicture),
              HasSubstr("one or the other"));
  EXPECT_THAT(
      refusal(kHead + kCamera + kPicture + "[animation]\nframes = 3\n[[keyframe]]\nframe = 3\n"),
      AllOf(HasSubstr("found 3"), HasSubstr("0 to 2")));
}

TEST(Scene, ReadsAndRefusesTheObserverAndTheSun) {
  using testing::AllOf;
  using testing::HasSubstr;
  std::string const base = kHead + kCamera + kPicture;
  Scene const s = parse(base +
                        "[display]\nbrackets = [-3, 0, 2.5]\n[sun]\nactivity = 0.8\n"
                        "corona = \"streamers\"\nprominences = 5\n");
  EXPECT_EQ(s.display.bracketsStops, (std::vector<double>{-3.0, 0.0, 2.5}));
  EXPECT_DOUBLE_EQ(*s.sun.activity, 0.8);
  EXPECT_TRUE(s.sun.streamers);
  EXPECT_EQ(s.sun.prominences, 5);
  EXPECT_TRUE(s.sun.coronaLight);
  EXPECT_FALSE(parse(base + "[sun]\ncorona_light = false\n").sun.coronaLight);
  EXPECT_THAT(refusal(base + "[sun]\ncorona_light = 1\n"),
              AllOf(HasSubstr("s.toml:15"), HasSubstr("corona_light")));
  EXPECT_TRUE(parse(base + "[display]\nobserver = \"eye\"\n").display.eye);
  EXPECT_THAT(refusal(base + "[display]\nobserver = \"owl\"\n"),
              AllOf(HasSubstr("s.toml:15"), HasSubstr("owl"), HasSubstr("camera")));
  EXPECT_THAT(refusal(base + "[display]\nexposure = \"fixed\"\nwhite = 3\nobserver = \"eye\"\n"),
              AllOf(HasSubstr("s.toml:17"), HasSubstr("auto")));
  EXPECT_THAT(refusal(base + "[display]\nobserver = \"eye\"\nbrackets = [1]\n"),
              HasSubstr("camera"));
  EXPECT_THAT(refusal(base + "[display]\nbrackets = [99]\n"),
              AllOf(HasSubstr("found 99"), HasSubstr("-30 to 30")));
  EXPECT_THAT(refusal(base + "[sun]\nactivity = 1.5\n"),
              AllOf(HasSubstr("s.toml:15"), HasSubstr("1.5"), HasSubstr("0 (minimum")));
  EXPECT_THAT(refusal(base + "[sun]\nprominences = 99\n"), HasSubstr("0 to 24"));
  EXPECT_THAT(refusal(base + "[sun]\ncorona = \"big\"\n"), HasSubstr("streamers"));
  EXPECT_THAT(refusal(base + "[sun]\nspots = 3\n"), HasSubstr("unknown key"));
}

TEST(Scene, ReadsAndRefusesTheAirOfBodies) {
  using testing::AllOf;
  using testing::HasSubstr;
  std::string const base = kHead + kCamera + kPicture;
  Scene const s = parse(base + "[air]\nEarth = \"earth_volcanic\"\nmars = \"none\"\n");
  EXPECT_EQ(s.air.at("Earth"), "earth_volcanic");
  EXPECT_EQ(s.air.at("Mars"), "");
  EXPECT_THAT(refusal(base + "[air]\nEarth = \"soup\"\n"),
              AllOf(HasSubstr("s.toml:15"), HasSubstr("soup"), HasSubstr("earth_molecular")));
  EXPECT_THAT(refusal(base + "[air]\nErath = \"earth\"\n"),
              AllOf(HasSubstr("s.toml:15"), HasSubstr("Erath"), HasSubstr("Earth")));
  EXPECT_THAT(refusal(base + "[air]\nSun = \"earth\"\n"), HasSubstr("star"));
  EXPECT_THAT(refusal(base + "[air]\nEarth = \"earth\"\nearth = \"mars\"\n"), HasSubstr("twice"));
}

TEST(Scene, ReadsAndRefusesPlainSurfacesAndASunLeftOut) {
  using testing::AllOf;
  using testing::HasSubstr;
  std::string const base = kHead + kCamera + kPicture;
  Scene const s = parse(base + "[surface]\nearth = 0.3\n[sun]\ndrawn = false\n");
  EXPECT_DOUBLE_EQ(s.surface.at("Earth"), 0.3);
  EXPECT_FALSE(s.sun.drawn);
  EXPECT_TRUE(parse(base).sun.drawn);
  EXPECT_THAT(refusal(base + "[surface]\nEarth = 1.3\n"),
              AllOf(HasSubstr("s.toml:15"), HasSubstr("1.3"), HasSubstr("0 to 1")));
  EXPECT_THAT(refusal(base + "[surface]\nEarth = \"grey\"\n"), HasSubstr("s.toml:15"));
  EXPECT_THAT(refusal(base + "[surface]\nErath = 0.3\n"),
              AllOf(HasSubstr("Erath"), HasSubstr("Earth")));
  EXPECT_THAT(refusal(base + "[surface]\nSun = 0.3\n"), HasSubstr("star"));
  EXPECT_THAT(refusal(base + "[surface]\nEarth = 0.3\nearth = 0.2\n"), HasSubstr("twice"));
  EXPECT_THAT(refusal(base + "[sun]\ndrawn = 0\n"), HasSubstr("s.toml:15"));
}

// Minima and maxima of the smoothed sunspot number (SILSO): December 2008, April 2014.
TEST(SolarActivity, FollowsTheSunspotCycle) {
  auto const at = [](const char* time) { return solarActivity(parseInstant(time, "test")); };
  EXPECT_LT(at("2008-12-15T00:00:00Z"), 0.001);
  EXPECT_GT(at("2014-04-15T00:00:00Z"), 0.999);
  EXPECT_NEAR(at("2011-08-15T00:00:00Z"), 0.5, 0.02);
  EXPECT_NEAR(at("2027-08-02T10:00:00Z"), 0.6, 0.15);  // on the way down
  for (const char* far : {"1000-01-01T00:00:00Z", "2600-01-01T00:00:00Z"}) {
    EXPECT_GE(at(far), 0.0);
    EXPECT_LE(at(far), 1.0);
  }
}

TEST(Scene, KeyframesKeepTheLimitsOfTheCamera) {
  using testing::AllOf;
  using testing::HasSubstr;
  std::string const key = "[animation]\nframes = 3\n[[keyframe]]\nframe = 1\n";
  auto const base = kHead + kCamera + kPicture + key;  // the keyframe's section is line 16
  EXPECT_THAT(refusal(base + "field = \"400 deg\"\n"),
              AllOf(HasSubstr("s.toml:18"), HasSubstr("400"), HasSubstr("360")));
  EXPECT_THAT(refusal(base + "latitude = \"120 deg\"\n"),
              AllOf(HasSubstr("s.toml:18"), HasSubstr("120"), HasSubstr("-90 to 90")));
  EXPECT_THAT(refusal(base + "longitude = \"720 deg\"\n"), HasSubstr("-360 to 360"));
  EXPECT_THAT(refusal(base + "azimuth = \"1 deg\"\n"), HasSubstr("target"));
  std::string const free = kHead +
                           "[camera]\nlatitude = \"0 deg\"\nlongitude = \"0 deg\"\n"
                           "height = \"1 m\"\nazimuth = \"0 deg\"\naltitude = \"0 deg\"\n" +
                           kPicture + key;
  EXPECT_THAT(refusal(free + "altitude = \"91 deg\"\n"), HasSubstr("-90 to 90"));
  EXPECT_EQ(refusal(free + "altitude = \"9 deg\"\nazimuth = \"370 deg\"\n"), "accepted");
}

TEST(Scene, KeyframesFallGeometricallyAndNeverOvershoot) {
  Scene const s = parse(kHead + kCamera + kPicture +
                        "[animation]\nframes = 12\n[[keyframe]]\nframe = 0\nheight = \"20000 km\"\n"
                        "[[keyframe]]\nframe = 6\nheight = \"100 km\"\n"
                        "[[keyframe]]\nframe = 11\nheight = \"2 m\"\n");
  Length last = 20001.0 * kilometre;
  for (int frame = 0; frame < 12; ++frame) {
    Length const height = s.atFrame(frame).camera.height;
    EXPECT_LT(height, last) << frame;
    last = height;
  }
  EXPECT_NEAR(s.atFrame(0).camera.height / metre, 2e7, 1e-3);
  EXPECT_NEAR(s.atFrame(6).camera.height / metre, 1e5, 1e-6);
  EXPECT_NEAR(s.atFrame(11).camera.height / metre, 2.0, 1e-9);
}

TEST(Scene, EveryShippedSceneCanBeRead) {
  int count = 0;
  for (auto const& entry : std::filesystem::directory_iterator(configsFolder() / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(readScene(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 6);
}

}  // namespace
}  // namespace antumbra
