#include "atmosphere/hemisphere_nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quantity/gauss_legendre.h"

namespace antumbra {
namespace {

constexpr int kAway = 40, kTurns = 20;  // from the pole; in a quarter of the turn about it

}  // namespace

std::vector<HemisphereNode> hemisphereNodes(Angle sunZenith) {
  constexpr double quarterTurn = 0.5 * std::numbers::pi;
  Angle const zenith = std::min(sunZenith, 90.0 * degree);
  glm::dvec3 const pole(sin(zenith), 0.0, cos(zenith));
  glm::dvec3 const up(-cos(zenith), 0.0, sin(zenith)), side(0.0, 1.0, 0.0);
  auto const away = gaussLegendreNodes(kAway), turns = gaussLegendreNodes(kTurns);
  std::vector<HemisphereNode> nodes;
  for (double left : {-1.0, 1.0})
    for (double rise : {-1.0, 1.0})
      for (auto const& turn : turns) {
        double const steep = rise * quarterTurn * turn.x * turn.x;
        glm::dvec3 const across = left * std::cos(steep) * side + std::sin(steep) * up;
        double const horizon = std::atan2(pole.z, -across.z);
        for (auto const& node : away) {
          double const x = node.x, theta = horizon * x * x * x;
          glm::dvec3 const u = std::cos(theta) * pole + std::sin(theta) * across;
          double const stretch = 3.0 * horizon * x * x;
          nodes.push_back({{u},
                           2.0 * quarterTurn * turn.x * turn.weight * stretch * node.weight *
                               std::sin(theta) * std::max(u.z, 0.0)});
        }
      }
  return nodes;
}

}  // namespace antumbra
