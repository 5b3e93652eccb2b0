// The shadows on one body: for each caster the pair's geometry and a table of the limb-darkened
// Sun's visible light between its cones, for the wavelengths of the body's air.
// The table replaces the closed form: 64 places in the antumbra and 256 between the cones by 49
// along the axis; relative error against it below 1e-3 (tests/passes/body_shadows_gl_test.cpp).
// Where several casters cover a part of the Sun at once, the union of their discs is computed at
// the sample (shaders/shared/several_casters.glsl). The table of an oblate caster is that of its
// equator's side.
#pragma once

#include <memory>
#include <vector>

#include "eclipse/corona_light.h"
#include "eclipse/limb_darkening.h"
#include "eclipse/shadow_pair.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace antumbra {

class BodyShadows {
 public:
  // `pairs`: receiver-centred metres, body-fixed axes. `polarOverEquatorial`: of the receiver.
  // `wavelengths`: a multiple of four. `reach`: greatest distance from the receiver's centre at
  // which light is asked for. `corona`: what shines past the casters besides, or none.
  BodyShadows(const std::vector<glsl::ShadowPair>& pairs, double polarOverEquatorial,
              LimbDarkeningLaw law, const std::vector<Length>& wavelengths, Length reach,
              std::shared_ptr<const CoronaLight> corona = {});
  // Geometry of a later instant.
  void update(const std::vector<glsl::ShadowPair>& pairs);
  // Another corona for the next update; one where there was none needs other programs.
  void setCorona(std::shared_ptr<const CoronaLight> corona) { corona_ = std::move(corona); }
  // Uniform blocks 7 and 8, texture unit 8.
  void bind() const;
  // What programs are compiled with for so many casters, with a corona that shines past them or
  // none.
  static gl::Definitions definitions(std::size_t casters, bool corona);
  gl::Definitions definitions() const;
  std::size_t bytes() const { return table_.bytes(); }

 private:
  int count_, layers_;
  double polarOverEquatorial_, reachMetres_;
  std::shared_ptr<const CoronaLight> corona_;
  gl::Program program_;
  gl::Buffer block_, laws_;
  gl::Texture table_;
};

}  // namespace antumbra
