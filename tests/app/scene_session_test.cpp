// A scene with what the command line changes of it.
#include "app/scene_session.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace antumbra {
namespace {

// Fields of keyframes are for the projection of the file.
TEST(SceneSession, AnotherProjectionHasItsOwnField) {
  auto const file = std::filesystem::temp_directory_path() / "antumbra_scene_session_test.toml";
  std::ofstream(file) << R"(title = "t"
time = "2027-08-02T10:05:06Z"
[camera]
latitude = "0 deg"
longitude = "0 deg"
height = "1000 km"
target = "nadir"
[picture]
projection = "fisheye"
field = "180 deg"
width = 64
height = 64
[animation]
frames = 2
[[keyframe]]
frame = 0
field = "220 deg"
[[keyframe]]
frame = 1
field = "300 deg"
)";
  SceneSession const asWritten(file.string(), {});
  EXPECT_NEAR(asWritten.at(1).scene.picture.field / degree, 300.0, 1e-9);
  SceneOverrides overrides;
  overrides.projection = "perspective";
  SceneSession const flat(file.string(), overrides);
  EXPECT_NEAR(flat.at(1).scene.picture.field / degree, 60.0, 1e-9);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace antumbra
