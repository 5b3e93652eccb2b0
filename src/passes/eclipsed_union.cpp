#include "passes/eclipsed_union.h"

#include "passes/air_tables.h"

namespace antumbra {
namespace {

constexpr int kDistances = 32, kAzimuths = 33;  // the last azimuth is the first one again

gl::Definitions definitionsOf(const AirTables& tables, std::size_t casters) {
  auto d = tables.definitions();
  d.emplace_back("SHADOW_PAIRS", std::to_string(casters));
  d.emplace_back("ECLIPSED_SOURCE", std::to_string(casters));
  return d;
}

}  // namespace

EclipsedUnion::EclipsedUnion(const AirTables& tables, LimbDarkeningLaw law,
                             const std::vector<glsl::ShadowPair>& pairs, double flattening)
    : shadows_(pairs, flattening, law, tables.wavelengths(), tables.groundRadius() + tables.top()),
      program_(gl::Program::compute("precompute/eclipsed_union.comp",
                                    definitionsOf(tables, pairs.size()))),
      map_(gl::Texture::layers(GL_RGBA16F, kDistances, kAzimuths,
                               static_cast<int>(pairs.size()) * tables.layers())) {}

void EclipsedUnion::update(const AirTables& tables, const std::vector<glsl::ShadowPair>& pairs) {
  shadows_.update(pairs);
  tables.bind();
  shadows_.bind();
  map_.bindImage(0, GL_WRITE_ONLY);
  program_.use();
  glDispatchCompute((kDistances + 7) / 8, (kAzimuths + 3) / 4, static_cast<GLuint>(map_.depth()));
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void EclipsedUnion::bind() const { map_.bind(14); }

}  // namespace antumbra
