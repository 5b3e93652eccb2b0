// Files come out whole or not at all, with their metadata.
#include "output/image_file.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>

#include "document/input_error.h"

namespace antumbra {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("antumbra_image_" + std::to_string(getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder;
};

TEST_F(ImageFile, ExrKeepsAbsoluteLuminanceAndMetadata) {
  std::vector<float> const pixels{1.6e9f, 1e-5f, 0.0f, 4.0f, 5.0f, 6.0f};
  writeExr(folder / "a.exr", 2, 1, pixels, {{"antumbra:time", "2027-08-02T10:06:50Z"}});
  auto input = OIIO::ImageInput::open((folder / "a.exr").string());
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().get_string_attribute("antumbra:time"), "2027-08-02T10:06:50Z");
  std::vector<float> back(6);
  ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, back.data()));
  EXPECT_EQ(back, pixels);
}

TEST_F(ImageFile, DecodesWithTheBottomRowFirst) {
  std::vector<std::uint8_t> const rows{255, 0, 0, 0, 0, 255};  // red above blue
  writePng(folder / "a.png", 1, 2, rows, {});
  DecodedImage const image = readImage(folder / "a.png", "map");
  EXPECT_EQ(image.texels, (std::vector<unsigned char>{0, 0, 255, 255, 0, 0}));
}

TEST_F(ImageFile, LeavesNothingBehindOnFailure) {
  EXPECT_THROW(checkOutputFile(folder / "none" / "a.png", "-o"), InputError);
  EXPECT_THROW(checkOutputFile(folder / "a.jpg", "-o"), InputError);
  fs::create_directory(folder / "b.png");  // a folder in the way of the rename
  std::ofstream(folder / "b.png" / "x") << "x";
  EXPECT_THROW(writePng(folder / "b.png", 1, 1, {1, 2, 3}, {}), InputError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(ImageFile, FollowsALinkAndRefusesWhatIsNoRegularFile) {
  writePng(folder / "real.png", 1, 1, {1, 2, 3}, {});
  fs::create_symlink(folder / "real.png", folder / "link.png");
  writePng(folder / "link.png", 1, 1, {200, 200, 200}, {});
  EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
  EXPECT_EQ(readImage(folder / "real.png", "map").texels[0], 200);
  ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  EXPECT_THROW(writePng(folder / "pipe.png", 1, 1, {1, 2, 3}, {}), InputError);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe.png"));
}

TEST_F(ImageFile, ExplainsAnUnreadableMap) {
  std::ofstream(folder / "broken.png") << "not an image";
  EXPECT_THAT([&] { readImage(folder / "broken.png", "earth.toml:3: map"); },
              testing::ThrowsMessage<InputError>(testing::AllOf(testing::HasSubstr("earth.toml:3"),
                                                                testing::HasSubstr("broken.png"))));
  EXPECT_THAT([&] { readImage(folder / "missing.png", "map"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("no such file")));
}

}  // namespace
}  // namespace antumbra
