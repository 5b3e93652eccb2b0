// Physical quantities as types: a length is not an angle and kilometres are not metres.
// A quantity holds its value in SI units (metre, second, radian) in double precision. It is made by
// multiplying a number with a unit and read by dividing by one: `6378.137 * kilometre`, `h /
// metre`. Angles carry a dimension of their own, so that an angle and a plain ratio cannot be mixed
// up.
#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace antumbra {

// Dimension exponents: length (m), time (s), angle (rad).
template <int L, int T, int A>
struct Quantity {
  double si = 0.0;
  constexpr Quantity() = default;
  constexpr explicit Quantity(double valueInSi) : si(valueInSi) {}
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.si + b.si); }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.si - b.si); }
  friend constexpr Quantity operator-(Quantity a) { return Quantity(-a.si); }
  friend constexpr Quantity operator*(double s, Quantity a) { return Quantity(s * a.si); }
  friend constexpr Quantity operator*(Quantity a, double s) { return Quantity(s * a.si); }
  friend constexpr Quantity operator/(Quantity a, double s) { return Quantity(a.si / s); }
  constexpr Quantity& operator+=(Quantity b) { return si += b.si, *this; }
  constexpr Quantity& operator-=(Quantity b) { return si -= b.si, *this; }
  friend constexpr auto operator<=>(Quantity, Quantity) = default;
};

namespace detail {
template <int L, int T, int A>
struct Simplify {
  static constexpr Quantity<L, T, A> of(double si) { return Quantity<L, T, A>(si); }
};
template <>
struct Simplify<0, 0, 0> {
  static constexpr double of(double si) { return si; }
};
}  // namespace detail

template <int L, int T, int A, int L2, int T2, int A2>
constexpr auto operator*(Quantity<L, T, A> a, Quantity<L2, T2, A2> b) {
  return detail::Simplify<L + L2, T + T2, A + A2>::of(a.si * b.si);
}
template <int L, int T, int A, int L2, int T2, int A2>
constexpr auto operator/(Quantity<L, T, A> a, Quantity<L2, T2, A2> b) {
  return detail::Simplify<L - L2, T - T2, A - A2>::of(a.si / b.si);
}
template <int L, int T, int A>
constexpr auto operator/(double s, Quantity<L, T, A> a) {
  return detail::Simplify<-L, -T, -A>::of(s / a.si);
}
template <int L, int T, int A>
Quantity<L, T, A> abs(Quantity<L, T, A> a) {
  return Quantity<L, T, A>(std::fabs(a.si));
}

using Length = Quantity<1, 0, 0>;
using Duration = Quantity<0, 1, 0>;
using Angle = Quantity<0, 0, 1>;
using Speed = Quantity<1, -1, 0>;
using AngularRate = Quantity<0, -1, 1>;

inline constexpr Length metre{1.0};
inline constexpr Length kilometre{1000.0};
inline constexpr Length nanometre{1e-9};
// IAU 2012 Resolution B2: exact.
inline constexpr Length astronomicalUnit{149597870700.0};

inline constexpr Duration second{1.0};
inline constexpr Duration minute{60.0};
inline constexpr Duration hour{3600.0};
inline constexpr Duration day{86400.0};

inline constexpr Angle radian{1.0};
inline constexpr Angle degree{std::numbers::pi / 180.0};
inline constexpr Angle arcminute{std::numbers::pi / 10800.0};
inline constexpr Angle arcsecond{std::numbers::pi / 648000.0};

inline double sin(Angle a) { return std::sin(a.si); }
inline double cos(Angle a) { return std::cos(a.si); }
inline double tan(Angle a) { return std::tan(a.si); }
inline Angle arcTangent(double y, double x) { return Angle(std::atan2(y, x)); }

}  // namespace antumbra
