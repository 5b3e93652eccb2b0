// Central line, durations and limits.
#include "eclipse/central_path.h"

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>

#include "quantity/constants.h"

namespace antumbra {
namespace {

const GeographicLib::Geodesic& geodesic() { return GeographicLib::Geodesic::WGS84(); }

Site placeAlong(const Site& from, double azimuthDegrees, double metres) {
  double latitude = 0.0, longitude = 0.0;
  geodesic().Direct(from.latitude / degree, from.longitude / degree, azimuthDegrees, metres,
                    latitude, longitude);
  return {latitude * degree, longitude * degree, 0.0 * metre};
}

// Square of the distance from the axis less that of the umbral radius: smooth in time and place,
// and zero on the umbra's edge.
double edgeFunction(const glsl::ShadowPair& pair, const glm::dvec3& point) {
  auto const place = glsl::placeInShadow(pair, point);
  double const radius = glsl::umbraRadiusAt(pair, place.along);
  return place.distance * place.distance - radius * radius;
}

// The instant near `start` when a fixed point lies deepest in the umbra, and its edge function
// then.
std::pair<double, double> deepest(const SunMoonTrack& track, const ShadowRadii& radii,
                                  const glm::dvec3& point, double start) {
  double t = start, value = 0.0;
  constexpr double kStep = 8.0;
  for (int i = 0; i < 8; ++i) {
    double const before = edgeFunction(track.shadowAt(t - kStep, radii), point);
    double const at = edgeFunction(track.shadowAt(t, radii), point);
    double const after = edgeFunction(track.shadowAt(t + kStep, radii), point);
    double const slope = 0.5 * (after - before), curvature = before - 2.0 * at + after;
    double const move = curvature > 0.0 ? std::clamp(-slope / curvature, -60.0, 60.0) : 0.0;
    value = at + slope * move + 0.5 * curvature * move * move;
    t += move * kStep;
    if (std::fabs(move) < 0.05) break;
  }
  return {t, value};
}

// Whether some of the Sun stands above the airless horizon of a place.
bool sunIsUp(const SunMoonTrack& track, const ShadowRadii& radii, const Site& place,
             double seconds) {
  auto const seen = solarAppearance(track, radii, place, seconds);
  return seen.sun.altitude / radian > -seen.sunRadius;
}

// Metres along the geodesic from the centre to where totality is just grazed; nothing where that
// would be beyond the terminator, for the cones go on through the Earth but nobody sees them.
std::optional<double> limitDistance(const SunMoonTrack& track, const ShadowRadii& radii,
                                    const Site& centre, double azimuthDegrees, double seconds,
                                    double guess) {
  double when = seconds;
  auto const grazed = [&](double metres) {
    auto const [t, value] =
        deepest(track, radii, itrsMetres(placeAlong(centre, azimuthDegrees, metres)), when);
    when = t;
    return value;
  };
  // The function grows with the square of the distance: secant steps in that square.
  double a = 0.8 * guess, b = guess, fa = grazed(a), fb = grazed(b);
  for (int i = 0; i < 40; ++i) {
    double const slope = (fb - fa) / (b * b - a * a);
    if (!(slope > 0.0)) return std::nullopt;
    double square = b * b - fb / slope;
    square = std::clamp(square, 0.04 * b * b, 25.0 * b * b);
    double const next = std::sqrt(square);
    if (next > 5e6) return std::nullopt;
    a = b, fa = fb;
    b = next;
    if (std::fabs(b - a) < 0.01) {
      if (!sunIsUp(track, radii, placeAlong(centre, azimuthDegrees, b), when)) return std::nullopt;
      return b;
    }
    fb = grazed(b);
  }
  return std::nullopt;
}

}  // namespace

double umbraDepth(const SunMoonTrack& track, const ShadowRadii& radii, const glm::dvec3& point,
                  double seconds) {
  auto const pair = track.shadowAt(seconds, radii);
  auto const place = glsl::placeInShadow(pair, point);
  return std::fabs(glsl::umbraRadiusAt(pair, place.along)) - place.distance;
}

std::optional<Site> centralPlace(const SunMoonTrack& track, const ShadowRadii& radii,
                                 double seconds) {
  auto const ground = axisOnEllipsoid(track.shadowAt(seconds, radii));
  if (!ground) return std::nullopt;
  Site place = siteOf(*ground);
  place.height = 0.0 * metre;
  return place;
}

std::optional<CentralPoint> centralPoint(const SunMoonTrack& track, const ShadowRadii& radii,
                                         double seconds) {
  auto const pair = track.shadowAt(seconds, radii);
  auto const ground = axisOnEllipsoid(pair);
  if (!ground) return std::nullopt;
  CentralPoint point;
  point.seconds = seconds;
  point.place = siteOf(*ground);
  point.place.height = 0.0 * metre;
  auto const seen = solarAppearance(track, radii, point.place, seconds);
  point.sun = seen.sun;
  point.magnitude = seen.diameterRatio();
  double const radius = glsl::umbraRadiusAt(pair, glsl::placeInShadow(pair, *ground).along);
  point.phase = radius > 0.0 ? CentralPhase::Total : CentralPhase::Annular;

  // Contacts at the fixed point: zeros of the edge function on either side of its deepest instant.
  auto const edge = [&](double t) { return edgeFunction(track.shadowAt(t, radii), *ground); };
  auto const [middle, depth] = deepest(track, radii, *ground, seconds);
  double const curvature = (edge(middle + 30.0) - 2.0 * depth + edge(middle - 30.0)) / 900.0;
  double const half = std::sqrt(std::max(-2.0 * depth / curvature, 1e-12));
  double const second = rootNear(edge, middle - half, middle - 0.98 * half);
  double const third = rootNear(edge, middle + half, middle + 0.98 * half);
  point.duration = Duration(third - second);

  // Ground track: the central points one second before and after, or on one side at the ends.
  constexpr double kStep = 1.0;
  auto const before = axisOnEllipsoid(track.shadowAt(seconds - kStep, radii));
  auto const after = axisOnEllipsoid(track.shadowAt(seconds + kStep, radii));
  if (before || after) {
    glm::dvec3 const motion = (after ? *after : *ground) - (before ? *before : *ground);
    point.trackAzimuth = horizontalOf(motion, point.place).azimuth;
    double const azimuth = point.trackAzimuth / degree;
    // The umbra's trace across the motion, as on a plane through the point.
    double const altitude = point.sun.altitude / radian;
    double const turn = (point.sun.azimuth - point.trackAzimuth) / radian;
    double const across = std::sqrt(1.0 - std::pow(std::cos(altitude) * std::sin(turn), 2.0));
    double const guess = std::max(std::fabs(radius) / std::max(across, 0.05), 1.0);
    auto const left = limitDistance(track, radii, point.place, azimuth - 90.0, seconds, guess);
    auto const right = limitDistance(track, radii, point.place, azimuth + 90.0, seconds, guess);
    if (left) point.left = placeAlong(point.place, azimuth - 90.0, *left);
    if (right) point.right = placeAlong(point.place, azimuth + 90.0, *right);
    if (left && right) point.width = Length(*left + *right);
    // Espenak & Meeus: 2 |l2'| / K, K^2 = sin^2 a + (x x' + y y')^2 / n^2 with the motion relative
    // to the rotating ground, both in the fundamental plane.
    auto const later = track.shadowAt(seconds + kStep, radii);
    glm::dvec3 const drift = *axisOnEllipsoid(pair) - pair.foot;  // along the axis
    glm::dvec3 const shadowVelocity =
        (later.foot + later.axis * glm::dot(drift, pair.axis)) - *ground;
    glm::dvec3 const velocity = shadowVelocity - pair.axis * glm::dot(shadowVelocity, pair.axis);
    double const along =
        glm::dot(pair.foot, velocity) / glm::length(velocity) / kEarthEquatorialRadius.si;
    double const sine = std::sin(altitude);
    point.canonWidth = Length(2.0 * std::fabs(radius) / std::sqrt(sine * sine + along * along));
  }
  return point;
}

std::vector<CentralPoint> centralLine(const SunMoonTrack& track, const ShadowRadii& radii,
                                      const SolarEclipse& eclipse, Duration step) {
  std::vector<CentralPoint> line;
  if (!eclipse.c1 || !eclipse.c4) return line;
  auto const tt = eclipse.c1->tt();
  double const midnight = std::floor(tt.value() - 0.5) + 0.5;
  Instant const start = Instant::fromTt({midnight, 0.0});
  double const first = std::ceil((*eclipse.c1 - start).si / step.si);
  for (double n = first;; n += 1.0) {
    Instant const t = start + n * step;
    if (t > *eclipse.c4) break;
    if (auto point = centralPoint(track, radii, track.secondsAt(t))) line.push_back(*point);
  }
  return line;
}

std::vector<Site> umbraFootprint(const SunMoonTrack& track, const ShadowRadii& radii,
                                 double seconds, int points) {
  std::vector<Site> outline;
  auto const pair = track.shadowAt(seconds, radii);
  glm::dvec3 const u = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), pair.axis));
  glm::dvec3 const v = glm::cross(pair.axis, u);
  for (int i = 0; i < points; ++i) {
    double const angle = 2.0 * M_PI * i / points;
    glm::dvec3 const outward = u * std::cos(angle) + v * std::sin(angle);
    // The flank is a straight line: from the foot's circle along the cone's generator.
    glsl::ShadowPair flank = pair;
    flank.axis = glm::normalize(pair.axis - outward * pair.umbraTangent);
    glm::dvec3 const start = pair.foot + outward * pair.umbraRadius;
    flank.foot = start - flank.axis * glm::dot(start, flank.axis);
    if (auto const ground = axisOnEllipsoid(flank)) {
      Site place = siteOf(*ground);
      place.height = 0.0 * metre;
      outline.push_back(place);
    }
  }
  return outline;
}

}  // namespace antumbra
