#include "plan/clock_face.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "quantity/constants.h"

namespace antumbra {
namespace {

constexpr double kPi = 3.14159265358979323846;
// The dial's arc: from lower left over the top to lower right, angles from up, clockwise.
constexpr double kDialEnd = 0.75 * kPi;

constexpr Ink kPanel{{12, 15, 24}, 0.82};
constexpr Ink kDark{{12, 15, 24}, 1.0};
constexpr Ink kText{{232, 235, 242}, 1.0};
constexpr Ink kQuiet{{150, 158, 174}, 1.0};
constexpr Ink kPartial{{116, 130, 158}, 1.0};
constexpr Ink kCentral{{255, 184, 64}, 1.0};
constexpr Ink kPresent{{255, 92, 74}, 1.0};
constexpr Ink kSun{{255, 206, 92}, 1.0};
constexpr Ink kSea{{58, 104, 160}, 1.0};
constexpr Ink kPenumbra{{12, 15, 24}, 0.45};

std::vector<glm::dvec2> disc(glm::dvec2 centre, double radius) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 96; ++i)
    points.push_back(centre + radius * glm::dvec2(std::cos(kPi * i / 48), std::sin(kPi * i / 48)));
  return points;
}

// What two convex outlines (in order of rising angle) share, after Sutherland & Hodgman 1974.
std::vector<glm::dvec2> common(std::vector<glm::dvec2> subject,
                               const std::vector<glm::dvec2>& clip) {
  for (std::size_t i = 0; i < clip.size(); ++i) {
    glm::dvec2 const a = clip[i], along = clip[(i + 1) % clip.size()] - a;
    auto const side = [&](glm::dvec2 p) { return along.x * (p.y - a.y) - along.y * (p.x - a.x); };
    std::vector<glm::dvec2> kept;
    for (std::size_t k = 0; k < subject.size(); ++k) {
      glm::dvec2 const p = subject[k], q = subject[(k + 1) % subject.size()];
      double const sp = side(p), sq = side(q);
      if (sp >= 0.0) kept.push_back(p);
      if ((sp >= 0.0) != (sq >= 0.0)) kept.push_back(p + (q - p) * (sp / (sp - sq)));
    }
    subject = std::move(kept);
  }
  return subject;
}

// In proportion to the picture's other words; a dome, seen from within, shows small things large.
double lettersOf(const Projection& picture, double textSize) {
  return (picture.kind == ProjectionKind::Fisheye ? 0.6 : 0.85) * textSize;
}

class Face {
 public:
  Face(const Projection& picture, const EclipseAtHand& eclipse, Instant now, double textSize)
      : eclipse_(eclipse),
        now_(now),
        seconds_(eclipse.event.track.secondsAt(now)),
        deltaT_(DeltaT::fixed(eclipse.event.eclipse.deltaT)),
        size_(lettersOf(picture, textSize)) {
    drawing_.width = picture.width;
    drawing_.height = picture.height;
    std::tie(low_, high_) = clockPanel(picture, textSize);
    centre_ = low_ + glm::dvec2(5.6, 6.0) * size_;
  }

  Drawing draw(const ClockReading& reading) {
    addPanel();
    auto const& first = reading.entries.front().instant;
    auto const& last = reading.entries.back().instant;
    if (first && last) addDial(reading, *first, *last);
    if (reading.seen)
      addSun(*reading.seen);
    else
      addEarth();
    addWords(reading);
    return std::move(drawing_);
  }

 private:
  void fill(std::vector<glm::dvec2> outline, const Ink& ink) {
    if (outline.size() < 3) return;
    DrawnShape shape;
    shape.paths = {std::move(outline)};
    shape.fill = ink;
    shape.clipped = false;
    drawing_.shapes.push_back(std::move(shape));
  }
  void line(std::vector<glm::dvec2> path, const Ink& ink, double width) {
    DrawnShape shape;
    shape.paths = {std::move(path)};
    shape.line = ink;
    shape.lineWidth = width;
    shape.clipped = false;
    drawing_.shapes.push_back(std::move(shape));
  }
  void write(const std::string& text, glm::dvec2 at, double size, const Ink& ink,
             DrawnWords::Anchor anchor = DrawnWords::Anchor::Start) {
    drawing_.words.push_back({text, at, size, ink, anchor, false});
  }
  glm::dvec2 onDial(double angle, double radius) const {
    return centre_ + radius * glm::dvec2(std::sin(angle), -std::cos(angle));
  }
  std::string clockTime(Instant t) const {
    return formatIso(t, TimeScale::Utc, deltaT_, 0).substr(11, 8);
  }

  void addPanel() {
    std::vector<glm::dvec2> outline;
    double const r = 0.8 * size_;
    glm::dvec2 const corners[4] = {{high_.x - r, high_.y - r},
                                   {low_.x + r, high_.y - r},
                                   {low_.x + r, low_.y + r},
                                   {high_.x - r, low_.y + r}};
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k <= 12; ++k) {
        double const angle = 0.5 * kPi * (i + k / 12.0);
        outline.push_back(corners[i] + r * glm::dvec2(std::cos(angle), std::sin(angle)));
      }
    fill(std::move(outline), kPanel);
  }

  void addDial(const ClockReading& reading, Instant first, Instant last) {
    double const radius = 4.0 * size_;
    auto const angleOf = [&](Instant t) {
      return kDialEnd * std::clamp(2.0 * ((t - first) / (last - first)) - 1.0, -1.0, 1.0);
    };
    auto const arc = [&](double from, double to) {
      std::vector<glm::dvec2> path;
      int const steps = std::max(2, static_cast<int>(std::ceil((to - from) / 0.05)));
      for (int i = 0; i <= steps; ++i)
        path.push_back(onDial(from + (to - from) * i / steps, radius));
      return path;
    };
    line(arc(-kDialEnd, kDialEnd), kPartial, 0.35 * size_);
    auto const &second = reading.entries[1].instant, &third = reading.entries[3].instant;
    if (second && third) line(arc(angleOf(*second), angleOf(*third)), kCentral, 0.55 * size_);
    for (auto const& entry : reading.entries) {
      if (!entry.instant) continue;
      double const angle = angleOf(*entry.instant);
      line({onDial(angle, radius - 0.45 * size_), onDial(angle, radius + 0.45 * size_)}, kText,
           0.11 * size_);
    }
    // The present: a hand from outside onto the arc; hollow before the first and after the last.
    double const angle = angleOf(now_);
    glm::dvec2 const tip = onDial(angle, radius + 0.2 * size_);
    glm::dvec2 const out = onDial(angle, radius + 1.15 * size_);
    glm::dvec2 const across = 0.42 * glm::dvec2(-(out - tip).y, (out - tip).x);
    fill({tip, out + across, out - across}, now_ < first || now_ > last ? kQuiet : kPresent);
  }

  void addSun(const SolarAppearance& seen) {
    double const radius = 1.9 * size_;
    auto const sun = disc(centre_, radius);
    fill(sun, kSun);
    double const apart = radius * seen.separation / seen.sunRadius;
    glm::dvec2 const moon =
        centre_ + apart * glm::dvec2(-std::sin(seen.zenithAngle), -std::cos(seen.zenithAngle));
    fill(common(disc(moon, radius * seen.diameterRatio()), sun), kDark);
    if (seen.separation + seen.sunRadius < seen.moonRadius) {
      auto rim = disc(centre_, radius * seen.diameterRatio());
      rim.push_back(rim.front());
      line(std::move(rim), kText, 0.14 * size_);
    }
  }

  // As the Sun sees it, north up, with the penumbra and the umbra's place.
  void addEarth() {
    double const radius = 2.6 * size_;
    auto const earth = disc(centre_, radius);
    fill(earth, kSea);
    auto const& track = eclipse_.event.track;
    if (std::fabs(seconds_) > track.halfSpan() / second) return;
    auto const pair = track.shadowAt(seconds_, eclipse_.radii);
    glm::dvec3 const east = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), -pair.axis));
    glm::dvec3 const north = glm::cross(-pair.axis, east);
    double const scale = radius / kEarthEquatorialRadius.si;
    glm::dvec2 const at =
        centre_ + scale * glm::dvec2(glm::dot(pair.foot, east), -glm::dot(pair.foot, north));
    fill(common(disc(at, scale * pair.penumbraRadius), earth), kPenumbra);
    fill(common(disc(at, std::max(scale * std::fabs(pair.umbraRadius), 0.14 * size_)), earth),
         kDark);
  }

  void addWords(const ClockReading& reading) {
    double const left = low_.x + 11.6 * size_, right = high_.x - 1.0 * size_;
    double y = low_.y + 1.7 * size_;
    write(reading.place, {left, y}, 0.8 * size_, kQuiet);
    y += 0.35 * size_;
    bool nextFound = false;
    for (auto const& entry : reading.entries) {
      y += 1.35 * size_;
      bool const next = entry.instant && !nextFound && *entry.instant > now_;
      nextFound = nextFound || next;
      Ink const ink = next ? kCentral : entry.instant && *entry.instant <= now_ ? kQuiet : kText;
      write(entry.name, {left, y}, size_, ink);
      write(entry.instant ? clockTime(*entry.instant) : "–", {right - 0.9 * size_, y}, size_, ink,
            DrawnWords::Anchor::End);
      // A contact below the horizon is marked.
      if (entry.below && entry.instant) write("*", {right - 0.7 * size_, y}, size_, kQuiet);
    }
    bool const below = std::any_of(reading.entries.begin(), reading.entries.end(),
                                   [](const ClockEntry& e) { return e.below && e.instant; });
    y += 1.7 * size_;
    // UTC where it is defined (time/instant.h).
    double const year = now_.julianYear();
    std::string const scale = year > 1960.1 && year < 2035.9 ? "UTC" : "UT1";
    write(clockTime(now_) + " " + scale, {left, y}, size_, kPresent);
    if (below)
      write("* Sun below horizon", {right, low_.y + 1.7 * size_}, 0.65 * size_, kQuiet,
            DrawnWords::Anchor::End);
    write(reading.phase, {centre_.x, high_.y - 1.0 * size_}, 0.85 * size_, kText,
          DrawnWords::Anchor::Middle);
  }

  const EclipseAtHand& eclipse_;
  Instant now_;
  double seconds_;
  DeltaT deltaT_;
  double size_;
  glm::dvec2 low_{0.0}, high_{0.0}, centre_{0.0};
  Drawing drawing_;
};

}  // namespace

std::pair<glm::dvec2, glm::dvec2> clockPanel(const Projection& picture, double textSize) {
  double const size = lettersOf(picture, textSize);
  glm::dvec2 const panel(21.2 * size, 11.6 * size), corner(picture.width, picture.height);
  // In a dome above its lower rim, else in the lower right corner.
  glm::dvec2 const low = picture.kind == ProjectionKind::Fisheye
                             ? glm::dvec2(0.5 * (corner.x - panel.x), 0.9 * corner.y - panel.y)
                             : corner - panel - glm::dvec2(1.2 * size);
  return {low, low + panel};
}

Drawing clockFace(const Projection& picture, const EclipseAtHand& eclipse, Instant now,
                  double textSize, const ClockReading& reading) {
  return Face(picture, eclipse, now, textSize).draw(reading);
}

}  // namespace antumbra
