#include "plan/shadow_trial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plan/air_profile.h"

namespace antumbra {
namespace {

constexpr std::array<Length, 4> kWavelengths{440.0 * nanometre, 680.0 * nanometre,
                                             550.0 * nanometre, 550.0 * nanometre};
// Below this share of a ray's light without the shadow, errors are of this share.
constexpr double kDarkest = 1e-5;
constexpr double kRayTolerance = 2e-5;
constexpr int kEdgeTurns = 6, kAirPlaces = 96, kAirColumns = 20;
// Where the edges of a globe's shadow on its rings are measured: this far behind it, in its radii.
constexpr double kRingsBehind = 1.7;

// Two directions across an axis.
std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& axis) {
  glm::dvec3 const first = glm::normalize(
      glm::cross(axis, std::fabs(axis.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
  return {first, glm::cross(axis, first)};
}

// The radius below which `light` stays under a level, of a light that grows with the radius.
template <class Light>
double radiusOfLevel(const Light& light, double level, double most) {
  double low = 0.0, high = most;
  for (int i = 0; i < 28; ++i) {
    double const middle = 0.5 * (low + high);
    (light(middle) < level ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::vector<ShadowReceiver> shadowReceivers(const RenderPlan& plan) {
  std::vector<ShadowReceiver> found;
  for (auto const& body : plan.bodies) {
    ShadowReceiver r;
    r.name = body.name;
    r.sun = body.sun.m;
    r.bodyFromCamera = body.bodyFromCamera.matrix;
    r.camera = r.bodyFromCamera * -body.centre.m;
    r.equatorialRadius = body.equatorialRadius.si;
    r.polarRadius = body.polarRadius.si;
    if (!body.casters.empty()) {
      ShadowReceiver globe = r;
      globe.atmosphere = body.atmosphere;
      globe.casters = body.casters;
      found.push_back(std::move(globe));
    }
    if (body.rings && !body.rings->bounds.empty()) {
      r.name = "rings of " + body.name;
      r.rings = body.rings->system;
      PlannedBody::Caster caster;
      caster.name = body.name;
      caster.radii = body.rings->globe;
      caster.figure = {{0.0, 0.0, 1.0}, r.polarRadius / r.equatorialRadius};
      r.casters = {caster};
      found.push_back(std::move(r));
    }
  }
  return found;
}

ShadowTrial::ShadowTrial(const ShadowReceiver& receiver, const Projection& picture,
                         LimbDarkeningLaw law, int points)
    : receiver_(receiver), law_(law), exact_(pairs({})) {
  for (auto const& caster : receiver.casters) {
    double const radius = caster.radii.casterUmbra.si;
    opaque_.push_back(
        {caster.centre.m, caster.figure.pole, radius, radius * caster.figure.polarOverEquatorial});
  }
  findPoints(points);
  findEdges();
  if (!receiver.atmosphere.empty()) findAirRays(picture);
}

std::vector<glsl::ShadowPair> ShadowTrial::pairs(const ShadowModel& model) const {
  std::vector<glsl::ShadowPair> all;
  for (auto const& caster : receiver_.casters)
    all.push_back(shadowPairMetres(receiver_.sun, caster.centre.m, caster.radii,
                                   model.spheroid ? caster.figure : CasterFigure{}));
  return all;
}

glsl::LimbDarkening ShadowTrial::lawOf(const ShadowModel& model) const {
  return limbDarkening(model.limbDarkened ? law_ : LimbDarkeningLaw::None, kWavelengths);
}

// Of a line along the Sun's rays with the sunlit side of the receiver.
std::optional<glm::dvec3> ShadowTrial::onReceiver(const glm::dvec3& from,
                                                  const glm::dvec3& along) const {
  if (receiver_.rings) {
    glm::dvec3 const point = from - along * (from.z / along.z);
    double const radius = std::hypot(point.x, point.y);
    bool const behind = glm::dot(point, along) > 0.0;
    if (!behind || radius < receiver_.rings->inner().si || radius > receiver_.rings->outer().si)
      return std::nullopt;
    return point;
  }
  double const a = receiver_.equatorialRadius;
  glm::dvec3 const stretch(1.0, 1.0, a / receiver_.polarRadius);
  glm::dvec3 const o = from * stretch, d = along * stretch;
  double const dd = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - a * a;
  if (b * b < dd * c) return std::nullopt;
  return from + along * ((-b - std::sqrt(b * b - dd * c)) / dd);
}

void ShadowTrial::findPoints(int count) {
  int const side = std::max(
      4, static_cast<int>(std::ceil(std::sqrt(1.3 * count / static_cast<double>(exact_.size())))));
  LimbProfile const blue = limbProfile(law_, kWavelengths[0]);
  LimbProfile const red = limbProfile(law_, kWavelengths[1]);
  auto const spheres = pairs({.spheroid = false});
  auto const law = lawOf({});
  for (auto const& pair : exact_) {
    auto const [u, v] = across(pair.axis);
    glm::dvec3 const along = glm::normalize(glsl::fromCasterSpace(pair, pair.axis));
    double const reach = std::max(pair.penumbraRadius, pair.casterRadius);
    for (int i = 0; i < side; ++i)
      for (int k = 0; k < side; ++k) {
        double const x = 2.0 * (i + 0.5) / side - 1.0, y = 2.0 * (k + 0.5) / side - 1.0;
        glm::dvec3 const from = glsl::fromCasterSpace(pair, pair.foot + (u * x + v * y) * reach);
        auto const point = onReceiver(from, along);
        if (!point) continue;
        double const red1 =
            visibleLightByRays(*point, receiver_.sun, pair.sunRadius, opaque_, red, kRayTolerance);
        // Light that no model takes away is no measure of any.
        if (red1 > 0.9999 && visibleSunlight(spheres, law, *point).y > 0.9999) continue;
        points_.push_back(*point);
        light_.emplace_back(
            visibleLightByRays(*point, receiver_.sun, pair.sunRadius, opaque_, blue, kRayTolerance),
            red1);
      }
  }
}

glm::dvec3 ShadowTrial::onEdge(std::size_t caster, double turn, double radius) const {
  auto const& pair = exact_[caster];
  auto const [u, v] = across(pair.axis);
  double const along = receiver_.rings ? kRingsBehind * receiver_.equatorialRadius : 0.0;
  return glsl::fromCasterSpace(
      pair, pair.foot + pair.axis * along + (u * std::cos(turn) + v * std::sin(turn)) * radius);
}

void ShadowTrial::findEdges() {
  LimbProfile const law = limbProfile(law_, kWavelengths[2]);
  for (std::size_t caster = 0; caster < exact_.size(); ++caster)
    for (int k = 0; k < kEdgeTurns; ++k)
      for (double level : {0.5, 0.01}) {
        double const turn = 2.0 * std::numbers::pi * (k + 0.3) / kEdgeTurns;
        auto const light = [&](double radius) {
          return visibleLightByRays(onEdge(caster, turn, radius), receiver_.sun,
                                    exact_[caster].sunRadius, std::span(&opaque_[caster], 1), law,
                                    kRayTolerance);
        };
        if (light(0.0) > level) continue;  // beyond the apex, where no umbra is
        double const most =
            1.3 * std::max(exact_[caster].penumbraRadius, exact_[caster].casterRadius);
        edges_.push_back({caster, turn, level, radiusOfLevel(light, level, most)});
      }
}

void ShadowTrial::findAirRays(const Projection& picture) {
  Medium const medium = readMedium(mediumFile(receiver_.atmosphere));
  AirProfile const profile(medium, kWavelengths[2]);
  double const a = receiver_.equatorialRadius;
  glm::dvec3 const stretch(1.0, 1.0, a / receiver_.polarRadius);
  glm::dvec3 const o = receiver_.camera * stretch, sun = glm::normalize(receiver_.sun * stretch);
  auto const law = lawOf({});
  int const rows = std::max(2, kAirColumns * picture.height / picture.width);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < kAirColumns; ++column) {
      auto const seen = picture.directionAt((column + 0.5) * picture.width / kAirColumns,
                                            (row + 0.5) * picture.height / rows);
      if (!seen) continue;
      glm::dvec3 const ray = receiver_.bodyFromCamera * seen->u, d = ray * stretch;
      double const dd = glm::dot(d, d), b = glm::dot(o, d) / dd;
      auto const root = [&](double radius) {
        return b * b - (glm::dot(o, o) - radius * radius) / dd;
      };
      double const top = root(a + profile.topMetres()), ground = root(a);
      if (!(top > 0.0)) continue;
      double const first = std::max(0.0, -b - std::sqrt(top));
      bool const hits = ground > 0.0 && b < 0.0;
      double const last = hits ? -b - std::sqrt(ground) : -b + std::sqrt(top);
      if (!(last > first)) continue;
      AirRay air;
      double depth = 0.0, all = 0.0, left = 0.0, least = 1.0;
      double const step = (last - first) / kAirPlaces;
      for (int i = 0; i < kAirPlaces; ++i) {
        double const t = first + (i + 0.5) * step;
        glm::dvec3 const place = receiver_.camera + ray * t, scaled = place * stretch;
        double const r = glm::length(scaled);
        glm::dvec2 const here = profile.at(r - a) * step;
        double const weight = here.x * std::exp(-depth - 0.5 * here.y) *
                              profile.passed(std::max(r, a), glm::dot(scaled, sun) / r, a);
        depth += here.y;
        double const light = visibleSunlight(exact_, law, place).z;
        least = std::min(least, light);
        air.lit.push_back(light > 0.0);
        air.places.push_back(place);
        air.weights.push_back(weight);
        all += weight;
        left += weight * light;
      }
      if (least > 0.9999 || !(all > 0.0)) continue;
      for (double& w : air.weights) w /= all;
      air.light = left / all;
      // One factor a pixel is that of the ground, or of the camera's end of a ray to the sky.
      air.single = receiver_.camera + ray * (hits ? last : first);
      airRays_.push_back(std::move(air));
    }
}

ShadowErrors ShadowTrial::errorsOf(const ShadowModel& model) const {
  auto const mine = pairs(model);
  auto const law = lawOf(model);
  ShadowErrors errors;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    auto const found = sunlightBy(model.several, mine, law, points_[i]);
    double const off = std::max(std::fabs(found.x - light_[i].x), std::fabs(found.y - light_[i].y));
    errors.largestLight = std::max(errors.largestLight, off);
    errors.meanLight += off / static_cast<double>(points_.size());
  }
  for (auto const& edge : edges_) {
    auto const light = [&](double radius) {
      return glsl::visibleSunlight(mine[edge.caster], law, onEdge(edge.caster, edge.turn, radius))
          .z;
    };
    double const most =
        1.3 * std::max(exact_[edge.caster].penumbraRadius, exact_[edge.caster].casterRadius);
    Length const off(
        glm::length(onEdge(edge.caster, edge.turn, radiusOfLevel(light, edge.level, most)) -
                    onEdge(edge.caster, edge.turn, edge.radius)));
    auto& worst = edge.level == 0.5 ? errors.halfLightEdge : errors.umbraEdge;
    worst = std::max(worst.value_or(Length(0.0)), off);
  }
  for (auto const& ray : airRays_) {
    double light = 0.0;
    if (model.evaluations == 1) {
      light = sunlightBy(model.several, mine, law, ray.single).z;
    } else {
      // At equal shares of the light that the ray would scatter without the shadow.
      auto const counts = [&](std::size_t i) { return !model.splitAtUmbra || ray.lit[i]; };
      double all = 0.0, within = 0.0;
      for (std::size_t i = 0; i < ray.places.size(); ++i) all += counts(i) ? ray.weights[i] : 0.0;
      int next = 0;
      for (std::size_t i = 0; i < ray.places.size(); ++i) {
        if (!counts(i)) continue;
        within += ray.weights[i];
        for (; next < model.evaluations && within >= all * (next + 0.5) / model.evaluations; ++next)
          light += sunlightBy(model.several, mine, law, ray.places[i]).z * all / model.evaluations;
      }
    }
    double const off = std::fabs(light - ray.light) / std::max(ray.light, kDarkest);
    errors.largestAir = std::max(errors.largestAir.value_or(0.0), off);
    errors.meanAir = errors.meanAir.value_or(0.0) + off / static_cast<double>(airRays_.size());
  }
  return errors;
}

double ShadowTrial::evaluateAll(const ShadowModel& model) const {
  auto const mine = pairs(model);
  auto const law = lawOf(model);
  double sum = 0.0;
  for (auto const& point : points_) sum += sunlightBy(model.several, mine, law, point).x;
  return sum;
}

}  // namespace antumbra
