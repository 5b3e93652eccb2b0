#include "plan/curve_overlay.h"

#include <fmt/format.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <set>

#include "eclipse/drawn_labels.h"
#include "plan/clock_face.h"

namespace antumbra {
namespace {

struct CurveStyle {
  const char* name;
  Ink ink;
  double width;  // of the central line's
  bool dashed;
};

CurveStyle styleOf(CurveKind kind) {
  switch (kind) {
    case CurveKind::CentralLine:
      return {"central line", {{255, 92, 74}, 1.0}, 1.0, false};
    case CurveKind::UmbraLimit:
      return {"limits of the umbra", {{255, 226, 160}, 1.0}, 0.8, false};
    case CurveKind::PenumbraLimit:
      return {"limit of the penumbra", {{126, 200, 255}, 1.0}, 0.9, false};
    case CurveKind::EqualMagnitude:
      return {"equal magnitude", {{206, 230, 255}, 1.0}, 0.7, false};
    case CurveKind::MaximumOnHorizon:
      return {"maximum at sunrise, sunset", {{255, 190, 92}, 0.95}, 0.75, true};
    case CurveKind::BeginsOrEndsOnHorizon:
      break;
  }
  return {"begins, ends at sunrise, sunset", {{255, 190, 92}, 0.95}, 0.65, false};
}

constexpr Ink kWhite{{255, 255, 255}, 1.0};
constexpr Ink kCasing{{6, 8, 16}, 0.4};
constexpr Ink kFootprint{{255, 255, 255}, 0.95};
constexpr Ink kIsoline{{255, 230, 120}, 1.0};  // of the illustrative look

bool wanted(const OverlaySettings& overlays, CurveKind kind) {
  switch (kind) {
    case CurveKind::CentralLine:
      return overlays.centralLine;
    case CurveKind::UmbraLimit:
      return overlays.limits;
    case CurveKind::PenumbraLimit:
      return overlays.penumbraLimits;
    case CurveKind::EqualMagnitude:
      return overlays.isolines;
    case CurveKind::MaximumOnHorizon:
    case CurveKind::BeginsOrEndsOnHorizon:
      break;
  }
  return overlays.horizonCurves;
}

class Composer {
 public:
  Composer(const Scene& scene, const EclipseAtHand& eclipse, Instant when,
           const SurfaceLines& earth, double textSize)
      : overlays_(scene.overlays),
        eclipse_(eclipse),
        seconds_(eclipse.event.track.secondsAt(when)),
        earth_(earth),
        size_(textSize),
        labels_(result_.drawing) {
    auto& drawing = result_.drawing;
    drawing.width = scene.picture.width;
    drawing.height = scene.picture.height;
    if (scene.picture.kind == ProjectionKind::Fisheye) {
      drawing.clipCentre = {0.5 * drawing.width, 0.5 * drawing.height};
      drawing.clipRadius = 0.5 * drawing.width;
    }
    if (scene.overlays.clock) {
      auto const [low, high] = clockPanel(scene.picture, textSize);
      labels_.keepFree(low, high);
    }
  }

  CurveOverlay compose() {
    std::vector<DrawnShape> lines;
    for (auto const& curve : eclipse_.curves.curves)
      if (wanted(overlays_, curve.kind)) addCurve(curve, lines);
    addFootprint(lines);
    auto& shapes = result_.drawing.shapes;
    for (auto const& line : lines) {
      DrawnShape casing = line;
      casing.line = kCasing;
      casing.lineWidth = line.lineWidth + 1.6;
      casing.dashed = false;
      shapes.push_back(std::move(casing));
    }
    shapes.insert(shapes.end(), lines.begin(), lines.end());
    addTimeMarks();
    if (overlays_.obscurationLabels) addObscurationLabels();
    for (auto const& [words, places] : curveLabels_) labels_.place(words, places);
    if (overlays_.legend) addLegend();
    return std::move(result_);
  }

 private:
  DrawnShape lineOf(std::vector<std::vector<glm::dvec2>> paths, const Ink& ink, double width,
                    bool dashed) const {
    DrawnShape shape;
    shape.paths = std::move(paths);
    shape.line = ink;
    shape.lineWidth = std::max(width * overlays_.lineWidth, 0.8);
    shape.dashed = dashed;
    shape.clipped = false;
    return shape;
  }

  void addCurve(const GlobeCurve& curve, std::vector<DrawnShape>& lines) {
    ++result_.curves;
    // The central line and its limits are exact at every point; contours are chords of a grid.
    bool const smooth = curve.kind == CurveKind::CentralLine || curve.kind == CurveKind::UmbraLimit;
    auto paths = earth_.shown(earth_.curveOf(curve.sites, smooth));
    if (paths.empty()) return;
    ++result_.shown;
    CurveStyle const style = styleOf(curve.kind);
    if (curve.kind == CurveKind::EqualMagnitude)
      addLabelOn(paths, fmt::format("{:.1f}", curve.magnitude), style.ink);
    lines.push_back(lineOf(std::move(paths), style.ink, style.width, style.dashed));
    shownKinds_.insert(curve.kind);
  }

  // As near to the picture's middle as there is room.
  void addLabelOn(const std::vector<std::vector<glm::dvec2>>& paths, const std::string& text,
                  const Ink& ink) {
    DrawnWords const words = wordsOf(text, 0.85 * size_, ink);
    glm::dvec2 const middle(0.5 * result_.drawing.width, 0.5 * result_.drawing.height);
    auto const off = [&](const DrawnLabels::Place& p) {
      glm::dvec2 const apart = glm::abs(p.at - middle) / middle;
      return std::max(apart.x, apart.y);
    };
    std::vector<DrawnLabels::Place> places;
    for (auto const& path : paths)
      for (auto const& p : path)
        places.push_back({p + glm::dvec2(0.0, 0.36 * words.size), DrawnWords::Anchor::Middle});
    std::ranges::sort(places, {}, off);
    curveLabels_.emplace_back(words, std::move(places));
  }

  static DrawnWords wordsOf(const std::string& text, double size, const Ink& ink) {
    DrawnWords words;
    words.text = text;
    words.size = size;
    words.ink = ink;
    words.halo = true;
    return words;
  }

  void addFootprint(std::vector<DrawnShape>& lines) {
    auto const& track = eclipse_.event.track;
    if (!overlays_.footprint || std::fabs(seconds_) > track.halfSpan() / second) return;
    auto sites = umbraFootprint(track, eclipse_.radii, seconds_, 240);
    if (sites.size() < 3) return;
    ++result_.curves;
    sites.push_back(sites.front());
    auto paths = earth_.shown(earth_.curveOf(sites, true));
    if (paths.empty()) return;
    ++result_.shown;
    lines.push_back(lineOf(std::move(paths), kFootprint, 0.8, false));
  }

  // Across the line, from the point of `mark`; nothing where the picture does not show it.
  std::optional<glm::dvec2> acrossLine(const TimeMark& mark) const {
    auto const& track = eclipse_.event.track;
    double const at = track.secondsAt(mark.instant);
    std::optional<glm::dvec2> ends[2];
    for (int i = 0; i < 2; ++i)
      if (auto const place = centralPlace(track, eclipse_.radii, at + (i == 0 ? -5.0 : 5.0)))
        ends[i] = earth_.shownPoint(earth_.unitOf(*place));
    if (!ends[0] || !ends[1] || glm::length(*ends[1] - *ends[0]) < 1e-3) return std::nullopt;
    glm::dvec2 const along = glm::normalize(*ends[1] - *ends[0]);
    glm::dvec2 const across(-along.y, along.x);
    // To the right where the line is steep, else up.
    bool const steep = std::fabs(along.y) > 0.8;
    return (steep ? across.x < 0.0 : across.y > 0.0) ? -across : across;
  }

  void addTimeMarks() {
    DrawnShape ticks = lineOf({}, kWhite, 1.0, false);
    bool first = true;
    glm::dvec2 last(-1e9);
    for (auto const& mark : eclipse_.curves.marks) {
      auto const at = earth_.shownPoint(earth_.unitOf(mark.place));
      auto const across = acrossLine(mark);
      if (!at || !across) continue;
      // Toward a horizon marks run together.
      if (glm::length(*at - last) < 0.7 * size_) continue;
      last = *at;
      double const reach = 0.3 * size_;
      ticks.paths.push_back({*at - reach * *across, *at + reach * *across});
      // Beyond the limits, where they run close beside.
      double beyond = reach;
      auto const point = centralPoint(eclipse_.event.track, eclipse_.radii,
                                      eclipse_.event.track.secondsAt(mark.instant));
      for (auto const* side : {&point->left, &point->right})
        if (overlays_.limits && *side)
          if (auto const edge = earth_.shownPoint(earth_.unitOf(**side))) {
            double const off = glm::dot(*edge - *at, *across);
            if (off > beyond && off < 2.0 * size_) beyond = off;
          }
      std::string text = ut1Text(mark.instant, eclipse_.event.eclipse.deltaT).substr(11, 5);
      DrawnWords const words = wordsOf(text + (first ? " UT" : ""), size_, kWhite);
      // On either side of the line, where the words' nearest corner stands clear of it.
      std::vector<DrawnLabels::Place> places;
      double const half = 0.5 * DrawnLabels::lengthOf(words);
      for (double const side : {1.0, -1.0}) {
        glm::dvec2 const way = side * *across;
        places.push_back({*at + way * (beyond + 0.45 * size_) +
                              glm::dvec2(half * way.x, 0.36 * size_ + 0.4 * size_ * way.y),
                          DrawnWords::Anchor::Middle});
      }
      first = !labels_.place(words, places) && first;
    }
    if (ticks.paths.empty()) return;
    DrawnShape casing = ticks;
    casing.line = kCasing;
    casing.lineWidth += 1.6;
    result_.drawing.shapes.push_back(std::move(casing));
    result_.drawing.shapes.push_back(std::move(ticks));
  }

  // Percent on the isolines that the illustrative look draws at this instant.
  void addObscurationLabels() {
    auto const& track = eclipse_.event.track;
    if (std::fabs(seconds_) > track.halfSpan() / second) return;
    auto const centre = centralPlace(track, eclipse_.radii, seconds_);
    if (!centre) return;
    auto const obscured = [&](double azimuthDegrees, double metres) {
      double latitude = 0.0, longitude = 0.0;
      GeographicLib::Geodesic::WGS84().Direct(centre->latitude / degree, centre->longitude / degree,
                                              azimuthDegrees, metres, latitude, longitude);
      Site const site{latitude * degree, longitude * degree, 0.0 * metre};
      return std::pair(site, solarAppearance(track, eclipse_.radii, site, seconds_).coveredArea());
    };
    for (double const level : {0.2, 0.4, 0.6, 0.8}) {
      for (double const azimuth : {225.0, 270.0, 180.0, 135.0, 315.0, 90.0, 45.0, 0.0}) {
        double inner = 0.0, outer = 8e6;
        if (obscured(azimuth, outer).second > level) continue;
        for (int i = 0; i < 30; ++i) {
          double const middle = 0.5 * (inner + outer);
          (obscured(azimuth, middle).second > level ? inner : outer) = middle;
        }
        auto const at = earth_.shownPoint(earth_.unitOf(obscured(azimuth, inner).first));
        if (!at) continue;
        DrawnWords const words =
            wordsOf(fmt::format("{:.0f} %", 100.0 * level), 0.85 * size_, kIsoline);
        if (!labels_.place(
                words, {{*at + glm::dvec2(0.0, 0.36 * words.size), DrawnWords::Anchor::Middle}}))
          continue;
        break;
      }
    }
  }

  // Lower left corner, one line a kind that the picture shows.
  void addLegend() {
    // Small beside a dome.
    double const size = result_.drawing.clipRadius > 0.0 ? 0.6 * size_ : size_;
    double const row = 1.5 * size, left = 1.2 * size;
    double y = result_.drawing.height - 1.2 * size;
    for (auto kind = shownKinds_.rbegin(); kind != shownKinds_.rend(); ++kind) {
      CurveStyle style = styleOf(*kind);
      if (*kind == CurveKind::UmbraLimit && eclipse_.event.eclipse.type[0] == 'T')
        style.name = "limits of totality";
      if (*kind == CurveKind::UmbraLimit && eclipse_.event.eclipse.type[0] == 'A')
        style.name = "limits of annularity";
      result_.drawing.shapes.push_back(
          lineOf({{{left, y - 0.35 * size}, {left + 1.8 * size, y - 0.35 * size}}}, style.ink,
                 style.width + 0.2, style.dashed));
      result_.drawing.words.push_back({style.name,
                                       {left + 2.4 * size, y},
                                       0.85 * size,
                                       {{225, 228, 235}, 1.0},
                                       DrawnWords::Anchor::Start,
                                       true});
      y -= row;
    }
    auto const& e = eclipse_.event.eclipse;
    std::string const kind = e.type[0] == 'T'   ? "Total"
                             : e.type[0] == 'A' ? "Annular"
                             : e.type[0] == 'H' ? "Hybrid"
                                                : "Partial";
    result_.drawing.words.push_back({fmt::format("{} solar eclipse of {}", kind, e.id),
                                     {left, y - 0.2 * size},
                                     size,
                                     kWhite,
                                     DrawnWords::Anchor::Start,
                                     true});
  }

  const OverlaySettings& overlays_;
  const EclipseAtHand& eclipse_;
  double seconds_;
  const SurfaceLines& earth_;
  double size_;
  CurveOverlay result_;
  DrawnLabels labels_;
  std::vector<std::pair<DrawnWords, std::vector<DrawnLabels::Place>>> curveLabels_;
  std::set<CurveKind> shownKinds_;
};

}  // namespace

CurveOverlay curveOverlay(const Scene& scene, const EclipseAtHand& eclipse, Instant when,
                          const SurfaceLines& earth, double textSize) {
  return Composer(scene, eclipse, when, earth, textSize).compose();
}

}  // namespace antumbra
