#include "eclipse/eclipse_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra {
namespace {

constexpr int kWidth = 1200, kHeight = 1340;
constexpr double kMapRadius = 560.0;
const glm::dvec2 kMapCentre(600.0, 660.0);

// Place on the map in polar form: `radius` in pixels from its centre, `bearing` clockwise from
// north.
struct Polar {
  double radius = 0.0, bearing = 0.0;
};

class AzimuthalMap {
 public:
  AzimuthalMap(const Site& centre, double reachDegrees)
      : latitude_(centre.latitude / radian),
        longitude_(centre.longitude / radian),
        scale_(kMapRadius / (2.0 * std::sin(0.5 * reachDegrees * M_PI / 180.0))) {}
  Polar polar(double latitudeDegrees, double longitudeDegrees) const {
    double const y = latitudeDegrees * M_PI / 180.0;
    double const x = longitudeDegrees * M_PI / 180.0 - longitude_;
    double const east = std::cos(y) * std::sin(x);
    double const north =
        std::cos(latitude_) * std::sin(y) - std::sin(latitude_) * std::cos(y) * std::cos(x);
    double const up =
        std::sin(latitude_) * std::sin(y) + std::cos(latitude_) * std::cos(y) * std::cos(x);
    double const away = std::atan2(std::hypot(east, north), up);
    return {scale_ * 2.0 * std::sin(0.5 * away), std::atan2(east, north)};
  }
  static glm::dvec2 pixel(const Polar& p) {
    return kMapCentre + p.radius * glm::dvec2(std::sin(p.bearing), -std::cos(p.bearing));
  }
  glm::dvec2 pixel(double latitudeDegrees, double longitudeDegrees) const {
    return pixel(polar(latitudeDegrees, longitudeDegrees));
  }
  glm::dvec2 pixel(const Site& s) const { return pixel(s.latitude / degree, s.longitude / degree); }
  bool shows(const Site& s) const {
    return polar(s.latitude / degree, s.longitude / degree).radius < kMapRadius;
  }

 private:
  double latitude_, longitude_, scale_;
};

using Ring = std::vector<glm::dvec2>;  // longitude, latitude in degrees

std::vector<Ring> landRings() {
  std::filesystem::path const file = catalogsFolder() / "eclipse" / "coastline.txt";
  std::ifstream in(file);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file.string()));
  std::vector<Ring> rings;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream numbers(line);
    Ring ring;
    for (double x = 0.0, y = 0.0; numbers >> x >> y;) ring.emplace_back(x / 100.0, y / 100.0);
    if (ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

// Longitudes made continuous, so that a ring may cross the antimeridian; one that goes round a pole
// is closed along it.
Ring unwrapped(const Ring& ring) {
  Ring out{ring.front()};
  for (std::size_t i = 1; i <= ring.size(); ++i) {
    glm::dvec2 const next = ring[i % ring.size()];
    out.emplace_back(out.back().x + std::remainder(next.x - out.back().x, 360.0), next.y);
  }
  if (std::fabs(out.back().x - out.front().x) > 180.0) {
    double const pole = ring.front().y < 0.0 ? -90.0 : 90.0;
    out.emplace_back(out.back().x, pole);
    out.emplace_back(out.front().x, pole);
  }
  return out;
}

bool holds(const Ring& ring, glm::dvec2 point) {
  Ring const closed = unwrapped(ring);
  bool inside = false;
  for (double const turn : {-720.0, -360.0, 0.0, 360.0, 720.0}) {
    double const x = point.x + turn;
    for (std::size_t i = 0, j = closed.size() - 1; i < closed.size(); j = i++) {
      auto const &a = closed[i], &b = closed[j];
      if ((a.y > point.y) != (b.y > point.y) &&
          x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
        inside = !inside;
    }
  }
  return inside;
}

std::vector<glm::dvec2> circle(double radius) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 180; ++i) points.push_back(AzimuthalMap::pixel({radius, M_PI * i / 90.0}));
  return points;
}

// Edges are cut to pieces of a degree. Beyond the map's edge points are drawn in to a circle
// outside it, along which the outline then runs, so that nothing crosses the map near the antipode.
std::vector<glm::dvec2> landOutline(const AzimuthalMap& map, const Ring& ring, bool& visible) {
  constexpr double kOutside = 1.1 * kMapRadius;
  std::vector<glm::dvec2> points;
  Polar last;
  bool first = true;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    auto const a = ring[i];
    auto b = ring[(i + 1) % ring.size()];
    b.x = a.x + std::remainder(b.x - a.x, 360.0);
    int const pieces = 1 + static_cast<int>(std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y)));
    for (int k = 0; k < pieces; ++k) {
      glm::dvec2 const p = a + (b - a) * (static_cast<double>(k) / pieces);
      Polar at = map.polar(p.y, p.x);
      visible = visible || at.radius < kMapRadius;
      at.radius = std::min(at.radius, kOutside);
      if (!first && last.radius == kOutside && at.radius == kOutside) {
        double const turn = std::remainder(at.bearing - last.bearing, 2.0 * M_PI);
        int const steps = static_cast<int>(std::fabs(turn) / 0.1);
        for (int s = 1; s <= steps; ++s)
          points.push_back(
              AzimuthalMap::pixel({kOutside, last.bearing + turn * s / (steps + 1.0)}));
        if (std::fabs(turn) < 0.02) continue;
      }
      points.push_back(AzimuthalMap::pixel(at));
      last = at;
      first = false;
    }
  }
  return points;
}

void addLand(Drawing& drawing, const AzimuthalMap& map, const Site& centre) {
  DrawnShape land;
  land.fill = Ink{{238, 232, 214}, 1.0};
  DrawnShape coast;
  coast.line = Ink{{120, 118, 108}, 1.0};
  coast.lineWidth = 0.7;
  glm::dvec2 antipode(centre.longitude / degree + 180.0, -(centre.latitude / degree));
  if (antipode.x > 180.0) antipode.x -= 360.0;
  bool inverted = false;
  for (auto const& ring : landRings()) {
    bool visible = false;
    auto outline = landOutline(map, ring, visible);
    bool const around = holds(ring, antipode);
    if (around) inverted = !inverted;
    if (visible || around) land.paths.push_back(std::move(outline));
    if (!visible) continue;
    std::vector<glm::dvec2> piece;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      auto const a = ring[i % ring.size()], before = ring[(i + ring.size() - 1) % ring.size()];
      // The cuts along the antimeridian and at the pole are no coast.
      bool const cut = (std::fabs(a.x) > 179.98 && std::fabs(before.x) > 179.98) ||
                       (a.y < -89.9 && before.y < -89.9);
      bool const shown = map.polar(a.y, a.x).radius < 1.05 * kMapRadius;
      if (cut || !shown) {
        if (piece.size() > 1) coast.paths.push_back(piece);
        piece.clear();
      }
      if (shown) piece.push_back(map.pixel(a.y, a.x));
    }
    if (piece.size() > 1) coast.paths.push_back(piece);
  }
  if (inverted) land.paths.push_back(circle(1.2 * kMapRadius));
  drawing.shapes.push_back(std::move(land));
  drawing.shapes.push_back(std::move(coast));
}

void addGraticule(Drawing& drawing, const AzimuthalMap& map) {
  DrawnShape lines;
  lines.line = Ink{{96, 120, 140}, 0.35};
  lines.lineWidth = 0.6;
  auto const add = [&](auto&& pointAt, int steps) {
    std::vector<glm::dvec2> piece;
    for (int i = 0; i <= steps; ++i) {
      auto const [latitude, longitude] = pointAt(i);
      Polar const p = map.polar(latitude, longitude);
      if (p.radius < 1.05 * kMapRadius) {
        piece.push_back(AzimuthalMap::pixel(p));
      } else {
        if (piece.size() > 1) lines.paths.push_back(piece);
        piece.clear();
      }
    }
    if (piece.size() > 1) lines.paths.push_back(piece);
  };
  auto const label = [&](double latitude, double longitude, const std::string& text) {
    Polar const p = map.polar(latitude, longitude);
    if (p.radius < 0.97 * kMapRadius)
      drawing.words.push_back({text, AzimuthalMap::pixel(p) + glm::dvec2(3.0, -3.0), 10.0,
                               Ink{{96, 120, 140}, 1.0}, DrawnWords::Anchor::Start, false});
  };
  for (int longitude = -180; longitude < 180; longitude += 15) {
    add([&](int i) { return std::pair(-85.0 + 2.0 * i, static_cast<double>(longitude)); }, 85);
    if (longitude % 30 == 0)
      label(0.0, longitude,
            fmt::format("{}°{}", std::abs(longitude),
                        longitude == 0 ? "" : (longitude > 0 ? "E" : "W")));
  }
  for (int latitude = -75; latitude <= 75; latitude += 15) {
    add([&](int i) { return std::pair(static_cast<double>(latitude), -180.0 + 2.0 * i); }, 180);
    if (latitude % 30 == 0 && latitude != 0)
      for (int longitude : {-90, 0, 90, 180})
        label(latitude, longitude,
              fmt::format("{}°{}", std::abs(latitude), latitude > 0 ? "N" : "S"));
  }
  drawing.shapes.push_back(std::move(lines));
}

struct CurveStyle {
  Ink ink;
  double width;
  bool dashed;
};

CurveStyle styleOf(CurveKind kind) {
  switch (kind) {
    case CurveKind::CentralLine:
      return {Ink{{170, 20, 30}, 1.0}, 1.6, false};
    case CurveKind::UmbraLimit:
      return {Ink{{30, 30, 60}, 1.0}, 1.1, false};
    case CurveKind::PenumbraLimit:
      return {Ink{{20, 90, 160}, 1.0}, 1.6, false};
    case CurveKind::EqualMagnitude:
      return {Ink{{60, 130, 190}, 1.0}, 1.0, false};
    case CurveKind::MaximumOnHorizon:
      return {Ink{{190, 120, 20}, 1.0}, 1.2, true};
    case CurveKind::BeginsOrEndsOnHorizon:
      break;
  }
  return {Ink{{190, 120, 20}, 1.0}, 1.2, false};
}

void addCurves(Drawing& drawing, const AzimuthalMap& map, const EclipseCurves& curves) {
  for (auto const& curve : curves.curves) {
    CurveStyle const style = styleOf(curve.kind);
    DrawnShape shape;
    shape.line = style.ink;
    shape.lineWidth = style.width;
    shape.dashed = style.dashed;
    std::vector<glm::dvec2> points;
    for (auto const& s : curve.sites) points.push_back(map.pixel(s));
    shape.paths.push_back(points);
    drawing.shapes.push_back(std::move(shape));
    bool const labelled =
        curve.kind == CurveKind::EqualMagnitude || curve.kind == CurveKind::PenumbraLimit ||
        curve.kind == CurveKind::UmbraLimit || curve.kind == CurveKind::MaximumOnHorizon;
    if (!labelled || curve.sites.size() < 12) continue;
    // Limits of a narrow path are labelled at different places.
    double const share = curve.kind == CurveKind::UmbraLimit ? (curve.name[0] == 'l' ? 0.3 : 0.93)
                         : curve.kind == CurveKind::MaximumOnHorizon ? 0.25
                                                                     : 0.5;
    auto const at = static_cast<std::size_t>(share * static_cast<double>(curve.sites.size() - 1));
    if (!map.shows(curve.sites[at])) continue;
    std::string const text = curve.kind == CurveKind::EqualMagnitude
                                 ? fmt::format("{:.1f}", curve.magnitude)
                                 : curve.name;
    bool const rightHalf = points[at].x > kMapCentre.x + 0.5 * kMapRadius;
    drawing.words.push_back(
        {text, points[at] + glm::dvec2(rightHalf ? -6.0 : 6.0, -6.0), 11.0, style.ink,
         rightHalf ? DrawnWords::Anchor::End : DrawnWords::Anchor::Start, true});
  }
}

void addMarks(Drawing& drawing, const AzimuthalMap& map, const EclipseCurves& curves,
              const SolarEvent& event) {
  DrawnShape shadow;
  shadow.fill = Ink{{20, 20, 40}, event.eclipse.type[0] == 'A' ? 0.35 : 0.6};
  DrawnShape ticks;
  ticks.fill = Ink{{170, 20, 30}, 1.0};
  double lastShown = -1e9;
  glm::dvec2 lastAt(-1e9);
  for (auto const& mark : curves.marks) {
    if (mark.footprint.size() > 2) {
      std::vector<glm::dvec2> outline;
      for (auto const& s : mark.footprint) outline.push_back(map.pixel(s));
      // Each footprint a shape of its own: they may overlap.
      DrawnShape one = shadow;
      one.paths = {outline};
      drawing.shapes.push_back(std::move(one));
    }
    glm::dvec2 const at = map.pixel(mark.place);
    std::vector<glm::dvec2> dot;
    for (int i = 0; i < 16; ++i)
      dot.push_back(at + 2.6 * glm::dvec2(std::cos(M_PI * i / 8.0), std::sin(M_PI * i / 8.0)));
    ticks.paths.push_back(dot);
    double const minutes = (mark.instant - event.eclipse.greatest) / minute;
    if (glm::length(at - lastAt) > 42.0 || minutes - lastShown > 59.0) {
      std::string const time = ut1Text(mark.instant, event.eclipse.deltaT).substr(11, 5);
      drawing.words.push_back({time, at + glm::dvec2(7.0, 16.0), 12.0, Ink{{110, 10, 20}, 1.0},
                               DrawnWords::Anchor::Start, true});
      lastAt = at;
      lastShown = minutes;
    }
  }
  drawing.shapes.push_back(std::move(ticks));
  // Greatest eclipse: a star of four points.
  glm::dvec2 const at = map.pixel(event.eclipse.place);
  DrawnShape star;
  star.fill = Ink{{250, 200, 40}, 1.0};
  star.line = Ink{{110, 10, 20}, 1.0};
  star.lineWidth = 0.8;
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 8; ++i) {
    double const r = i % 2 == 0 ? 9.0 : 3.0;
    points.push_back(at + r * glm::dvec2(std::sin(M_PI * i / 4.0), -std::cos(M_PI * i / 4.0)));
  }
  points.push_back(points.front());
  star.paths = {points};
  drawing.shapes.push_back(std::move(star));
}

double reachOf(const EclipseCurves& curves, const Site& centre) {
  glm::dvec3 const c = glm::normalize(itrsMetres(centre));
  double reach = 40.0;
  for (auto const& curve : curves.curves)
    for (auto const& s : curve.sites) {
      glm::dvec3 const p = glm::normalize(itrsMetres(s));
      reach =
          std::max(reach, std::atan2(glm::length(glm::cross(c, p)), glm::dot(c, p)) * 180.0 / M_PI);
    }
  return std::min(reach + 4.0, 130.0);
}

std::string nameOfType(const std::string& type) {
  std::string const kind = type[0] == 'T'   ? "Total"
                           : type[0] == 'A' ? "Annular"
                           : type[0] == 'H' ? "Hybrid"
                                            : "Partial";
  return type.size() > 1 ? kind + " (not central)" : kind;
}

void addWords(Drawing& drawing, const SolarEvent& event, const std::string& basis) {
  auto const& e = event.eclipse;
  auto const add = [&](const std::string& text, glm::dvec2 at, double size) {
    drawing.words.push_back(
        {text, at, size, Ink{{30, 34, 44}, 1.0}, DrawnWords::Anchor::Middle, false});
  };
  drawing.title = fmt::format("{} solar eclipse of {}", nameOfType(e.type), e.id);
  add(drawing.title, {0.5 * kWidth, 40.0}, 28.0);
  std::string line = fmt::format(
      "Greatest {} UT1 at {:.2f}°{} {:.2f}°{}, Sun {:.0f}° high; magnitude {:.4f}, gamma {:.4f}",
      ut1Text(e.greatest, e.deltaT).substr(11, 8), std::fabs(e.place.latitude / degree),
      e.place.latitude >= 0.0 * degree ? "N" : "S", std::fabs(e.place.longitude / degree),
      e.place.longitude >= 0.0 * degree ? "E" : "W", std::fabs(e.seen.sun.altitude / degree),
      e.magnitude, e.gamma);
  if (e.duration) {
    int const tenths = static_cast<int>(std::lround(*e.duration / second * 10.0));
    line += fmt::format("; {}m {:.1f}s", tenths / 600, (tenths % 600) / 10.0);
  }
  add(line, {0.5 * kWidth, 68.0}, 15.0);
  add(fmt::format("Saros {}; Lambert azimuthal equal-area; times UT1, delta T {:.1f} s", e.saros,
                  e.deltaT / second),
      {0.5 * kWidth, 90.0}, 13.0);
  double const y = kMapCentre.y + kMapRadius + 28.0;
  struct Entry {
    const char* text;
    CurveKind kind;
  };
  std::vector<Entry> const entries{
      {"central line", CurveKind::CentralLine},
      {"limits of the umbra", CurveKind::UmbraLimit},
      {"limit of the penumbra", CurveKind::PenumbraLimit},
      {"equal magnitude", CurveKind::EqualMagnitude},
      {"maximum at sunrise, sunset", CurveKind::MaximumOnHorizon},
      {"begins, ends at sunrise, sunset", CurveKind::BeginsOrEndsOnHorizon}};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto const& entry = entries[i];
    double const x = 130.0 + 340.0 * static_cast<double>(i % 3);
    double const row = y + 20.0 * static_cast<double>(i / 3);
    CurveStyle const style = styleOf(entry.kind);
    DrawnShape sample;
    sample.line = style.ink;
    sample.lineWidth = style.width + 0.4;
    sample.dashed = style.dashed;
    sample.clipped = false;
    sample.paths = {{{x, row - 4.0}, {x + 26.0, row - 4.0}}};
    drawing.shapes.push_back(std::move(sample));
    drawing.words.push_back({entry.text,
                             {x + 34.0, row},
                             12.0,
                             Ink{{30, 34, 44}, 1.0},
                             DrawnWords::Anchor::Start,
                             false});
  }
  // The note in lines of at most 150 characters.
  std::string note = basis;
  double noteY = y + 52.0;
  while (!note.empty()) {
    std::size_t end = note.size();
    if (end > 150) end = note.rfind(' ', 150);
    add(note.substr(0, end), {0.5 * kWidth, noteY}, 11.0);
    note = end < note.size() ? note.substr(end + 1) : "";
    noteY += 17.0;
  }
}

}  // namespace

Drawing eclipseMap(const SolarEvent& event, const EclipseCurves& curves, const std::string& basis) {
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = kHeight;
  drawing.clipCentre = kMapCentre;
  drawing.clipRadius = kMapRadius;
  Site const centre = event.eclipse.place;
  AzimuthalMap const map(centre, reachOf(curves, centre));
  DrawnShape sea;
  sea.fill = Ink{{214, 228, 238}, 1.0};
  sea.paths = {circle(kMapRadius)};
  drawing.shapes.push_back(std::move(sea));
  addLand(drawing, map, centre);
  addGraticule(drawing, map);
  addCurves(drawing, map, curves);
  addMarks(drawing, map, curves, event);
  DrawnShape rim;
  rim.line = Ink{{70, 90, 110}, 1.0};
  rim.lineWidth = 1.2;
  auto edge = circle(kMapRadius);
  edge.push_back(edge.front());
  rim.paths = {edge};
  rim.clipped = false;
  drawing.shapes.push_back(std::move(rim));
  addWords(drawing, event, basis);
  return drawing;
}

}  // namespace antumbra
