// Cones of a shadow from the places and radii of the Sun and the caster.
#include "eclipse/shadow_pair.h"

#include <fmt/format.h>

#include "document/input_error.h"

namespace antumbra {

glsl::ShadowPair shadowPairMetres(const glm::dvec3& sun, const glm::dvec3& caster,
                                  const ShadowRadii& radii) {
  if (!(radii.sun.si > 0.0) || !(radii.casterUmbra.si > 0.0) || !(radii.casterPenumbra.si > 0.0)) {
    throw InputError(
        fmt::format("shadow: radii must be positive, found Sun {} m, caster {} m, {} m",
                    radii.sun.si, radii.casterUmbra.si, radii.casterPenumbra.si));
  }
  glm::dvec3 between = caster - sun;
  double distance = glm::length(between);
  if (!(distance > radii.sun.si + radii.casterPenumbra.si)) {
    throw InputError(fmt::format(
        "shadow: the caster's centre must be farther from the Sun's than both radii, found {} m",
        distance));
  }
  glsl::ShadowPair pair;
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

std::array<float, 16> packedForShader(const glsl::ShadowPair& pair) {
  std::array<double, 16> values{
      pair.foot.x,       pair.foot.y,    pair.foot.z,       pair.umbraRadius,
      pair.axis.x,       pair.axis.y,    pair.axis.z,       pair.penumbraRadius,
      pair.casterBehind, pair.sunBehind, pair.casterRadius, pair.sunRadius,
      pair.umbraTangent, pair.umbraSine, pair.umbraCosine,  pair.penumbraTangent};
  std::array<float, 16> packed{};
  for (std::size_t i = 0; i < values.size(); ++i) packed[i] = static_cast<float>(values[i]);
  return packed;
}

}  // namespace antumbra
