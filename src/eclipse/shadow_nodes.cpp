#include "eclipse/shadow_nodes.h"

#include <algorithm>
#include <cmath>

namespace antumbra {
namespace {

constexpr double kHeightScale = 0.1;  // rad
constexpr double kSunDistanceStep = 0.002, kPenumbraStep = 0.0005;

double heightCoordinate(double axisShare, double step) {
  double const p = axisShare < 1.0 ? std::acos(axisShare) : -std::acosh(axisShare);
  return std::asinh(p / kHeightScale) / step;
}

double axisShareAt(double coordinate, double step) {
  double const p = kHeightScale * std::sinh(coordinate * step);
  return p > 0.0 ? std::cos(std::min(p, std::acos(0.0))) : std::cosh(p);
}

// The pair's spheres with the Sun `sunBehind` before the foot and an umbra of `umbra` there.
glsl::ShadowPair canonicalPair(const glsl::ShadowPair& pair, double sunBehind, double umbra,
                               double axisDistance) {
  double behind = pair.casterBehind, sine = pair.umbraSine, cosine = pair.umbraCosine;
  for (int i = 0; i < 20; ++i) {
    double const distance = sunBehind - behind;
    sine = glsl::umbralSine(pair.sunRadius, pair.casterRadius, distance);
    cosine = std::sqrt(1.0 - sine * sine);
    if (std::fabs(sine) * pair.casterBehind < 1e-6 * pair.casterRadius) break;  // a cylinder
    behind = (pair.casterRadius - umbra * cosine) / sine;
  }
  glsl::ShadowPair node = pair;
  node.foot = glm::dvec3(axisDistance, 0.0, 0.0);
  node.axis = glm::dvec3(0.0, 0.0, -1.0);
  node.squash = 0.0;
  node.casterBehind = behind;
  node.sunBehind = sunBehind;
  node.umbraRadius = umbra;
  node.umbraSine = sine;
  node.umbraCosine = cosine;
  node.umbraTangent = sine / cosine;
  double const outer = glsl::penumbralSine(pair.sunRadius, pair.casterRadius, sunBehind - behind);
  node.penumbraRadius = glsl::penumbraRadiusBehind(pair.casterRadius, outer, behind);
  node.penumbraTangent = outer / std::sqrt(1.0 - outer * outer);
  return node;
}

}  // namespace

std::vector<ShadowNode> shadowNodes(const glsl::ShadowPair& pair, Length axisDistance,
                                    Length radius, const ShadowLattice& lattice) {
  long const sunKey = std::lround(std::log(pair.sunBehind) / kSunDistanceStep);
  double const sunBehind = std::exp(static_cast<double>(sunKey) * kSunDistanceStep);
  double const rounded =
      canonicalPair(pair, sunBehind, pair.umbraRadius, axisDistance.si).penumbraRadius;
  long const penumbraKey = std::lround(std::log(pair.penumbraRadius / rounded) / kPenumbraStep);
  double const widened = std::exp(static_cast<double>(penumbraKey) * kPenumbraStep);

  double const height = heightCoordinate(axisDistance / radius, lattice.heightStep);
  double const umbra = std::asinh(pair.umbraRadius / lattice.umbraScale.si) / lattice.umbraStep;
  std::vector<ShadowNode> nodes;
  double const h0 = std::floor(height), u0 = std::floor(umbra);
  double const across = height - h0, up = umbra - u0;
  bool const lower = across > up;  // which half of the lattice's cell
  for (int i = 0; i < 3; ++i) {
    double const h = i == 0 ? h0 : i == 2 || lower ? h0 + 1.0 : h0;
    double const u = i == 0 ? u0 : i == 2 || !lower ? u0 + 1.0 : u0;
    double const weight = i == 0   ? 1.0 - std::max(across, up)
                          : i == 1 ? std::fabs(across - up)
                                   : std::min(across, up);
    if (!(weight > 0.0)) continue;
    // Below the least nodes the lattice goes on; the Sun is never higher than the zenith.
    double const share = axisShareAt(h, lattice.heightStep);
    ShadowNode node{
        {static_cast<long>(h), static_cast<long>(u), sunKey, penumbraKey},
        weight,
        canonicalPair(pair, sunBehind, lattice.umbraScale.si * std::sinh(u * lattice.umbraStep),
                      share * radius.si)};
    node.pair.penumbraRadius *= widened;
    nodes.push_back(node);
  }
  return nodes;
}

glsl::ShadowPair shadowAlone(const glsl::ShadowPair& pair, Length axisDistance) {
  glsl::ShadowPair alone = pair;
  alone.foot = glm::dvec3(axisDistance.si, 0.0, 0.0);
  alone.axis = glm::dvec3(0.0, 0.0, -1.0);
  alone.squash = 0.0;
  return alone;
}

Length umbraOnGround(const glsl::ShadowPair& pair, Length axisDistance, Length radius) {
  double const inside = radius.si * radius.si - axisDistance.si * axisDistance.si;
  return Length(glsl::umbraRadiusAt(pair, -std::sqrt(std::max(inside, 0.0))));
}

}  // namespace antumbra
