// Predictions of lunar eclipses against an independent program on JPL DE431.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "document/input_error.h"
#include "eclipse/eclipse_search.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

double secondsOfDay(const std::string& iso) {
  return 3600.0 * std::stod(iso.substr(11, 2)) + 60.0 * std::stod(iso.substr(14, 2)) +
         std::stod(iso.substr(17));
}

TEST(LunarPrediction, TwoCenturiesAgree) {
  auto const all = lunarEclipses(EclipseBasis{}, startOfYear(1900), startOfYear(2101));
  EXPECT_EQ(all.size(), 459u);
  std::map<std::string, LunarEclipse> found;
  for (auto const& e : all) found[e.id] = e;
  double time = 0.0, magnitude = 0.0, contact = 0.0, gamma = 0.0;
  for (auto const& row : readCsv("tests/authorities/lunar_eclipses.csv")) {
    ASSERT_TRUE(found.count(row.text("ecl_id"))) << row.text("ecl_id");
    LunarEclipse const& e = found[row.text("ecl_id")];
    EXPECT_EQ(e.type, row.text("type")) << e.id;
    EXPECT_EQ(e.saros, static_cast<int>(row.number("nasa_saros"))) << e.id;
    auto const worst = [](double& into, double value) { into = std::max(into, std::fabs(value)); };
    worst(time, (e.greatest.tt().value() - row.number("jd_tt_greatest")) * 86400.0);
    worst(gamma, e.gamma - row.number("gamma"));
    worst(magnitude, e.umbralMagnitude - row.number("umbral_mag_danjon"));
    worst(magnitude, e.penumbralMagnitude - row.number("penumbral_mag_danjon"));
    auto const compare = [&](const std::optional<Instant>& t, const char* column) {
      EXPECT_EQ(t.has_value(), !row.empty(column)) << e.id << " " << column;
      if (!t || row.empty(column)) return;
      Duration const printed = row.number("deltaT_s") * second;
      double const difference = secondsOfDay(ut1Text(*t, printed)) - secondsOfDay(row.text(column));
      worst(contact, std::remainder(difference, 86400.0));
    };
    compare(e.p1, "P1_ut1");
    compare(e.u1, "U1_ut1");
    compare(e.u2, "U2_ut1");
    compare(e.u3, "U3_ut1");
    compare(e.u4, "U4_ut1");
    compare(e.p4, "P4_ut1");
  }
  std::printf("lunar: greatest %.3f s, contacts %.3f s, magnitudes %.1e, gamma %.1e at most\n",
              time, contact, magnitude, gamma);
  EXPECT_LT(time, 1.0);
  EXPECT_LT(contact, 1.5);
  EXPECT_LT(magnitude, 1e-4);
  EXPECT_LT(gamma, 2e-5);
}

TEST(LunarPrediction, EnlargementsAreNamed) {
  EXPECT_EQ(nameOf(parseShadowEnlargement("chauvenet", "x")), "chauvenet");
  EXPECT_THROW(parseShadowEnlargement("bigger", "--shadow-enlargement"), InputError);
  EclipseBasis basis;
  double const danjon = lunarEventOn(basis, "2025-03-14", "x").eclipse.umbralMagnitude;
  basis.enlargement = ShadowEnlargement::None;
  double const none = lunarEventOn(basis, "2025-03-14", "x").eclipse.umbralMagnitude;
  // 1 % of the Moon's parallax, 0.9505 deg, over its diameter, 0.518 deg.
  EXPECT_NEAR(danjon - none, 0.01 * 0.9505 / 0.518, 5e-4);
}

}  // namespace
}  // namespace antumbra
