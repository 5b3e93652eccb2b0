// Sites, horizons and refraction.
#include "geodesy/site.h"

#include <gtest/gtest.h>

#include "document/input_error.h"
#include "geodesy/refraction.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

TEST(Site, RoundTripsThroughItrs) {
  for (double lat : {-90.0, -31.5, 0.0, 25.687, 89.9})
    for (double height : {-430.0, 2.0, 1e7, 4e8}) {
      Site const s{lat * degree, 32.64 * degree, height * metre};
      auto const back = siteFromItrs(itrsFromSite(s));
      EXPECT_NEAR(back.height / metre, height, 1e-6);
      EXPECT_NEAR(back.latitude / degree, lat, 1e-13);
    }
  EXPECT_NEAR(itrsFromSite({0.0 * degree, 90.0 * degree, 0.0 * metre}).m.y, 6378137.0, 1e-9);
}

TEST(Site, EnuPointsEastNorthUp) {
  Site const s{25.687 * degree, 32.640 * degree, 80.0 * metre};
  auto const enu = enuFromItrs(s);
  auto const moved = [&](double lat, double lon, double h) {
    return enu(itrsFromSite(
                   {s.latitude + lat * degree, s.longitude + lon * degree, s.height + h * metre}) -
               itrsFromSite(s))
        .m;
  };
  EXPECT_GT(moved(0, 1e-5, 0).x, 1.0);
  EXPECT_GT(moved(1e-5, 0, 0).y, 1.0);
  EXPECT_NEAR(moved(0, 0, 5).z, 5.0, 1e-8);
  auto const h = horizontalFromEnu({{1.0, 0.0, 0.0}});
  EXPECT_NEAR(h.azimuth / degree, 90.0, 1e-12);
  auto const d = enuFromHorizontal({200.0 * degree, 30.0 * degree});
  EXPECT_NEAR(horizontalFromEnu(d).azimuth / degree, 200.0, 1e-12);
}

TEST(Site, HorizonDipOfAnAeroplane) {
  // acos(6371 / 6381), the textbook form, which is exact enough at this height.
  EXPECT_NEAR(horizonDip(10.0 * kilometre, 6371.0 * kilometre) / degree, 3.20812, 1e-5);
  EXPECT_NEAR(horizonDip(1e-6 * metre, 6371.0 * kilometre) / radian, std::sqrt(2e-6 / 6371e3),
              1e-13);
}

TEST(Site, TextIsCheckedByRange) {
  auto const s = parseSite("25.687,32.640,76", "--site");
  EXPECT_NEAR(s.height / metre, 76.0, 0.0);
  EXPECT_THROW(parseSite("95,0,0", "--site"), InputError);
  EXPECT_THROW(parseSite("25.6", "--site"), InputError);
  EXPECT_THROW(parseSite("25,nan,0", "--site"), InputError);
}

TEST(Refraction, MatchesTheAlmanac) {
  // Explanatory Supplement (2013): 29' at apparent altitude 0.5 degrees, 34' at the horizon, 1'
  // at 45.
  EXPECT_NEAR(refractionAt(-34.0 / 60.0 * degree) / arcminute, 34.0, 1.0);
  EXPECT_NEAR(refractionAt(45.0 * degree) / arcminute, 1.0, 0.03);
  EXPECT_NEAR(refractionAt(90.0 * degree) / arcminute, 0.0, 1e-3);
}

}  // namespace
}  // namespace antumbra
