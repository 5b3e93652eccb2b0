// The inner loop of term_series.cpp, included once per instruction set: the includer defines the
// vector type Vec, its width kWidth and the functions load, store, splat, multiplyAdd (a b + c),
// negativeMultiplyAdd (c - a b), roundToNearest and flipSignIfOdd (value, integer-valued vector).
// No include guard on purpose.

struct Pair {
  Vec cosine, sine;
};

// pi in three parts, so that n * pi is exact to 1e-30 for the n of these theories (below 2^21).
inline Vec reduced(Vec phase, Vec n) {
  Vec r = negativeMultiplyAdd(n, splat(3.141592653589793), phase);
  return negativeMultiplyAdd(n, splat(1.2246467991473532e-16), r);
}

// Interpolation at Chebyshev nodes in x = r^2 over [0, (pi/2)^2], solved in 60 digits.
inline Vec cosineOf(Vec x) {
  Vec p = splat(4.608305950216779e-14);
  p = multiplyAdd(p, x, splat(-1.1462839679820625e-11));
  p = multiplyAdd(p, x, splat(2.087655950649352e-09));
  p = multiplyAdd(p, x, splat(-2.755731634569081e-07));
  p = multiplyAdd(p, x, splat(2.4801587276929864e-05));
  p = multiplyAdd(p, x, splat(-0.001388888888877019));
  p = multiplyAdd(p, x, splat(0.041666666666663806));
  p = multiplyAdd(p, x, splat(-0.4999999999999997));
  return multiplyAdd(p, x, splat(1.0));
}
inline Vec sineOf(Vec r, Vec x) {
  Vec p = splat(-7.373314011498657e-13);
  p = multiplyAdd(p, x, splat(1.6048082049869003e-10));
  p = multiplyAdd(p, x, splat(-2.50518792391943e-08));
  p = multiplyAdd(p, x, splat(2.755731656722859e-06));
  p = multiplyAdd(p, x, splat(-0.0001984126982453264));
  p = multiplyAdd(p, x, splat(0.008333333333281534));
  p = multiplyAdd(p, x, splat(-0.16666666666666055));
  p = multiplyAdd(p, x, splat(0.9999999999999999));
  return p * r;
}

template <int kPhases, bool kWithRate>
inline void sumRange(const TermBlock& block, const double* amplitudes, std::size_t begin,
                     std::size_t end, double t, Vec& value, Vec& rate) {
  const double* const a = block.columns;
  std::size_t const s = block.stride;
  Vec const time = splat(t);
  for (std::size_t i = begin; i < end; i += kWidth) {
    Vec phase = load(a + s * kPhases + i);
    Vec phaseRate = phase;
    if constexpr (kWithRate && kPhases == 5) {
      phaseRate = phase * splat(4.0);
      phaseRate = multiplyAdd(phaseRate, time, load(a + s * 4 + i) * splat(3.0));
      phaseRate = multiplyAdd(phaseRate, time, load(a + s * 3 + i) * splat(2.0));
      phaseRate = multiplyAdd(phaseRate, time, load(a + s * 2 + i));
    }
    for (int k = kPhases - 1; k >= 1; --k)
      phase = multiplyAdd(phase, time, load(a + s * static_cast<std::size_t>(k) + i));
    Vec const n = roundToNearest(phase * splat(0.3183098861837907));
    Vec const r = reduced(phase, n);
    Vec const x = r * r;
    Vec const amplitude = flipSignIfOdd(load(amplitudes + (i - begin)), n);
    value = multiplyAdd(amplitude, cosineOf(x), value);
    if constexpr (kWithRate) rate = negativeMultiplyAdd(amplitude * phaseRate, sineOf(r, x), rate);
  }
}

template <int kPhases, bool kWithRate>
inline SeriesValue sumBlock(const TermBlock& block, double t) {
  std::size_t const whole = block.terms / kWidth * kWidth;
  Vec value = splat(0.0), rate = splat(0.0);
  sumRange<kPhases, kWithRate>(block, block.columns, 0, whole, t, value, rate);
  double v[kWidth], w[kWidth];
  if (whole < block.terms) {
    // A truncated series ends within a vector: the rest of it counts with amplitude zero.
    for (std::size_t k = 0; k < kWidth; ++k)
      v[k] = whole + k < block.terms ? block.columns[whole + k] : 0.0;
    sumRange<kPhases, kWithRate>(block, v, whole, whole + kWidth, t, value, rate);
  }
  store(v, value);
  store(w, rate);
  SeriesValue sum;
  for (std::size_t k = 0; k < kWidth; ++k) {
    sum.value += v[k];
    sum.rate += w[k];
  }
  return sum;
}

template <bool kWithRate>
SeriesValue sumBlockAny(const TermBlock& block, double t) {
  return block.phases == 2 ? sumBlock<2, kWithRate>(block, t) : sumBlock<5, kWithRate>(block, t);
}
