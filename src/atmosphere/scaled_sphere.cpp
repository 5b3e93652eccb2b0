#include "atmosphere/scaled_sphere.h"

#include <cmath>

namespace antumbra {

ScaledSphere::ScaledSphere(Length equatorialRadius, Length polarRadius,
                           Displacement<BodyFixed> observer, Direction<BodyFixed> sun)
    : radius_(equatorialRadius), stretch_(1.0, 1.0, equatorialRadius / polarRadius) {
  glm::dvec3 const place = stretch_ * observer.m;
  up_ = glm::normalize(place);
  height_ = Length(glm::length(place)) - radius_;
  sun_ = glm::normalize(stretch_ * sun.u);
  glm::dvec3 level = sun_ - up_ * glm::dot(up_, sun_);
  if (glm::length(level) < 1e-9)  // the Sun in the zenith: any azimuth will do
    level = glm::cross(up_, std::fabs(up_.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0));
  sunward_ = glm::normalize(level);
  side_ = glm::cross(up_, sunward_);
}

Angle ScaledSphere::sunZenith() const {
  return arcTangent(glm::dot(sun_, sunward_), glm::dot(sun_, up_));
}

Direction<AirFrame> ScaledSphere::operator()(Direction<BodyFixed> direction) const {
  glm::dvec3 const d = glm::normalize(stretch_ * direction.u);
  return {{glm::dot(d, sunward_), glm::dot(d, side_), glm::dot(d, up_)}};
}

}  // namespace antumbra
