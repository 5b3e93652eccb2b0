#include "ephemeris/state.h"

#include <fmt/format.h>

namespace antumbra {

SpanError::SpanError(const std::string& theory, Instant asked, Span span, bool extrapolable)
    : InputError(fmt::format("{}: found the date {} (JD {:.5f} TT); allowed: {} to {}", theory,
                             formatIso(asked, TimeScale::Tt, 0), asked.tt().value(),
                             formatIso(span.first, TimeScale::Tt, 0),
                             formatIso(span.last, TimeScale::Tt, 0))),
      theory_(theory),
      extrapolable_(extrapolable),
      span_(span) {}

}  // namespace antumbra
