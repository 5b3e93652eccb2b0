#include "passes/air_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <numbers>

#include "medium/forward_peak.h"
#include "passes/gauss_legendre.h"
#include "passes/peak_sunlight.h"
#include "passes/thick_air.h"
#include "photometry/spectral_weights.h"
#include "shared/as_cpp.h"

#define GLSL_AS_CPP
namespace antumbra::glsl {
namespace {
#include "shared/phase_place.glsl"
[[maybe_unused]] auto const kForShaders = &phasePlace;
}  // namespace
}  // namespace antumbra::glsl
#undef GLSL_AS_CPP

namespace antumbra {
namespace {

constexpr int kDensityTexels = 1024;
constexpr float kLargestHalf = 65504.0f;  // IEEE 754-2019, binary16
constexpr int kPhaseTexels = 896;
// Vertical optical depth of peaked constituents together, mean over the wavelengths.
constexpr double kThinHaze = 0.08;
// This many orders more for each square of the vertical depth of what turns light, as light that
// walks at random takes.
constexpr double kOrdersPerSquare = 1.0;
// Vertical optical depth beyond which air is thick, and how its light is solved for.
constexpr double kThickAir = 3.0;
constexpr int kMostSteps = 10;
constexpr double kEnoughChange = 1e-3;
// Samples of thick haze on the way to a cell of the source: between them light is exponential.
constexpr int kThickSamples = 10;
constexpr int kPhaseLevels = 12;  // of blur by forward peaks

bool scatters(const Constituent& c) {
  return !c.scattering.isConstant() || c.scattering.at(550.0 * nanometre) > 0.0;
}

bool isSmooth(const Constituent& c) {
  return !scatters(c) || c.phase.kind() == PhaseFunction::Kind::kIsotropic ||
         c.phase.kind() == PhaseFunction::Kind::kRayleigh;
}

// Constituents that only absorb first, then smooth ones, in the order of the file otherwise.
std::vector<std::size_t> tableOrder(const Medium& medium) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < medium.constituents.size(); ++i) order.push_back(i);
  auto const rank = [&](std::size_t i) {
    auto const& c = medium.constituents[i];
    return !scatters(c) ? 0 : isSmooth(c) ? 1 : 2;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

// Spectral albedo from a linear sRGB colour: the bands of a piecewise linear basis, corrected by
// the least change that makes white light reflected by a colour come out as that colour times
// white. Columns: red, green, blue; a row per wavelength; rows sum to 1.
std::vector<glm::dvec3> albedoBasis(const std::vector<Length>& wavelengths,
                                    const std::vector<glm::dvec3>& weights) {
  std::vector<glm::dvec3> basis;
  for (Length w : wavelengths) {
    double const nm = w / nanometre;
    // Bands meet at 495 and 590 nm.
    double const toGreen = std::clamp((nm - 475.0) / 40.0, 0.0, 1.0);
    double const toRed = std::clamp((nm - 570.0) / 40.0, 0.0, 1.0);
    basis.emplace_back(toRed, toGreen * (1.0 - toRed), 1.0 - toGreen);
  }
  glm::dmat3 gram(0.0), reached(0.0);
  glm::dvec3 white(0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    gram += glm::outerProduct(weights[i], weights[i]);
    reached += glm::outerProduct(weights[i], basis[i]);
    white += weights[i];
  }
  glm::dmat3 wanted(0.0);
  for (int i = 0; i < 3; ++i) wanted[i][i] = white[i];
  if (std::fabs(glm::determinant(gram)) > 1e-12 * std::pow(gram[0][0] + gram[1][1], 3.0)) {
    glm::dmat3 const change = glm::inverse(gram) * (wanted - reached);
    for (std::size_t i = 0; i < weights.size(); ++i) basis[i] += weights[i] * change;
  }
  return basis;
}

// The root of height over the top's at which the source's level, of evenly many roots, is `level`.
double rootAtLevel(const std::vector<double>& levels, double level) {
  auto const after = std::lower_bound(levels.begin() + 1, levels.end() - 1, level);
  auto const k = static_cast<std::size_t>(after - levels.begin()) - 1;
  double const within = std::clamp((level - levels[k]) / (levels[k + 1] - levels[k]), 0.0, 1.0);
  return (static_cast<double>(k) + within) / static_cast<double>(levels.size() - 1);
}

std::vector<Length> padded(std::vector<Length> wavelengths) {
  while (wavelengths.size() % 4) wavelengths.push_back(wavelengths.back());
  return wavelengths;
}

std::vector<glm::dvec3> weightsOf(const std::vector<Length>& wavelengths) {
  // Repeated wavelengths (padding) and single ones have no colour to speak of.
  for (std::size_t i = 1; i < wavelengths.size(); ++i)
    if (!(wavelengths[i] > wavelengths[i - 1]))
      return std::vector<glm::dvec3>(wavelengths.size(), glm::dvec3(1.0));
  return linearSrgbWeights(wavelengths);
}

}  // namespace

std::vector<glm::vec4> airBlockOf(const Medium* medium, const std::vector<Length>& wavelengths,
                                  Length groundRadius, double lowestSunCosine, Angle sunRadius,
                                  const std::vector<std::size_t>& order, const AirPhases& phases) {
  std::size_t const layers = wavelengths.size() / 4;
  std::vector<glm::vec4> block;
  double const top = medium ? medium->topHeight.si : 1.0;
  block.emplace_back(groundRadius.si, top, lowestSunCosine, sunRadius.si);
  double const widest = std::sqrt(top * (2.0 * groundRadius.si + top));
  block.emplace_back(widest, 1.0 / widest, 1.0 / top, 1.0);
  block.emplace_back(1.0, 0.0, 1.0, 0.0);
  auto const add = [&](auto&& value) {
    for (std::size_t layer = 0; layer < layers; ++layer) {
      glm::vec4 four;
      for (int i = 0; i < 4; ++i)
        four[i] = static_cast<float>(value(layer * 4 + static_cast<std::size_t>(i)));
      block.push_back(four);
    }
  };
  add([&](std::size_t i) { return medium ? medium->groundAlbedo.at(wavelengths[i]) : 0.0; });
  auto const addConstituents = [&](auto&& value) {
    for (std::size_t layer = 0; layer < layers; ++layer)
      for (std::size_t c = 0; c < std::max<std::size_t>(order.size(), 1); ++c) {
        glm::vec4 four(0.0f);
        for (int i = 0; i < 4 && !order.empty(); ++i)
          four[i] = static_cast<float>(value(medium->constituents[order[c]],
                                             wavelengths[layer * 4 + static_cast<std::size_t>(i)]));
        block.push_back(four);
      }
  };
  addConstituents([](const Constituent& c, Length w) { return c.scattering.at(w); });
  addConstituents(
      [](const Constituent& c, Length w) { return c.scattering.at(w) + c.absorption.at(w); });
  for (int l = 0; l <= phases.degree; ++l)
    for (std::size_t layer = 0; layer < layers; ++layer)
      for (std::size_t c = 0; c < std::max<std::size_t>(order.size(), 1); ++c) {
        glm::vec4 four(0.0f);
        for (std::size_t i = 0; i < 4 && !order.empty(); ++i)
          four[static_cast<int>(i)] = static_cast<float>(
              phases.of[c][layer * 4 + i].restMoments()[static_cast<std::size_t>(l)]);
        block.push_back(four);
      }
  auto const weights = weightsOf(wavelengths);
  for (int channel = 0; channel < 3; ++channel)
    add([&](std::size_t i) { return weights[i][channel]; });
  auto const basis = albedoBasis(wavelengths, weights);
  for (int channel = 0; channel < 3; ++channel)
    add([&](std::size_t i) { return basis[i][channel]; });
  return block;
}

QuadratureBlock::QuadratureBlock(int many, int few) {
  std::vector<glm::vec4> content(129, glm::vec4(0.0f));
  auto next = content.begin() + 1;
  for (int count : {many, few})
    if (count) {
      auto const nodes = gaussLegendre(count);
      next = std::copy(nodes.begin(), nodes.end(), next);
    }
  content[0].x = std::bit_cast<float>(many);
  content[0].y = std::bit_cast<float>(few);
  buffer_.write(std::span<const glm::vec4>(content));
}

AirTables::AirTables(const Medium& medium, Length groundRadius,
                     const std::vector<Length>& wavelengths, const AirQuality& quality,
                     Angle sunRadius)
    : quality_(quality),
      groundRadius_(groundRadius),
      top_(medium.topHeight),
      wavelengths_(padded(wavelengths)) {
  glFinish();
  auto const start = std::chrono::steady_clock::now();
  layers_ = static_cast<int>(wavelengths_.size() / 4);
  auto const order = tableOrder(medium);
  constituents_ = static_cast<int>(order.size());
  peaked_ = static_cast<int>(std::count_if(medium.constituents.begin(), medium.constituents.end(),
                                           [](const Constituent& c) { return !isSmooth(c); }));
  auto const dark = std::count_if(medium.constituents.begin(), medium.constituents.end(),
                                  [](const Constituent& c) { return !scatters(c); });
  // Thin haze hardly shows its higher harmonics.
  double haze = 0.0;
  for (std::size_t c = 0; c < medium.constituents.size(); ++c)
    if (!isSmooth(medium.constituents[c])) {
      double depth = 0.0;
      for (Length w : wavelengths_) depth += medium.opticalDepth(c, w);
      haze += depth / static_cast<double>(wavelengths_.size());
    }
  // Sunlight scattered once alone has no use for it.
  hazy_ = haze > kThinHaze && quality_.orders > 0;
  degree_ = hazy_ ? quality_.hazeDegree : quality_.degree;
  if (hazy_) {
    // Its many harmonics ask for half as many cells and directions again and one order more, in an
    // eclipse too; finer ones than these cost more than they give.
    quality_.sourceWidth = std::min(quality_.sourceWidth * 3 / 2, 96);
    quality_.sourceHeight = std::min(quality_.sourceHeight * 3 / 2, 32);
    quality_.zenithDirections = std::min(quality_.zenithDirections * 3 / 4 * 2, 16);
    quality_.azimuthDirections = std::min(quality_.azimuthDirections * 3 / 2, 12);
    quality_.sourceSamples = std::min(quality_.sourceSamples, 12);
    ++quality_.orders;
    ++quality_.eclipseOrders;
  }
  definitions_ = {{"AIR", ""},
                  {"AIR_LAYERS", std::to_string(layers_)},
                  {"AIR_CONSTITUENTS", std::to_string(constituents_)},
                  {"AIR_SMOOTH", std::to_string(constituents_ - peaked_)},
                  {"AIR_DARK", std::to_string(dark)},
                  {"AIR_DEGREE", std::to_string(degree_)},
                  {"AIR_PHASE_LEVELS", std::to_string(kPhaseLevels)}};
  if (hazy_) definitions_.emplace_back("AIR_HAZY", "");

  bent_ = BentSunlight::bends(medium, groundRadius);
  if (bent_) definitions_.emplace_back("AIR_BENT", "");
  // Twice the angle by which the top sees the Sun below the ground's horizon, and 5 degrees.
  double const dip = std::acos(groundRadius / (groundRadius + top_));
  lowestSunCosine_ = -std::sin(std::min(2.0 * dip + 5.0 * degree.si, 0.5 * std::numbers::pi));
  AirPhases phases{degree_, {}};
  for (std::size_t c : order) {
    phases.of.emplace_back();
    for (Length w : wavelengths_)
      phases.of.back().emplace_back(medium.constituents[c].phase, w, degree_, hazy_);
  }
  // Of what turns light; the thickest wavelength.
  double turning = 0.0;
  for (std::size_t w = 0; w < wavelengths_.size(); ++w) {
    double depth = 0.0;
    for (std::size_t c = 0; c < order.size(); ++c) {
      Constituent const& own = medium.constituents[order[c]];
      depth += (1.0 - phases.of[c][w].share()) * own.scattering.at(wavelengths_[w]) *
               (own.density.column(Length(0.0), medium.topHeight) / metre);
    }
    turning = std::max(turning, depth);
  }
  double thickest = 0.0;
  for (Length w : wavelengths_) {
    double depth = 0.0;
    for (std::size_t c = 0; c < medium.constituents.size(); ++c) depth += medium.opticalDepth(c, w);
    thickest = std::max(thickest, depth);
  }
  thick_ = thickest > kThickAir;
  if (thick_) {
    definitions_.emplace_back("AIR_THICK", "");
    quality_.depthHeight *= 2;
    // Many heights, fewer directions and Suns: what diffuses has little form.
    quality_.sourceHeight *= 2;
    quality_.sourceWidth = std::min(quality_.sourceWidth, 64);
    quality_.zenithDirections = std::min(quality_.zenithDirections, 12);
    quality_.azimuthDirections = std::min(quality_.azimuthDirections, 8);
    if (hazy_) quality_.sourceSamples = std::min(quality_.sourceSamples, kThickSamples);
  }
  // 0 orders mean single scattering, whatever the air.
  int const more = thick_ ? 0 : static_cast<int>(kOrdersPerSquare * turning * turning);
  orders_ = quality_.orders == 0 ? 0 : quality_.orders + more;
  auto block =
      airBlockOf(&medium, wavelengths_, groundRadius, lowestSunCosine_, sunRadius, order, phases);
  BentSunTexels const sun = bent_ ? bentSun(medium, sunRadius) : BentSunTexels{};
  block[2] = glm::vec4(1.0 / sun.reach, sun.lowestCosine, 1.0 / (1.0 - sun.lowestCosine), 0.0);
  block_.write(std::span<const glm::vec4>(block));
  auto const levels = sourceLevels(medium, order, phases);
  buildDensities(medium, order, levels, sun.ground);
  buildPhases(medium, order, phases);
  buildDepths(sun, peaksOnTheWay(medium, order, phases));
  buildSource(medium, order, phases, levels);
  measureSource();
  if (quality_.storage == AirStorage::Half) {
    block[1].w = halve();
    block_.write(std::span<const glm::vec4>(block));
  }
  glFinish();
  precomputeSeconds_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Levels of the source over the root of height, as table: half of them even in that root, half in
// the logarithm of the optical depth above, so that hazes and clouds have theirs; in thick air more
// by depth, and more of these where sunlight comes in.
std::vector<double> AirTables::sourceLevels(const Medium& medium,
                                            const std::vector<std::size_t>& order,
                                            const AirPhases& phases) const {
  auto const depthAbove = [&](double height) {
    double sum = 0.0;
    for (std::size_t c = 0; c < order.size(); ++c) {
      Constituent const& own = medium.constituents[order[c]];
      double turning = 0.0;
      for (std::size_t w = 0; w < wavelengths_.size(); ++w)
        turning += own.absorption.at(wavelengths_[w]) +
                   own.scattering.at(wavelengths_[w]) * (1.0 - phases.of[c][w].share());
      sum += turning / static_cast<double>(wavelengths_.size()) *
             (own.density.column(Length(height), medium.topHeight) / metre);
    }
    return sum;
  };
  auto const scaled = [&](double height) {
    double const depth = depthAbove(height);
    return (thick_ ? 2.0 : 1.0) * std::log1p(8.0 * depth) + 0.4 * depth;
  };
  double const share = thick_ ? 0.75 : 0.5;
  double const all = scaled(0.0);
  std::vector<double> levels;
  for (int i = 0; i < kDensityTexels; ++i) {
    double const x = static_cast<double>(i) / (kDensityTexels - 1);
    double const dense = all > 0.0 ? 1.0 - scaled(x * x * medium.topHeight.si) / all : x;
    levels.push_back(std::lerp(x, dense, share));
  }
  return levels;
}

Angle AirTables::discOf(Angle sunRadius) {
  constexpr double standard = 0.00465, step = 0.02;  // rad: at 1 au
  if (!(sunRadius > Angle(0.0))) return sunRadius;
  return Angle(standard * std::exp(step * std::round(std::log(sunRadius.si / standard) / step)));
}

BentSunTexels AirTables::bentSun(const Medium& medium, Angle sunRadius) const {
  std::vector<BentColour> colours;
  for (Length w : wavelengths_) {
    BentColour colour{medium.refractivity.at(w), {}};
    for (Constituent const& own : medium.constituents)
      colour.extinction.push_back(own.absorption.at(w) + own.scattering.at(w));
    colours.push_back(std::move(colour));
  }
  return bentSunTexels(medium, groundRadius_, discOf(sunRadius), colours, quality_.depthWidth,
                       quality_.depthHeight, kDensityTexels);
}

void AirTables::buildDensities(const Medium& medium, const std::vector<std::size_t>& order,
                               const std::vector<double>& levels,
                               const std::vector<float>& sunOnGround) {
  int const rows = (constituents_ + 3) / 4 + 1;
  std::vector<float> texels(static_cast<std::size_t>(kDensityTexels * rows * 4), 0.0f);
  for (std::size_t c = 0; c < order.size(); ++c)
    for (int i = 0; i < kDensityTexels; ++i) {
      double const x = static_cast<double>(i) / (kDensityTexels - 1);
      // The last texel holds the density just below the top.
      double const height = std::min(x * x, 1.0 - 1e-9) * medium.topHeight.si;
      std::size_t const at = (c / 4) * kDensityTexels * 4 + static_cast<std::size_t>(i) * 4 + c % 4;
      texels[at] = static_cast<float>(medium.constituents[order[c]].density.atMetres(height));
    }
  std::size_t const last = static_cast<std::size_t>((rows - 1) * kDensityTexels * 4);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    texels[last + 4 * i] = static_cast<float>(levels[i]);
    texels[last + 4 * i + 1] =
        static_cast<float>(rootAtLevel(levels, static_cast<double>(i) / (kDensityTexels - 1)));
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    std::size_t const low = i > 0 ? i - 1 : 0, high = std::min(i + 1, levels.size() - 1);
    texels[last + 4 * i + 2] = (texels[last + 4 * high + 1] - texels[last + 4 * low + 1]) *
                               static_cast<float>(kDensityTexels - 1) /
                               static_cast<float>(high - low);
  }
  texels.insert(texels.end(), sunOnGround.begin(), sunOnGround.end());
  densities_ = gl::Texture::plane(GL_RGBA32F, kDensityTexels, rows + (bent_ ? layers_ : 0));
  densities_.upload(texels, 4);
}

// By wavelength.
std::vector<PeaksOnTheWay> AirTables::peaksOnTheWay(const Medium& medium,
                                                    const std::vector<std::size_t>& order,
                                                    const AirPhases& phases) const {
  std::vector<PeaksOnTheWay> ways;
  for (std::size_t w = 0; w < wavelengths_.size(); ++w) {
    PeaksOnTheWay way;
    auto const add = [](std::vector<double>& to, const std::vector<double>& moments,
                        double factor) {
      if (to.size() < moments.size()) to.resize(moments.size(), 0.0);
      for (std::size_t l = 0; l < moments.size(); ++l) to[l] += factor * moments[l];
    };
    for (std::size_t c = 0; c < order.size(); ++c) {
      ForwardPeak const& phase = phases.of[c][w];
      if (phase.share() == 0.0) continue;
      Constituent const& own = medium.constituents[order[c]];
      double const scattered = own.scattering.at(wavelengths_[w]) *
                               (own.density.column(Length(0.0), medium.topHeight) / metre);
      way.depth += phase.share() * scattered;
      add(way.peak, phase.peakMoments(), phase.share() * scattered);
      add(way.rest, phase.allRestMoments(), scattered);
    }
    for (auto* moments : {&way.peak, &way.rest})
      for (double& m : *moments) m /= way.depth;
    ways.push_back(std::move(way));
  }
  return ways;
}

void AirTables::buildPhases(const Medium& medium, const std::vector<std::size_t>& order,
                            const AirPhases& phases) {
  int const rowsEach = hazy_ ? kPhaseLevels + 1 : 1, rows = layers_ * constituents_ * rowsEach;
  std::vector<double> cosines;
  for (int i = 0; i < kPhaseTexels; ++i)
    cosines.push_back(glsl::phaseCosine(static_cast<double>(i) / (kPhaseTexels - 1)));
  std::vector<float> texels(static_cast<std::size_t>(kPhaseTexels * rows * 4), 0.0f);
  auto const put = [&](int row, std::size_t k, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      texels[(static_cast<std::size_t>(row * kPhaseTexels) + i) * 4 + k] =
          static_cast<float>(values[i]);
  };
  // Rows go by the mean depth of forward peaks over the first layer.
  std::size_t const count = order.size();
  std::vector<PeaksOnTheWay> const ways = peaksOnTheWay(medium, order, phases);
  double const standard = 0.25 * (ways[0].depth + ways[1].depth + ways[2].depth + ways[3].depth);
  for (std::size_t w = 0; w < wavelengths_.size(); ++w) {
    PeaksOnTheWay const& way = ways[w];
    for (std::size_t c = 0; c < count; ++c) {
      ForwardPeak const& own = phases.of[c][w];
      int const first = (static_cast<int>(w / 4) * constituents_ + static_cast<int>(c)) * rowsEach;
      std::vector<double> rest, byMoments;
      for (double x : cosines) {
        rest.push_back(own.rest(x));
        byMoments.push_back(own.restByMoments(x));
      }
      if (!hazy_) {
        put(first, w % 4, rest);
        continue;
      }
      for (int level = 0; level < kPhaseLevels; ++level) {
        double const depth = glsl::blurDepth(level, kPhaseLevels - 1) *
                             (standard > 0.0 ? way.depth / standard : 1.0);
        put(first + level, w % 4, blurredPhase(own, way, depth, cosines));
      }
      put(first + kPhaseLevels, w % 4, byMoments);
    }
  }
  phases_ = gl::Texture::plane(GL_RGBA32F, kPhaseTexels, rows);
  phases_.upload(texels, 4);
}

void AirTables::bind() const {
  block_.bindUniform(1);
  densities_.bind(2);
  if (depths_) depths_.bind(3);
  if (source_) source_.bind(4);
  phases_.bind(5);
}

void AirTables::buildDepths(const BentSunTexels& sun, const std::vector<PeaksOnTheWay>& ways) {
  int const width = quality_.depthWidth, height = quality_.depthHeight;
  int const straight = hazy_ ? 2 * layers_ : layers_;
  depths_ = gl::Texture::layers(GL_RGBA32F, width, height,
                                hazy_   ? 4 * layers_
                                : bent_ ? 2 * layers_
                                        : layers_);
  if (bent_) {  // true ones, the last
    std::vector<float> texels(static_cast<std::size_t>(width * height * depths_.depth() * 4), 0.0f);
    std::copy(sun.depths.begin(), sun.depths.end(),
              texels.end() - static_cast<std::ptrdiff_t>(sun.depths.size()));
    depths_.upload(texels, 4);
  }
  auto const program = gl::Program::compute("precompute/air_depth.comp", definitions_);
  QuadratureBlock const nodes(hazy_ ? 64 : 48);
  bind();
  nodes.bind();
  program.use();
  depths_.bindImage(0, GL_WRITE_ONLY);
  glDispatchCompute(static_cast<GLuint>((width + 7) / 8), static_cast<GLuint>((height + 7) / 8),
                    static_cast<GLuint>(straight));
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  if (!hazy_) return;
  if (!bent_)
    glCopyImageSubData(depths_.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, layers_, depths_.id(),
                       GL_TEXTURE_2D_ARRAY, 0, 0, 0, 3 * layers_, width, height, layers_);
  turnSunlight(depths_, densities_, definitions_, ways, sun.reach);
}

std::vector<double> AirTables::sourceHeights(const std::vector<double>& levels) const {
  std::vector<double> heights;
  for (int row = 0; row < quality_.sourceHeight; ++row) {
    double root = static_cast<double>(row) / (quality_.sourceHeight - 1);
    if (hazy_) root = rootAtLevel(levels, root);
    heights.push_back(top_.si * std::min(root * root, 0.9999));
  }
  return heights;
}

void AirTables::buildSource(const Medium& medium, const std::vector<std::size_t>& order,
                            const AirPhases& phases, const std::vector<double>& levels) {
  int const width = quality_.sourceWidth, height = quality_.sourceHeight;
  int const directions = quality_.zenithDirections * quality_.azimuthDirections;
  // Harmonics and the irradiance.
  int const moments = (degree_ + 1) * (degree_ + 2) / 2 + 1;
  source_ = gl::Texture::layers(GL_RGBA32F, width, height, moments * layers_);
  auto previous = gl::Texture::layers(GL_RGBA32F, width, height, moments * layers_);
  auto const radiances = gl::Texture::layers(GL_RGBA32F, width, height, directions * layers_);
  if (quality_.orders == 0) {  // sunlight scattered once alone: no source
    glClearTexImage(source_.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
    return;
  }
  auto with = [&](const char* flag) {
    auto d = definitions_;
    d.emplace_back(flag, "");
    return d;
  };
  auto const first = gl::Program::compute("precompute/air_radiance.comp", with("AIR_SINGLE"));
  auto const next = gl::Program::compute("precompute/air_radiance.comp", with("AIR_SOURCE"));
  auto const project = gl::Program::compute("precompute/air_moments.comp", definitions_);
  QuadratureBlock const nodes(quality_.sourceSamples);
  gl::Buffer zenith;
  std::vector<glm::vec4> zenithNodes(64, glm::vec4(0.0f));
  auto const half = gaussLegendre(quality_.zenithDirections / 2);
  std::copy(half.begin(), half.end(), zenithNodes.begin());
  zenith.write(std::span<const glm::vec4>(zenithNodes));
  auto const groupsX = static_cast<GLuint>((width + 7) / 8);
  auto const groupsY = static_cast<GLuint>((height + 3) / 4);
  glm::ivec2 const counts(quality_.zenithDirections, quality_.azimuthDirections);
  // Harmonics into `previous`, and into the source: their sum over the orders up to `number`.
  auto const scatter = [&](const gl::Program& program, int number, int last) {
    bind();
    nodes.bind();
    zenith.bindUniform(4);
    if (&program == &next) previous.bind(4);
    program.set("directionCount", counts).use();
    radiances.bindImage(0, GL_WRITE_ONLY);
    glDispatchCompute(groupsX, groupsY, static_cast<GLuint>(directions));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    project.set("directionCount", counts).set("order", number).set("lastOrder", last).use();
    radiances.bindImage(0, GL_READ_ONLY);
    previous.bindImage(1, GL_READ_WRITE);
    source_.bindImage(2, GL_READ_WRITE);
    glDispatchCompute(groupsX, groupsY, static_cast<GLuint>(layers_));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glFinish();
  };
  if (!thick_) {
    for (int number = 1; number <= orders_; ++number)
      scatter(number == 1 ? first : next, number, orders_);
    return;
  }
  std::vector<double> sunCosines;
  for (int column = 0; column < width; ++column)
    sunCosines.push_back(
        glsl::sourceSunCosine(glsl::sunSpan(lowestSunCosine_), column / (width - 1.0)));
  scatter(first, 1, 0);
  auto const once = source_.readRgba();
  ThickAirSolver solver(thickAirGrid(medium, order, phases, wavelengths_, groundRadius_,
                                     sourceHeights(levels), sunCosines, moments),
                        once);
  int step = 1;
  do {
    previous.upload(solver.direction(), 4);
    scatter(next, 1, 0);
    solver.advance(source_.readRgba());
    ++step;
  } while (step < kMostSteps && solver.change() > kEnoughChange);
  orders_ = step;
  lastChange_ = solver.change();
  // What is left of the error may be negative where it is dark; light is not.
  auto light = solver.light();
  std::size_t const slice = static_cast<std::size_t>(width * height) * 4;
  for (int layer = 0; layer < layers_; ++layer)
    for (int i : {0, moments - 1})
      for (std::size_t k = 0; k < slice; ++k) {
        float& value = light[static_cast<std::size_t>(layer * moments + i) * slice + k];
        value = std::max(value, 0.0f);
      }
  source_.upload(light, 4);
}

namespace {

gl::Texture halved(const gl::Texture& from, float scale, bool layered) {
  auto to = layered ? gl::Texture::layers(GL_RGBA16F, from.width(), from.height(), from.depth())
                    : gl::Texture::plane(GL_RGBA16F, from.width(), from.height());
  auto texels = from.readRgba();
  for (float& value : texels) value = std::clamp(value * scale, -kLargestHalf, kLargestHalf);
  to.upload(texels, 4);
  return to;
}

}  // namespace

void AirTables::measureSource() {
  auto const texels = source_.readRgba();
  auto const width = static_cast<std::size_t>(source_.width());
  std::size_t const slice = width * static_cast<std::size_t>(source_.height()) * 4;
  int const perLayer = source_.depth() / layers_;
  brightest_.assign(width, 0.0);
  for (int layer = 0; layer < layers_; ++layer)
    for (std::size_t i = 0; i < slice; ++i) {
      double& most = brightest_[i / 4 % width];
      double const held = texels[static_cast<std::size_t>(layer * perLayer) * slice + i];
      most = std::max(most, thick_ ? held : std::pow(held, 8.0));
    }
}

double AirTables::brightnessUnder(double sunCosine) const {
  double const most = *std::max_element(brightest_.begin(), brightest_.end());
  if (!(most > 0.0)) return 1.0;
  double const x = glsl::sourceColumn(glsl::sunSpan(lowestSunCosine_), sunCosine);
  auto const last = static_cast<double>(brightest_.size() - 1);
  auto const at = static_cast<std::size_t>(std::clamp(std::ceil(x * last), 0.0, last));
  return brightest_[at] / most;
}

float AirTables::halve() {
  // Thick air tells near depths by differences of large ones.
  if (!thick_) depths_ = halved(depths_, 1.0f, true);
  phases_ = halved(phases_, 1.0f, false);
  float most = 1e-30f;
  for (float value : source_.readRgba()) most = std::max(most, std::fabs(value));
  // A power of two, so that the scale itself rounds nothing; half of the range is left to spare.
  // Roots and shares have no need of it.
  float const scale = thick_ ? std::exp2(std::floor(std::log2(0.5f * kLargestHalf / most))) : 1.0f;
  source_ = halved(source_, scale, true);
  return 1.0f / scale;
}

std::size_t AirTables::bytes() const {
  return densities_.bytes() + phases_.bytes() + depths_.bytes() + source_.bytes();
}

}  // namespace antumbra
