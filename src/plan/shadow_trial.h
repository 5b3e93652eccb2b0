// What a simpler model of shadows costs in accuracy, on the shadows of a planned picture: the light
// on the receivers and in their air, and the place of the shadows' edges, against rays to the
// points of the Sun (eclipse/rays_to_sun.h) at 440 and 680 nm.
//
// In air the reference is the light scattered once along the picture's own rays with the exact
// model at 96 places of each: straight rays, one wavelength (550 nm), the medium's own extinction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eclipse/limb_darkening.h"
#include "eclipse/rays_to_sun.h"
#include "eclipse/shadow_model.h"
#include "plan/render_plan.h"

namespace antumbra {

// A body, or rings, in the shadow of at least one caster. Metres in body-fixed axes.
struct ShadowReceiver {
  std::string name;
  glm::dvec3 sun, camera;
  glm::dmat3 bodyFromCamera;
  double equatorialRadius = 0.0, polarRadius = 0.0;
  std::optional<RingSystem> rings;  // the receiver is the rings, the caster their globe
  std::string atmosphere;           // stem of its medium, or empty
  std::vector<PlannedBody::Caster> casters;
};
std::vector<ShadowReceiver> shadowReceivers(const RenderPlan& plan);

struct ShadowErrors {
  double largestLight = 0.0, meanLight = 0.0;  // of the free Sun, over points in partial shadow
  std::optional<double> largestAir, meanAir;   // of the light scattered once along the ray, as far
                                               // as 1e-5 of it without the shadow is left
  std::optional<Length> halfLightEdge;         // largest displacement of the line of half light,
  std::optional<Length> umbraEdge;             // and of that of a hundredth
};

class ShadowTrial {
 public:
  // About `points` places in each shadow. Slow: seconds for hundreds of points.
  ShadowTrial(const ShadowReceiver& receiver, const Projection& picture, LimbDarkeningLaw law,
              int points);
  ShadowErrors errorsOf(const ShadowModel& model) const;
  // Evaluates the model at every point once, for measuring; returns the sum of the light.
  double evaluateAll(const ShadowModel& model) const;
  std::size_t points() const { return points_.size(); }
  std::size_t airRays() const { return airRays_.size(); }

 private:
  struct Edge {
    std::size_t caster;
    double turn, level;
    double radius;  // by rays, m in the caster's space
  };
  struct AirRay {
    std::vector<glm::dvec3> places;
    std::vector<double> weights;  // sum 1
    std::vector<bool> lit;        // outside every umbra
    glm::dvec3 single;            // where one evaluation a pixel is made
    double light;                 // share that is left, by the exact model
  };
  std::vector<glsl::ShadowPair> pairs(const ShadowModel& model) const;
  glsl::LimbDarkening lawOf(const ShadowModel& model) const;
  glm::dvec3 onEdge(std::size_t caster, double turn, double radius) const;
  std::optional<glm::dvec3> onReceiver(const glm::dvec3& from, const glm::dvec3& along) const;
  void findPoints(int count);
  void findEdges();
  void findAirRays(const Projection& picture);

  ShadowReceiver receiver_;
  LimbDarkeningLaw law_;
  std::vector<OpaqueSpheroid> opaque_;
  std::vector<glsl::ShadowPair> exact_;
  std::vector<glm::dvec3> points_;
  std::vector<glm::dvec2> light_;  // by rays, at both wavelengths
  std::vector<Edge> edges_;
  std::vector<AirRay> airRays_;
};

}  // namespace antumbra
