// Light that the casters' own airs bend into their shadows on one body: tables for
// interface/refracted_light.glsl, from atmosphere/refracted_shadow_table.h. The light of a place
// replaces that of the geometric shadow, umbra and penumbra alike.
#pragma once

#include <memory>
#include <vector>

#include "atmosphere/refracted_shadow_table.h"
#include "eclipse/shadow_pair.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace antumbra {

class RefractedLight {
 public:
  // One table for each caster of the body, null where it has no air; `wavelengths`: a multiple of
  // four, those of the tables. At least one is not null.
  RefractedLight(std::vector<std::shared_ptr<RefractedShadowTable>> tables, int wavelengths,
                 Length reach);
  // Geometry of an instant, one pair for each caster.
  void update(const std::vector<glsl::ShadowPair>& pairs);
  // Uniform block 11, texture unit 11.
  void bind() const;
  static gl::Definitions definitions() { return {{"REFRACTED_LIGHT", ""}}; }
  std::size_t bytes() const { return texture_.bytes(); }
  const std::vector<std::shared_ptr<RefractedShadowTable>>& tables() const { return tables_; }

 private:
  std::vector<std::shared_ptr<RefractedShadowTable>> tables_;
  int layers_;
  double reachMetres_;
  gl::Buffer block_;
  gl::Texture texture_;
};

}  // namespace antumbra
