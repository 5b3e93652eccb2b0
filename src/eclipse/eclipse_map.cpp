#include "eclipse/eclipse_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "eclipse/azimuthal_map.h"

namespace antumbra {
namespace {

constexpr int kWidth = 1200, kHeight = 1340;
constexpr double kMapRadius = 560.0;
const glm::dvec2 kMapCentre(600.0, 660.0);

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
  }
}

// The baselines beside a point of a curve; those of a limit lie outside the path.
std::vector<DrawnLabels::Place> besides(glm::dvec2 point, const std::vector<glm::dvec2>& avoid) {
  std::vector<DrawnLabels::Place> places;
  glm::dvec2 outward(0.0);
  double nearest = 1e9;
  for (auto const& p : avoid)
    if (double const away = glm::length(point - p); away < nearest)
      nearest = away, outward = point - p;
  for (double const x : {6.0, -6.0})
    for (double const y : {-6.0, 16.0})
      if (avoid.empty() || (x * outward.x >= 0.0 && (y - 5.0) * outward.y >= 0.0))
        places.push_back({point + glm::dvec2(x, y),
                          x > 0.0 ? DrawnWords::Anchor::Start : DrawnWords::Anchor::End});
  return places;
}

// The name of a curve, or the magnitude it is of, beside it at the first free place along it.
void labelCurves(DrawnLabels& labels, const AzimuthalMap& map, const EclipseCurves& curves) {
  std::vector<glm::dvec2> centralLine;
  for (auto const& curve : curves.curves)
    if (curve.kind == CurveKind::CentralLine)
      for (auto const& s : curve.sites) centralLine.push_back(map.pixel(s));
  for (CurveKind const kind : {CurveKind::PenumbraLimit, CurveKind::UmbraLimit,
                               CurveKind::EqualMagnitude, CurveKind::MaximumOnHorizon}) {
    for (auto const& curve : curves.curves) {
      if (curve.kind != kind || curve.sites.size() < 12) continue;
      std::vector<DrawnLabels::Place> places;
      for (double const share : {0.5, 0.3, 0.7, 0.15, 0.85, 0.4, 0.6, 0.22, 0.78, 0.05, 0.95}) {
        auto const at =
            static_cast<std::size_t>(share * static_cast<double>(curve.sites.size() - 1));
        auto const some =
            besides(map.pixel(curve.sites[at]),
                    kind == CurveKind::UmbraLimit ? centralLine : std::vector<glm::dvec2>{});
        places.insert(places.end(), some.begin(), some.end());
      }
      labels.place(
          {.text = kind == CurveKind::EqualMagnitude ? fmt::format("{:.1f}", curve.magnitude)
                                                     : curve.name,
           .size = 11.0,
           .ink = styleOf(kind).ink,
           .halo = true},
          places);
    }
  }
}

void addMarks(Drawing& drawing, DrawnLabels& labels, const AzimuthalMap& map,
              const EclipseCurves& curves, const SolarEvent& event) {
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
      bool const written =
          labels.place({.text = time, .size = 12.0, .ink = Ink{{110, 10, 20}, 1.0}, .halo = true},
                       {{at + glm::dvec2(9.0, 20.0)},
                        {at + glm::dvec2(9.0, -12.0)},
                        {at + glm::dvec2(-9.0, -12.0), DrawnWords::Anchor::End}});
      if (written) {
        lastAt = at;
        lastShown = minutes;
      }
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

Angle reachOf(const EclipseCurves& curves, const Site& centre) {
  glm::dvec3 const c = glm::normalize(itrsMetres(centre));
  double reach = 40.0;
  for (auto const& curve : curves.curves)
    for (auto const& s : curve.sites) {
      glm::dvec3 const p = glm::normalize(itrsMetres(s));
      reach =
          std::max(reach, std::atan2(glm::length(glm::cross(c, p)), glm::dot(c, p)) * 180.0 / M_PI);
    }
  return std::min(reach + 4.0, 130.0) * degree;
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
  AzimuthalMap const map(centre, reachOf(curves, centre), kMapCentre, kMapRadius);
  DrawnLabels labels(drawing);
  DrawnShape sea;
  sea.fill = Ink{{214, 228, 238}, 1.0};
  sea.paths = {map.circle(kMapRadius)};
  drawing.shapes.push_back(std::move(sea));
  addLand(drawing, map);
  addGraticule(drawing, map);
  addCurves(drawing, map, curves);
  addMarks(drawing, labels, map, curves, event);
  labelCurves(labels, map, curves);
  labelGraticule(labels, map);
  DrawnShape rim;
  rim.line = Ink{{70, 90, 110}, 1.0};
  rim.lineWidth = 1.2;
  auto edge = map.circle(kMapRadius);
  edge.push_back(edge.front());
  rim.paths = {edge};
  rim.clipped = false;
  drawing.shapes.push_back(std::move(rim));
  addWords(drawing, event, basis);
  return drawing;
}

}  // namespace antumbra
