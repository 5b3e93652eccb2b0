// Gauss-Legendre nodes and weights on [0, 1], by Newton's iteration on the Legendre polynomial from
// Tricomi's initial guess; exact to 1e-15.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace antumbra {

// x: node, y: weight; z and w unused, as std140 wants them.
std::vector<glm::vec4> gaussLegendre(int count);

}  // namespace antumbra
