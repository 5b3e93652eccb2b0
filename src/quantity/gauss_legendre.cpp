#include "quantity/gauss_legendre.h"

#include <cmath>
#include <numbers>

namespace antumbra {

std::vector<QuadratureNode> gaussLegendreNodes(int count) {
  std::vector<QuadratureNode> nodes;
  for (int i = 0; i < count; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    double slope = 1.0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double p = 1.0, before = 0.0;
      for (int n = 1; n <= count; ++n) {
        double const next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
        before = p;
        p = next;
      }
      slope = count * (x * p - before) / (x * x - 1.0);
      double const step = p / slope;
      x -= step;
      if (std::fabs(step) < 1e-15) break;
    }
    nodes.push_back({0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return nodes;
}

}  // namespace antumbra
