// Galilean shadow transits against published observations of rare ones.
#include "eclipse/jovian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "ephemeris/apparent.h"
#include "frame/body_rotation.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

TEST(Jovian, ThreeShadowsFellOnJupiterOn24January2015) {
  // Sky & Telescope, "Rare Triple Transit!", January 2015: three shadows on the disc from 6:26 to
  // 6:53 UT (1:26 to 1:53 a.m. EST), of Callisto, Io and Europa.
  Instant const day = startOfDate("2015-01-24", "test");
  auto const events = jovianEvents(EclipseBasis{}, day, day + 1.0 * antumbra::day);
  int triple = 0;
  Instant enters = day, leaves = day + 2.0 * antumbra::day;
  for (auto const& e : events) {
    if (!e.shadowOnJupiter || e.shadowsAtOnce < 3) continue;
    ++triple;
    enters = std::max(enters, e.seen(e.begin));
    leaves = std::min(leaves, e.seen(e.end));
  }
  EXPECT_EQ(triple, 3);
  auto const minuteOfDay = [&](Instant t) {
    std::string const iso = ut1Text(t, 67.6 * second);
    return 60.0 * std::stod(iso.substr(11, 2)) + std::stod(iso.substr(14, 2)) +
           std::stod(iso.substr(17)) / 60.0;
  };
  // Published for whole shadows or first specks of them: Callisto's takes ten minutes to leave.
  EXPECT_NEAR(minuteOfDay(enters), 6 * 60 + 26, 3.0);
  EXPECT_NEAR(minuteOfDay(leaves), 6 * 60 + 53, 6.0);
}

TEST(Jovian, EventsComeOncePerRevolution) {
  Instant const from = startOfYear(2020);
  auto const events = jovianEvents(EclipseBasis{}, from, from + 100.0 * day);
  int io = 0, ioEclipsed = 0, callisto = 0;
  for (auto const& e : events) {
    if (e.moon == BodyId::Io) (e.shadowOnJupiter ? io : ioEclipsed) += 1;
    callisto += e.moon == BodyId::Callisto;
    EXPECT_LT(e.begin, e.middle);
    EXPECT_LT(e.middle, e.end);
    EXPECT_LT(e.end - e.begin, 6.0 * hour);
    EXPECT_LT(e.leastDistance, 1.0);
    EXPECT_GT(e.lightTime, 32.0 * minute);
    EXPECT_LT(e.lightTime, 55.0 * minute);
  }
  // 100 days hold 56.5 revolutions of Io and 6 of Callisto, whose shadow meets Jupiter within some
  // eighteen months of the planet's equinoxes (2015 February, 2021 May) and passes by it in 2018.
  EXPECT_NEAR(io, 56.5, 0.6);
  EXPECT_NEAR(ioEclipsed, 56.5, 0.6);
  EXPECT_NEAR(callisto, 12, 1);
  for (auto const& e : jovianEvents(EclipseBasis{}, startOfYear(2018), startOfYear(2019)))
    EXPECT_NE(e.moon, BodyId::Callisto) << e.id;
}

// A moon's shadow on Jupiter from its place as JPL gives it at an epoch, by the definition: the
// line from the Sun through the moon meets the ellipsoid.
class ShadowByPlace {
 public:
  // `truth`: moon less planet, metres along Icrs, at `epoch`.
  ShadowByPlace(BodyId moon, Instant epoch, const glm::dvec3& truth)
      : moon_(moon), axes_(bodyFixedFromIcrs(bodyRotation("Jupiter"), epoch).matrix) {
    auto const s = Ephemeris::standard().state(moon, BodyId::Jupiter, epoch);
    off_ = glm::transpose(orbitAxes(s)) * (truth - s.position.m);
  }
  double kilometresOff() const { return glm::length(off_) / 1e3; }
  // Distance of the line from the centre over the equatorial radius, where Jupiter's axes are
  // stretched so that it is a sphere; with the epoch's difference carried along the orbit, or not.
  double lineDistance(Instant t, bool corrected) const {
    auto const& ephemeris = Ephemeris::standard();
    auto const eye = observerAt(ephemeris, BodyId::Jupiter, t);
    glm::dvec3 const sun = apparentPlace(ephemeris, BodyId::Sun, eye, t).displacement.m;
    glm::dvec3 moon = apparentPlace(ephemeris, moon_, eye, t).displacement.m;
    if (corrected) moon += orbitAxes(ephemeris.state(moon_, BodyId::Jupiter, t)) * off_;
    glm::dvec3 const stretch(1.0, 1.0, 71492.0 / 66854.0);
    glm::dvec3 const m = axes_ * moon * stretch;
    glm::dvec3 const ray = glm::normalize(axes_ * (moon - sun) * stretch);
    return glm::length(glm::cross(m, ray)) / 71492e3;
  }
  // When the line's distance passes 1 between two instants, by halving.
  Instant crossing(Instant early, Instant late, bool corrected) const {
    bool const atFirst = lineDistance(early, corrected) < 1.0;
    while (late - early > 0.05 * second) {
      Instant const middle = early + 0.5 * (late - early);
      ((lineDistance(middle, corrected) < 1.0) == atFirst ? early : late) = middle;
    }
    return early;
  }

 private:
  // Radial, along the motion, across both.
  static glm::dmat3 orbitAxes(const State& s) {
    glm::dvec3 const radial = glm::normalize(s.position.m);
    glm::dvec3 const normal = glm::normalize(glm::cross(s.position.m, s.velocity.m));
    return {radial, glm::cross(normal, radial), normal};
  }

  BodyId moon_;
  glm::dmat3 axes_;
  glm::dvec3 off_{0.0};
};

// The shadow transit nearest each epoch of JPL's places (Horizons), with the moon where JPL has it.
TEST(Jovian, ShadowTransitsAreThoseOfJplWithinHalfAMinute) {
  EclipseBasis const basis;
  std::map<std::string, std::pair<int, double>> found;  // count, largest difference in s
  double largestOwn = 0.0;
  for (const auto& row : readCsv("tests/authorities/moons_planetocentric.csv")) {
    auto const moon = bodyFromName(row.text("moon"));
    if (row.text("planet") != "Jupiter" || !moon) continue;
    if (*moon != BodyId::Io && *moon != BodyId::Europa && *moon != BodyId::Ganymede &&
        *moon != BodyId::Callisto)
      continue;
    Instant const epoch = Instant::fromTdb({row.number("jd_tdb"), 0.0});
    if (epoch.julianYear() < 1901.0 || epoch.julianYear() > 2099.0) continue;
    ShadowByPlace const shadow(
        *moon, epoch,
        {1e3 * row.number("x_km"), 1e3 * row.number("y_km"), 1e3 * row.number("z_km")});
    std::optional<JovianEvent> nearest;
    for (auto const& e : jovianEvents(basis, epoch - 9.0 * day, epoch + 9.0 * day))
      if (e.moon == *moon && e.shadowOnJupiter &&
          (!nearest || abs(e.middle - epoch) < abs(nearest->middle - epoch)))
        nearest = e;
    // Callisto's shadow passes by Jupiter for years; near the poles it only grazes the planet.
    if (!nearest || nearest->leastDistance > 0.95) continue;
    Duration const half = 0.5 * (nearest->end - nearest->begin);
    auto& [count, largest] = found[row.text("moon")];
    ++count;
    for (bool const corrected : {false, true})
      for (bool const entry : {true, false}) {
        Instant const outside = entry ? nearest->begin - half : nearest->end + half;
        Instant const expected = shadow.crossing(std::min(outside, nearest->middle),
                                                 std::max(outside, nearest->middle), corrected);
        double const difference = ((entry ? nearest->begin : nearest->end) - expected) / second;
        double& most = corrected ? largest : largestOwn;
        most = std::max(most, std::fabs(difference));
      }
  }
  std::printf("shadow transits, contacts by halving: within %.2f s\n", largestOwn);
  for (const auto& [name, what] : found) {
    std::printf("shadow transits of %-9s %3d, within %.1f s of JPL's places\n", name.c_str(),
                what.first, what.second);
    EXPECT_GT(what.first, name == "Callisto" ? 3 : 20) << name;
    EXPECT_LT(what.second, 30.0) << name;
  }
  EXPECT_EQ(found.size(), 4u);
  EXPECT_LT(largestOwn, 0.5);
}

}  // namespace
}  // namespace antumbra
