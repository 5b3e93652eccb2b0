// Rings of a planet in its equatorial plane, as annuli of constant normal optical depth; read from
// [rings] of catalogs/bodies/*.toml (keys and sources: the README there).
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "document/document.h"
#include "quantity/quantity.h"

namespace antumbra {

struct RingPart {
  std::string name;
  Length inner;
  Length outer;
  double opticalDepth = 0.0;  // normal to the plane, visible light
  glm::vec3 albedo{0.0f};     // of single scattering, linear sRGB
};

struct RingSystem {
  double phaseExponent = 0.0;   // n of the particles' phase function, (pi - phase angle)^n
  std::vector<RingPart> parts;  // ascending, without overlap

  Length inner() const { return parts.front().inner; }
  Length outer() const { return parts.back().outer; }
  // 0 in gaps and outside.
  double opticalDepthAt(Length radius) const;
  // Integral of exp(-opticalDepth / sine) from `inner()` to `radius` (beyond the rings, of 1): the
  // light that passes, for a Sun whose height over the plane has that sine.
  Length lightPassedWithin(Length radius, double sine) const;
};

// Throws InputError with file and line for unknown keys, radii that overlap or do not ascend,
// negative depths, an albedo outside 0 to 1.
RingSystem readRings(const Table& table);

}  // namespace antumbra
