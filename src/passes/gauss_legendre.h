// Gauss-Legendre nodes on [0, 1] (quantity/gauss_legendre.h) as uniform blocks take them.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace antumbra {

// x: node, y: weight; z and w unused, as std140 wants them.
std::vector<glm::vec4> gaussLegendre(int count);

}  // namespace antumbra
