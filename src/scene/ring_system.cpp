#include "scene/ring_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace antumbra {

double RingSystem::opticalDepthAt(Length radius) const {
  for (auto const& part : parts)
    if (radius >= part.inner && radius < part.outer) return part.opticalDepth;
  return 0.0;
}

Length RingSystem::lightPassedWithin(Length radius, double sine) const {
  double metres = radius.si - inner().si;
  for (auto const& part : parts) {
    double const covered = std::clamp(radius.si, part.inner.si, part.outer.si) - part.inner.si;
    metres -= covered * -std::expm1(-part.opticalDepth / sine);
  }
  return Length(metres);
}

RingSystem readRings(const Table& table) {
  RingSystem rings;
  rings.phaseExponent = table.number("phase_exponent");
  if (!(rings.phaseExponent >= 0.0 && rings.phaseExponent <= 10.0))
    table.fail("phase_exponent", fmt::format("found {}; allowed: 0 to 10", rings.phaseExponent));
  for (const Table& t : table.tables("part")) {
    RingPart part;
    part.name = t.text("name");
    part.inner = t.length("inner");
    part.outer = t.length("outer");
    Length const least = rings.parts.empty() ? Length(0.0) : rings.parts.back().outer;
    if (part.inner < least || !(part.inner.si > 0.0))
      t.fail("inner", fmt::format("found {} km; allowed: from the outer radius of the part before, "
                                  "{} km",
                                  part.inner / kilometre, least / kilometre));
    if (!(part.outer > part.inner)) t.fail("outer", "allowed: above the inner radius");
    part.opticalDepth = t.number("optical_depth");
    if (!(part.opticalDepth >= 0.0))
      t.fail("optical_depth", fmt::format("found {}; allowed: 0 or more", part.opticalDepth));
    auto const albedo = t.numbers("albedo");
    if (albedo.size() != 3)
      t.fail("albedo", fmt::format("found {} numbers; allowed: three, linear sRGB", albedo.size()));
    for (double a : albedo)
      if (!(a >= 0.0 && a <= 1.0)) t.fail("albedo", fmt::format("found {}; allowed: 0 to 1", a));
    part.albedo = {albedo[0], albedo[1], albedo[2]};
    rings.parts.push_back(part);
  }
  if (rings.parts.empty()) table.fail("part", "missing; rings need at least one part");
  return rings;
}

}  // namespace antumbra
