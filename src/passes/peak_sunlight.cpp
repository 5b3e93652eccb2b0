#include "passes/peak_sunlight.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "gl/buffer.h"
#include "passes/air_tables.h"
#include "passes/gauss_legendre.h"

namespace antumbra {
namespace {

// What halving each of these changes is under 1 % of the light
// (tests/passes/peak_sunlight_gl_test.cpp).
constexpr int kWidth = 32, kHeight = 48;           // cells over the Sun's zenith angle and height
constexpr std::size_t kRings = 4;                  // of turns by a peak,
constexpr int kSamples = 8;                        // on a leg
constexpr int kLeastOrders = 6, kMostOrders = 40;  // peaks one after another
constexpr double kDeep = 3.0;  // depth of the rest behind which fewer peaks than pass are followed
constexpr int kAngles = 1000;  // of the cumulative turn

// Moments to the power of n as light per radian of turn at evenly spaced angles.
std::vector<double> turnsOf(const std::vector<double>& moments, int n) {
  std::vector<double> powers;
  for (std::size_t l = 0; l < moments.size(); ++l)
    powers.push_back((2.0 * static_cast<double>(l) + 1.0) * std::pow(moments[l], n));
  std::vector<double> light;
  for (int i = 0; i < kAngles; ++i) {
    double const angle = (i + 0.5) / kAngles * std::numbers::pi;
    light.push_back(std::max(legendreSum(powers, std::cos(angle)), 0.0) * std::sin(angle));
  }
  return light;
}

// Rings of directions about the Sun for light turned n times: cosine of the turn (x), and by group
// of four wavelengths their shares.
std::vector<glm::vec4> rings(const std::vector<PeaksOnTheWay>& ways, int n) {
  std::vector<std::vector<double>> turns;
  std::vector<double> mean(kAngles, 0.0);
  for (auto const& way : ways) {
    turns.push_back(turnsOf(way.peak, n));
    double sum = 0.0;
    for (double t : turns.back()) sum += t;
    for (std::size_t i = 0; i < kAngles; ++i) {
      turns.back()[i] /= std::max(sum, 1e-30);
      mean[i] += turns.back()[i] / static_cast<double>(ways.size());
    }
  }
  std::vector<double> upTo{0.0};
  for (double m : mean) upTo.push_back(upTo.back() + m);
  std::size_t const groups = ways.size() / 4;
  std::vector<glm::vec4> block(kRings * (groups + 1), glm::vec4(0.0f));
  std::vector<double> sums(ways.size(), 0.0);
  auto const nodes = gaussLegendre(static_cast<int>(kRings));
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    double const share = static_cast<double>(nodes[ring].x) * upTo.back();
    auto const after = std::upper_bound(upTo.begin() + 1, upTo.end() - 1, share);
    auto const i = static_cast<std::size_t>(after - upTo.begin()) - 1;
    double const within = (share - upTo[i]) / std::max(mean[i], 1e-30);
    double const angle = (static_cast<double>(i) + within) / kAngles * std::numbers::pi;
    block[ring * (groups + 1)].x = static_cast<float>(std::cos(angle));
    for (std::size_t w = 0; w < ways.size(); ++w) {
      double const weight =
          static_cast<double>(nodes[ring].y) * turns[w][i] / std::max(mean[i], 1e-30);
      block[ring * (groups + 1) + 1 + w / 4][static_cast<int>(w % 4)] = static_cast<float>(weight);
      sums[w] += weight;
    }
  }
  for (std::size_t ring = 0; ring < kRings; ++ring)
    for (std::size_t w = 0; w < ways.size(); ++w)
      block[ring * (groups + 1) + 1 + w / 4][static_cast<int>(w % 4)] /=
          static_cast<float>(std::max(sums[w], 1e-30));
  return block;
}

// As many as nearly all light meets on its way to that depth.
int ordersOf(const std::vector<PeaksOnTheWay>& ways) {
  double most = 0.0;
  for (auto const& way : ways)
    if (way.depth > 0.0) most = std::max(most, kDeep / std::max(way.rest.front(), 1e-3));
  return std::clamp(static_cast<int>(std::ceil(most + 3.0 * std::sqrt(most))) + 2, kLeastOrders,
                    kMostOrders);
}

}  // namespace

void turnSunlight(const gl::Texture& depths, const gl::Texture& densities,
                  const gl::Definitions& air, const std::vector<PeaksOnTheWay>& ways,
                  double reach) {
  auto const layers = static_cast<int>(ways.size() / 4);
  auto definitions = air;
  definitions.emplace_back("PEAK_RINGS", std::to_string(kRings));
  auto const turn = gl::Program::compute("precompute/air_peaks.comp", definitions);
  auto const join = gl::Program::compute("precompute/air_peaks_join.comp", definitions);
  auto const table = [&](int height) {
    return gl::Texture::layers(GL_RGBA32F, kWidth, height, layers);
  };
  gl::Texture before = table(kHeight), now = table(kHeight), sum = table(kHeight);
  gl::Texture const onGround = table(1);
  glClearTexImage(onGround.id(), 0, GL_RGBA, GL_FLOAT, nullptr);
  QuadratureBlock const nodes(kSamples);
  nodes.bind();
  int const orders = ordersOf(ways);
  for (int order = 1; order <= orders; ++order) {
    gl::Buffer block;
    auto const content = rings(ways, order);
    block.write(std::span<const glm::vec4>(content));
    block.bindStorage(0);
    before.bind(4);
    turn.set("order", order).set("reach", static_cast<float>(reach)).use();
    now.bindImage(0, GL_WRITE_ONLY);
    sum.bindImage(1, GL_READ_WRITE);
    onGround.bindImage(2, GL_READ_WRITE);
    glDispatchCompute(kWidth / 8, kHeight / 4, static_cast<GLuint>(layers));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::swap(before, now);
  }
  sum.bind(4);
  join.use();
  depths.bindImage(0, GL_READ_WRITE);
  glDispatchCompute(static_cast<GLuint>((depths.width() + 7) / 8),
                    static_cast<GLuint>((depths.height() + 7) / 8), static_cast<GLuint>(layers));
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  if (std::none_of(air.begin(), air.end(), [](auto const& d) { return d.first == "AIR_BENT"; }))
    return;
  auto const ground = gl::Program::compute("precompute/air_peaks_ground.comp", definitions);
  onGround.bind(4);
  ground.use();
  densities.bindImage(0, GL_READ_WRITE);
  glDispatchCompute(static_cast<GLuint>((densities.width() + 63) / 64), 1,
                    static_cast<GLuint>(layers));
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace antumbra
