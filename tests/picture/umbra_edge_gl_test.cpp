// The edge of the umbra and of the antumbra in pictures at 0.5 km a pixel against the predicted
// footprint of the instant.
//
// Each picture is a window seen from straight above a stretch of the predicted edge; the edge
// itself is read from the picture. In natural light on an airless Earth the Sun's visible fraction
// is the picture's light over that of the same picture without the Moon's shadow: the umbra's edge
// is where it reaches zero, the antumbra's where it leaves the plateau of the ring. In the
// illustrative look it is the step between the flat colours, seen through the air. (Natural light
// through the air has no edge to read: what the air scatters, 2 cd/m2, exceeds the first light on
// the ground for four pixels.)
//
// Instants: a picture shows the shadow of its instant at the centre of the body that the camera
// stands on; the light's way from the ground up to the camera (3 ms from 1000 km, 2 m of the
// umbra's motion) is left out in pictures, and so it is here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "eclipse/central_path.h"
#include "eclipse/eclipse_search.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ground_window.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

using testsupport::GroundWindow;
using UmbraEdge = testsupport::GlTest;

struct Case {
  const char* what;
  const char* eclipse;
  double sunAltitude;  // deg, after greatest eclipse; 0: at greatest eclipse
  double heightMetres;
  CentralPhase phase;
  bool wide = true;  // an antumbra in which the ring's light can be seen to change evenly
};

constexpr Case kCases[] = {
    {"total", "2027-08-02", 0.0, 1e6, CentralPhase::Total},
    {"total, from 20 000 km", "2017-08-21", 0.0, 2e7, CentralPhase::Total},
    {"annular", "2023-10-14", 0.0, 1e6, CentralPhase::Annular},
    {"annular, from 4000 km", "2020-06-21", 50.0, 4e6, CentralPhase::Annular},
    {"hybrid", "2023-04-20", 0.0, 1e6, CentralPhase::Total},
    {"hybrid, its annular end", "2005-04-08", 6.0, 1e6, CentralPhase::Annular, false},
    {"low Sun", "2024-04-08", 5.0, 1e6, CentralPhase::Total},
    {"low Sun, annular", "2023-10-14", 6.0, 1e6, CentralPhase::Annular},
    {"polar", "2015-03-20", 0.0, 1e6, CentralPhase::Total},
    {"polar, annular", "2021-06-10", 0.0, 1e6, CentralPhase::Annular},
};

// When the Sun stands at an altitude at the central point, between greatest eclipse and the end.
double secondsOf(const SolarEvent& event, const ShadowRadii& radii, double sunAltitude) {
  double early = event.track.secondsAt(event.eclipse.greatest);
  if (sunAltitude == 0.0) return early;
  double late = event.track.secondsAt(*event.eclipse.c4);
  while (late - early > 1.0) {
    double const t = 0.5 * (early + late);
    auto const point = centralPoint(event.track, radii, t);
    (point && point->sun.altitude / degree > sunAltitude ? early : late) = t;
  }
  return early;
}

// Points of an outline, at most `count`, spread evenly over the places.
std::vector<Site> spread(const std::vector<Site>& outline, std::size_t count) {
  std::vector<Site> few;
  for (std::size_t i = 0; i < count; ++i) few.push_back(outline[i * outline.size() / count]);
  return few;
}

// Distance of a point from the broken line of the outline in the picture, in pixels.
double pixelsFromOutline(const GroundWindow& window, const std::vector<Site>& outline,
                         glm::dvec2 point) {
  double least = 1e9;
  std::optional<glm::dvec2> before;
  for (std::size_t i = 0; i <= outline.size(); ++i) {
    auto const here = window.pixelOf(itrsMetres(outline[i % outline.size()]));
    if (here && before && glm::length(*here - point) < 200.0) {
      glm::dvec2 const along = *here - *before;
      double const share = std::clamp(
          glm::dot(point - *before, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
      least = std::min(least, glm::length(*before + share * along - point));
    }
    before = here;
  }
  return least;
}

// A picture's value per pixel, beyond the plane that it follows inside the shadow: in the umbra it
// is zero, in the antumbra the ring's light changes evenly with the place.
struct BeyondPlateau {
  std::vector<double> values;
  double level = 0.0;  // of the plane in the middle
};

BeyondPlateau beyondPlateau(int size, const std::function<double(int, int)>& value) {
  BeyondPlateau beyond;
  double least = 1e99;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      beyond.values.push_back(value(x, y));
      least = std::min(least, beyond.values.back());
    }
  auto const place = [&](std::size_t i) {
    return glm::dvec2(static_cast<double>(i % static_cast<std::size_t>(size)),
                      static_cast<double>(i / static_cast<std::size_t>(size))) -
           0.5 * (size - 1);
  };
  // Towards the light.
  glm::dvec2 outward(0.0);
  for (std::size_t i = 0; i < beyond.values.size(); ++i)
    outward += (beyond.values[i] - least) * place(i);
  outward = glm::normalize(outward);
  // Least squares of a + b x + c y over what lies four pixels or more inside, in a wedge that stays
  // inside at the sharp ends of a long outline, too.
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  auto const isInside = [&](std::size_t i) {
    double const depth = -glm::dot(place(i), outward);
    double const aside = glm::dot(place(i), glm::dvec2(-outward.y, outward.x));
    return depth > 4.0 && std::fabs(aside) < depth;
  };
  if (least == 0.0) return beyond;
  for (std::size_t i = 0; i < beyond.values.size(); ++i) {
    if (!isInside(i)) continue;
    glm::dvec3 const row(1.0, place(i));
    normal += glm::outerProduct(row, row);
    right += row * beyond.values[i];
  }
  glm::dvec3 const plane = glm::inverse(normal) * right;
  for (std::size_t i = 0; i < beyond.values.size(); ++i) {
    beyond.values[i] -= glm::dot(plane, glm::dvec3(1.0, place(i)));
  }
  beyond.level = plane.x;
  return beyond;
}

// Crossings of `level` along rows and columns, by straight lines between pixels.
std::vector<glm::dvec2> crossings(int size, double level,
                                  const std::function<double(int, int)>& value) {
  std::vector<glm::dvec2> found;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (glm::ivec2 const& step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
        if (x + step.x >= size || y + step.y >= size) continue;
        double const a = value(x, y) - level, b = value(x + step.x, y + step.y) - level;
        if ((a > 0.0) == (b > 0.0)) continue;
        found.push_back(glm::dvec2(x, y) + 0.5 + glm::dvec2(step) * (a / (a - b)));
      }
  return found;
}

// Where `value` (per pixel, not negative) begins to rise from zero. Its 2/3 power grows evenly
// beyond the edge of a shadow: from where that has a quarter of its greatest value in the window,
// some four pixels outside, back along its slope.
std::vector<glm::dvec2> edgesFromZero(int size, const std::function<double(int, int)>& value) {
  std::vector<double> even;
  double most = 0.0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      even.push_back(std::pow(std::max(value(x, y), 0.0), 2.0 / 3.0));
      most = std::max(most, even.back());
    }
  auto const at = [&](int x, int y) { return even[static_cast<std::size_t>(y * size + x)]; };
  std::vector<glm::dvec2> edges;
  for (auto const& p : crossings(size, 0.25 * most, at)) {
    glm::ivec2 const i(p);
    if (i.x < 1 || i.y < 1 || i.x > size - 2 || i.y > size - 2) continue;
    glm::dvec2 const slope(0.5 * (at(i.x + 1, i.y) - at(i.x - 1, i.y)),
                           0.5 * (at(i.x, i.y + 1) - at(i.x, i.y - 1)));
    edges.push_back(p - slope * (0.25 * most / glm::dot(slope, slope)));
  }
  return edges;
}

class Distances {
 public:
  void add(double pixels) {
    largest_ = testsupport::larger(largest_, pixels);
    sum_ += pixels * pixels;
    ++count_;
  }
  double largest() const { return largest_; }
  int count() const { return count_; }
  double rms() const { return std::sqrt(sum_ / std::max(count_, 1)); }

 private:
  double largest_ = 0.0, sum_ = 0.0;
  int count_ = 0;
};

void check(const Case& c, bool illustrative, PictureRenderer& renderer) {
  EclipseBasis const basis;
  SolarEvent const event = solarEventOn(basis, c.eclipse, "test");
  double const seconds = secondsOf(event, basis.radii(), c.sunAltitude);
  auto const centre = centralPoint(event.track, basis.radii(), seconds);
  ASSERT_TRUE(centre);
  ASSERT_EQ(centre->phase, c.phase);
  auto const outline = umbraFootprint(event.track, basis.radii(), seconds, 20000);
  ASSERT_GT(outline.size(), 10000u);
  Distances distances;
  for (Site const& place : spread(outline, 6)) {
    // At the ends of a long outline the Sun may set: no light, no edge.
    if (solarAppearance(event.track, basis.radii(), place, seconds).sun.altitude < 1.0 * degree)
      continue;
    GroundWindow::View view;
    view.latitude = place.latitude / degree + 0.013;  // off the middle, which would hide errors
    view.longitude = place.longitude / degree - 0.021;
    view.heightMetres = c.heightMetres;
    view.illustrative = illustrative;
    view.air = illustrative;
    Instant const when = event.track.instantAt(seconds);
    GroundWindow const window(renderer, view, when, event.eclipse.deltaT);
    int const size = window.size();
    std::vector<glm::dvec2> edges;
    if (illustrative) {
      double low = 1e99, high = -1e99;
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          low = std::min(low, window.at(x, y, 2));
          high = std::max(high, window.at(x, y, 2));
        }
      edges = crossings(size, 0.5 * (low + high), [&](int x, int y) { return window.at(x, y, 2); });
    } else {
      view.eclipsed = false;
      GroundWindow const full(renderer, view, when, event.eclipse.deltaT);
      auto const fraction = [&](int x, int y) { return window.at(x, y) / full.at(x, y); };
      BeyondPlateau const beyond = beyondPlateau(size, fraction);
      EXPECT_EQ(beyond.level > 0.0, c.phase == CentralPhase::Annular) << c.what;
      edges = edgesFromZero(size, [&](int x, int y) {
        return beyond.values[static_cast<std::size_t>(y * size + x)];
      });
    }
    for (auto const& edge : edges) {
      if (edge.x < 2.0 || edge.y < 2.0 || edge.x > size - 2.0 || edge.y > size - 2.0) continue;
      distances.add(pixelsFromOutline(window, outline, edge));
    }
  }
  std::printf("%-26s Sun %5.1f deg, %s: %5d places, rms %.3f px, largest %.3f px\n", c.what,
              centre->sun.altitude / degree, illustrative ? "illustrative" : "natural     ",
              distances.count(), distances.rms(), distances.largest());
  EXPECT_GT(distances.count(), 50) << c.what;
  EXPECT_LT(distances.largest(), 1.0) << c.what;
}

TEST_F(UmbraEdge, LiesWhereItIsPredictedInNaturalLight) {
  PictureRenderer renderer(testsupport::greyMap);
  for (Case const& c : kCases)
    if (c.wide) check(c, false, renderer);
}

TEST_F(UmbraEdge, LiesWhereItIsPredictedInTheIllustrativeLook) {
  PictureRenderer renderer(testsupport::greyMap);
  for (Case const& c : kCases) check(c, true, renderer);
}

// What an earlier picture had resident does not change a later one: a body without its air is as
// bright after a picture with it as before.
TEST_F(UmbraEdge, ABodyThatLosesItsAirIsDrawnWithoutIt) {
  EclipseBasis const basis;
  SolarEvent const event = solarEventOn(basis, "2027-08-02", "test");
  GroundWindow::View view;
  view.latitude = view.longitude = 20.0;
  view.size = 2;
  auto const bare = [&](PictureRenderer& renderer) {
    view.air = false;
    return GroundWindow(renderer, view, event.eclipse.greatest, event.eclipse.deltaT).at(0, 0);
  };
  PictureRenderer fresh(testsupport::greyMap), used(testsupport::greyMap);
  double const expected = bare(fresh);
  EXPECT_GT(expected, 100.0);  // cd/m2, in the penumbra by day
  view.air = true;
  view.illustrative = true;
  GroundWindow(used, view, event.eclipse.greatest, event.eclipse.deltaT);
  view.illustrative = false;
  EXPECT_FLOAT_EQ(static_cast<float>(bare(used)), static_cast<float>(expected));
}

}  // namespace
}  // namespace antumbra
