// Bodies as catalogued, and the words in which a broken file is refused.
#include "scene/body_catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace antumbra {
namespace {

using testing::HasSubstr;

Body parse(const std::string& text) {
  Document const document = Document::parse(text, "b.toml");
  Body const body = readBody(document.root(), "b");
  document.root().finish();
  return body;
}
std::string refusal(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}
std::string withRadii(const std::string& equatorial, const std::string& polar) {
  return "name = \"B\"\nkind = \"moon\"\nephemeris = \"B\"\n[figure]\nequatorial_radius = \"" +
         equatorial + "\"\npolar_radius = \"" + polar + "\"\n[surface]\n";
}

TEST(BodyCatalogue, HoldsTheSunThePlanetsAndTheMoon) {
  auto const& bodies = BodyCatalogue::standard();
  for (const char* name : {"Sun", "Mercury", "Venus", "Earth", "Moon", "Mars", "Jupiter", "Saturn",
                           "Uranus", "Neptune"})
    EXPECT_EQ(bodies.body(name, "test").name, name);
  EXPECT_EQ(bodies.depth(bodies.body("moon", "test")), 2);
  EXPECT_THAT([&] { bodies.body("Vulcan", "--bodies"); },
              testing::ThrowsMessage<InputError>(testing::AllOf(
                  HasSubstr("--bodies"), HasSubstr("Vulcan"), HasSubstr("Mercury"))));
}

TEST(BodyCatalogue, RefusesImpossibleFigures) {
  EXPECT_THAT(refusal(withRadii("0 km", "1 km")),
              testing::AllOf(HasSubstr("b.toml:5"), HasSubstr("positive radius")));
  EXPECT_THAT(refusal(withRadii("-3 km", "1 km")), HasSubstr("positive radius"));
  EXPECT_THAT(refusal(withRadii("nan km", "1 km")), HasSubstr("not a finite number"));
  EXPECT_THAT(refusal(withRadii("1 km", "2 km")), HasSubstr("exceeds the equatorial"));
  EXPECT_THAT(refusal(withRadii("1 deg", "1 km")), HasSubstr("wrong unit"));
  EXPECT_THAT(refusal(withRadii("1 km", "1 km") + "albedoo = 3\n"), HasSubstr("albedoo"));
  EXPECT_EQ(refusal(withRadii("1 km", "1 km")), "accepted");
}

// Apparent magnitudes of the Astronomical Almanac's usual order: Venus near greatest brilliancy,
// and Jupiter at opposition (Mallama & Hilton 2018 give -4.92 at best and -2.94 at best).
TEST(BodyCatalogue, MagnitudesAreThoseOfThePlanets) {
  auto const& bodies = BodyCatalogue::standard();
  auto const venus =
      bodies.body("Venus", "test")
          .magnitude.apparent(121.0 * degree, 0.7184 * astronomicalUnit, 0.41 * astronomicalUnit);
  ASSERT_TRUE(venus);
  EXPECT_NEAR(*venus, -4.85, 0.15);
  auto const jupiter =
      bodies.body("Jupiter", "test")
          .magnitude.apparent(0.0 * degree, 4.95 * astronomicalUnit, 3.95 * astronomicalUnit);
  ASSERT_TRUE(jupiter);
  EXPECT_NEAR(*jupiter, -2.94, 0.02);
  auto const moon =
      bodies.body("Moon", "test")
          .magnitude.apparent(0.0 * degree, 1.0 * astronomicalUnit, 384400.0 * kilometre);
  ASSERT_TRUE(moon);
  EXPECT_NEAR(*moon, -12.73, 0.02);
}

}  // namespace
}  // namespace antumbra
