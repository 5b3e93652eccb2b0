// The light in the shadow of a body with air, tabulated over the distance from the axis, at any
// distance behind the body: rows for shaders.
//
// The light of refracted_shadow.h is computed at nodes 1 % apart in the distance behind the body
// and 0.4 % in that of the Sun, when first asked for, and interpolated by straight lines in its
// logarithm between four of them, at equal places of shaders/shared/refracted_shadow.glsl: within
// 1 % of the light itself, 1.5 % on the axis (tests/atmosphere/refracted_shadow_test.cpp). A row is
// a pure function of its station.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "atmosphere/refracted_shadow.h"

namespace antumbra {

class RefractedShadowTable {
 public:
  static constexpr int kPlaces = 512;  // from the axis to the reach, both ends included
  RefractedShadowTable(const Medium& medium, Length ground, Length sunRadius,
                       const std::vector<Length>& wavelengths, LimbDarkeningLaw law);

  // log2 of the light, place by place, every wavelength of a place together.
  std::vector<double> row(const ShadowStation& station);
  // Distance from the axis of a place of the row (shaders/shared/refracted_shadow.glsl).
  Length distance(int place, const ShadowStation& station) const;
  const RefractedShadow& shadow() const { return shadow_; }
  int nodesComputed() const { return static_cast<int>(nodes_.size()); }

 private:
  const std::vector<double>& node(int behind, int sun);
  RefractedShadow shadow_;
  Length sunRadius_;
  std::map<std::pair<int, int>, std::vector<double>> nodes_;
};

}  // namespace antumbra
