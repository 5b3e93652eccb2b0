// The [overlays] section as users write it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene.h"

namespace antumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kScene =
    "title = \"t\"\ntime = \"2027-08-02T10:05:06Z\"\n[camera]\nlatitude = \"0 deg\"\n"
    "longitude = \"0 deg\"\nheight = \"1000 km\"\ntarget = \"nadir\"\n[picture]\n"
    "projection = \"perspective\"\nfield = \"60 deg\"\nwidth = 64\nheight = 64\n[overlays]\n";

Scene parse(const std::string& overlays) {
  Document const document = Document::parse(kScene + overlays, "s.toml");
  return readScene(document.root());
}

std::string refusal(const std::string& overlays) {
  try {
    parse(overlays);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(OverlaySettings, ReadsWhatIsAskedFor) {
  OverlaySettings const o = parse(
                                "central_line = true\ncones = [\"Moon\"]\n"
                                "time_marks = \"5 min\"\nclock_site = \"25.7,32.6\"\n")
                                .overlays;
  EXPECT_TRUE(o.centralLine && o.lines() && o.any());
  EXPECT_FALSE(o.contours());
  EXPECT_EQ(o.cones, std::vector<std::string>{"Moon"});
  EXPECT_DOUBLE_EQ(*o.timeMarks / minute, 5.0);
  EXPECT_DOUBLE_EQ(o.clockSite->latitude / degree, 25.7);
  EXPECT_FALSE(parse("legend = true\n").overlays.any());  // a legend of nothing
}

TEST(OverlaySettings, RefusesWithFileAndLine) {
  // The section begins at line 13.
  EXPECT_THAT(refusal("centre_line = true\n"),
              AllOf(HasSubstr("s.toml:14"), HasSubstr("centre_line"), HasSubstr("unknown key")));
  EXPECT_THAT(refusal("central_line = \"yes\"\n"),
              AllOf(HasSubstr("s.toml:14"), HasSubstr("central_line")));
  EXPECT_THAT(refusal("time_marks = \"5 s\"\n"),
              AllOf(HasSubstr("s.toml:14"), HasSubstr("found 5 s"), HasSubstr("1 min")));
  EXPECT_THAT(refusal("time_marks = \"5 km\"\n"), HasSubstr("s.toml:14"));
  EXPECT_THAT(refusal("line_width = 0\n"), AllOf(HasSubstr("found 0"), HasSubstr("0.5 to 20")));
  EXPECT_THAT(refusal("clock_site = \"95,0\"\n"), HasSubstr("s.toml:14"));
  EXPECT_THAT(refusal("cones = [\"a\", \"b\", \"c\", \"d\", \"e\"]\n"), HasSubstr("at most 4"));
  EXPECT_THAT(refusal("cone_length = \"0 km\"\n"), HasSubstr("above 0"));
}

}  // namespace
}  // namespace antumbra
