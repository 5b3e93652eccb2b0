#include "atmosphere/limb_rays.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace antumbra {
namespace {

// Twelve-point Gauss-Legendre rule on [-1, 1], positive half (Abramowitz & Stegun, table 25.4).
constexpr std::array<double, 6> kGaussNodes{0.125233408511469, 0.367831498998180,
                                            0.587317954286617, 0.769902674194305,
                                            0.904117256370475, 0.981560634246719};
constexpr std::array<double, 6> kGaussWeights{0.249147045813403, 0.233492536538355,
                                              0.203167426723066, 0.160078328543346,
                                              0.106939325995318, 0.047175336386512};

// Calls `use(x, weight)` for the nodes of [from, to].
template <class Use>
void eachGaussNode(double from, double to, const Use& use) {
  double const middle = 0.5 * (from + to), half = 0.5 * (to - from);
  for (std::size_t i = 6; i-- > 0;) use(middle - half * kGaussNodes[i], half * kGaussWeights[i]);
  for (std::size_t i = 0; i < 6; ++i) use(middle + half * kGaussNodes[i], half * kGaussWeights[i]);
}

// The refracting constituent's density and its slope.
class Refractor {
 public:
  Refractor(const Medium& medium, Length ground, double refractivity)
      : ground_(ground.si), refractivity_(refractivity) {
    for (Constituent const& c : medium.constituents)
      if (c.name == medium.refractingConstituent) density_ = &c.density;
    if (!density_) refractivity_ = 0.0;
  }
  double excess(double height) const {  // n - 1
    return density_ ? refractivity_ * density_->atMetres(height) : 0.0;
  }
  double slope(double height) const {  // dn/dr, 1/m
    return density_ ? refractivity_ * density_->slopeAtMetres(height) : 0.0;
  }
  // d(n r)/dr: positive where rays leave again.
  double growth(double height) const {
    return 1.0 + excess(height) + (ground_ + height) * slope(height);
  }

 private:
  double ground_, refractivity_;
  const DensityProfile* density_ = nullptr;
};

// Ground, kinks of the densities and of the clouds, top; no piece thicker than `most`.
std::vector<double> breakHeights(const Medium& medium, double floor, double most) {
  std::vector<double> heights{floor};
  std::vector<double> kinks;
  for (Length h : medium.kinks()) kinks.push_back(h.si);
  for (Length h : medium.clearHeights) kinks.push_back(h.si);
  kinks.push_back(medium.topHeight.si);
  std::sort(kinks.begin(), kinks.end());
  for (double h : kinks) {
    double const from = heights.back();
    if (h < from + 1e-3 || h > medium.topHeight.si) continue;
    int const parts = std::max(1, static_cast<int>(std::ceil((h - from) / most)));
    for (int i = 1; i <= parts; ++i) heights.push_back(from + (h - from) * i / parts);
  }
  return heights;
}

LimbRay trace(const Medium& medium, const Refractor& refractor, const std::vector<double>& breaks,
              double ground, double tangent) {
  double const r0 = ground + tangent, excess0 = refractor.excess(tangent);
  double const b = (1.0 + excess0) * r0;
  double bending = 0.0;
  std::vector<double> columns(medium.constituents.size(), 0.0);
  double from = 0.0;
  for (double top : breaks) {
    if (top <= tangent) continue;
    double const to = std::sqrt(top - tangent);
    eachGaussNode(from, to, [&](double w, double weight) {
      double const height = tangent + w * w, r = ground + height;
      double const excess = refractor.excess(height), n = 1.0 + excess;
      // n r - b without its cancellation.
      double const above = n * w * w + r0 * (excess - excess0);
      double const root = std::sqrt(std::max(above, 1e-12) * (n * r + b));
      double const step = 2.0 * w * weight / root;
      bending -= 2.0 * b * refractor.slope(height) / n * step;
      for (std::size_t c = 0; c < columns.size(); ++c)
        columns[c] += 2.0 * medium.constituents[c].density.atMetres(height) * n * r * step;
    });
    from = to;
  }
  LimbRay ray{Length(b), Angle(bending), {}};
  for (double column : columns) ray.columns.emplace_back(column);
  return ray;
}

// Pieces of the paths, in thicknesses of the air.
constexpr double kPathPiece = 0.04;

// Pieces of the quadrature over b: fine where air is dense and bends rays over the whole shadow.
std::vector<double> impactPieces(const Medium& medium, double floor) {
  double const top = medium.topHeight.si;
  std::vector<double> kept;
  for (double h : breakHeights(medium, floor, 0.005 * top)) {
    double const least = h < 0.12 * top ? 0.0 : h < 0.6 * top ? 0.02 * top : 0.04 * top;
    if (kept.empty() || h - kept.back() >= 0.99 * least) kept.push_back(h);
  }
  kept.back() = top;
  return kept;
}

}  // namespace

Length limbFloor(const Medium& medium, Length ground, double refractivity) {
  Refractor const refractor(medium, ground, refractivity);
  constexpr int kSteps = 4000;
  for (int i = kSteps - 1; i >= 0; --i) {
    double const height = medium.topHeight.si * (i + 0.5) / kSteps;
    if (refractor.growth(height) < 0.02) return Length(medium.topHeight.si * (i + 1.0) / kSteps);
  }
  return Length(0.0);
}

LimbRay limbRay(const Medium& medium, Length ground, Length tangentHeight, double refractivity) {
  Refractor const refractor(medium, ground, refractivity);
  return trace(medium, refractor, breakHeights(medium, 0.0, kPathPiece * medium.topHeight.si),
               ground.si, tangentHeight.si);
}

std::vector<std::vector<LimbNode>> limbNodes(const Medium& medium, Length ground,
                                             const std::vector<Length>& wavelengths) {
  bool const refracts = !medium.refractingConstituent.empty();
  std::vector<double> refractivities;
  for (Length w : wavelengths) refractivities.push_back(refracts ? medium.refractivity.at(w) : 0.0);
  auto const [least, most] = std::minmax_element(refractivities.begin(), refractivities.end());
  // A span of its own even where there is no dispersion.
  double const low = *least, high = std::max(*most, low * 1.001 + 1e-12);
  std::array<double, 3> const support{low, 0.5 * (low + high), high};
  double const floor = limbFloor(medium, ground, high).si;
  auto const path = breakHeights(medium, 0.0, kPathPiece * medium.topHeight.si);
  auto const kept = impactPieces(medium, floor);
  std::vector<std::vector<LimbNode>> nodes(wavelengths.size());
  for (std::size_t piece = 0; piece + 1 < kept.size(); ++piece)
    eachGaussNode(kept[piece], kept[piece + 1], [&](double height, double weight) {
      std::array<LimbRay, 3> rays;
      for (std::size_t k = 0; k < 3; ++k)
        rays[k] = trace(medium, Refractor(medium, ground, support[k]), path, ground.si, height);
      double const clear = medium.clearShareAt(Length(height));
      for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        double const t = (refractivities[i] - low) / (high - low);
        std::array<double, 3> const share{(1.0 - t) * (1.0 - 2.0 * t), 4.0 * t * (1.0 - t),
                                          t * (2.0 * t - 1.0)};
        LimbNode node;
        Refractor const refractor(medium, ground, refractivities[i]);
        node.impactMetres = (1.0 + refractor.excess(height)) * (ground.si + height);
        node.stepMetres = weight * refractor.growth(height);
        double depth = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          node.bendingRadians += share[k] * rays[k].bending.si;
          for (std::size_t c = 0; c < medium.constituents.size(); ++c) {
            Constituent const& air = medium.constituents[c];
            depth += share[k] * rays[k].columns[c].si *
                     (air.scattering.at(wavelengths[i]) + air.absorption.at(wavelengths[i]));
          }
        }
        node.transmittance = clear * std::exp(-std::max(depth, 0.0));
        nodes[i].push_back(node);
      }
    });
  return nodes;
}

}  // namespace antumbra
