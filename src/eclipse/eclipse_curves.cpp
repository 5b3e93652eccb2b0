// Contours of local circumstances by marching squares, and the central line.
#include "eclipse/eclipse_curves.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "eclipse/local_circumstances.h"

namespace antumbra {
namespace {

// What the contours follow at one place; altitudes in degrees.
struct Node {
  double magnitude = -1.0;  // covered part of the diameter at maximum, negative outside
  double altitudeAtMaximum = 0.0, altitudeAtFirst = 0.0, altitudeAtLast = 0.0;
};

Node nodeAt(const SolarEvent& event, const ShadowRadii& radii, double latitude, double longitude) {
  Site const site{latitude * degree, longitude * degree, 0.0 * metre};
  auto const& track = event.track;
  double const limit = track.halfSpan() / second;
  double const t = std::clamp(
      localMaximumSeconds(track, radii, itrsMetres(site), track.secondsAt(event.eclipse.greatest)),
      -limit, limit);
  auto const seen = solarAppearance(track, radii, site, t);
  Node node;
  node.magnitude = seen.coveredDiameter();
  node.altitudeAtMaximum = node.altitudeAtFirst = node.altitudeAtLast = seen.sun.altitude / degree;
  if (node.magnitude > 0.0) {
    auto const local = localCircumstances(event, radii, site);
    if (local.c1 && local.c4) {
      node.altitudeAtFirst = local.c1->sun.altitude / degree;
      node.altitudeAtLast = local.c4->sun.altitude / degree;
    }
  }
  return node;
}

class Contours {
 public:
  using Value = std::function<double(const Node&)>;
  using Keep = std::function<bool(const Node&)>;

  Contours(const SolarEvent& event, const ShadowRadii& radii, double step)
      : event_(event),
        radii_(radii),
        columns_(static_cast<int>(std::lround(360.0 / step)) + 1),
        rows_(static_cast<int>(std::lround(180.0 / step)) + 1),
        step_(step) {
    nodes_.reserve(static_cast<std::size_t>(columns_ * rows_));
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        nodes_.push_back(nodeAt(event, radii, latitude(row), longitude(column)));
  }

  // Chains of places where `value` is zero, where `keep` holds.
  std::vector<std::vector<Site>> zeros(const Value& value, const Keep& keep) const {
    std::map<long, std::vector<long>> neighbours;
    std::map<long, Site> places;
    for (int row = 0; row + 1 < rows_; ++row) {
      for (int column = 0; column + 1 < columns_; ++column) {
        // Corners anticlockwise, and the edges after each.
        std::array<std::pair<int, int>, 4> const corners{
            {{row, column}, {row, column + 1}, {row + 1, column + 1}, {row + 1, column}}};
        std::vector<long> crossed;
        for (std::size_t i = 0; i < 4; ++i) {
          auto const a = corners[i], b = corners[(i + 1) % 4];
          double const va = value(node(a)), vb = value(node(b));
          if ((va > 0.0) == (vb > 0.0)) continue;
          long const edge = edgeBetween(a, b);
          if (!places.count(edge)) {
            auto const found = crossing(a, b, va, vb, value);
            if (!keep(found.second)) continue;
            places[edge] = found.first;
          }
          crossed.push_back(edge);
        }
        for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
          neighbours[crossed[i]].push_back(crossed[i + 1]);
          neighbours[crossed[i + 1]].push_back(crossed[i]);
        }
      }
    }
    return chained(neighbours, places);
  }

 private:
  double latitude(int row) const { return -90.0 + row * step_; }
  double longitude(int column) const { return -180.0 + column * step_; }
  const Node& node(std::pair<int, int> at) const {
    return nodes_[static_cast<std::size_t>(at.first * columns_ + at.second)];
  }
  long edgeBetween(std::pair<int, int> a, std::pair<int, int> b) const {
    auto const first = std::min(a, b);
    return 2 * (static_cast<long>(first.first) * columns_ + first.second) +
           (a.first == b.first ? 0 : 1);
  }
  // Two steps of the rule of false position with exact circumstances.
  std::pair<Site, Node> crossing(std::pair<int, int> a, std::pair<int, int> b, double va, double vb,
                                 const Value& value) const {
    double from = 0.0, to = 1.0;
    Node found;
    double share = 0.5;
    auto const placeAt = [&](double s) {
      return std::pair(latitude(a.first) + s * (latitude(b.first) - latitude(a.first)),
                       longitude(a.second) + s * (longitude(b.second) - longitude(a.second)));
    };
    for (int i = 0; i < 2; ++i) {
      share = from + (to - from) * va / (va - vb);
      auto const [y, x] = placeAt(share);
      found = nodeAt(event_, radii_, y, x);
      double const v = value(found);
      if ((v > 0.0) == (va > 0.0)) {
        from = share;
        va = v;
      } else {
        to = share;
        vb = v;
      }
    }
    auto const [y, x] = placeAt(from + (to - from) * (va == vb ? 0.0 : va / (va - vb)));
    return {Site{y * degree, x * degree, 0.0 * metre}, found};
  }
  static std::vector<std::vector<Site>> chained(std::map<long, std::vector<long>>& neighbours,
                                                const std::map<long, Site>& places) {
    std::vector<std::vector<Site>> chains;
    auto const follow = [&](long start) {
      std::vector<Site> chain{places.at(start)};
      long at = start;
      while (!neighbours[at].empty()) {
        long const next = neighbours[at].back();
        neighbours[at].pop_back();
        std::erase(neighbours[next], at);
        chain.push_back(places.at(next));
        at = next;
      }
      if (chain.size() > 1) chains.push_back(std::move(chain));
    };
    for (auto const& [edge, site] : places)
      if (neighbours[edge].size() == 1) follow(edge);
    for (auto const& [edge, site] : places)
      while (!neighbours[edge].empty()) follow(edge);
    return chains;
  }

  const SolarEvent& event_;
  ShadowRadii radii_;
  int columns_, rows_;
  double step_;
  std::vector<Node> nodes_;
};

}  // namespace

EclipseCurves eclipseCurves(const SolarEvent& event, const ShadowRadii& radii, Angle gridStep) {
  EclipseCurves all;
  Contours const contours(event, radii, gridStep / degree);
  auto const addAll = [&](CurveKind kind, const std::string& name, double magnitude,
                          const Contours::Value& value, const Contours::Keep& keep) {
    for (auto& sites : contours.zeros(value, keep))
      all.curves.push_back({kind, name, magnitude, std::move(sites)});
  };
  auto const up = [](const Node& n) { return n.altitudeAtMaximum > -0.3; };
  for (double level : {0.2, 0.4, 0.6, 0.8})
    addAll(
        CurveKind::EqualMagnitude, fmt::format("magnitude {:.1f}", level), level,
        [level](const Node& n) { return n.magnitude - level; }, up);
  addAll(
      CurveKind::PenumbraLimit, "limit of the penumbra", 0.0,
      [](const Node& n) { return n.magnitude; }, up);
  auto const eclipsed = [](const Node& n) { return n.magnitude > -0.02; };
  addAll(
      CurveKind::MaximumOnHorizon, "maximum at sunrise or sunset", 0.0,
      [](const Node& n) { return n.altitudeAtMaximum; }, eclipsed);
  addAll(
      CurveKind::BeginsOrEndsOnHorizon, "first contact at sunrise or sunset", 0.0,
      [](const Node& n) { return n.altitudeAtFirst; }, eclipsed);
  addAll(
      CurveKind::BeginsOrEndsOnHorizon, "last contact at sunrise or sunset", 0.0,
      [](const Node& n) { return n.altitudeAtLast; }, eclipsed);

  for (auto& curve : centralCurves(event, radii)) all.curves.push_back(std::move(curve));
  all.marks = timeMarks(event, radii, 600.0 * second);
  return all;
}

std::vector<GlobeCurve> centralCurves(const SolarEvent& event, const ShadowRadii& radii) {
  auto const& eclipse = event.eclipse;
  if (!eclipse.c1 || !eclipse.c4) return {};
  GlobeCurve centre{CurveKind::CentralLine, "central line", 0.0, {}};
  bool const annular = eclipse.type[0] == 'A';
  std::string const what = annular ? "annularity" : (eclipse.type[0] == 'H' ? "umbra" : "totality");
  GlobeCurve left{CurveKind::UmbraLimit, "left limit of " + what, 0.0, {}};
  GlobeCurve right{CurveKind::UmbraLimit, "right limit of " + what, 0.0, {}};
  double const first = event.track.secondsAt(*eclipse.c1) + 0.01;
  double const last = event.track.secondsAt(*eclipse.c4) - 0.01;
  constexpr int kSteps = 400;
  for (int i = 0; i <= kSteps; ++i) {
    // Closer together at both ends, where the shadow runs fastest.
    double const share = 0.5 - 0.5 * std::cos(M_PI * i / kSteps);
    auto const point = centralPoint(event.track, radii, first + share * (last - first));
    if (!point) continue;
    centre.sites.push_back(point->place);
    if (point->left) left.sites.push_back(*point->left);
    if (point->right) right.sites.push_back(*point->right);
  }
  std::vector<GlobeCurve> curves;
  for (auto* curve : {&centre, &left, &right})
    if (curve->sites.size() > 1) curves.push_back(std::move(*curve));
  return curves;
}

std::vector<TimeMark> timeMarks(const SolarEvent& event, const ShadowRadii& radii,
                                Duration interval) {
  auto const& eclipse = event.eclipse;
  std::vector<TimeMark> marks;
  if (!eclipse.c1 || !eclipse.c4) return marks;
  DeltaT const deltaT = DeltaT::fixed(eclipse.deltaT);
  auto const ut = eclipse.c1->ut1(deltaT);
  double const dayStart = std::floor(ut.whole + ut.fraction - 0.5) + 0.5;
  Instant const midnight = Instant::fromUt1({dayStart, 0.0}, deltaT);
  for (double n = std::ceil((*eclipse.c1 - midnight) / interval);; n += 1.0) {
    Instant const t = midnight + n * interval;
    if (t > *eclipse.c4) break;
    double const seconds = event.track.secondsAt(t);
    if (auto const place = centralPlace(event.track, radii, seconds))
      marks.push_back({t, *place, umbraFootprint(event.track, radii, seconds, 60)});
  }
  return marks;
}

}  // namespace antumbra
