#include "picture/sunlight.h"

#include <algorithm>
#include <cmath>

#include "atmosphere/single_scattering.h"
#include "photometry/colour.h"
#include "photometry/spectral_weights.h"
#include "photometry/standard_spectra.h"

namespace antumbra {

glm::dvec3 solarIlluminanceAtOneAu() {
  static glm::dvec3 const lux =
      linearSrgbFromXyz(xyzOfRelativeRadiance([](Length) { return 1.0; }));
  return lux;
}

namespace {

// Toward the Sun's centre, in the body's axes.
double lightThroughRings(const PlannedBody& body, Direction<CameraAxes> sun) {
  glm::dvec3 const camera = body.bodyFromCamera.matrix * -body.centre.m;
  glm::dvec3 const ray = body.bodyFromCamera.matrix * sun.u;
  double const way = -camera.z / ray.z;
  if (!(way > 0.0)) return 1.0;
  Length const radius(glm::length(glm::dvec2(camera + ray * way)));
  return std::exp(-body.rings->system.opticalDepthAt(radius) / std::fabs(ray.z));
}

}  // namespace

SunlightThroughAir::SunlightThroughAir()
    : wavelengths_(defaultWavelengths(16)), weights_(linearSrgbWeights(wavelengths_)) {}

glm::dvec3 SunlightThroughAir::share(const RenderPlan& plan) {
  std::vector<double> passed(wavelengths_.size(), 1.0);
  bool any = false;
  for (const PlannedBody& body : plan.bodies) {
    if (body.rings) {
      double const light = lightThroughRings(body, plan.sun.direction);
      for (double& p : passed) p *= light;
      any = any || light < 1.0;
    }
    if (body.atmosphere.empty()) continue;
    glm::dvec3 const stretch(1.0, 1.0, body.equatorialRadius / body.polarRadius);
    glm::dmat3 const& turn = body.bodyFromCamera.matrix;
    glm::dvec3 const up = glm::normalize(stretch * (turn * -body.centre.m));
    glm::dvec3 const sun = glm::normalize(stretch * (turn * plan.sun.direction.u));
    auto known = media_.find(body.atmosphere);
    if (known == media_.end())
      known = media_.emplace(body.atmosphere, readMedium(mediumFile(body.atmosphere))).first;
    Medium const& medium = known->second;
    double const r = medium.radius.si + std::max(body.cameraHeight.si, 0.0);
    double const cosine = glm::dot(up, sun);
    double const sine = glm::length(glm::cross(up, sun));
    // A ray that meets the ground is dimmed like the one that grazes it: the silhouette hides it.
    double const grazing =
        -std::sqrt(std::max(0.0, 1.0 - std::pow(medium.radius.si / r, 2.0))) + 1e-7;
    double const c = std::max(cosine, grazing);
    double const s = c == cosine ? sine : std::sqrt(1.0 - c * c);
    for (std::size_t i = 0; i < wavelengths_.size(); ++i)
      passed[i] *= transmittance(medium, Position<AirFrame>{{0.0, 0.0, r}},
                                 Direction<AirFrame>{{s, 0.0, c}}, wavelengths_[i]);
    any = true;
  }
  if (!any) return glm::dvec3(1.0);
  glm::dvec3 through(0.0), whole(0.0);
  for (std::size_t i = 0; i < wavelengths_.size(); ++i) {
    through += weights_[i] * passed[i];
    whole += weights_[i];
  }
  return glm::max(through / whole, 0.0);
}

}  // namespace antumbra
