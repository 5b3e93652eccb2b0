#include "atmosphere/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

namespace antumbra {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kBatchPaths = 256;
constexpr size_t kFirstBatches = 64, kFewestBatches = 16;
constexpr size_t kMaxConstituents = 16;
// Below this weight a path lives on with probability one half.
constexpr double kRouletteWeight = 0.02;
// Share of first vertices placed where single scattering comes from, and of directions drawn
// towards the sunward horizon where the Sun is low; the rest follow the physics, so that weights
// stay bounded.
constexpr double kGuidedVertices = 0.5, kGuidedDirections = 0.3;
// Beyond a few orders the products of the weights would spread.
constexpr int kGuidedOrders = 3;
// Of the later vertices in twilight, this share is drawn from the sunlit part of the leg alone.
constexpr double kGuidedLight = 0.5;
// Sunlight counts as gone where it has grazed air of this optical depth.
constexpr double kGrazingDepth = 3.0;
// As long, no path may leave the air: it is scattered, with the weight of its probability.
constexpr int kForcedOrders = 4;
constexpr double kGuideG = 0.6, kGuideRise = 0.15, kGuideBelowSunCosine = 0.1;

uint64_t mixed(uint64_t x) {  // splitmix64 (Steele, Lea & Flood 2014)
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// A direction at the angle of `cosine` from `axis`, turned about it by `turn` radians.
glm::dvec3 around(const glm::dvec3& axis, double cosine, double turn) {
  glm::dvec3 const x = std::abs(axis.x) < 0.6 ? glm::normalize(glm::dvec3(0.0, axis.z, -axis.y))
                                              : glm::normalize(glm::dvec3(-axis.z, 0.0, axis.x));
  glm::dvec3 const y = glm::cross(axis, x);
  double const sine = std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine)));
  return cosine * axis + sine * (std::cos(turn) * x + std::sin(turn) * y);
}

double guideDensity(double cosine) {
  double const base = 1.0 + kGuideG * kGuideG - 2.0 * kGuideG * cosine;
  return (1.0 - kGuideG * kGuideG) / (4.0 * kPi * base * std::sqrt(base));
}

}  // namespace

// xoshiro256+ (Blackman & Vigna 2018).
struct PathTracer::Random {
  uint64_t s[4];
  Random(uint64_t seed, uint64_t batch) {
    uint64_t x = mixed(seed) ^ mixed(batch + 0x632be59bd9b4e019u);
    for (auto& word : s) word = x = mixed(x);
  }
  double operator()() {
    uint64_t const result = s[0] + s[3], t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = (s[3] << 45) | (s[3] >> 19);
    return static_cast<double>(result >> 11) * 0x1p-53;
  }
};

struct PathTracer::FirstLeg {
  glm::dvec3 start, direction;
  AirRay ray;
  SpectralMedium::Span span;
  bool inAir;
  double depth = 0.0;
  std::vector<double> edges, cumulative;  // of the guide; empty: no guide

  FirstLeg(const PathTracer& tracer, const glm::dvec3& camera, const glm::dvec3& towards,
           bool guided)
      : start(camera), direction(towards), ray(camera, towards) {
    inAir = tracer.air_.spanOf(ray, span);
    if (!inAir) return;
    depth = tracer.air_.depthBetween(ray, span.enter, span.leave);
    if (!guided || !(span.leave > span.enter)) return;
    std::vector<double> cuts{span.enter, span.leave};
    for (double h : tracer.air_.breakHeights()) {
      double first, second;
      if (!ray.crossings(tracer.air_.ground() + h, first, second)) continue;
      for (double cut : {first, second})
        if (cut > span.enter && cut < span.leave) cuts.push_back(cut);
    }
    if (-ray.along > span.enter && -ray.along < span.leave) cuts.push_back(-ray.along);
    std::sort(cuts.begin(), cuts.end());
    edges.push_back(cuts[0]);
    cumulative.push_back(0.0);
    double each[kMaxConstituents];
    for (size_t i = 0; i + 1 < cuts.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        double const a = cuts[i] + (cuts[i + 1] - cuts[i]) * k / 4.0;
        double const b = cuts[i] + (cuts[i + 1] - cuts[i]) * (k + 1) / 4.0;
        if (!(b > a)) continue;
        double light = 0.0;
        for (double s : {a + 0.2 * (b - a), a + 0.8 * (b - a)}) {
          glm::dvec3 const x = start + s * direction;
          double const radius = ray.radiusAt(s);
          light += tracer.air_.scattering(ray.heightAt(s, tracer.air_.ground()), each) *
                   std::exp(-tracer.air_.depthBetween(ray, span.enter, s)) *
                   tracer.directLight(x, radius, tracer.sun_.toSun.u);
        }
        edges.push_back(b);
        cumulative.push_back(cumulative.back() + light * (b - a));
      }
    if (cumulative.back() > 0.0)
      for (double& c : cumulative) c /= cumulative.back();
    else
      edges.clear();
  }
};

PathTracer::PathTracer(const Medium& medium, const Sunlight& sun, Length wavelength,
                       Length groundRadius)
    : air_(medium, wavelength, groundRadius),
      sun_(sun),
      shadow_(sun, wavelength),
      disc_(sun.law, wavelength) {
  air_.bendSunlight();
  double low = air_.ground(), high = air_.top();
  for (int i = 0; i < 40; ++i) {
    double const middle = 0.5 * (low + high);
    (2.0 * air_.depthToTop(middle, 0.0) > kGrazingDepth ? low : high) = middle;
  }
  twilightRadius_ = low;
}

double PathTracer::directLight(const glm::dvec3& x, double radius, const glm::dvec3& toSun) const {
  double const depth = air_.depthToSun(x, radius, toSun);
  if (depth > 700.0) return 0.0;
  return std::exp(-depth) * (shadow_.empty() ? 1.0 : shadow_.visibleShare(x));
}

glm::dvec3 PathTracer::drawSun(Random& random, double& weight) const {
  weight = 1.0;
  if (sun_.discRadius == Angle(0.0)) return sun_.toSun.u;
  double const area = random();
  weight = disc_.at(std::sqrt(1.0 - area));
  return around(sun_.toSun.u, std::cos(std::sqrt(area) * (sun_.discRadius / radian)),
                2.0 * kPi * random());
}

double PathTracer::distanceAtDepth(const AirRay& ray, double enter, double leave,
                                   double depth) const {
  double const ra = ray.radiusAt(enter), ca = ray.cosineAt(enter, ra);
  double const before = air_.depthToTop(ra, std::abs(ca));
  double const rising =
      ca >= 0.0 ? before : 2.0 * air_.depthToTop(std::sqrt(ray.perigeeSquared), 0.0) - before;
  auto const depthAt = [&](double s) {
    double const r = ray.radiusAt(s), c = ray.cosineAt(s, r);
    return c >= 0.0 ? rising - air_.depthToTop(r, c) : air_.depthToTop(r, -c) - before;
  };
  double low = enter, high = leave, s = enter + 0.5 * (leave - enter);
  double const extinction = air_.extinction(ray.heightAt(enter, air_.ground()));
  if (extinction > 0.0 && depth / extinction < leave - enter) s = enter + depth / extinction;
  for (int i = 0; i < 60; ++i) {
    double const miss = depthAt(s) - depth;
    if (std::abs(miss) < 1e-6 * (1.0 + depth)) break;
    (miss > 0.0 ? high : low) = s;
    if (!(high - low > 1e-9 * (1.0 + std::abs(high)))) break;
    double const slope = air_.extinction(ray.heightAt(s, air_.ground()));
    double next = slope > 0.0 ? s - miss / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    s = next;
  }
  return s;
}

double PathTracer::sunlitFrom(const glm::dvec3& start, const glm::dvec3& direction,
                              const SpectralMedium::Span& span) const {
  glm::dvec3 const toSun = sun_.toSun.u;
  double const along = glm::dot(start, toSun), gain = glm::dot(direction, toSun);
  glm::dvec3 const p = start - along * toSun, d = direction - gain * toSun;
  double const a = glm::dot(d, d), b = glm::dot(p, d);
  double const c = glm::dot(p, p) - twilightRadius_ * twilightRadius_;
  if (c >= 0.0 || along >= 0.0 || !(a > 0.0)) return span.enter;
  // Out of the cylinder of shadow, or past the terminator's plane.
  double const out = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
  return gain > 0.0 ? std::min(out, -along / gain) : out;
}

double PathTracer::pathLight(const FirstLeg& leg, double first, Random& random,
                             int maxOrders) const {
  if (!leg.inAir) return 0.0;
  glm::dvec3 start = leg.start, direction = leg.direction;
  double weight = 1.0, light = 0.0;
  double each[kMaxConstituents];
  bool sunLow = false;  // at the last vertex
  for (int order = 1; maxOrders == 0 || order <= maxOrders; ++order) {
    AirRay const ray = order == 1 ? leg.ray : AirRay(start, direction);
    SpectralMedium::Span span = leg.span;
    if (order > 1 && !air_.spanOf(ray, span)) break;
    double const depth = order == 1 ? leg.depth : air_.depthBetween(ray, span.enter, span.leave);
    double const scattered = -std::expm1(-depth);
    double u = order == 1 ? first : random();
    bool ground = false;
    double s = span.leave;
    if (span.hitsGround) {
      // By its probability, kept away from 0 and 1 on the first leg so that both are seen.
      double passing = 1.0 - scattered;
      double const drawn = order == 1 && passing > 1e-12 ? std::clamp(passing, 0.1, 0.9) : passing;
      if (!(scattered > 0.0) || u < drawn) {
        ground = true;
        weight *= scattered > 0.0 ? passing / drawn : 1.0;
      } else {
        u = std::min((u - drawn) / (1.0 - drawn), 1.0 - 1e-16);
        weight *= scattered / (1.0 - drawn);
      }
    } else {
      if (!(scattered > 0.0)) break;
      if (order <= kForcedOrders) {
        weight *= scattered;
      } else if (u < scattered) {
        u = std::min(u / scattered, 1.0 - 1e-16);
      } else {
        break;
      }
    }
    if (!ground) {
      // From here u is uniform and the vertex has density extinction exp(-depth) / scattered.
      bool const guided = order == 1 && !leg.edges.empty();
      size_t bin = 0;
      if (guided && u < kGuidedVertices) {
        u /= kGuidedVertices;
        auto const after =
            std::upper_bound(leg.cumulative.begin() + 1, leg.cumulative.end() - 1, u);
        bin = static_cast<size_t>(after - leg.cumulative.begin());
        double const width = leg.cumulative[bin] - leg.cumulative[bin - 1];
        double const t = width > 0.0 ? (u - leg.cumulative[bin - 1]) / width : 0.5;
        s = leg.edges[bin - 1] + std::clamp(t, 0.0, 1.0) * (leg.edges[bin] - leg.edges[bin - 1]);
      } else {
        if (guided) u = (u - kGuidedVertices) / (1.0 - kGuidedVertices);
        double unlit = 0.0;  // share of the collisions before the leg comes into sunlight
        if (order > 1 && order <= kGuidedOrders + 1 && sunLow) {
          double const lit = sunlitFrom(start, direction, span);
          if (lit > span.enter && lit < span.leave)
            unlit = -std::expm1(-air_.depthBetween(ray, span.enter, lit)) / scattered;
        }
        if (unlit > 0.0 && unlit < 1.0) {
          // Mixture of all collisions and of those in the light; the weight is one over its density
          // relative to that of all.
          double const lightShare = 1.0 - unlit;
          if (u < kGuidedLight) {
            u = unlit + lightShare * (u / kGuidedLight);
          } else {
            u = (u - kGuidedLight) / (1.0 - kGuidedLight);
          }
          u = std::min(u, 1.0 - 1e-16);
          weight /= 1.0 - kGuidedLight + (u >= unlit ? kGuidedLight / lightShare : 0.0);
        }
        s = distanceAtDepth(ray, span.enter, span.leave, -std::log1p(-u * scattered));
        if (guided) {
          auto const after = std::upper_bound(leg.edges.begin() + 1, leg.edges.end() - 1, s);
          bin = static_cast<size_t>(after - leg.edges.begin());
        }
      }
      double const height = ray.heightAt(s, air_.ground());
      double const extinction = air_.extinction(height);
      double const scattering = air_.scattering(height, each);
      if (!(extinction > 0.0) || !(scattering > 0.0)) break;
      if (guided) {
        double const collision =
            extinction * std::exp(-air_.depthBetween(ray, span.enter, s)) / scattered;
        double const guide =
            (leg.cumulative[bin] - leg.cumulative[bin - 1]) / (leg.edges[bin] - leg.edges[bin - 1]);
        weight *= collision / (kGuidedVertices * guide + (1.0 - kGuidedVertices) * collision);
      }
      weight *= std::min(scattering / extinction, 1.0);
      start += s * direction;
      double const radius = ray.radiusAt(s);
      double sunWeight;
      glm::dvec3 const toSun = drawSun(random, sunWeight);
      double const sunlight = directLight(start, radius, toSun);
      if (sunlight > 0.0) {
        double phase = 0.0, cosine = glm::dot(direction, toSun);
        for (size_t c = 0; c < air_.constituents(); ++c)
          phase += each[c] * air_.phase(c).at(cosine);
        light += weight * sunWeight * sunlight * phase / scattering;
      }
      // The next direction.
      glm::dvec3 const up = start / radius;
      double const sunCosine = glm::dot(up, sun_.toSun.u);
      sunLow = sunCosine < 0.0;
      bool const low =
          order <= kGuidedOrders && sunCosine < kGuideBelowSunCosine && sunCosine > -0.9;
      glm::dvec3 guideAxis(0.0);
      if (low) guideAxis = glm::normalize(sun_.toSun.u - (sunCosine - kGuideRise) * up);
      glm::dvec3 next;
      if (low && random() < kGuidedDirections) {
        double const t = (1.0 - kGuideG * kGuideG) / (1.0 - kGuideG + 2.0 * kGuideG * random());
        double const cosine = (1.0 + kGuideG * kGuideG - t * t) / (2.0 * kGuideG);
        next = around(guideAxis, std::clamp(cosine, -1.0, 1.0), 2.0 * kPi * random());
      } else {
        double pick = random() * scattering;
        size_t c = 0;
        while (c + 1 < air_.constituents() && (pick -= each[c]) >= 0.0) ++c;
        next = around(direction, air_.phase(c).draw(random(), random()), 2.0 * kPi * random());
      }
      next = glm::normalize(next);
      double const cosine = glm::dot(direction, next);
      double phase = 0.0, drawn = 0.0;
      for (size_t c = 0; c < air_.constituents(); ++c) {
        if (!(each[c] > 0.0)) continue;
        phase += each[c] * air_.phase(c).at(cosine);
        drawn += each[c] * air_.phase(c).drawDensity(cosine);
      }
      if (low)
        drawn = (1.0 - kGuidedDirections) * drawn +
                kGuidedDirections * scattering * guideDensity(glm::dot(guideAxis, next));
      if (!(drawn > 0.0)) break;
      weight *= phase / drawn;
      direction = next;
    } else {
      if (!(air_.groundAlbedo() > 0.0)) break;
      glm::dvec3 const normal = glm::normalize(start + span.leave * direction);
      start = air_.ground() * normal;
      weight *= air_.groundAlbedo();
      double sunWeight;
      glm::dvec3 const toSun = drawSun(random, sunWeight);
      double const cosine = glm::dot(normal, air_.apparentSun(start, air_.ground(), toSun));
      if (cosine > 0.0)
        light += weight * sunWeight * cosine / kPi * directLight(start, air_.ground(), toSun);
      sunLow = cosine < 0.0;
      direction = glm::normalize(around(normal, std::sqrt(random()), 2.0 * kPi * random()));
    }
    while (weight < kRouletteWeight) {
      if (random() < 0.5) return light;
      weight *= 2.0;
    }
  }
  return light;
}

Estimate PathTracer::average(const std::function<double(Random&, double)>& path,
                             const PathTracerSettings& settings, const Progress& progress) const {
  std::vector<double> means;
  size_t const most = std::max<size_t>(
      kFewestBatches, static_cast<size_t>(settings.maxPaths / static_cast<uint64_t>(kBatchPaths)));
  size_t wanted = std::min(kFirstBatches, most);
  unsigned const threads = settings.threads > 0 ? static_cast<unsigned>(settings.threads)
                                                : std::max(1u, std::thread::hardware_concurrency());
  Estimate estimate;
  for (;;) {
    size_t const from = means.size();
    means.resize(wanted);
    std::atomic<size_t> next{from};
    auto const work = [&] {
      for (size_t batch; (batch = next++) < wanted;) {
        Random random(settings.seed, batch);
        double sum = 0.0;
        for (int i = 0; i < kBatchPaths; ++i) sum += path(random, (i + random()) / kBatchPaths);
        means[batch] = sum / kBatchPaths;
      }
    };
    std::vector<std::thread> crew;
    for (unsigned t = 1; t < threads; ++t) crew.emplace_back(work);
    work();
    for (auto& worker : crew) worker.join();

    double sum = 0.0, squares = 0.0;
    for (double m : means) sum += m;
    auto const n = static_cast<double>(means.size());
    estimate.value = sum / n;
    for (double m : means) squares += (m - estimate.value) * (m - estimate.value);
    estimate.standardError = std::sqrt(squares / (n - 1.0) / n);
    estimate.paths = means.size() * static_cast<size_t>(kBatchPaths);
    double const target = settings.relativeError * estimate.value;
    double const needed = target > 0.0 ? n * std::pow(estimate.standardError / target, 2.0) : 0.0;
    if (progress) progress(needed > n ? n / std::min(needed, static_cast<double>(most)) : 1.0);
    if (!(needed > n) || means.size() >= most) return estimate;
    double const grown = std::clamp(1.1 * needed, 1.25 * n, 4.0 * n);
    wanted = std::min(most, static_cast<size_t>(std::ceil(grown)));
  }
}

Estimate PathTracer::radiance(Position<AirFrame> camera, Direction<AirFrame> direction,
                              const PathTracerSettings& settings, const Progress& progress) const {
  FirstLeg const leg(*this, camera.m, direction.u, true);
  if (!leg.inAir) return {};
  return average([&](Random& random,
                     double first) { return pathLight(leg, first, random, settings.maxOrders); },
                 settings, progress);
}

Estimate PathTracer::diffuseIrradiance(Position<AirFrame> point, Direction<AirFrame> normal,
                                       const PathTracerSettings& settings,
                                       const Progress& progress) const {
  return average(
      [&](Random& random, double first) {
        FirstLeg const leg(*this, point.m,
                           around(normal.u, std::sqrt(1.0 - first), 2.0 * kPi * random()), false);
        return kPi * pathLight(leg, random(), random, settings.maxOrders);
      },
      settings, progress);
}

}  // namespace antumbra
