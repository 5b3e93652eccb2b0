// Curves on the globe as a picture shows them, against rows of an independent program projected by
// an independent camera.
#include "plan/surface_lines.h"

#include <gtest/gtest.h>

#include <numbers>

#include "plan/eclipse_at_hand.h"
#include "plan/render_plan.h"
#include "tests/support/csv.h"
#include "tests/support/globe_view.h"

namespace antumbra {
namespace {

using testsupport::distanceTo;
using testsupport::GlobeView;

// The annular eclipse of 2005-10-03 with the printed delta T of the authority.
constexpr double kDeltaT = 64.796;
constexpr const char* kTime = "2005-10-03T10:31:00Z";

struct View {
  Scene scene;
  PlacedScene placed;
  RenderPlan plan;
  std::shared_ptr<const EclipseAtHand> eclipse;
  const PlannedBody& earth() const { return plan.bodies.back(); }
  SurfaceLines lines() const { return {scene.picture, earth(), plan.bodies}; }
  std::vector<std::vector<glm::dvec2>> paths(CurveKind kind, const std::string& begins = "") const {
    std::vector<std::vector<glm::dvec2>> all;
    SurfaceLines const shown = lines();
    for (auto const& curve : eclipse->curves.curves)
      if (curve.kind == kind && curve.name.rfind(begins, 0) == 0)
        for (auto& path : shown.shown(shown.curveOf(curve.sites, true)))
          all.push_back(std::move(path));
    return all;
  }
};

View viewOf(const GlobeView& from, ProjectionKind kind = ProjectionKind::Perspective,
            std::vector<std::string> bodies = {"Sun", "Earth", "Moon"}) {
  View v;
  v.scene.file = "test";
  v.scene.bodies = std::move(bodies);
  v.scene.camera.latitude = from.latitude * degree;
  v.scene.camera.longitude = from.longitude * degree;
  v.scene.camera.height = from.height * metre;
  v.scene.camera.azimuth = from.azimuth * degree;
  v.scene.camera.altitude = from.altitude * degree;
  v.scene.camera.up = CameraPlacement::Up::Zenith;  // north where the camera looks down
  v.scene.picture = {kind, from.fieldDegrees * degree, from.width, from.pixelsHigh};
  v.scene.shadows.convention = "nasa";
  v.placed = placeScene(v.scene, parseInstant(kTime, "test"), BodyCatalogue::standard(),
                        Ephemeris::standard(), DeltaT::fixed(kDeltaT * second));
  v.plan = makeRenderPlan(v.scene, v.placed);
  v.eclipse = eclipseAtHand(v.scene, v.placed);
  return v;
}

TEST(SurfaceLines, PassWhereTheAuthorityPutsCentralLineAndLimits) {
  GlobeView const space{10.0, 25.0, 9e6};
  View const v = viewOf(space);
  ASSERT_TRUE(v.eclipse);
  auto const centre = v.paths(CurveKind::CentralLine);
  auto const left = v.paths(CurveKind::UmbraLimit, "left");
  auto const right = v.paths(CurveKind::UmbraLimit, "right");
  int checked = 0;
  for (auto const& row : readCsv("tests/authorities/solar_central_lines.csv")) {
    if (row.text("ecl_id") != "2005-10-03") continue;
    struct {
      const std::vector<std::vector<glm::dvec2>>& paths;
      const char *lat, *lon;
      double tolerance;  // pixels; one is 17 km at the nadir, the authority is good to 0.2 km and
                         // its limits to 0.4 km, a chord to 0.1 pixel
    } const lines[] = {{centre, "lat_deg", "lon_deg_east", 0.13},
                       {left, "left_limit_lat", "left_limit_lon", 0.15},
                       {right, "right_limit_lat", "right_limit_lon", 0.15}};
    for (auto const& line : lines) {
      double const lat = row.number(line.lat), lon = row.number(line.lon);
      if (!space.visible(lat, lon)) continue;
      EXPECT_LT(distanceTo(line.paths, *space.pixel(lat, lon)), line.tolerance)
          << row.text("jd_tt") << " " << line.lat;
      ++checked;
    }
  }
  EXPECT_GT(checked, 90);
}

TEST(SurfaceLines, SmoothCurvesStayOnTheExactCentralLine) {
  View const v = viewOf({10.0, 25.0, 9e6});
  SurfaceLines const lines = v.lines();
  auto const& track = v.eclipse->event.track;
  double const first = track.secondsAt(*v.eclipse->event.eclipse.c1);
  double const last = track.secondsAt(*v.eclipse->event.eclipse.c4);
  SurfaceCurve const curve = lines.curveOf(v.eclipse->curves.curves.at(0).sites, true);
  ASSERT_EQ(v.eclipse->curves.curves.at(0).kind, CurveKind::CentralLine);
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    double const t = first + (last - first) * (0.02 + 0.96 * i / 1000.0);
    auto const place = centralPlace(track, v.eclipse->radii, t);
    ASSERT_TRUE(place);
    glm::dvec3 const exact = lines.unitOf(*place);
    double least = 1e9;
    for (double at = 0.0; at < static_cast<double>(curve.points.size() - 1); at += 0.05) {
      glm::dvec3 const a = curve.at(at), b = curve.at(at + 0.05);
      double const share =
          std::clamp(glm::dot(exact - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
      least = std::min(least, glm::length(exact - (a + share * (b - a))));
    }
    worst = std::max(worst, 6378137.0 * least);
  }
  // Apart from the first and last 2 % of the time, where the Sun stands low.
  EXPECT_LT(worst, 30.0) << "metres";
}

TEST(SurfaceLines, NothingBehindTheLimbIsShown) {
  GlobeView const space{10.0, 60.0, 4e6};  // the path's beginning lies beyond the limb
  View const v = viewOf(space);
  auto const paths = v.paths(CurveKind::CentralLine);
  ASSERT_FALSE(paths.empty());
  int hidden = 0, onLimb = 0;
  for (auto const& row : readCsv("tests/authorities/solar_central_lines.csv")) {
    if (row.text("ecl_id") != "2005-10-03") continue;
    double const lat = row.number("lat_deg"), lon = row.number("lon_deg_east");
    auto const pixel = space.pixel(lat, lon);
    if (space.visible(lat, lon) || !pixel) continue;
    ++hidden;
    EXPECT_GT(distanceTo(paths, *pixel), 1.0) << row.text("jd_tt");
  }
  EXPECT_GE(hidden, 6);
  // A line ends on the limb itself: where its tangent ray grazes the ellipsoid.
  for (auto const& path : paths)
    for (glm::dvec2 const& end : {path.front(), path.back()}) {
      auto const d = v.scene.picture.directionAt(end.x, space.pixelsHigh - end.y);
      glm::dvec3 const shape(1.0 / 6378137.0, 1.0 / 6378137.0, 1.0 / 6356752.314245);
      glm::dvec3 const o = space.camera() * shape;
      glm::dvec3 const ray = shape * v.earth().bodyFromCamera(*d).u;
      double const square = glm::dot(ray, ray), half = glm::dot(o, ray);
      double const nearest = std::sqrt(glm::dot(o, o) - half * half / square);
      // Half a kilometre is 0.05 pixel at the limb.
      if (std::fabs(nearest - 1.0) < 8e-5) ++onLimb;
    }
  EXPECT_GE(onLimb, 1);
}

TEST(SurfaceLines, FromTwoMetresALineRunsToTheHorizon) {
  // 300 m beside the central line at 10:31 UT, looking along it.
  View probe = viewOf({10.0, 25.0, 9e6});
  auto const& event = probe.eclipse->event;
  double const now = event.track.secondsAt(probe.placed.when);
  auto const here = *centralPlace(event.track, probe.eclipse->radii, now);
  auto const point = *centralPoint(event.track, probe.eclipse->radii, now);
  GlobeView ground{here.latitude / degree + 0.0027, here.longitude / degree, 2.0};
  ground.azimuth = point.trackAzimuth / degree;
  ground.altitude = 0.0;
  View const v = viewOf(ground);
  auto const paths = v.paths(CurveKind::CentralLine);
  ASSERT_FALSE(paths.empty());
  double highest = 1e9;  // y grows downward
  for (auto const& path : paths)
    for (auto const& p : path) highest = std::min(highest, p.y);
  // The dip of the horizon, sqrt(2 h / R) for small heights, in pixels of a field of 60 degrees.
  double const scale = 320.0 / std::tan(std::numbers::pi / 6.0);
  double const dip = std::sqrt(2.0 * 2.0 / 6.37e6);
  EXPECT_NEAR(highest, 240.0 + scale * dip, 0.05);
  // And a place of the line a kilometre ahead stands where it must.
  auto const ahead = *centralPlace(event.track, probe.eclipse->radii, now + 1.4);
  auto const pixel = ground.pixel(ahead.latitude / degree, ahead.longitude / degree);
  ASSERT_TRUE(pixel);
  EXPECT_LT(distanceTo(paths, *pixel), 0.5);
}

TEST(SurfaceLines, EquirectangularPicturesPartWhereTheyBegin) {
  GlobeView from{10.0, 25.0, 2e6};
  from.azimuth = 180.0;  // the line runs north of the camera, behind it
  from.altitude = 0.0;   // the globe lies round the lower edge, over all longitudes
  from.width = 800;
  from.pixelsHigh = 400;
  View const v = viewOf(from, ProjectionKind::Equirectangular);
  auto const paths = v.paths(CurveKind::CentralLine);
  ASSERT_GE(paths.size(), 2u);
  for (auto const& path : paths)
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      EXPECT_LT(std::fabs(path[i + 1].x - path[i].x), 100.0);
}

TEST(SurfaceLines, TheMoonHidesWhatLiesBehindIt) {
  GlobeView const space{13.58, 28.2, 9e6};
  View v = viewOf(space);
  auto const before = v.paths(CurveKind::CentralLine);
  // A body like the Moon put before the middle of the picture.
  PlannedBody screen = v.plan.bodies.back();
  screen.name = "screen";
  screen.equatorialRadius = screen.polarRadius = 300.0 * kilometre;
  screen.centre = {{0.0, 0.0, -5e6}};
  v.plan.bodies.insert(v.plan.bodies.begin(), screen);
  auto const behind = v.paths(CurveKind::CentralLine);
  double const scale = 320.0 / std::tan(std::numbers::pi / 6.0);
  double const radius = scale * 3e5 / std::sqrt(5e6 * 5e6 - 3e5 * 3e5);
  glm::dvec2 const middle(320.0, 240.0);
  bool crossed = false;
  for (auto const& path : before)
    for (auto const& p : path) crossed = crossed || glm::length(p - middle) < 0.8 * radius;
  ASSERT_TRUE(crossed) << "the line must run behind the screen for the test to mean anything";
  for (auto const& path : behind)
    for (auto const& p : path) EXPECT_GT(glm::length(p - middle), radius - 0.05);
  EXPECT_GT(behind.size(), before.size());
}

}  // namespace
}  // namespace antumbra
