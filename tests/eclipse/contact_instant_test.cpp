// Contacts as instants.
#include "eclipse/contact_instant.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/input_error.h"

namespace antumbra {
namespace {

EclipseBasis basisOf1999() {
  EclipseBasis basis;
  basis.deltaT = 63.702 * second;
  return basis;
}

TEST(ContactInstant, IsTheAuthoritysSecondContact) {
  // tests/authorities/solar_local.csv: Munich, 1999-08-11, C2 10:37:13.978 UT1.
  Instant const t = contactInstant("C2 1999-08-11 @48.1372,11.5756,520", basisOf1999(), "--time");
  Instant const printed =
      parseInstant("1999-08-11T10:37:13.978 UT1", "test", DeltaT::fixed(63.702 * second));
  EXPECT_LT(abs(t - printed), 0.2 * second);
}

TEST(ContactInstant, OrdersTheContacts) {
  auto const at = [](const char* name) {
    return contactInstant(std::string(name) + " 1999-08-11 @48.1372,11.5756", basisOf1999(), "x");
  };
  EXPECT_LT(at("C1"), at("C2"));
  EXPECT_LT(at("C2"), at("max"));
  EXPECT_LT(at("max"), at("C3"));
  EXPECT_LT(at("C3"), at("C4"));
  Instant const greatest = contactInstant("greatest 1999-08-11", basisOf1999(), "x");
  EXPECT_LT(contactInstant("P1 1999-08-11", basisOf1999(), "x"), greatest);
}

TEST(ContactInstant, ExplainsBadInput) {
  for (const char* text : {"C5 1999-08-11 @1,2", "C2 1999-08-11", "greatest 1999-08-11 @1,2", "C2",
                           "C2 1999-08-11 48,11", "C2 1999-08-11 @48,11 now",
                           "C2 1999-08-12 @48,11", "C2 1999-08-11 @91,11"})
    EXPECT_THROW(contactInstant(text, basisOf1999(), "--time"), InputError) << text;
  EXPECT_THAT([] { contactInstant("C2 1999-08-11 @51.5,-0.1", basisOf1999(), "--time"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("partial there")));
  EXPECT_TRUE(looksLikeContact("C2 1999-08-11 @1,2"));
  EXPECT_FALSE(looksLikeContact("1999-08-11T10:37:13Z"));
  EXPECT_FALSE(looksLikeContact("JD 2451545.0 TT"));
}

}  // namespace
}  // namespace antumbra
