#include "ephemeris/term_series.h"

#include <fmt/format.h>
#include <immintrin.h>
#include <cmath>
#include <cstring>

#include "document/input_error.h"

// GCC 12's own AVX-512 header trips this warning (GCC bug 105593); nothing below relies on it.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

namespace antumbra {

namespace plain {
using Vec = double;
constexpr std::size_t kWidth = 1;
inline Vec load(const double* p) { return *p; }
inline void store(double* p, Vec v) { *p = v; }
inline Vec splat(double v) { return v; }
inline Vec multiplyAdd(Vec a, Vec b, Vec c) { return a * b + c; }
// Exact products by Veltkamp's split would be needed here without FMA; std::fma keeps it simple.
inline Vec negativeMultiplyAdd(Vec a, Vec b, Vec c) { return std::fma(-a, b, c); }
inline Vec roundToNearest(Vec v) { return std::nearbyint(v); }
inline Vec flipSignIfOdd(Vec v, Vec n) { return static_cast<long>(n) & 1 ? -v : v; }
#include "ephemeris/term_series_kernel.h"
}  // namespace plain

#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace avx2 {
using Vec = __m256d;
constexpr std::size_t kWidth = 4;
inline Vec load(const double* p) { return _mm256_loadu_pd(p); }
inline void store(double* p, Vec v) { _mm256_storeu_pd(p, v); }
inline Vec splat(double v) { return _mm256_set1_pd(v); }
inline Vec multiplyAdd(Vec a, Vec b, Vec c) { return _mm256_fmadd_pd(a, b, c); }
inline Vec negativeMultiplyAdd(Vec a, Vec b, Vec c) { return _mm256_fnmadd_pd(a, b, c); }
inline Vec roundToNearest(Vec v) {
  return _mm256_round_pd(v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
// Adding 1.5 * 2^52 leaves the integer in the low bits; its lowest bit becomes the sign.
inline Vec flipSignIfOdd(Vec v, Vec n) {
  __m256i const bits = _mm256_castpd_si256(_mm256_add_pd(n, splat(6755399441055744.0)));
  return _mm256_xor_pd(v, _mm256_castsi256_pd(_mm256_slli_epi64(bits, 63)));
}
#include "ephemeris/term_series_kernel.h"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx2,fma")
namespace avx512 {
using Vec = __m512d;
constexpr std::size_t kWidth = 8;
inline Vec load(const double* p) { return _mm512_loadu_pd(p); }
inline void store(double* p, Vec v) { _mm512_storeu_pd(p, v); }
inline Vec splat(double v) { return _mm512_set1_pd(v); }
inline Vec multiplyAdd(Vec a, Vec b, Vec c) { return _mm512_fmadd_pd(a, b, c); }
inline Vec negativeMultiplyAdd(Vec a, Vec b, Vec c) { return _mm512_fnmadd_pd(a, b, c); }
inline Vec roundToNearest(Vec v) {
  return _mm512_roundscale_pd(v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
inline Vec flipSignIfOdd(Vec v, Vec n) {
  __m512i const bits = _mm512_castpd_si512(_mm512_add_pd(n, splat(6755399441055744.0)));
  return _mm512_xor_pd(v, _mm512_castsi512_pd(_mm512_slli_epi64(bits, 63)));
}
#include "ephemeris/term_series_kernel.h"
}  // namespace avx512
#pragma GCC pop_options

namespace {

template <bool kWithRate>
SeriesValue sumOn(VectorUnit unit, const TermBlock& block, double t) {
  switch (unit) {
    case VectorUnit::Avx512:
      return avx512::sumBlockAny<kWithRate>(block, t);
    case VectorUnit::Avx2:
      return avx2::sumBlockAny<kWithRate>(block, t);
    case VectorUnit::Plain:
      break;
  }
  return plain::sumBlockAny<kWithRate>(block, t);
}

// sum_n t^n S_n and its derivative.
template <class Sum>
SeriesValue combine(const TermSeries& series, double t, Sum sum) {
  SeriesValue total;
  for (const auto& block : series.blocks) {
    auto const s = sum(block);
    double power = 1.0, powerBelow = 0.0;  // t^n, t^(n-1)
    for (std::uint32_t k = 0; k < block.power; ++k) {
      powerBelow = power;
      power *= t;
    }
    total.value += power * s.value;
    total.rate += power * s.rate + block.power * powerBelow * s.value;
  }
  return total;
}

SeriesValue libmBlock(const TermBlock& b, double t, bool withRate) {
  SeriesValue sum;
  for (std::uint32_t i = 0; i < b.terms; ++i) {
    double phase = 0.0, rate = 0.0;
    for (std::uint32_t k = b.phases; k >= 1; --k) {
      rate = rate * t + phase;
      phase = phase * t + b.columns[b.stride * k + i];
    }
    sum.value += b.columns[i] * std::cos(phase);
    if (withRate) sum.rate -= b.columns[i] * rate * std::sin(phase);
  }
  return sum;
}

}  // namespace

std::size_t TermSeries::terms() const {
  std::size_t n = 0;
  for (const auto& b : blocks) n += b.terms;
  return n;
}

double TermSeries::truncate(double threshold, double tMax) {
  double dropped = 0.0;
  for (auto& b : blocks) {
    double const scale = std::pow(std::fabs(tMax), b.power);
    std::uint32_t keep = 0;
    while (keep < b.terms && std::fabs(b.columns[keep]) * scale >= threshold) ++keep;
    for (std::uint32_t i = keep; i < b.terms; ++i) dropped += std::fabs(b.columns[i]) * scale;
    b.terms = keep;
  }
  std::erase_if(blocks, [](const TermBlock& b) { return b.terms == 0; });
  return dropped;
}

VectorUnit bestVectorUnit() {
  static const VectorUnit best =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? VectorUnit::Avx512
      : __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")       ? VectorUnit::Avx2
                                                                              : VectorUnit::Plain;
  return best;
}

std::string nameOf(VectorUnit unit) {
  return unit == VectorUnit::Avx512 ? "AVX-512" : unit == VectorUnit::Avx2 ? "AVX2" : "plain";
}

SeriesValue evaluateOn(VectorUnit unit, const TermSeries& series, double t) {
  return combine(series, t, [&](const TermBlock& b) { return sumOn<true>(unit, b, t); });
}
double valueOn(VectorUnit unit, const TermSeries& series, double t) {
  return combine(series, t, [&](const TermBlock& b) { return sumOn<false>(unit, b, t); }).value;
}
SeriesValue TermSeries::evaluate(double t) const { return evaluateOn(bestVectorUnit(), *this, t); }
double TermSeries::value(double t) const { return valueOn(bestVectorUnit(), *this, t); }

SeriesValue evaluateByLibm(const TermSeries& series, double t) {
  return combine(series, t, [&](const TermBlock& b) { return libmBlock(b, t, true); });
}
double valueByLibm(const TermSeries& series, double t) {
  return combine(series, t, [&](const TermBlock& b) { return libmBlock(b, t, false); }).value;
}

SeriesCatalogue::SeriesCatalogue(const std::filesystem::path& path)
    : file_(path, "ANTSERI1", "tools/build_series_catalogue") {
  struct Entry {
    char body[16];
    char variable[8];
    std::uint32_t power, phases, terms, stride;
    std::uint64_t offset;
  };
  static_assert(sizeof(Entry) == 48);
  for (const auto& e : file_.entries<Entry>()) {
    auto const body = nameIn(e.body), variable = nameIn(e.variable);
    auto const which = fmt::format("{} {}", body, variable);
    if (e.terms > e.stride || e.stride % 8 != 0 || e.offset % 8 != 0 ||
        (e.phases != 1 && e.phases != 2 && e.phases != 5))
      throw file_.broken(fmt::format("entry {} is misshapen", which));
    const std::byte* const data =
        file_.at(e.offset, std::uint64_t{e.stride} * (e.phases + 1) * sizeof(double), which);
    series_[{body, variable}].blocks.push_back(
        {reinterpret_cast<const double*>(data), e.stride, e.phases, e.power, e.terms});
  }
}

const TermSeries& SeriesCatalogue::series(const std::string& body,
                                          const std::string& variable) const {
  auto const found = series_.find({body, variable});
  if (found == series_.end())
    throw InputError(fmt::format("{}: holds no series {} of {}", file_.name(), variable, body));
  return found->second;
}

}  // namespace antumbra
