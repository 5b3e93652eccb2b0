// An ephemeris for time-lapse: the same answers as another one, read from Chebyshev segments that
// are fitted to it ahead of the playback, so that a frame never waits for a long series.
//
// Each body's segment covers a fixed stretch (4 days for the Moon, 8 to 32 for the planets) with 14
// coefficients, relative to the Sun (Moon: the Earth). Against the source: below 1 m in place and
// 0.0001" in direction (tests/ephemeris/playback_test.cpp).
#pragma once

#include <memory>

#include "ephemeris/ephemeris.h"

namespace antumbra {

class PlaybackEphemeris : public Ephemeris {
 public:
  // Takes the source's theories and options. The series of other planets' moons are short: they
  // are evaluated as they are, on top of the cached system.
  explicit PlaybackEphemeris(const Ephemeris& source);
  ~PlaybackEphemeris() override;

  // Fits what [from, to] needs, now, in this thread.
  void prepare(Instant from, Instant to) const;
  // Tells where playback stands and how fast it runs (seconds of ephemeris per second, either
  // sign): a thread of its own fits what the next `ahead` of real time needs, and forgets what lies
  // far behind.
  void follow(Instant now, double rate, Duration ahead = 4.0 * second) const;

  // Answers from the segments; where one is missing, from the source (never waits for the thread).
  State state(BodyId target, BodyId centre, Instant t) const override;
  void states(std::span<const BodyId> targets, BodyId centre, Instant t,
              std::span<State> out) const override;
  // How many bodies were answered by the source since construction, because a segment was missing.
  std::size_t misses() const;

 private:
  struct Cache;
  std::unique_ptr<Cache> cache_;
};

}  // namespace antumbra
