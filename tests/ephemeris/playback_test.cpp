// The playback cache against its source.
#include "ephemeris/playback.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace antumbra {
namespace {

constexpr BodyId kBodies[] = {BodyId::Sun,
                              BodyId::Moon,
                              BodyId::Mercury,
                              BodyId::Venus,
                              BodyId::Mars,
                              BodyId::JupiterBarycentre,
                              BodyId::SaturnBarycentre,
                              BodyId::SolarSystemBarycentre};

TEST(Playback, EqualsItsSourceWithoutMisses) {
  for (Theory theory : {Theory::Series, Theory::Auto}) {
    Ephemeris const source({.theory = theory});
    PlaybackEphemeris const cached(source);
    auto const start = Instant::fromTt({2461250.0, 0.0});
    cached.prepare(start + 200.0 * day, start);  // the order of the two does not matter
    for (double d = 0.0; d < 200.0; d += 1.37) {
      auto const t = start + d * day;
      for (BodyId body : kBodies) {
        auto const a = cached.state(body, BodyId::Earth, t),
                   b = source.state(body, BodyId::Earth, t);
        // The table's own segments end inside: their rounding steps (up to 570 m) are smoothed.
        double const metres =
            theory == Theory::Series ? 2.0 : 1000.0 + 4e-9 * glm::length(b.position.m);
        EXPECT_LT(glm::length(a.position.m - b.position.m), metres) << nameOf(body) << " " << d;
        EXPECT_LT(angleBetween(a.position, b.position) / arcsecond,
                  theory == Theory::Series ? 0.0001 : 0.003);
        EXPECT_LT(glm::length(a.velocity.m - b.velocity.m), 0.03) << nameOf(body);
      }
    }
    EXPECT_EQ(cached.misses(), 0u);
  }
}

TEST(Playback, AnswersFromTheSourceWhereNothingIsReady) {
  Ephemeris const source({.theory = Theory::Series});
  PlaybackEphemeris const cached(source);
  auto const t = Instant::fromTt({2461250.0, 0.0});
  EXPECT_EQ(cached.state(BodyId::Mars, BodyId::Earth, t).position.m,
            source.state(BodyId::Mars, BodyId::Earth, t).position.m);
  EXPECT_EQ(cached.misses(), 1u);
}

TEST(Playback, FollowBuildsAheadInEitherDirection) {
  Ephemeris const source({.theory = Theory::Series});
  for (double rate : {86400.0 * 10, -86400.0 * 10}) {
    PlaybackEphemeris const cached(source);
    auto const now = Instant::fromTt({2461250.0, 0.0});
    cached.follow(now, rate, 4.0 * second);
    auto const soon = now + 3.9 * rate * second;
    // Ten days a second, four seconds ahead: 120 fits; waits at most ten seconds for them.
    for (int i = 0; i < 1000; ++i) {
      auto const before = cached.misses();
      (void)cached.state(BodyId::Moon, BodyId::Sun, soon);
      (void)cached.state(BodyId::NeptuneBarycentre, BodyId::Sun, soon);
      if (cached.misses() == before) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    auto const before = cached.misses();
    (void)cached.state(BodyId::Moon, BodyId::Sun, soon);
    EXPECT_EQ(cached.misses(), before);
  }
}

TEST(Playback, AChangeOfTheoryIsNotSmoothedOver) {
  Ephemeris const source{Ephemeris::Options{}};
  PlaybackEphemeris const cached(source);
  auto const seam = Ephemeris::tableSpan().first;
  cached.prepare(seam - 40.0 * day, seam + 40.0 * day);
  for (double d : {-1.0, -0.1, 0.1, 1.0}) {
    auto const t = seam + d * day;
    EXPECT_LT(glm::length(cached.state(BodyId::JupiterBarycentre, BodyId::Sun, t).position.m -
                          source.state(BodyId::JupiterBarycentre, BodyId::Sun, t).position.m),
              2000.0);
  }
}

}  // namespace
}  // namespace antumbra
