// What several shadows on a body with air leave of its scattered light together.
//
// Each caster's grid (EclipsedSource) holds what its own shadow leaves. Transport is linear, so two
// shadows that lie apart take their losses away side by side, and one behind another takes nothing
// more; neither a product nor the least of the shares does both. So the share of one caster is
// multiplied by that of the light it lets through which the others let through too: the ratio of
// two means of visible sunlight, past all casters and past this one, over the surroundings that
// light is scattered from. The ratio depends on the shape of those surroundings only weakly; it is
// computed for each instant on a map about each shadow's axis, and the casters' results are joined
// by weights that favour the darker one (interface/eclipsed_union.glsl).
//
// Error against the path tracer: tests/passes/two_shadows_gl_test.cpp.
#pragma once

#include <vector>

#include "passes/body_shadows.h"

namespace antumbra {

class AirTables;

class EclipsedUnion {
 public:
  // `pairs`: about the body's centre, m; `flattening`: polar over equatorial radius.
  EclipsedUnion(const AirTables& tables, LimbDarkeningLaw law,
                const std::vector<glsl::ShadowPair>& pairs, double flattening);
  // Geometry of a later instant; uniform block 9 holds the casters' axes.
  void update(const AirTables& tables, const std::vector<glsl::ShadowPair>& pairs);
  void bind() const;  // texture unit 14
  std::size_t bytes() const { return map_.bytes() + shadows_.bytes(); }

 private:
  BodyShadows shadows_;
  gl::Program program_;
  gl::Texture map_;
};

}  // namespace antumbra
