#include "passes/gauss_legendre.h"

#include "quantity/gauss_legendre.h"

namespace antumbra {

std::vector<glm::vec4> gaussLegendre(int count) {
  std::vector<glm::vec4> nodes;
  for (auto const& node : gaussLegendreNodes(count))
    nodes.emplace_back(node.x, node.weight, 0.0, 0.0);
  return nodes;
}

}  // namespace antumbra
