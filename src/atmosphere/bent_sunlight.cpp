#include "atmosphere/bent_sunlight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "atmosphere/limb_rays.h"

namespace antumbra {
namespace {

constexpr double kPi = std::numbers::pi;
// Of the table: heights even in the distance to the ground's horizon, angles in that to the top.
constexpr int kRows = 96, kColumns = 256;
constexpr int kTangents = 2;  // lowest points of rays for each row
constexpr int kSteep = 48;    // rays that meet the ground
// Rays leave where n r grows with r; slower than this they all but circle.
constexpr double kLeastGrowth = 0.1;
// Gauss-Legendre on [-1, 1] with three nodes (Abramowitz & Stegun 1972, table 25.4).
constexpr std::array<double, 3> kNode{-0.774596669241483, 0.0, 0.774596669241483};
constexpr std::array<double, 3> kWeight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

const DensityProfile* refractingDensity(const Medium& medium) {
  for (Constituent const& c : medium.constituents)
    if (c.name == medium.refractingConstituent) return &c.density;
  return nullptr;
}

double heightOfRow(double ground, double widest, double row) {
  double const across = widest * row / (kRows - 1);
  return across * across / (ground + std::sqrt(ground * ground + across * across));
}

// The medium's densities at one height.
struct Air {
  std::vector<double> densities;
  double refracting = 0.0, slope = 0.0;  // of the refracting constituent, slope in 1/m
};

// A ray from its low end to the top: where it starts and what it has met at each row above.
struct Traced {
  int firstRow = 0;
  double tangent = 0.0;        // height of its lowest point; steep rays: 0
  double lowCosine = 0.0;      // of its apparent zenith angle at the low end
  std::vector<double> cosine;  // the same by row from firstRow on
  std::vector<double> bending;
  std::vector<double> columns;  // row by row, every constituent
};

class Tracer {
 public:
  Tracer(const Medium& medium, double ground, double above, double widest)
      : medium_(medium), refracting_(*refractingDensity(medium)), ground_(ground), above_(above) {
    std::vector<double> heights;
    for (int row = 0; row < kRows; ++row) heights.push_back(heightOfRow(ground, widest, row));
    rows_ = heights;
    for (Length kink : medium.kinks())
      if (kink.si + above > 0.0 && kink.si + above < heights.back())
        heights.push_back(kink.si + above);
    std::sort(heights.begin(), heights.end());
    breaks_ = heights;
  }
  const std::vector<double>& rows() const { return rows_; }

  // From `tangent` (the ray's lowest point) or, where `cosine` is positive, from the ground.
  Traced trace(double refractivity, double tangent, double cosine) const {
    std::size_t const constituents = medium_.constituents.size();
    Traced ray;
    ray.tangent = tangent;
    ray.lowCosine = cosine;
    ray.firstRow = static_cast<int>(std::lower_bound(rows_.begin(), rows_.end(), tangent - 1e-6) -
                                    rows_.begin());
    double const low = ground_ + tangent;
    double const excess0 = refractivity * refracting_.atMetres(tangent - above_);
    double const sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    double const gone = cosine * cosine / (1.0 + sine);  // 1 - sine
    double const b = (1.0 + excess0) * low * sine;
    // n r - b near the low end is about (height + offset) times the growth of n r.
    double const offset = low * gone - tangent;
    double bending = 0.0;
    std::vector<double> columns(constituents, 0.0);
    auto const rise = [&](double height, double excess) {  // n r - b
      return (height - tangent) + (ground_ + height) * excess - low * excess0 * sine + low * gone;
    };
    double from = tangent;
    std::size_t next = static_cast<std::size_t>(ray.firstRow);
    auto const record = [&](double height) {
      double const excess = refractivity * refracting_.atMetres(height - above_);
      double const n = 1.0 + excess, r = ground_ + height;
      ray.cosine.push_back(std::sqrt(std::max(rise(height, excess), 0.0) * (n * r + b)) / (n * r));
      ray.bending.push_back(bending);
      ray.columns.insert(ray.columns.end(), columns.begin(), columns.end());
      ++next;
    };
    if (next < rows_.size() && rows_[next] <= tangent + 1e-6) record(tangent);
    for (double to : breaks_) {
      if (to <= from + 1e-6) continue;
      double const w0 = std::sqrt(std::max(from + offset, 0.0)), w1 = std::sqrt(to + offset);
      double const middle = 0.5 * (w0 + w1), half = 0.5 * (w1 - w0);
      for (std::size_t k = 0; k < kNode.size(); ++k) {
        double const w = middle + half * kNode[k];
        double const height = w * w - offset, h = height - above_;
        double const excess = refractivity * refracting_.atMetres(h);
        double const slope = h < 0.0 ? 0.0 : refractivity * refracting_.slopeAtMetres(h);
        double const n = 1.0 + excess, r = ground_ + height;
        double const root = std::sqrt(std::max(rise(height, excess), 1e-12) * (n * r + b));
        double const step = half * kWeight[k] * 2.0 * w / root;
        bending -= b * slope / n * step;
        for (std::size_t c = 0; c < constituents; ++c)
          columns[c] += medium_.constituents[c].density.atMetres(h) * n * r * step;
      }
      from = to;
      if (next < rows_.size() && to >= rows_[next] - 1e-6) record(to);
    }
    while (next < rows_.size()) record(rows_[next]);
    return ray;
  }

 private:
  const Medium& medium_;
  const DensityProfile& refracting_;
  double ground_, above_;
  std::vector<double> rows_, breaks_;
};

// Monotone cubic interpolation (Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17, 238; slopes by the
// weighted harmonic mean of Fritsch & Butland 1984).
class MonotoneCubic {
 public:
  MonotoneCubic(const std::vector<double>& x, std::vector<double> y) : x_(x), y_(std::move(y)) {
    std::size_t const n = x_.size();
    slope_.assign(n, 0.0);
    auto const secant = [&](std::size_t i) { return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]); };
    for (std::size_t i = 1; i + 1 < n; ++i) {
      double const a = secant(i - 1), c = secant(i);
      double const h0 = x_[i] - x_[i - 1], h1 = x_[i + 1] - x_[i];
      if (a * c > 0.0) slope_[i] = 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / a + (h1 + 2.0 * h0) / c);
    }
    auto const end = [&](std::size_t i, double h0, double h1, double s0, double s1) {
      double s = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
      if (s * s0 <= 0.0) s = 0.0;
      if (s0 * s1 <= 0.0 && std::fabs(s) > 3.0 * std::fabs(s0)) s = 3.0 * s0;
      slope_[i] = s;
    };
    if (n > 2) {
      end(0, x_[1] - x_[0], x_[2] - x_[1], secant(0), secant(1));
      end(n - 1, x_[n - 1] - x_[n - 2], x_[n - 2] - x_[n - 3], secant(n - 2), secant(n - 3));
    } else {
      slope_[0] = slope_[1] = secant(0);
    }
  }
  struct Value {
    double value, slope;
  };
  // `from`: a hint that ascending calls keep.
  Value at(double x, std::size_t& from) const {
    while (from + 2 < x_.size() && x_[from + 1] < x) ++from;
    double const h = x_[from + 1] - x_[from], t = std::clamp((x - x_[from]) / h, 0.0, 1.0);
    double const y0 = y_[from], y1 = y_[from + 1], s0 = slope_[from] * h, s1 = slope_[from + 1] * h;
    double const a = 2.0 * (y0 - y1) + s0 + s1, b = 3.0 * (y1 - y0) - 2.0 * s0 - s1;
    return {y0 + t * (s0 + t * (b + t * a)), (s0 + t * (2.0 * b + 3.0 * t * a)) / h};
  }

 private:
  std::vector<double> x_, y_, slope_;
};

void cubicWeights(double t, double w[4]) {
  w[0] = -t * (t - 1.0) * (t - 2.0) / 6.0;
  w[1] = (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0;
  w[2] = -(t + 1.0) * t * (t - 2.0) / 2.0;
  w[3] = (t + 1.0) * t * (t - 1.0) / 6.0;
}

// Distance to the top along a straight line that rises with `rise`; `gain`: its squared radius over
// the point's.
double distanceToTop(double rise, double gain) {
  double const root = std::sqrt(rise * rise + gain);
  return rise > 0.0 ? gain / (root + rise) : root - rise;
}

}  // namespace

bool BentSunlight::bends(const Medium& medium, Length ground) {
  auto const* density = refractingDensity(medium);
  if (!density) return false;
  double most = medium.refractivity.isConstant() ? medium.refractivity.at(550.0 * nanometre) : 0.0;
  for (double value : medium.refractivity.values()) most = std::max(most, value);
  if (!(most > 0.0)) return false;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    double const height = medium.topHeight.si * (i + 0.5) / kSteps;
    double const growth = 1.0 + most * density->atMetres(height) +
                          (ground.si + height) * most * density->slopeAtMetres(height);
    if (growth < kLeastGrowth) return false;
  }
  return true;
}

BentSunlight::BentSunlight(const Medium& medium, Length ground, Length above,
                           const std::vector<BentColour>& colours)
    : ground_(ground.si), topHeight_(medium.topHeight.si + above.si) {
  widest_ = std::sqrt(topHeight_ * (2.0 * ground_ + topHeight_));
  Tracer const tracer(medium, ground_, above.si, widest_);
  auto const& rows = tracer.rows();
  std::size_t const constituents = medium.constituents.size();
  double low = colours.front().refractivity, high = low;
  for (auto const& c : colours) {
    low = std::min(low, c.refractivity);
    high = std::max(high, c.refractivity);
  }
  // Rays at the extremes of the refractivity: what others meet lies on straight lines between.
  std::vector<double> supports{low};
  if (high > low) supports.push_back(high);
  struct Fan {
    std::vector<Traced> steep, tangent;
  };
  std::vector<Fan> fans;
  for (double refractivity : supports) {
    Fan fan;
    for (int i = 0; i < kSteep; ++i) {
      double const x = static_cast<double>(kSteep - i) / kSteep;
      fan.steep.push_back(tracer.trace(refractivity, 0.0, x * x));
    }
    for (int i = 0; i <= (kRows - 1) * kTangents; ++i)
      fan.tangent.push_back(tracer.trace(
          refractivity, heightOfRow(ground_, widest_, static_cast<double>(i) / kTangents), 0.0));
    fans.push_back(std::move(fan));
  }

  struct Sample {
    double cosine = 0.0, bending = 0.0, depth = 0.0;
  };
  for (auto const& colour : colours) {
    double const share = high > low ? (colour.refractivity - low) / (high - low) : 0.0;
    Sheet sheet;
    sheet.depth.reserve(kRows * kColumns);
    for (int row = 0; row < kRows; ++row) {
      // Toward the Sun along a ray (`up`), or back along it over its lowest point.
      auto const sampleOf = [&](auto member, std::size_t index, bool up) {
        Sample mixed;
        for (std::size_t k = 0; k < fans.size(); ++k) {
          Traced const& ray = (fans[k].*member)[index];
          double const part = fans.size() == 1 ? 1.0 : k == 0 ? 1.0 - share : share;
          auto const at = static_cast<std::size_t>(row - ray.firstRow);
          double const sense = up ? -1.0 : 1.0;
          double depth = 0.0;
          for (std::size_t c = 0; c < constituents; ++c)
            depth += colour.extinction[c] * (ray.columns[ray.columns.size() - constituents + c] +
                                             sense * ray.columns[at * constituents + c]);
          mixed.cosine += part * (up ? 1.0 : -1.0) * ray.cosine[at];
          mixed.bending += part * (ray.bending.back() + sense * ray.bending[at]);
          mixed.depth += part * depth;
        }
        return mixed;
      };
      std::vector<double> zeniths, apparents, depths;
      auto const add = [&](const Sample& s) {
        double const i = std::acos(std::clamp(s.cosine, -1.0, 1.0)), z = i + s.bending;
        if (!zeniths.empty() && z < zeniths.back() + 1e-9) return;  // another image
        zeniths.push_back(z);
        apparents.push_back(i);
        depths.push_back(std::max(s.depth, 0.0));
      };
      for (std::size_t i = 0; i < kSteep; ++i) add(sampleOf(&Fan::steep, i, true));
      int const own = row * kTangents;
      for (int i = 0; i <= own; ++i)
        add(sampleOf(&Fan::tangent, static_cast<std::size_t>(i), true));
      for (int i = own - 1; i >= 0; --i)
        add(sampleOf(&Fan::tangent, static_cast<std::size_t>(i), false));
      MonotoneCubic const apparentAt(zeniths, apparents), depthAt(zeniths, depths);
      double const height = rows[static_cast<std::size_t>(row)], r = ground_ + height;
      double const lowest = r * std::cos(zeniths.back());
      sheet.lowest.push_back(lowest);
      double const gain = (topHeight_ - height) * (2.0 * ground_ + topHeight_ + height);
      double const least = topHeight_ - height, most = distanceToTop(lowest, gain);
      double const n =
          1.0 + colour.refractivity * refractingDensity(medium)->atMetres(height - above.si);
      std::size_t hint = 0, hintDepth = 0;
      for (int column = 0; column < kColumns; ++column) {
        double const d = least + (most - least) * column / (kColumns - 1);
        double const cosine = d > 0.0 ? std::clamp((gain - d * d) / (2.0 * r * d), -1.0, 1.0) : 1.0;
        double const z = std::min(std::acos(cosine), zeniths.back());
        auto const i = apparentAt.at(z, hint);
        double const sines = z > 1e-4 && z < kPi - 1e-4 ? std::sin(i.value) / std::sin(z) : i.slope;
        double const thinning = -std::log(std::max(n * n * sines * i.slope, 1e-12));
        sheet.depth.push_back(depthAt.at(z, hintDepth).value + thinning);
        sheet.lift.push_back(z - i.value);
      }
    }
    sheets_.push_back(std::move(sheet));
  }
}

struct BentSunlight::Place {
  std::size_t corner = 0;  // of the first of four rows and columns
  double rows[4], columns[4];
  bool hidden = false;
};

BentSunlight::Place BentSunlight::placeOf(std::size_t colour, double heightMetres,
                                          double cosine) const {
  Place place;
  double const height = std::clamp(heightMetres, 0.0, topHeight_), r = ground_ + height;
  double const across = std::sqrt(height * (2.0 * ground_ + height));
  double const y = across / widest_ * (kRows - 1);
  int const row = std::clamp(static_cast<int>(y), 1, kRows - 3);
  cubicWeights(y - row, place.rows);
  auto const& lowest = sheets_[colour].lowest;
  double horizon = 0.0;
  for (int k = 0; k < 4; ++k)
    horizon += place.rows[k] * lowest[static_cast<std::size_t>(row - 1 + k)];
  double const rise = r * cosine;
  place.hidden = rise < horizon;
  double const gain = (topHeight_ - height) * (2.0 * ground_ + topHeight_ + height);
  double const least = topHeight_ - height, most = distanceToTop(horizon, gain);
  double const x =
      most > least
          ? std::clamp((distanceToTop(std::max(rise, horizon), gain) - least) / (most - least), 0.0,
                       1.0) *
                (kColumns - 1)
          : 0.0;
  int const column = std::clamp(static_cast<int>(x), 1, kColumns - 3);
  cubicWeights(x - column, place.columns);
  place.corner = static_cast<std::size_t>((row - 1) * kColumns + column - 1);
  return place;
}

double BentSunlight::read(const std::vector<double>& table, const Place& place) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    double const* row = &table[place.corner + k * kColumns];
    sum += place.rows[k] * (place.columns[0] * row[0] + place.columns[1] * row[1] +
                            place.columns[2] * row[2] + place.columns[3] * row[3]);
  }
  return sum;
}

double BentSunlight::depth(std::size_t colour, double heightMetres, double cosine) const {
  Place const place = placeOf(colour, heightMetres, cosine);
  if (place.hidden) return std::numeric_limits<double>::infinity();
  return read(sheets_[colour].depth, place);
}

double BentSunlight::lift(std::size_t colour, double heightMetres, double cosine) const {
  return read(sheets_[colour].lift, placeOf(colour, heightMetres, cosine));
}

double BentSunlight::horizonCosine(std::size_t colour, double heightMetres) const {
  Place const place = placeOf(colour, heightMetres, 1.0);
  std::size_t const row = place.corner / kColumns;
  double horizon = 0.0;
  for (std::size_t k = 0; k < 4; ++k) horizon += place.rows[k] * sheets_[colour].lowest[row + k];
  return horizon / (ground_ + std::clamp(heightMetres, 0.0, topHeight_));
}

}  // namespace antumbra
