// Gauss-Legendre nodes and weights on [0, 1], by Newton's iteration on the Legendre polynomial from
// Tricomi's initial guess; exact to 1e-15.
#pragma once

#include <vector>

namespace antumbra {

struct QuadratureNode {
  double x, weight;
};

std::vector<QuadratureNode> gaussLegendreNodes(int count);

}  // namespace antumbra
