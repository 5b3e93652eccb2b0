#include "scene/placed_scene.h"

#include <fmt/format.h>

#include <cmath>

#include "ephemeris/apparent.h"
#include "frame/body_rotation.h"
#include "quantity/constants.h"
#include "scene/footing.h"

namespace antumbra {
namespace {

// Body-fixed axes at an instant: the Earth's from ERFA, every other body's from the IAU report.
Rotation<BodyFixed, Icrs> axesOf(const Body& body, Instant when, const DeltaT& deltaT) {
  if (body.name == "Earth") return {itrsFromIcrs(when, deltaT).matrix};
  return bodyFixedFromIcrs(bodyRotation(body.name), when);
}

void refuseInside(const CameraPlacement& camera, const Body& body) {
  // The deepest dry land of the Earth lies 430 m below its spheroid; other bodies have basins of
  // several kilometres.
  Length const deepest = body.name == "Earth" ? -500.0 * metre : -1e-3 * body.equatorialRadius;
  if (camera.height < deepest)
    throw InputError(
        fmt::format("{}: found {:.6g} m, which puts the camera inside {}; allowed: {:.6g} m "
                    "or more above its spheroid",
                    camera.heightWhere, camera.height / metre, body.name, deepest / metre));
}

Rotation<CameraAxes, Enu> cameraFromEnu(const CameraPlacement& camera, glm::dvec3 forward) {
  glm::dvec3 upHint{0, 0, 1};
  switch (camera.up) {
    case CameraPlacement::Up::Zenith:
      break;
    case CameraPlacement::Up::North:
      upHint = {0, 1, 0};
      break;
    case CameraPlacement::Up::Azimuth:
      upHint = {sin(camera.upAzimuth), cos(camera.upAzimuth), 0.0};
      break;
  }
  // Looking along the hint itself, north (or the look's azimuth) is up instead.
  if (glm::length(glm::cross(forward, upHint)) < 1e-6) upHint = {0, 1, 0};
  if (glm::length(glm::cross(forward, upHint)) < 1e-6) upHint = {0, 0, 1};
  glm::dvec3 right = glm::normalize(glm::cross(forward, upHint));
  glm::dvec3 up = glm::cross(right, forward);
  // Tilt leans the axis toward the lower edge; roll turns the picture counter-clockwise.
  double const ct = cos(camera.tilt), st = sin(camera.tilt);
  glm::dvec3 const tilted = ct * forward - st * up;
  up = ct * up + st * forward;
  double const cr = cos(camera.roll), sr = sin(camera.roll);
  glm::dvec3 const rolledRight = cr * right - sr * up;
  glm::dvec3 const rolledUp = cr * up + sr * right;
  return {glm::transpose(glm::dmat3{rolledRight, rolledUp, -tilted})};
}

BodyId bodyIdOf(const Body& body) {
  std::string const name = body.ephemeris.substr(0, body.ephemeris.find(".center"));
  return bodyNamed(name, body.file + ": ephemeris");
}

// Whether a body stands near enough to the line from another to the Sun that its exact place is
// worth computing. Places of one instant are good to their motion during light time, 40" of
// direction.
bool mayCast(const PlacedBody& receiver, const PlacedBody& caster) {
  auto const toCaster = caster.fromAnchor - receiver.fromAnchor;
  Length const distance = norm(toCaster);
  Length const sunDistance = norm(receiver.sunFromBody);
  if (distance > sunDistance) return false;
  constexpr Angle kMargin{1e-3};
  Length const reach = 2.0 * receiver.body->equatorialRadius + caster.body->equatorialRadius;
  double const sum = reach / distance + kSolarRadiusIau / sunDistance + kMargin.si;
  return angleBetween(toCaster, receiver.sunFromBody).si < sum;
}

}  // namespace

PlacedScene placeScene(const Scene& scene, Instant when, const BodyCatalogue& catalogue,
                       const Ephemeris& ephemeris, const DeltaT& deltaT) {
  std::vector<const Body*> wanted;
  if (scene.bodies.empty())
    for (auto const& [key, body] : catalogue.all()) wanted.push_back(&body);
  for (auto const& name : scene.bodies)
    wanted.push_back(&catalogue.body(name, scene.file + ": bodies"));
  const Body& anchor = catalogue.body(scene.camera.body, scene.camera.bodyWhere);
  if (anchor.kind == "star")
    throw InputError(fmt::format("{}: found {}, a star; allowed: a planet or a moon",
                                 scene.camera.bodyWhere, anchor.name));
  auto const require = [&](const Body* body) {
    for (auto const* w : wanted)
      if (w == body) return;
    wanted.push_back(body);
  };
  require(&anchor);
  for (auto const& [key, body] : catalogue.all())
    if (body.kind == "star") require(&body);

  PlacedScene placed;
  placed.when = when;
  placed.deltaT = deltaT.at(when);
  placed.deltaTSource = deltaT.explain(when).source;

  Footing const footing =
      footingOn(anchor, scene.camera.latitude, scene.camera.longitude, scene.camera.height);
  refuseInside(scene.camera, anchor);
  auto const anchorAxes = axesOf(anchor, when, deltaT);
  placed.cameraOnAnchor = footing.fromCentre;
  placed.cameraFromAnchor = anchorAxes.inverse()(footing.fromCentre);
  placed.enuFromIcrs = footing.enuFromBody * anchorAxes;

  // Apparent places about one body's centre, all bodies alike.
  auto const eyeAt = [&](const Body& centre, Instant t) {
    return observerAt(ephemeris, bodyIdOf(centre), t);
  };
  Observer const anchorEye = eyeAt(anchor, when);
  placed.velocity = anchorEye.barycentric.velocity;
  std::size_t star = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    PlacedBody b;
    b.body = wanted[i];
    b.when = when;
    if (b.body == &anchor) {
      placed.anchor = i;
    } else {
      auto const place = apparentPlace(ephemeris, bodyIdOf(*b.body), anchorEye, when);
      b.fromAnchor = place.displacement;
      b.when = when - place.lightTime;
    }
    if (b.body->kind == "star") star = i;
    b.fromCamera = b.fromAnchor - placed.cameraFromAnchor;
    b.bodyFromIcrs = b.body == &anchor ? anchorAxes : axesOf(*b.body, b.when, deltaT);
    placed.bodies.push_back(std::move(b));
  }
  for (PlacedBody& b : placed.bodies) {
    if (&b == &placed.bodies[star]) continue;
    Observer const eye = b.body == &anchor ? anchorEye : eyeAt(*b.body, b.when);
    b.sunFromBody =
        apparentPlace(ephemeris, bodyIdOf(*placed.bodies[star].body), eye, b.when).displacement;
    for (const PlacedBody& other : placed.bodies) {
      if (&other == &b || &other == &placed.bodies[star]) continue;
      if (!mayCast(b, other)) continue;
      b.neighbours.push_back(
          {other.body, apparentPlace(ephemeris, bodyIdOf(*other.body), eye, b.when).displacement,
           other.bodyFromIcrs.inverse()(Direction<BodyFixed>{{0.0, 0.0, 1.0}})});
    }
  }

  glm::dvec3 forward{0, 0, 1};
  const CameraPlacement& camera = scene.camera;
  if (camera.target == "nadir") {
    forward = {0, 0, -1};
  } else if (camera.target == "zenith") {
    forward = {0, 0, 1};
  } else if (!camera.target.empty()) {
    const Body& target = catalogue.body(camera.target, camera.targetWhere);
    for (auto const& b : placed.bodies)
      if (b.body == &target) forward = placed.enuFromIcrs(directionOf(b.fromCamera)).u;
  } else {
    forward = {sin(camera.azimuth) * cos(camera.altitude),
               cos(camera.azimuth) * cos(camera.altitude), sin(camera.altitude)};
  }
  placed.cameraFromIcrs = cameraFromEnu(camera, forward) * placed.enuFromIcrs;
  return placed;
}

}  // namespace antumbra
