// Transits of Mercury and Venus against Espenak's catalogues (NASA GSFC, "Seven Century Catalog of
// Mercury Transits" and "Six Millennium Catalog of Venus Transits"): geocentric contacts, UT.
#include "eclipse/transit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace antumbra {
namespace {

struct Printed {
  const char* id;
  BodyId planet;
  double separationArcsec;
  const char *i, *ii, *greatest, *iii, *iv;  // HH:MM
};

double minutes(const std::string& hm) {
  return 60.0 * std::stod(hm.substr(0, 2)) + std::stod(hm.substr(3));
}
double minutesOf(const std::string& iso) {
  return minutes(iso.substr(11, 5)) + std::stod(iso.substr(17)) / 60.0;
}

TEST(Transit, TwoCenturiesHoldThePublishedOnes) {
  auto const all = transits(EclipseBasis{}, startOfYear(1901), startOfYear(2101));
  int mercury = 0, venus = 0;
  std::map<std::string, Transit> found;
  for (auto const& t : all) {
    (t.planet == BodyId::Mercury ? mercury : venus) += 1;
    found[t.id] = t;
  }
  // 14 of Mercury in each of the centuries 1901-2000 and 2001-2100; of Venus 2004 and 2012.
  EXPECT_EQ(mercury, 28);
  EXPECT_EQ(venus, 2);
  for (Printed const& p :
       {Printed{"2004-06-08", BodyId::Venus, 627.0, "05:13", "05:33", "08:20", "11:07", "11:26"},
        Printed{"2012-06-06", BodyId::Venus, 554.0, "22:09", "22:27", "01:29", "04:32", "04:49"},
        Printed{"2016-05-09", BodyId::Mercury, 319.0, "11:12", "11:15", "14:57", "18:39", "18:42"},
        Printed{"2019-11-11", BodyId::Mercury, 76.0, "12:35", "12:37", "15:20", "18:03",
                "18:04"}}) {
    ASSERT_TRUE(found.count(p.id)) << p.id;
    Transit const& t = found[p.id];
    EXPECT_EQ(t.planet, p.planet);
    // Printed to the arcsecond and the minute (rounded or cut), with other radii (10 s).
    EXPECT_NEAR(t.separation / arcsecond, p.separationArcsec, 1.0) << p.id;
    auto const near = [&](const std::optional<Instant>& when, const char* printed) {
      ASSERT_TRUE(when);
      EXPECT_NEAR(std::remainder(minutesOf(ut1Text(*when, t.deltaT)) - minutes(printed), 1440.0),
                  0.3, 0.95)
          << p.id << " " << printed;
    };
    near(t.i, p.i);
    near(t.ii, p.ii);
    near(t.greatest, p.greatest);
    near(t.iii, p.iii);
    near(t.iv, p.iv);
  }
}

}  // namespace
}  // namespace antumbra
