#include "ephemeris/playback.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <numbers>
#include <shared_mutex>
#include <thread>

#include "ephemeris/masses.h"

namespace antumbra {
namespace {

constexpr std::size_t kOrders = 14;
constexpr long kKeptBehind = 8;  // segments behind the playback that stay for a turn of direction

// What is fitted: one vector each, whose sums give every body.
struct Track {
  BodyId target, centre;
  double daysPerSegment;
};
constexpr Track kTracks[] = {
    {BodyId::Sun, BodyId::SolarSystemBarycentre, 32.0},
    {BodyId::EarthMoonBarycentre, BodyId::Sun, 8.0},
    {BodyId::Moon, BodyId::Earth, 4.0},
    {BodyId::Mercury, BodyId::Sun, 6.0},
    {BodyId::Venus, BodyId::Sun, 8.0},
    {BodyId::Mars, BodyId::Sun, 32.0},
    {BodyId::JupiterBarycentre, BodyId::Sun, 32.0},
    {BodyId::SaturnBarycentre, BodyId::Sun, 32.0},
    {BodyId::UranusBarycentre, BodyId::Sun, 32.0},
    {BodyId::NeptuneBarycentre, BodyId::Sun, 32.0},
    {BodyId::PlutoBarycentre, BodyId::Sun, 32.0},
};
constexpr std::size_t kTrackCount = std::size(kTracks);
constexpr std::size_t kSun = 0, kEmb = 1, kMoon = 2;

struct Segment {
  alignas(32) double c[4 * kOrders] = {};
};
using SegmentPointer = std::shared_ptr<const Segment>;

std::optional<std::size_t> trackOf(BodyId body) {
  for (std::size_t i = 3; i < kTrackCount; ++i)
    if (kTracks[i].target == body) return i;
  return std::nullopt;
}

Instant dayOf(double tdbDays) { return Instant::fromTdb({2451545.0, tdbDays}); }

}  // namespace

struct PlaybackEphemeris::Cache {
  struct Stretch {
    long first = 0;
    std::vector<SegmentPointer> segments;
    const Segment* find(long index) const {
      if (index < first || index >= first + static_cast<long>(segments.size())) return nullptr;
      return segments[static_cast<std::size_t>(index - first)].get();
    }
  };
  mutable std::shared_mutex guard;
  std::array<Stretch, kTrackCount> stretches;
  std::atomic<std::size_t> misses = 0;

  std::mutex wanted;
  std::condition_variable_any wake;
  std::optional<std::pair<double, double>> range;  // days to have ready
  bool forward = true;
  std::jthread worker;

  static long indexOf(const Track& track, double days) {
    return static_cast<long>(std::floor(days / track.daysPerSegment));
  }

  // The state of one track, or nothing where no segment is ready. Caller holds the guard.
  std::optional<State> read(std::size_t i, double days) const {
    auto const& track = kTracks[i];
    long const index = indexOf(track, days);
    const Segment* segment = stretches[i].find(index);
    if (!segment) return std::nullopt;
    double const x = 2.0 * (days / track.daysPerSegment - static_cast<double>(index)) - 1.0;
    auto const sum = chebyshevSum(segment->c, kOrders, x);
    return State{{sum.value}, {2.0 / (track.daysPerSegment * 86400.0) * sum.derivative}};
  }

  // Interpolation at Chebyshev nodes; nothing where the theory changes or ends within the segment.
  static SegmentPointer fit(const Ephemeris& source, const Track& track, long index) {
    double const begin = static_cast<double>(index) * track.daysPerSegment;
    try {
      if (source.theoryAt(dayOf(begin)) != source.theoryAt(dayOf(begin + track.daysPerSegment)))
        return nullptr;
      auto segment = std::make_shared<Segment>();
      for (std::size_t node = 0; node < kOrders; ++node) {
        double const angle =
            std::numbers::pi * (static_cast<double>(node) + 0.5) / static_cast<double>(kOrders);
        double const days = begin + 0.5 * track.daysPerSegment * (1.0 + std::cos(angle));
        auto const place =
            source.Ephemeris::state(track.target, track.centre, dayOf(days)).position.m;
        for (std::size_t k = 0; k < kOrders; ++k) {
          double const weight = (k == 0 ? 1.0 : 2.0) / static_cast<double>(kOrders) *
                                std::cos(static_cast<double>(k) * angle);
          for (int axis = 0; axis < 3; ++axis)
            segment->c[4 * k + static_cast<std::size_t>(axis)] += weight * place[axis];
        }
      }
      return segment;
    } catch (const SpanError&) {
      return nullptr;
    }
  }

  // Makes every track hold [from, to]; keeps what it has nearby. `stop` ends early.
  void build(const Ephemeris& source, double from, double to, const std::stop_token* stop) {
    for (std::size_t i = 0; i < kTrackCount; ++i) {
      auto const& track = kTracks[i];
      long const first = indexOf(track, from), last = indexOf(track, to);
      Stretch next;
      next.first = first - kKeptBehind;
      {
        std::shared_lock const lock(guard);
        auto const& old = stretches[i];
        for (long k = next.first; k <= last + kKeptBehind; ++k) {
          long const offset = k - old.first;
          bool const kept = offset >= 0 && offset < static_cast<long>(old.segments.size());
          next.segments.push_back(kept ? old.segments[static_cast<std::size_t>(offset)] : nullptr);
        }
      }
      bool changed = false;
      for (long k = first; k <= last; ++k) {
        auto& slot = next.segments[static_cast<std::size_t>(k - next.first)];
        if (slot) continue;
        if (stop && stop->stop_requested()) return;
        slot = fit(source, track, k);
        changed = true;
      }
      if (!changed) continue;
      std::unique_lock const lock(guard);
      std::swap(stretches[i], next);
    }
  }
};

PlaybackEphemeris::PlaybackEphemeris(const Ephemeris& source)
    : Ephemeris(source), cache_(std::make_unique<Cache>()) {}

PlaybackEphemeris::~PlaybackEphemeris() {
  if (cache_->worker.joinable()) {
    cache_->worker.request_stop();
    cache_->wake.notify_all();
    cache_->worker.join();
  }
}

void PlaybackEphemeris::prepare(Instant from, Instant to) const {
  double const a = from.tdbDaysSinceJ2000(), b = to.tdbDaysSinceJ2000();
  cache_->build(*this, std::min(a, b), std::max(a, b), nullptr);
}

void PlaybackEphemeris::follow(Instant now, double rate, Duration ahead) const {
  double const here = now.tdbDaysSinceJ2000(), there = here + rate * (ahead / day);
  {
    std::lock_guard const lock(cache_->wanted);
    cache_->range = std::minmax(here, there);
    if (!cache_->worker.joinable())
      cache_->worker = std::jthread([this](std::stop_token stop) {
        while (!stop.stop_requested()) {
          std::pair<double, double> range;
          {
            std::unique_lock lock(cache_->wanted);
            cache_->wake.wait(lock, stop, [this] { return cache_->range.has_value(); });
            if (stop.stop_requested()) return;
            range = *cache_->range;
            cache_->range.reset();
          }
          cache_->build(*this, range.first, range.second, &stop);
        }
      });
  }
  cache_->wake.notify_one();
}

State PlaybackEphemeris::state(BodyId target, BodyId centre, Instant t) const {
  State out;
  states(std::span(&target, 1), centre, t, std::span(&out, 1));
  return out;
}

void PlaybackEphemeris::states(std::span<const BodyId> targets, BodyId centre, Instant t,
                               std::span<State> out) const {
  double const days = t.tdbDaysSinceJ2000();
  {
    std::shared_lock const lock(cache_->guard);
    std::array<std::optional<State>, kTrackCount> read;
    auto const track = [&](std::size_t i) -> const std::optional<State>& {
      if (!read[i]) read[i] = cache_->read(i, days);
      return read[i];
    };
    constexpr double kEarthShare = 1.0 / (1.0 + kEarthOverMoonMass);
    auto const heliocentric = [&](BodyId body) -> std::optional<State> {
      if (body == BodyId::Sun) return State{};
      if (body == BodyId::SolarSystemBarycentre) {
        if (auto const& s = track(kSun)) return -1.0 * *s;
        return std::nullopt;
      }
      if (auto const i = trackOf(body)) return track(*i);
      auto const& emb = track(kEmb);
      auto const& moon = track(kMoon);
      if (!emb || !moon) return std::nullopt;
      if (body == BodyId::EarthMoonBarycentre) return emb;
      if (body == BodyId::Earth) return *emb - kEarthShare * *moon;
      if (body == BodyId::Moon) return *emb + (1.0 - kEarthShare) * *moon;
      return std::nullopt;
    };
    auto const placed = [&](BodyId body) -> std::optional<State> {
      auto s = heliocentric(systemOf(body));
      if (s && systemOf(body) != body) s = *s + withinSystem(body, days);
      return s;
    };
    auto const origin = placed(centre);
    std::size_t done = 0;
    for (; origin && done < targets.size(); ++done) {
      BodyId const target = targets[done];
      bool const lunar = (target == BodyId::Moon && centre == BodyId::Earth) ||
                         (target == BodyId::Earth && centre == BodyId::Moon);
      auto const s = lunar ? track(kMoon) : placed(target);
      if (!s) break;
      out[done] = !lunar ? *s - *origin : target == BodyId::Moon ? *s : -1.0 * *s;
    }
    if (done == targets.size()) return;
  }
  cache_->misses += targets.size();
  Ephemeris::states(targets, centre, t, out);
}

std::size_t PlaybackEphemeris::misses() const { return cache_->misses; }

}  // namespace antumbra
