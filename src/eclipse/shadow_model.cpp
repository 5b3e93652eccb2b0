#include "eclipse/shadow_model.h"

namespace antumbra {

const char* nameOf(SeveralCasters rule) {
  switch (rule) {
    case SeveralCasters::Minimum:
      return "minimum";
    case SeveralCasters::Product:
      return "product";
    default:
      return "union";
  }
}

glm::dvec4 sunlightBy(SeveralCasters rule, std::span<const glsl::ShadowPair> pairs,
                      const glsl::LimbDarkening& law, const glm::dvec3& point) {
  if (rule == SeveralCasters::Union) return visibleSunlight(pairs, law, point);
  glm::dvec4 light(1.0);
  for (auto const& pair : pairs) {
    glm::dvec4 const one = glsl::visibleSunlight(pair, law, point);
    light = rule == SeveralCasters::Minimum ? glm::min(light, one) : light * one;
  }
  return light;
}

}  // namespace antumbra
