// Radii by convention, as the canons print them.
#include "eclipse/shadow_convention.h"

#include <gtest/gtest.h>

#include "document/input_error.h"

namespace antumbra {
namespace {

TEST(ShadowConvention, RadiiAreThoseOfTheirSources) {
  auto const iau = ShadowConvention::named("iau", "test");
  EXPECT_DOUBLE_EQ(iau.sunRadius / kilometre, 695700.0);
  EXPECT_NEAR(iau.radiiOf("Moon", 1737.4 * kilometre).casterUmbra / kilometre, 1738.091, 0.001);
  auto const nasa = ShadowConvention::named("nasa", "test");
  EXPECT_NEAR(nasa.sunRadius / kilometre, 695990.0, 5.0);
  auto const moon = nasa.radiiOf("Moon", 1737.4 * kilometre);
  EXPECT_NEAR(moon.casterUmbra / kilometre, 1736.646, 0.001);
  EXPECT_NEAR(moon.casterPenumbra / kilometre, 1737.966, 0.001);
  EXPECT_EQ(nasa.radiiOf("Io", 1821.5 * kilometre).casterUmbra, 1821.5 * kilometre);
  EXPECT_THROW(ShadowConvention::named("canon", "--convention"), InputError);
}

}  // namespace
}  // namespace antumbra
