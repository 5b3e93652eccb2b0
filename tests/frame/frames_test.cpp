// Precession, nutation and Earth rotation against published values and Swiss Ephemeris.
#include "frame/frames.h"

#include <erfa.h>
#include <gtest/gtest.h>
#include <type_traits>

#include "tests/support/csv.h"

namespace antumbra {
namespace {

double largestDifference(const glm::dmat3& a, const glm::dmat3& b) {
  double d = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) d = std::max(d, std::fabs(a[i][j] - b[i][j]));
  return d;
}
Instant epoch(double julianYear) {
  return Instant::fromTt({2451545.0, (julianYear - 2000.0) * 365.25});
}

// Wrong mixes of frames do not compile.
using ItrsRotation = Rotation<Itrs, Icrs>;
static_assert(std::is_invocable_v<ItrsRotation, Displacement<Icrs>>);
static_assert(!std::is_invocable_v<ItrsRotation, Displacement<Itrs>>);
static_assert(!std::is_invocable_v<ItrsRotation, Displacement<EclipticJ2000>>);
static_assert(!std::is_invocable_v<ItrsRotation, Displacement<TrueEquatorOfDate>>);

TEST(Frames, TerrestrialRotationEqualsErfasOwn) {
  for (double year : {1900.0, 1987.3, 2027.6, 2099.0}) {
    auto const t = epoch(year);
    auto const deltaT = DeltaT::fixed(60.0 * second);
    double m[3][3];
    auto const tt = t.tt(), ut1 = t.ut1(deltaT);
    eraC2t06a(tt.whole, tt.fraction, ut1.whole, ut1.fraction, 0.0, 0.0, m);
    auto const mine = itrsFromIcrs(t, deltaT).matrix;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        // CIO based there, equinox based here: 0.00005" apart in 1900.
        EXPECT_NEAR(mine[j][i], m[i][j], 5e-10) << year;
  }
}

TEST(Frames, LongTermPrecessionMeetsIau2006AtTheSeams) {
  for (double edge : {1800.0, 2200.0}) {
    auto const a = trueEquatorOfDateFromIcrs(epoch(edge - 1e-5)).matrix;
    auto const b = trueEquatorOfDateFromIcrs(epoch(edge + 1e-5)).matrix;
    // 1e-5 year of precession is 0.0005"; what the models differ by stays below 0.002".
    EXPECT_LT(largestDifference(a, b), 0.003 * arcsecond.si) << edge;
    auto const deltaT = DeltaT::fixed(0.0 * second);
    // Sidereal time advances 2 pi a day: 2e-5 years of it, modulo a turn, is taken out.
    double const step = 2e-5 * 365.25 * 2.0 * M_PI * 1.00273781191;
    double const jump = std::remainder((greenwichApparentSiderealTime(epoch(edge + 1e-5), deltaT) -
                                        greenwichApparentSiderealTime(epoch(edge - 1e-5), deltaT))
                                               .si -
                                           step,
                                       2.0 * M_PI);
    EXPECT_LT(std::fabs(jump), 0.003 * arcsecond.si) << edge;
  }
}

TEST(Frames, NutationAndObliquityAgreeWithSwissEphemeris) {
  for (const auto& row : readCsv("tests/authorities/nutation_obliquity.csv")) {
    auto const t = Instant::fromTt({row.number("jd_tt"), 0.0});
    auto const mine = nutationAndObliquity(t);
    bool const near = row.text("epoch_id").starts_with("main");
    // Near the present the file's own ERFA columns; far off Swiss Ephemeris's 2000B-like nutation,
    // whose arguments drift by 0.03".
    double const tolerance = near ? 2e-6 : 0.05;
    EXPECT_NEAR(mine.longitude / arcsecond,
                row.number(near ? "erfa_dpsi_06a_arcsec" : "se_dpsi_arcsec"), tolerance);
    if (near) {
      EXPECT_NEAR(mine.meanObliquity / degree, row.number("erfa_obl06_deg"), 1e-9);
    }
  }
}

}  // namespace
}  // namespace antumbra
