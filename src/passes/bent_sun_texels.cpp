#include "passes/bent_sun_texels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "passes/gauss_legendre.h"
#include "shared/as_cpp.h"

namespace antumbra {
namespace {

// Where the whole disc stands this far above the horizon, its centre speaks for it: 0.1 %.
constexpr double kHighSun = 0.05;  // rad
constexpr int kDiscNodes = 6;

// One colour of a disc.
class DiscLight {
 public:
  DiscLight(const BentSunlight& rays, std::size_t colour, double radius)
      : rays_(rays), colour_(colour), radius_(radius) {
    for (auto const& node : gaussLegendre(kDiscNodes)) nodes_.push_back(node);
  }

  // Zenith angle at which the ground hides the Sun, rad.
  double horizonAt(double height) const {
    return std::acos(std::clamp(rays_.horizonCosine(colour_, height), -1.0, 1.0));
  }
  struct Light {
    double across;      // its own way
    double horizontal;  // the ground
  };
  // `withCosine`: the second as well.
  Light at(double height, double horizon, double cosine, bool withCosine) const {
    double const zenith = std::acos(std::clamp(cosine, -1.0, 1.0));
    auto const point = [&](double z) {
      double const light = std::exp(-rays_.depth(colour_, height, std::cos(z)));
      double const apparent =
          withCosine && light > 0.0 ? z - rays_.lift(colour_, height, std::cos(z)) : 0.0;
      return Light{light, withCosine ? light * std::max(std::cos(apparent), 0.0) : 0.0};
    };
    if (!(radius_ > 0.0) || zenith + radius_ + kHighSun < horizon) return point(zenith);
    if (zenith - radius_ >= horizon) return {0.0, 0.0};
    // Slices at radius * cos(phi) below the centre weigh sin^2(phi); those from phi = least on
    // stand above the horizon.
    double const least = std::acos(std::clamp((horizon - zenith) / radius_, -1.0, 1.0));
    Light sum{0.0, 0.0};
    double const span = std::numbers::pi - least;
    for (auto const& node : nodes_) {
      double const phi = least + span * static_cast<double>(node.x), sine = std::sin(phi);
      double const weight =
          2.0 / std::numbers::pi * sine * sine * span * static_cast<double>(node.y);
      Light const light = point(std::fabs(zenith + radius_ * std::cos(phi)));
      sum.across += weight * light.across;
      sum.horizontal += weight * light.horizontal;
    }
    return sum;
  }

 private:
  const BentSunlight& rays_;
  std::size_t colour_;
  double radius_;
  std::vector<glm::vec4> nodes_;
};

glsl::AirShell shellOf(double radius, double top) {
  glsl::AirShell shell{};
  shell.radius = radius;
  shell.top = top;
  shell.widest = std::sqrt(top * (2.0 * radius + top));
  shell.overWidest = 1.0 / shell.widest;
  shell.overTop = 1.0 / top;
  return shell;
}

}  // namespace

BentSunTexels bentSunTexels(const Medium& medium, Length groundRadius, Angle sunRadius,
                            const std::vector<BentColour>& colours, int width, int height,
                            int groundTexels) {
  BentSunlight const rays(medium, groundRadius, Length(0.0), colours);
  std::vector<DiscLight> discs;
  for (std::size_t c = 0; c < colours.size(); ++c) discs.emplace_back(rays, c, sunRadius.si);
  auto const shell = shellOf(groundRadius.si, medium.topHeight.si);
  BentSunTexels texels;
  // The least factor that holds the Sun's upper limb on the horizon at every height, and a texel.
  std::vector<double> heights;
  for (int y = 0; y < height; ++y) {
    glsl::TableCoordinates const place(0.0, static_cast<double>(y) / (height - 1));
    double const h = glsl::heightAndCosineAt(shell, place).height;
    heights.push_back(h);
    auto const row = glsl::depthRow(shell, std::min(h, shell.top));
    for (auto const& disc : discs) {
      double const z = disc.horizonAt(h) + sunRadius.si;
      double const rise = (shell.radius + h) * std::cos(z);
      double const root = std::sqrt(std::max(rise * rise + row.gain, 0.0));
      double const distance = glsl::distanceBetweenRises(rise, root, row.gain);
      texels.reach = std::max(texels.reach, (distance - row.least) * row.scale);
    }
  }
  texels.reach *= 1.0 + 1.5 / (width - 1);

  std::size_t const groups = colours.size() / 4;
  auto const columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  texels.depths.assign(columns * rows * groups * 4, 0.0f);
  for (std::size_t c = 0; c < colours.size(); ++c) {
    DiscLight const& disc = discs[c];
    for (std::size_t y = 0; y < rows; ++y) {
      double const h = heights[y], r = shell.radius + h;
      double const horizon = disc.horizonAt(h);
      auto const row = glsl::depthRow(shell, std::min(h, shell.top));
      for (std::size_t x = 0; x < columns; ++x) {
        double const across = static_cast<double>(x) / static_cast<double>(width - 1);
        double const distance = row.least + across * texels.reach / row.scale;
        double const cosine =
            distance > 0.0
                ? std::clamp((row.gain - distance * distance) / (2.0 * r * distance), -1.0, 1.0)
                : 1.0;
        double const light = disc.at(h, horizon, cosine, false).across;
        texels.depths[(((c / 4) * rows + y) * columns + x) * 4 + c % 4] =
            static_cast<float>(light > std::exp(-kDarkDepth) ? -std::log(light) : kDarkDepth);
      }
    }
  }

  double horizon = 0.5 * std::numbers::pi;
  for (auto const& disc : discs) horizon = std::max(horizon, disc.horizonAt(0.0));
  texels.lowestCosine = std::cos(horizon + sunRadius.si);
  auto const along = static_cast<std::size_t>(groundTexels);
  texels.ground.assign(along * groups * 4, 0.0f);
  for (std::size_t c = 0; c < colours.size(); ++c) {
    DiscLight const& disc = discs[c];
    double const own = disc.horizonAt(0.0);
    for (std::size_t x = 0; x < along; ++x) {
      double const u = static_cast<double>(x) / static_cast<double>(groundTexels - 1);
      double const cosine = texels.lowestCosine + (1.0 - texels.lowestCosine) * u * u;
      texels.ground[((c / 4) * along + x) * 4 + c % 4] =
          static_cast<float>(disc.at(0.0, own, cosine, true).horizontal);
    }
  }
  return texels;
}

}  // namespace antumbra
