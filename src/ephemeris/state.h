// Place and velocity of one body relative to another, along the axes of Icrs.
#pragma once

#include <string>

#include "document/input_error.h"
#include "frame/frames.h"
#include "quantity/vector.h"
#include "time/instant.h"

namespace antumbra {

struct State {
  Displacement<Icrs> position;
  Velocity<Icrs> velocity;
  friend State operator+(State a, State b) {
    return {a.position + b.position, a.velocity + b.velocity};
  }
  friend State operator-(State a, State b) {
    return {a.position - b.position, a.velocity - b.velocity};
  }
  friend State operator*(double s, State a) { return {s * a.position, s * a.velocity}; }
};

struct Span {
  Instant first, last;
  bool covers(Instant t) const { return t >= first && t <= last; }
};

// A date outside the span over which a theory is stated to hold; carries the span.
class SpanError : public InputError {
 public:
  // `extrapolable`: Ephemeris::Options::extrapolate would answer.
  SpanError(const std::string& theory, Instant asked, Span span, bool extrapolable = false);
  const std::string& theory() const { return theory_; }
  Span span() const { return span_; }
  bool extrapolable() const { return extrapolable_; }

 private:
  std::string theory_;
  bool extrapolable_;
  Span span_;
};

}  // namespace antumbra
