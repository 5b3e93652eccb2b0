// The light behind several casters by an exact rule or by a shortcut, so that the shortcuts' errors
// can be measured (plan/shadow_trial.h).
#pragma once

#include <span>
#include <string>

#include "eclipse/shadow_pair.h"

namespace antumbra {

// How several casters act together: the union of their discs; the least of their single lights; the
// product of these, as if each caster dimmed what the others leave.
enum class SeveralCasters { Union, Minimum, Product };
const char* nameOf(SeveralCasters rule);

struct ShadowModel {
  bool spheroid = true;      // oblate casters as such, otherwise spheres of their equators
  bool limbDarkened = true;  // otherwise a uniform disc
  SeveralCasters several = SeveralCasters::Union;
  bool splitAtUmbra = false;  // evaluations along a ray only where it lies outside every umbra
  int evaluations = 1;        // of the light along a ray through air, besides the ground's; 1: the
                              // ground's own serves the air too
};

// Share of sunlight at `point` (metres from the pairs' common origin), at four wavelengths.
glm::dvec4 sunlightBy(SeveralCasters rule, std::span<const glsl::ShadowPair> pairs,
                      const glsl::LimbDarkening& law, const glm::dvec3& point);

}  // namespace antumbra
