#include "passes/refracted_light.h"

namespace antumbra {
namespace {

constexpr int kAlong = 3;  // rows from before the body's centre to behind it

}  // namespace

RefractedLight::RefractedLight(std::vector<std::shared_ptr<RefractedShadowTable>> tables,
                               int wavelengths, Length reach)
    : tables_(std::move(tables)),
      layers_(wavelengths / 4),
      reachMetres_(reach.si),
      texture_(gl::Texture::layers(GL_RGBA32F, RefractedShadowTable::kPlaces, kAlong,
                                   static_cast<int>(tables_.size()) * layers_)) {}

void RefractedLight::update(const std::vector<glsl::ShadowPair>& pairs) {
  std::vector<glm::vec4> block;
  constexpr int places = RefractedShadowTable::kPlaces;
  std::vector<float> texels(static_cast<std::size_t>(places * kAlong * texture_.depth() * 4), 0.0f);
  for (std::size_t caster = 0; caster < tables_.size(); ++caster) {
    if (!tables_[caster]) {
      block.emplace_back(0.0f);
      continue;
    }
    auto const& pair = pairs[caster];
    auto const stationAt = [&](double along) {
      return ShadowStation{Length(pair.sunRadius), Length(pair.sunBehind - pair.casterBehind),
                           Length(pair.casterBehind + along)};
    };
    RefractedShadow const& shadow = tables_[caster]->shadow();
    auto const here = stationAt(0.0), beyond = stationAt(reachMetres_);
    auto const growth = [&](Length from, Length to) { return (to - from).si / reachMetres_; };
    block.emplace_back(shadow.reach(here).si, growth(shadow.reach(here), shadow.reach(beyond)),
                       shadow.rim(here).si, growth(shadow.rim(here), shadow.rim(beyond)));
    for (int row = 0; row < kAlong; ++row) {
      double const along = reachMetres_ * (2.0 * row / (kAlong - 1) - 1.0);
      auto const light = tables_[caster]->row(stationAt(along));
      std::size_t const bands = static_cast<std::size_t>(layers_) * 4;
      for (std::size_t place = 0; place < places; ++place)
        for (std::size_t band = 0; band < bands; ++band) {
          std::size_t const layer = caster * static_cast<std::size_t>(layers_) + band / 4;
          std::size_t const texel =
              (layer * kAlong + static_cast<std::size_t>(row)) * places + place;
          texels[texel * 4 + band % 4] = static_cast<float>(light[place * bands + band]);
        }
    }
  }
  block_.write(std::span<const glm::vec4>(block));
  texture_.upload(texels, 4);
}

void RefractedLight::bind() const {
  block_.bindUniform(11);
  texture_.bind(11);
}

}  // namespace antumbra
