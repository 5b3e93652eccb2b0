#include "ephemeris/chebyshev_table.h"

#include <fmt/format.h>
#include <immintrin.h>
#include <cmath>
#include <cstring>

#include "ephemeris/term_series.h"

namespace antumbra {
namespace {

constexpr double kJ2000 = 2451545.0;
constexpr std::size_t kMaxOrders = 48;

// Four doubles side by side; the compiler maps them to whatever vectors the machine has.
using Four = double __attribute__((vector_size(32)));

template <class Integer>
std::size_t unpack(const std::byte* from, std::uint32_t orders, double* to) {
  for (std::uint32_t k = 0; k < orders; ++k) {
    Integer v[3];
    std::memcpy(v, from + k * sizeof v, sizeof v);
    for (std::size_t axis = 0; axis < 3; ++axis) to[4 * k + axis] = static_cast<double>(v[axis]);
  }
  return orders * 3 * sizeof(Integer);
}

#pragma GCC push_options
#pragma GCC target("avx2,fma")

// Widens three integers (and one beyond them, never used) to doubles.
inline __m256d widen(const std::int32_t* p) {
  return _mm256_cvtepi32_pd(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)));
}
inline __m256d widen(const std::int16_t* p) {
  return _mm256_cvtepi32_pd(
      _mm_cvtepi16_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p))));
}
inline __m256d widen(const std::int8_t* p) {
  int bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  return _mm256_cvtepi32_pd(_mm_cvtepi8_epi32(_mm_cvtsi32_si128(bytes)));
}

inline __m256d widen(const double* p) { return _mm256_loadu_pd(p); }

// T_k by its recurrence, k U_{k-1} for the derivative; two chains instead of Clenshaw's longer one.
struct Recurrence {
  double twice, t, tBefore, u, uBefore, order;
  __m256d value, derivative;
  void add(__m256d c) {
    value = _mm256_fmadd_pd(c, _mm256_set1_pd(t), value);
    derivative = _mm256_fmadd_pd(c, _mm256_set1_pd(order * uBefore), derivative);
    double const tNext = __builtin_fma(twice, t, -tBefore);
    double const uNext = __builtin_fma(twice, u, -uBefore);
    tBefore = t;
    t = tNext;
    uBefore = u;
    u = uNext;
    order += 1.0;
  }
  // Coefficients of x, y, z and one unused number.
  void addFours(const double* c, std::size_t orders) {
    for (std::size_t k = 0; k < orders; ++k) add(widen(c + 4 * k));
  }
  template <class Integer>
  const std::byte* addAll(const std::byte* from, std::uint32_t orders) {
    const auto* p = reinterpret_cast<const Integer*>(from);
    for (std::uint32_t k = 0; k < orders; ++k, p += 3) add(widen(p));
    return reinterpret_cast<const std::byte*>(p);
  }
};

// The last order of one byte is copied first: four bytes there could lie beyond the file.
ChebyshevSum sumAvx2(const ChebyshevBody& body, const std::byte* from, double x) {
  Recurrence r{2.0 * x, 1.0, x, 1.0, 0.0, 0.0, _mm256_setzero_pd(), _mm256_setzero_pd()};
  from = r.addAll<std::int32_t>(from, body.n32);
  from = r.addAll<std::int16_t>(from, body.n16);
  from = r.addAll<std::int8_t>(from, body.n8 - 1);
  std::int8_t last[4] = {};
  std::memcpy(last, from, 3);
  r.add(widen(last));
  return {{r.value[0], r.value[1], r.value[2]},
          {r.derivative[0], r.derivative[1], r.derivative[2]}};
}
ChebyshevSum sumFoursAvx2(const double* c, std::size_t orders, double x) {
  Recurrence r{2.0 * x, 1.0, x, 1.0, 0.0, 0.0, _mm256_setzero_pd(), _mm256_setzero_pd()};
  r.addFours(c, orders);
  return {{r.value[0], r.value[1], r.value[2]},
          {r.derivative[0], r.derivative[1], r.derivative[2]}};
}
#pragma GCC pop_options

bool haveAvx2() {
  static const bool have = bestVectorUnit() != VectorUnit::Plain;
  return have;
}

}  // namespace

ChebyshevSum chebyshevSum(const double* c, std::size_t orders, double x) {
  if (haveAvx2()) return sumFoursAvx2(c, orders, x);
  Four const twice = Four{} + 2.0 * x;
  Four b1{}, b2{}, d1{}, d2{};
  // b_k = c_k + 2x b_{k+1} - b_{k+2}; its derivative alongside.
  for (std::size_t k = orders; k-- > 1;) {
    Four ck;
    std::memcpy(&ck, c + 4 * k, sizeof ck);
    Four const d = 2.0 * b1 + twice * d1 - d2;
    Four const b = ck + twice * b1 - b2;
    d2 = d1;
    d1 = d;
    b2 = b1;
    b1 = b;
  }
  Four c0;
  std::memcpy(&c0, c, sizeof c0);
  Four const value = c0 + x * b1 - b2;
  Four const derivative = b1 + x * d1 - d2;
  return {{value[0], value[1], value[2]}, {derivative[0], derivative[1], derivative[2]}};
}

bool ChebyshevBody::covers(double tdbDays) const {
  double const days = tdbDays + (kJ2000 - firstJulianDate);
  return days >= 0.0 && days <= daysPerSegment * segments;
}

State ChebyshevBody::state(double tdbDays) const {
  double const days = tdbDays + (kJ2000 - firstJulianDate);
  auto const index = std::min(static_cast<std::uint32_t>(days / daysPerSegment), segments - 1);
  double const x = 2.0 * (days - index * daysPerSegment) / daysPerSegment - 1.0;
  const std::byte* from = data + index * bytesPerSegment;
  double const rate = unitMetres * 2.0 / (daysPerSegment * 86400.0);
  if (haveAvx2() && n8 > 0) {
    auto const sum = sumAvx2(*this, from, x);
    return {{unitMetres * sum.value}, {rate * sum.derivative}};
  }
  alignas(32) double c[4 * kMaxOrders];
  from += unpack<std::int32_t>(from, n32, c);
  from += unpack<std::int16_t>(from, n16, c + 4 * n32);
  unpack<std::int8_t>(from, n8, c + 4 * (n32 + n16));
  std::size_t const orders = n32 + n16 + n8;
  for (std::size_t k = 0; k < orders; ++k) c[4 * k + 3] = 0.0;
  auto const sum = chebyshevSum(c, orders, x);
  return {{unitMetres * sum.value}, {rate * sum.derivative}};
}

TableCatalogue::TableCatalogue(const std::filesystem::path& path)
    : file_(path, "ANTCHEB1", "tools/build_table_catalogue or tools/build_moon_catalogue") {
  struct Entry {
    char body[24], centre[24];
    double first, days, unit;
    std::uint32_t segments, n32, n16, n8;
    std::uint64_t offset;
  };
  static_assert(sizeof(Entry) == 96);
  for (const auto& e : file_.entries<Entry>()) {
    ChebyshevBody b;
    b.body = nameIn(e.body);
    b.centre = nameIn(e.centre);
    b.firstJulianDate = e.first;
    b.daysPerSegment = e.days;
    b.unitMetres = e.unit;
    b.segments = e.segments;
    b.n32 = e.n32;
    b.n16 = e.n16;
    b.n8 = e.n8;
    std::uint64_t const orders = std::uint64_t{e.n32} + e.n16 + e.n8;
    b.bytesPerSegment = (3 * (4 * std::size_t{e.n32} + 2 * std::size_t{e.n16} + e.n8) + 3) / 4 * 4;
    if (orders == 0 || orders > kMaxOrders || e.segments == 0 || !(e.days > 0.0) || !(e.unit > 0.0))
      throw file_.broken(fmt::format("entry {} is misshapen", b.body));
    b.data = file_.at(e.offset, b.bytesPerSegment * e.segments, b.body);
    bodies_.push_back(b);
  }
}

const ChebyshevBody& TableCatalogue::body(const std::string& name) const {
  for (const auto& b : bodies_)
    if (b.body == name) return b;
  throw InputError(fmt::format("{}: holds no table of {}", file_.name(), name));
}

}  // namespace antumbra
