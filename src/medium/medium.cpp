#include "medium/medium.h"

#include <algorithm>

namespace antumbra {

std::vector<ConstituentCoefficients> Medium::coefficientsAt(Length height,
                                                            Length wavelength) const {
  std::vector<ConstituentCoefficients> result;
  for (Constituent const& c : constituents) {
    double const density = height > topHeight ? 0.0 : c.density.at(height);
    result.push_back({InverseLength(density * c.scattering.at(wavelength)),
                      InverseLength(density * c.absorption.at(wavelength))});
  }
  return result;
}

InverseLength Medium::extinctionAt(Length height, Length wavelength) const {
  InverseLength sum;
  for (auto const& c : coefficientsAt(height, wavelength)) sum += c.extinction();
  return sum;
}

double Medium::opticalDepth(size_t constituent, Length wavelength) const {
  Constituent const& c = constituents.at(constituent);
  return (c.scattering.at(wavelength) + c.absorption.at(wavelength)) *
         (c.density.column(Length(0.0), topHeight) / metre);
}

Length Medium::firstWavelength() const {
  Length first = std::max(groundAlbedo.first(), refractivity.first());
  for (Constituent const& c : constituents)
    first =
        std::max({first, c.scattering.first(), c.absorption.first(), c.phase.firstWavelength()});
  return first;
}

Length Medium::lastWavelength() const {
  Length last = std::min(groundAlbedo.last(), refractivity.last());
  for (Constituent const& c : constituents)
    last = std::min({last, c.scattering.last(), c.absorption.last(), c.phase.lastWavelength()});
  return last;
}

double Medium::clearShareAt(Length height) const {
  if (clearHeights.empty() || height >= clearHeights.back()) return 1.0;
  if (height <= clearHeights.front()) return clearShares.front();
  auto const after = std::upper_bound(clearHeights.begin(), clearHeights.end(), height);
  auto const i = static_cast<size_t>(after - clearHeights.begin());
  double const t = (height - clearHeights[i - 1]) / (clearHeights[i] - clearHeights[i - 1]);
  return clearShares[i - 1] + t * (clearShares[i] - clearShares[i - 1]);
}

std::vector<Length> Medium::kinks() const {
  std::vector<Length> heights;
  for (Constituent const& c : constituents)
    for (double h : c.density.nodeHeightsMetres())
      if (h > 0.0 && h < topHeight / metre) heights.push_back(h * metre);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

}  // namespace antumbra
