// Vectors that know their reference frame. A frame is an empty tag type (frame/frames.h); adding
// vectors of two frames, or rotating a vector of the wrong one, does not compile. GLM stays inside:
// `.m` holds metres (or metres per second), for the bodies of functions.
#pragma once

#include <glm/glm.hpp>

#include "quantity/quantity.h"

namespace antumbra {

// A difference of two places, in metres along the axes of Frame.
template <class Frame>
struct Displacement {
  glm::dvec3 m{0.0};
  friend Displacement operator+(Displacement a, Displacement b) { return {a.m + b.m}; }
  friend Displacement operator-(Displacement a, Displacement b) { return {a.m - b.m}; }
  friend Displacement operator-(Displacement a) { return {-a.m}; }
  friend Displacement operator*(double s, Displacement a) { return {s * a.m}; }
};

// Metres per second along the axes of Frame.
template <class Frame>
struct Velocity {
  glm::dvec3 m{0.0};
  friend Velocity operator+(Velocity a, Velocity b) { return {a.m + b.m}; }
  friend Velocity operator-(Velocity a, Velocity b) { return {a.m - b.m}; }
  friend Velocity operator*(double s, Velocity a) { return {s * a.m}; }
  friend Displacement<Frame> operator*(Duration t, Velocity v) { return {t.si * v.m}; }
};

// A unit vector along the axes of Frame.
template <class Frame>
struct Direction {
  glm::dvec3 u{1.0, 0.0, 0.0};
  friend Direction operator-(Direction a) { return {-a.u}; }
  friend Displacement<Frame> operator*(Length l, Direction d) { return {l.si * d.u}; }
};

// A place, in metres from the origin of Frame.
template <class Frame>
struct Position {
  glm::dvec3 m{0.0};
  friend Displacement<Frame> operator-(Position a, Position b) { return {a.m - b.m}; }
  friend Position operator+(Position a, Displacement<Frame> d) { return {a.m + d.m}; }
  friend Position operator-(Position a, Displacement<Frame> d) { return {a.m - d.m}; }
};

template <class Frame>
Length norm(Displacement<Frame> d) {
  return Length(glm::length(d.m));
}
template <class Frame>
Speed norm(Velocity<Frame> v) {
  return Speed(glm::length(v.m));
}
template <class Frame>
Direction<Frame> directionOf(Displacement<Frame> d) {
  return {glm::normalize(d.m)};
}
template <class Frame>
double dot(Direction<Frame> a, Direction<Frame> b) {
  return glm::dot(a.u, b.u);
}
template <class Frame>
Length dot(Displacement<Frame> a, Direction<Frame> b) {
  return Length(glm::dot(a.m, b.u));
}
// The angle between two vectors by atan2, accurate at arcsecond scale and below, where acos is not.
template <class Frame>
Angle angleBetween(Direction<Frame> a, Direction<Frame> b) {
  return Angle(std::atan2(glm::length(glm::cross(a.u, b.u)), glm::dot(a.u, b.u)));
}
template <class Frame>
Angle angleBetween(Displacement<Frame> a, Displacement<Frame> b) {
  return Angle(std::atan2(glm::length(glm::cross(a.m, b.m)), glm::dot(a.m, b.m)));
}

// An orthonormal change of axes, read right to left: `itrsFromIcrs(v)` with v in Icrs.
template <class To, class From>
struct Rotation {
  glm::dmat3 matrix{1.0};
  Displacement<To> operator()(Displacement<From> d) const { return {matrix * d.m}; }
  Velocity<To> operator()(Velocity<From> v) const { return {matrix * v.m}; }
  Direction<To> operator()(Direction<From> d) const { return {matrix * d.u}; }
  Rotation<From, To> inverse() const { return {glm::transpose(matrix)}; }
  template <class Other>
  Rotation<To, Other> operator*(const Rotation<From, Other>& b) const {
    return {matrix * b.matrix};
  }
};

}  // namespace antumbra
