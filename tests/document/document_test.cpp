// Messages of the document reader: file, line, what was found, what is allowed.
#include "document/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace antumbra {
namespace {

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Document, ReadsQuantitiesWithUnits) {
  auto const d = Document::parse("altitude = \"12000 km\"\nlat = \"25.687 deg\"\n", "a.toml");
  EXPECT_DOUBLE_EQ(d.root().length("altitude") / metre, 12e6);
  EXPECT_DOUBLE_EQ(d.root().angle("lat") / degree, 25.687);
  EXPECT_NO_THROW(d.root().finish());
}

TEST(Document, RefusesAUnitOfAnotherDimension) {
  auto const d = Document::parse("\naltitude = \"12 deg\"\n", "a.toml");
  EXPECT_THAT(messageOf([&] { d.root().length("altitude"); }),
              testing::AllOf(testing::HasSubstr("a.toml:2"), testing::HasSubstr("wrong unit"),
                             testing::HasSubstr("12 deg"), testing::HasSubstr("km")));
}

TEST(Document, NamesTheUnknownKeyAndWhatIsAllowed) {
  auto const d = Document::parse("[camera]\nfov = \"40 deg\"\nfow = 3\n", "a.toml");
  (void)d.root().table("camera").angle("fov");
  EXPECT_THAT(messageOf([&] { d.root().finish(); }),
              testing::AllOf(testing::HasSubstr("a.toml:3"), testing::HasSubstr("fow"),
                             testing::HasSubstr("allowed here: fov")));
}

TEST(Document, RefusesNanMissingAndBrokenFiles) {
  auto const d = Document::parse("x = nan\n", "a.toml");
  EXPECT_THAT(messageOf([&] { d.root().number("x"); }), testing::HasSubstr("a.toml:1"));
  EXPECT_THAT(messageOf([&] { d.root().number("y"); }), testing::HasSubstr("missing"));
  EXPECT_THAT(messageOf([] { Document::load("/nonexistent.toml"); }),
              testing::HasSubstr("cannot be read"));
  EXPECT_THAT(messageOf([] { Document::parse("a = 1\nb = = 2\n", "b.toml"); }),
              testing::HasSubstr("b.toml:2"));
  EXPECT_THROW(parseNumber("nan", "x"), InputError);
  EXPECT_THROW(parseNumber("1x", "x"), InputError);
}

}  // namespace
}  // namespace antumbra
