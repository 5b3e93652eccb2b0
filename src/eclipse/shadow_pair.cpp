// Cones of a shadow from the places and radii of the Sun and the caster.
#include "eclipse/shadow_pair.h"

#include <fmt/format.h>

#include "document/input_error.h"

namespace antumbra {

glsl::ShadowPair shadowPairMetres(const glm::dvec3& sunMetres, const glm::dvec3& casterMetres,
                                  const ShadowRadii& radii, const CasterFigure& figure) {
  if (!(radii.sun.si > 0.0) || !(radii.casterUmbra.si > 0.0) || !(radii.casterPenumbra.si > 0.0)) {
    throw InputError(
        fmt::format("shadow: radii must be positive, found Sun {} m, caster {} m, {} m",
                    radii.sun.si, radii.casterUmbra.si, radii.casterPenumbra.si));
  }
  double const flat = figure.polarOverEquatorial;
  if (!(flat > 0.0 && flat <= 1.0)) {
    throw InputError(fmt::format(
        "shadow: the caster's polar over its equatorial radius must be in (0, 1], found {}", flat));
  }
  glsl::ShadowPair pair;
  pair.pole = figure.pole;
  pair.squash = 1.0 / flat - 1.0;
  glm::dvec3 const sun = glsl::inCasterSpace(pair, sunMetres);
  glm::dvec3 const caster = glsl::inCasterSpace(pair, casterMetres);
  glm::dvec3 between = caster - sun;
  double distance = glm::length(between);
  if (!(distance > radii.sun.si + radii.casterPenumbra.si)) {
    throw InputError(fmt::format(
        "shadow: the caster's centre must be farther from the Sun's than both radii, found {} m",
        distance));
  }
  pair.axis = between / distance;
  pair.casterBehind = -glm::dot(caster, pair.axis);
  pair.sunBehind = pair.casterBehind + distance;
  pair.foot = caster + pair.axis * pair.casterBehind;
  pair.casterRadius = radii.casterUmbra.si;
  pair.sunRadius = radii.sun.si;
  double umbraSine = glsl::umbralSine(radii.sun.si, radii.casterUmbra.si, distance);
  double penumbraSine = glsl::penumbralSine(radii.sun.si, radii.casterPenumbra.si, distance);
  pair.umbraRadius = glsl::umbraRadiusBehind(radii.casterUmbra.si, umbraSine, pair.casterBehind);
  pair.penumbraRadius =
      glsl::penumbraRadiusBehind(radii.casterPenumbra.si, penumbraSine, pair.casterBehind);
  pair.umbraSine = umbraSine;
  pair.umbraCosine = std::sqrt(1.0 - umbraSine * umbraSine);
  pair.umbraTangent = umbraSine / pair.umbraCosine;
  pair.penumbraTangent = penumbraSine / std::sqrt(1.0 - penumbraSine * penumbraSine);
  return pair;
}

glm::dvec4 visibleSunlight(std::span<const glsl::ShadowPair> pairs, const glsl::LimbDarkening& law,
                           const glm::dvec3& point) {
  glm::dvec4 least(1.0), product(1.0), beyond(1.0);
  glsl::SunCover cover = glsl::noCover();
  glm::dvec3 first(0.0);
  for (auto const& pair : pairs) {
    auto const place = glsl::placeInShadow(pair, point);
    auto const discs = glsl::discsAt(pair, place);
    auto const light = glsl::visibleFraction(discs, law);
    if (light == glm::dvec4(1.0)) continue;
    least = glm::min(least, light);
    product *= light;
    if (cover.count == glsl::kMostDiscs) beyond *= light;
    glm::dvec3 const toward = glsl::limbDirection(pair, place);
    if (cover.count == 0) first = toward;
    cover = glsl::withDisc(cover, discs, glsl::turnBetween(pair, first, toward));
  }
  if (cover.count < 2) return product;
  return glm::min(glsl::visibleFractionOfUnion(cover, law), least) * beyond;
}

std::array<float, 20> packedForShader(const glsl::ShadowPair& pair) {
  std::array<double, 20> values{
      pair.foot.x,       pair.foot.y,    pair.foot.z,       pair.umbraRadius,
      pair.axis.x,       pair.axis.y,    pair.axis.z,       pair.penumbraRadius,
      pair.casterBehind, pair.sunBehind, pair.casterRadius, pair.sunRadius,
      pair.umbraTangent, pair.umbraSine, pair.umbraCosine,  pair.penumbraTangent,
      pair.pole.x,       pair.pole.y,    pair.pole.z,       pair.squash};
  std::array<float, 20> packed{};
  for (std::size_t i = 0; i < values.size(); ++i) packed[i] = static_cast<float>(values[i]);
  return packed;
}

}  // namespace antumbra
