// Units and frames as types: what must compile does, what must not does not.
#include "quantity/vector.h"

#include <gtest/gtest.h>

#include <functional>
#include <type_traits>

namespace antumbra {
namespace {

struct North {};
struct East {};

TEST(Vector, WrongMixesDoNotCompile) {
  static_assert(std::is_invocable_v<std::minus<>, Position<North>, Position<North>>);
  static_assert(!std::is_invocable_v<std::minus<>, Position<North>, Position<East>>);
  static_assert(!std::is_invocable_v<std::plus<>, Position<North>, Position<North>>);
  static_assert(std::is_invocable_v<Rotation<East, North>, Displacement<North>>);
  static_assert(!std::is_invocable_v<Rotation<East, North>, Displacement<East>>);
  static_assert(!std::is_invocable_v<std::plus<>, Length, Angle>);
  static_assert(!std::is_convertible_v<double, Length>);
  static_assert(std::is_same_v<decltype(metre / second), Speed>);
  static_assert(std::is_same_v<decltype(metre / kilometre), double>);
  static_assert(sizeof(Position<North>) == sizeof(glm::dvec3));
}

TEST(Vector, RotationRoundTrip) {
  Rotation<East, North> const r{glm::dmat3{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
  Displacement<North> const d{{1.5e11, 2.0, 3.0}};
  EXPECT_EQ(r.inverse()(r(d)).m, d.m);
}

TEST(Vector, TinyAnglesKeepTheirPrecision) {
  // 1e-9 rad, where acos of a double dot product gives 0 or 1.5e-8.
  Direction<North> const a{{1, 0, 0}};
  Direction<North> const b{glm::normalize(glm::dvec3{1, 1e-9, 0})};
  EXPECT_NEAR(angleBetween(a, b) / radian, 1e-9, 1e-18);
}

}  // namespace
}  // namespace antumbra
