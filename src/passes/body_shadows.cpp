#include "passes/body_shadows.h"

#include <fmt/format.h>

namespace antumbra {
namespace {

constexpr int kPlaces = 64 + 256, kAlong = 49;  // 64: SHADOW_INNER of interface/shadows.glsl

}  // namespace

BodyShadows::BodyShadows(const std::vector<glsl::ShadowPair>& pairs, double polarOverEquatorial,
                         LimbDarkeningLaw law, const std::vector<Length>& wavelengths, Length reach,
                         std::shared_ptr<const CoronaLight> corona)
    : count_(static_cast<int>(pairs.size())),
      layers_(static_cast<int>(wavelengths.size() / 4)),
      polarOverEquatorial_(polarOverEquatorial),
      reachMetres_(reach.si),
      corona_(std::move(corona)),
      table_(gl::Texture::layers(GL_RGBA32F, kPlaces, kAlong, count_ * layers_)) {
  auto d = definitions();
  d.emplace_back("AIR_LAYERS", std::to_string(layers_));
  program_ = gl::Program::compute("precompute/shadow_light.comp", d);
  std::vector<float> laws;
  for (int layer = 0; layer < layers_; ++layer) {
    auto const first = wavelengths.begin() + layer * 4;
    auto const packed =
        packedForShader(limbDarkening(law, {first[0], first[1], first[2], first[3]}));
    laws.insert(laws.end(), packed.begin(), packed.end());
  }
  laws_.write(std::span<const float>(laws));
  update(pairs);
}

gl::Definitions BodyShadows::definitions(std::size_t casters, bool corona) {
  gl::Definitions d{{"SHADOW_PAIRS", std::to_string(casters)}};
  if (corona) d.emplace_back("CORONA_LIGHT", "");
  return d;
}
gl::Definitions BodyShadows::definitions() const {
  return definitions(static_cast<std::size_t>(count_), corona_ != nullptr);
}

void BodyShadows::update(const std::vector<glsl::ShadowPair>& pairs) {
  std::vector<float> block;
  for (auto const& pair : pairs) {
    auto const packed = packedForShader(pair);
    block.insert(block.end(), packed.begin(), packed.end());
  }
  for (double value : {polarOverEquatorial_, reachMetres_, 0.0, 0.0})
    block.push_back(static_cast<float>(value));
  for (auto const& pair : pairs) {
    if (!corona_) break;
    auto const packed = packedForShader(corona_->fit(pair, Length(reachMetres_)));
    block.insert(block.end(), packed.begin(), packed.end());
  }
  block_.write(std::span<const float>(block));
  block_.bindUniform(7);
  laws_.bindUniform(8);
  program_.use();
  table_.bindImage(0, GL_WRITE_ONLY);
  glDispatchCompute(kPlaces / 8, (kAlong + 3) / 4, static_cast<GLuint>(count_ * layers_));
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void BodyShadows::bind() const {
  block_.bindUniform(7);
  laws_.bindUniform(8);
  table_.bind(8);
}

}  // namespace antumbra
