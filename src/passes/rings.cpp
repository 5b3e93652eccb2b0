#include "passes/rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gl/view_block.h"

namespace antumbra {
namespace {

constexpr int kProfileTexels = 4096;
// Shadow table: radii from the inner edge less a margin to the outer one and as much, and widths of
// the Sun's disc in equal steps of their logarithm.
constexpr int kShadowRadii = 4096, kShadowWidths = 24;
constexpr double kMargin = 0.1;
constexpr double kNarrowest = 1e4, kWidest = 3e7;  // m
// Live, how far the sine of the Sun's height may move, relatively, before the table does.
constexpr double kLiveTolerance = 1e-3;
constexpr int kStrips = 32;  // of the disc

struct ShadowBlock {  // std140, `RingShadow` of interface/body.glsl
  glm::vec4 radii;  // first and last of the table, m; log2 of the narrowest width, steps per octave
  glm::vec4 sun;    // its angular radius, rad
};

// Share of the disc's light in equal strips across it, from one limb to the other.
std::array<double, kStrips> stripsOfDisc(LimbDarkeningLaw law) {
  LimbProfile const profile = limbProfile(law, 550.0 * nanometre);
  std::array<double, kStrips> strips{};
  double sum = 0.0;
  constexpr int kFine = 64;
  for (int i = 0; i < kStrips; ++i) {
    for (int a = 0; a < kFine; ++a) {
      double const x = 2.0 * (i + (a + 0.5) / kFine) / kStrips - 1.0;
      double const chord = std::sqrt(std::max(1.0 - x * x, 0.0));
      for (int b = 0; b < kFine; ++b) {
        double const y = chord * (b + 0.5) / kFine;
        double const mu = std::sqrt(std::max(1.0 - x * x - y * y, 0.0));
        double polynomial = 0.0;
        for (std::size_t k = 6; k-- > 0;) polynomial = polynomial * mu + profile.polynomial[k];
        strips[static_cast<std::size_t>(i)] += chord * std::pow(mu, profile.exponent) * polynomial;
      }
    }
    sum += strips[static_cast<std::size_t>(i)];
  }
  for (double& s : strips) s /= sum;
  return strips;
}

}  // namespace

double ringPhaseNorm(double exponent) {
  // 2 over the integral of x^n sin x from 0 to pi, by Simpson's rule.
  constexpr int kSteps = 2000;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    double const x = std::numbers::pi * i / kSteps;
    double const f = std::pow(x, exponent) * std::sin(x);
    sum += f * (i == 0 || i == kSteps ? 1.0 : i % 2 ? 4.0 : 2.0);
  }
  return 2.0 / (sum * std::numbers::pi / kSteps / 3.0);
}

Rings::Rings(const RingSystem& system, LimbDarkeningLaw law, const std::vector<Length>& wavelengths,
             const gl::Definitions& colourDefinitions, bool exact)
    : system_(system),
      law_(law),
      wavelengths_(wavelengths),
      colourDefinitions_(colourDefinitions),
      exact_(exact),
      profile_(gl::Texture::plane(GL_RGBA32F, kProfileTexels, 1, gl::Filter::Mipmapped,
                                  gl::Wrap::Clamp, 0)),
      shadow_(gl::Texture::plane(GL_R32F, kShadowRadii, kShadowWidths)) {
  double const inner = system.inner().si, outer = system.outer().si;
  double const step = (outer - inner) / kProfileTexels;
  std::vector<float> texels;
  for (int i = 0; i < kProfileTexels; ++i) {
    // Each texel the mean over its width; a gap keeps the albedo of what lies nearest.
    double const from = inner + step * i, to = from + step;
    double depth = 0.0, nearest = 1e300;
    glm::vec3 albedo(0.0f);
    for (auto const& part : system.parts) {
      depth += part.opticalDepth *
               std::max(0.0, std::min(to, part.outer.si) - std::max(from, part.inner.si)) / step;
      double const away = std::max({part.inner.si - to, from - part.outer.si, 0.0});
      if (away < nearest) {
        nearest = away;
        albedo = part.albedo;
      }
    }
    for (int c = 0; c < 3; ++c) texels.push_back(albedo[c]);
    texels.push_back(static_cast<float>(depth));
  }
  profile_.upload(std::span<const float>(texels), 4);
}

void Rings::tabulateShadow(double sine) {
  if (std::fabs(sine - tabulatedSine_) <= (exact_ ? 0.0 : kLiveTolerance) * sine) return;
  tabulatedSine_ = sine;
  // Light passed within a radius is linear between the parts' edges.
  std::vector<std::pair<double, double>> knots{{0.0, -system_.inner().si}};
  for (auto const& part : system_.parts)
    for (Length const edge : {part.inner, part.outer})
      knots.emplace_back(edge.si, system_.lightPassedWithin(edge, sine).si);
  knots.emplace_back(1e10, knots.back().second + 1e10 - knots.back().first);
  auto const passedWithin = [&](double radius) {
    auto const above =
        std::lower_bound(knots.begin() + 1, knots.end() - 1, std::pair(radius, -1e300));
    auto const below = above - 1;
    double const width = above->first - below->first;
    double const share = width > 0.0 ? (radius - below->first) / width : 0.0;
    return below->second + share * (above->second - below->second);
  };
  auto const strips = stripsOfDisc(law_);
  double const inner = system_.inner().si, outer = system_.outer().si;
  double const margin = kMargin * (outer - inner);
  double const first = inner - margin, last = outer + margin;
  std::vector<float> texels(static_cast<std::size_t>(kShadowRadii * kShadowWidths));
  for (int row = 0; row < kShadowWidths; ++row) {
    double const half =
        kNarrowest * std::pow(kWidest / kNarrowest, double(row) / (kShadowWidths - 1));
    for (int i = 0; i < kShadowRadii; ++i) {
      double const radius = first + (last - first) * i / (kShadowRadii - 1);
      double light = 0.0;
      double before = passedWithin(radius - half);
      for (int k = 0; k < kStrips; ++k) {
        double const edge = radius + half * (2.0 * (k + 1) / kStrips - 1.0);
        double const passed = passedWithin(edge);
        light += strips[static_cast<std::size_t>(k)] * (passed - before) / (2.0 * half / kStrips);
        before = passed;
      }
      texels[static_cast<std::size_t>(row * kShadowRadii + i)] = static_cast<float>(light);
    }
  }
  shadow_.upload(std::span<const float>(texels), 1);
}

void Rings::update(const PlannedBody& body, const Projection& picture) {
  kind_ = picture.kind;
  double const distance = glm::length(body.sun.m);
  double const height = body.sun.m.z / distance, sine = std::max(std::fabs(height), 1e-6);
  auto const& rings = *body.rings;
  if (rings.shadeGlobe) {
    tabulateShadow(sine);
    double const inner = system_.inner().si, outer = system_.outer().si;
    double const margin = kMargin * (outer - inner);
    ShadowBlock const block{glm::vec4(inner - margin, outer + margin, std::log2(kNarrowest),
                                      (kShadowWidths - 1) / std::log2(kWidest / kNarrowest)),
                            glm::vec4(rings.globe.sun.si / distance, 0.0, 0.0, 0.0)};
    shadowBlock_.write(block);
  }
  if (rings.bounds.empty()) return;
  auto const pair = shadowPairMetres(body.sun.m, glm::dvec3(0.0), rings.globe,
                                     {{0.0, 0.0, 1.0}, body.polarRadius / body.equatorialRadius});
  std::vector<float> block;
  auto const packed = packedForShader(pair);
  block.insert(block.end(), packed.begin(), packed.end());
  for (double value : {system_.inner().si, system_.outer().si, sine, height < 0.0 ? -1.0 : 1.0,
                       system_.phaseExponent, ringPhaseNorm(system_.phaseExponent), 0.0, 0.0})
    block.push_back(static_cast<float>(value));
  for (std::size_t i = 0; i < wavelengths_.size(); i += 4) {
    auto const law = packedForShader(limbDarkening(
        law_, {wavelengths_[i], wavelengths_[i + 1], wavelengths_[i + 2], wavelengths_[i + 3]}));
    block.insert(block.end(), law.begin(), law.end());
  }
  block_.write(std::span<const float>(block));
  if (!programs_.count(kind_)) {
    auto definitions = gl::projectionDefinition(kind_);
    definitions.insert(definitions.end(), colourDefinitions_.begin(), colourDefinitions_.end());
    programs_[kind_] = gl::Program::fullScreen("passes/rings.frag", definitions);
  }
}

void Rings::draw(const PixelBounds& bounds, RingsHalf half, glm::ivec2 tileOrigin,
                 glm::ivec2 targetSize) const {
  glm::ivec2 const low = glm::max(glm::ivec2(bounds.x0, bounds.y0) - tileOrigin, glm::ivec2(0));
  glm::ivec2 const high = glm::min(glm::ivec2(bounds.x1, bounds.y1) - tileOrigin, targetSize);
  if (high.x <= low.x || high.y <= low.y) return;
  block_.bindUniform(12);
  profile_.bind(12);
  glEnable(GL_SCISSOR_TEST);
  glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_SRC1_COLOR);
  programs_.at(kind_).set("ringSide", half == RingsHalf::BeyondGlobe ? 1.0f : -1.0f).use();
  gl::drawFullScreen();
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

void Rings::bindShadow() const {
  shadowBlock_.bindUniform(13);
  shadow_.bind(13);
}

}  // namespace antumbra
