#include "ephemeris/apparent.h"

#include <erfa.h>

#include "ephemeris/masses.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

// The Sun's own barycentric motion, linear over the light time: its acceleration, 2e-7 m/s^2, makes
// 25 m over the four hours to Neptune.
struct RetardedSun {
  State atObservation;
  State at(Duration earlier) const {
    return {atObservation.position - earlier * atObservation.velocity, atObservation.velocity};
  }
};

struct Context {
  const Ephemeris& ephemeris;
  const Observer& observer;
  Instant t;
  Corrections corrections;
  RetardedSun sun;
};

// From the eye to the target's place at t - tau, in barycentric axes.
glm::dvec3 fromEye(const Context& c, BodyId target, Duration tau, glm::dvec3* velocity) {
  State const sun = c.sun.at(tau);
  State const body = target == BodyId::SolarSystemBarycentre
                         ? State{}
                         : sun + c.ephemeris.state(target, BodyId::Sun, c.t - tau);
  *velocity = body.velocity.m;
  return body.position.m - c.observer.barycentric.position.m;
}

glm::dvec3 bent(const Context& c, glm::dvec3 direction, glm::dvec3 retarded) {
  glm::dvec3 const sunToEye = c.observer.barycentric.position.m - c.sun.atObservation.position.m;
  double const distance = glm::length(sunToEye);
  glm::dvec3 const sunToTarget = sunToEye + retarded;
  if (glm::length(sunToTarget) < 1e9) return direction;  // the Sun itself
  glm::dvec3 e = sunToEye / distance, q = glm::normalize(sunToTarget);
  double p[3] = {direction.x, direction.y, direction.z}, out[3];
  double qv[3] = {q.x, q.y, q.z}, ev[3] = {e.x, e.y, e.z};
  // ERFA's limiter: the deflection is held constant within about 9" of the Sun's centre, far inside
  // its disc.
  eraLd(1.0, p, qv, ev, distance / astronomicalUnit.si, 1e-9, out);
  return {out[0], out[1], out[2]};
}

ApparentPlace placeOf(const Context& c, BodyId target) {
  glm::dvec3 velocity;
  glm::dvec3 place = fromEye(c, target, Duration(), &velocity);
  double const light = kSpeedOfLight.si;
  Duration tau;
  if (c.corrections.lightTime) {
    // One full evaluation at t - |u(t)|/c; what remains (v/c times tau, below a second) is linear.
    tau = Duration(glm::length(place) / light);
    place = fromEye(c, target, tau, &velocity);
    for (int i = 0; i < 3; ++i) {
      Duration const next(glm::length(place) / light);
      place -= (next - tau).si * velocity;
      tau = next;
    }
  }
  double const length = glm::length(place);
  ApparentPlace result{target, {place}, Duration(length / light), {place}};
  if (length == 0.0) return result;
  glm::dvec3 direction = place / length;
  if (c.corrections.deflection) direction = bent(c, direction, place);
  if (c.corrections.aberration) {
    glm::dvec3 const v = c.observer.barycentric.velocity.m / light;
    double const sun =
        glm::length(c.observer.barycentric.position.m - c.sun.atObservation.position.m);
    double natural[3] = {direction.x, direction.y, direction.z}, speed[3] = {v.x, v.y, v.z},
           proper[3];
    eraAb(natural, speed, sun / astronomicalUnit.si, std::sqrt(1.0 - glm::dot(v, v)), proper);
    direction = {proper[0], proper[1], proper[2]};
  }
  result.displacement = {length * direction};
  return result;
}

}  // namespace

Observer observerAt(const Ephemeris& ephemeris, BodyId centre, Instant t) {
  return {ephemeris.state(centre, BodyId::SolarSystemBarycentre, t)};
}

Observer observerAt(const Ephemeris& ephemeris, const Site& site, Instant t, const DeltaT& deltaT) {
  auto const equator = trueEquatorOfDateFromIcrs(t);
  auto const spin = itrsFromTrueEquatorOfDate(t, deltaT);
  auto const place = itrsFromSite(site);
  Displacement<TrueEquatorOfDate> const r = spin.inverse()(Displacement<Itrs>{place.m});
  glm::dvec3 const pole(0.0, 0.0, kEarthAngularVelocity.si);
  Velocity<TrueEquatorOfDate> const v{glm::cross(pole, r.m)};
  State const geocentric{equator.inverse()(r), equator.inverse()(v)};
  return {ephemeris.state(BodyId::Earth, BodyId::SolarSystemBarycentre, t) + geocentric};
}

std::vector<ApparentPlace> apparentPlaces(const Ephemeris& ephemeris,
                                          std::span<const BodyId> targets, const Observer& observer,
                                          Instant t, Corrections corrections) {
  Context const context{ephemeris,
                        observer,
                        t,
                        corrections,
                        {ephemeris.state(BodyId::Sun, BodyId::SolarSystemBarycentre, t)}};
  std::vector<ApparentPlace> places;
  places.reserve(targets.size());
  for (BodyId const target : targets) places.push_back(placeOf(context, target));
  return places;
}

ApparentPlace apparentPlace(const Ephemeris& ephemeris, BodyId target, const Observer& observer,
                            Instant t, Corrections corrections) {
  return apparentPlaces(ephemeris, std::span(&target, 1), observer, t, corrections).front();
}

}  // namespace antumbra
