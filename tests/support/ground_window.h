// A window on the Earth's ground, drawn as any picture is, and where each of its pixels lies on the
// ellipsoid, by intersecting lines of sight with it in double precision.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "picture/picture_renderer.h"
#include "quantity/constants.h"

namespace antumbra::testsupport {

inline DecodedImage greyMap(const std::string&, const std::string&) {
  return {4, 2, 3, std::vector<unsigned char>(4 * 2 * 3, 128)};
}

class GroundWindow {
 public:
  struct View {
    double latitude = 0.0, longitude = 0.0;  // deg, below the camera, which looks straight down
    double heightMetres = 1e6;
    double pixelMetres = 500.0;  // on the ground below
    int size = 32;
    std::string convention = "nasa";
    std::string limbDarkening = "none";
    bool illustrative = false;
    bool air = false;
    bool eclipsed = true;  // false: nothing is cast
  };

  GroundWindow(PictureRenderer& renderer, const View& view, Instant when, Duration deltaT) {
    Scene scene;
    scene.file = "test";
    scene.bodies = {"Earth", "Moon", "Sun"};
    scene.camera.latitude = view.latitude * degree;
    scene.camera.longitude = view.longitude * degree;
    scene.camera.height = Length(view.heightMetres);
    scene.camera.target = "nadir";
    scene.camera.up = CameraPlacement::Up::North;
    double const half = 0.5 * view.size * view.pixelMetres;
    scene.picture = {ProjectionKind::Perspective, Angle(2.0 * std::atan(half / view.heightMetres)),
                     view.size, view.size};
    scene.shadows.convention = view.convention;
    scene.shadows.limbDarkening = view.limbDarkening;
    scene.sun.coronaLight = false;  // edges and contacts are those of the photosphere
    scene.display.illustrative = view.illustrative;
    scene.display.automaticExposure = false;
    scene.quality = "draft";
    placed_ = placeScene(scene, when, BodyCatalogue::standard(), Ephemeris::standard(),
                         DeltaT::fixed(deltaT));
    RenderPlan plan = makeRenderPlan(scene, placed_);
    for (auto& body : plan.bodies) {
      if (!view.air) body.atmosphere.clear();
      if (!view.eclipsed) body.casters.clear();
    }
    picture_ = scene.picture;
    finished_ = renderer.finish(scene, placed_, plan);
  }

  int size() const { return picture_.width; }
  const FinishedPicture& finished() const { return finished_; }
  // cd/m2 of a channel at a pixel, counted from the lower left corner.
  double at(int x, int y, int channel = 1) const {
    auto const row = static_cast<std::size_t>(picture_.height - 1 - y);
    return static_cast<double>(
        finished_
            .linear[(row * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x)) *
                        3 +
                    static_cast<std::size_t>(channel)]);
  }
  // The point of the ellipsoid that a place in the picture shows (pixel centres at halves), metres
  // along Itrs.
  std::optional<glm::dvec3> groundAt(double x, double y) const {
    auto const& earth = placed_.bodies[placed_.anchor];
    auto const direction = picture_.directionAt(x, y);
    glm::dvec3 const d = (earth.bodyFromIcrs * placed_.cameraFromIcrs.inverse())(*direction).u;
    glm::dvec3 const from = placed_.cameraOnAnchor.m;
    glm::dvec3 const scale(1.0, 1.0, 1.0 / (1.0 - kEarthFlattening));
    glm::dvec3 const p = from * scale, q = d * scale;
    double const a = kEarthEquatorialRadius.si;
    double const qq = glm::dot(q, q), pq = glm::dot(p, q), pp = glm::dot(p, p) - a * a;
    double const root = pq * pq - qq * pp;
    if (root < 0.0) return std::nullopt;
    return from + d * ((-pq - std::sqrt(root)) / qq);
  }
  // Where a point of Itrs falls in the picture, in pixels; nothing behind the camera.
  std::optional<glm::dvec2> pixelOf(const glm::dvec3& ground) const {
    auto const& earth = placed_.bodies[placed_.anchor];
    Rotation<CameraAxes, BodyFixed> const turn =
        placed_.cameraFromIcrs * earth.bodyFromIcrs.inverse();
    return picture_.pixelOf(
        turn(directionOf(Displacement<BodyFixed>{ground - placed_.cameraOnAnchor.m})));
  }

 private:
  PlacedScene placed_;
  Projection picture_;
  FinishedPicture finished_;
};

}  // namespace antumbra::testsupport
