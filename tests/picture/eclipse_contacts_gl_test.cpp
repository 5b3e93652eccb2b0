// An eclipse as it passes over a place, in pixels against predictions: the visible fraction of the
// Sun from first to fourth contact, and the instant of second contact.
//
// Two kinds of pixels: the Sun's disc as an observer at the place sees it, by the pass that draws
// it, and the ground at the place as a camera above sees it, on an airless Earth, over the same
// picture without the Moon's shadow. Expected fractions come from the apparent angles of Sun and
// Moon in double precision, contacts from the local circumstances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "eclipse/limb_darkening.h"
#include "eclipse/local_circumstances.h"
#include "passes/sun.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/ground_window.h"
#include "tests/support/larger.h"
#include "tests/support/sky_picture.h"

namespace antumbra {
namespace {

using testsupport::GroundWindow;
using EclipseContacts = testsupport::GlTest;

struct Place {
  const char* what;
  const char* eclipse;
  double latitude, longitude, heightMetres;
};

constexpr Place kPlaces[] = {
    {"Luxor", "2027-08-02", 25.687, 32.640, 76.0},
    {"near the limit, Kentucky", "2017-08-21", 37.42, -87.7, 120.0},
    {"Svalbard", "2015-03-20", 78.22, 15.65, 10.0},
    {"Albuquerque, annular", "2023-10-14", 35.084, -106.65, 1600.0},
};

Site siteAt(const Place& p, double heightMetres) {
  return {p.latitude * degree, p.longitude * degree, heightMetres * metre};
}

// The Sun as the pass draws it for an observer at the place.
class SunPicture {
 public:
  SunPicture(const Place& place, Duration deltaT, Angle field, int size)
      : place_(place),
        deltaT_(deltaT),
        pass_(ProjectionKind::Perspective),
        picture_({ProjectionKind::Perspective, field, size, size}) {}

  // Illuminance of the picture, lx in linear sRGB.
  glm::dvec3 illuminance(Instant when, LimbDarkeningLaw law, bool withMoon) {
    Scene scene;
    scene.file = "test";
    scene.bodies = {"Earth", "Moon", "Sun"};
    scene.camera.latitude = place_.latitude * degree;
    scene.camera.longitude = place_.longitude * degree;
    scene.camera.height = place_.heightMetres * metre;
    scene.camera.target = "Sun";
    scene.picture = picture_.projection;
    scene.shadows.convention = "nasa";
    RenderPlan const plan =
        makeRenderPlan(scene, placeScene(scene, when, BodyCatalogue::standard(),
                                         Ephemeris::standard(), DeltaT::fixed(deltaT_)));
    SunInView sun;
    sun.centre = plan.sun.distance * plan.sun.direction;
    sun.radius = plan.sun.radius;
    sun.north = plan.sun.north;
    sun.illuminanceLux = glm::dvec3(1.0);
    sun.law = limbDarkening(law, kSolarChannels);
    SunPlane const plane(sun);
    std::vector<SpheroidInView> bodies;
    for (auto const& body : plan.bodies)
      if (withMoon && body.name == "Moon")
        bodies.push_back({body.centre,
                          body.bodyFromCamera.inverse()(Direction<BodyFixed>{{0, 0, 1}}),
                          body.equatorialRadius, body.polarRadius});
    picture_.draw([&] { pass_.draw(picture_.projection, sun, plane, plane.silhouettes(bodies)); });
    return picture_.illuminance();
  }

 private:
  Place place_;
  Duration deltaT_;
  SunPass pass_;
  testsupport::SkyPicture picture_;
};

// Fractions by angles, for the three channels' wavelengths.
glm::dvec4 expectedFraction(const SolarEvent& event, const ShadowRadii& radii, const Site& site,
                            double seconds, LimbDarkeningLaw law) {
  auto const seen = solarAppearance(event.track, radii, site, seconds);
  return glsl::visibleFraction(
      glsl::discsFromAngles(seen.sunRadius, seen.moonRadius, seen.separation),
      limbDarkening(law, kSolarChannels));
}

// Instants from first to fourth contact, close together about the inner ones.
std::vector<double> instantsOf(const SolarEvent& event, const LocalCircumstances& local) {
  std::vector<double> times;
  auto const at = [&](const LocalContact& c) { return event.track.secondsAt(c.instant); };
  double const c1 = at(*local.c1), c4 = at(*local.c4);
  for (int i = 1; i < 10; ++i) times.push_back(c1 + (c4 - c1) * i / 10.0);
  for (double off : {1.0, 8.0, 40.0, 200.0}) {
    times.push_back(at(*local.c2) - off);
    times.push_back(at(*local.c3) + off);
  }
  if (local.type == "A") times.push_back(at(*local.maximum));
  return times;
}

TEST_F(EclipseContacts, VisibleFractionOfTheSunInView) {
  EclipseBasis const basis;
  for (Place const& place : kPlaces) {
    SolarEvent const event = solarEventOn(basis, place.eclipse, "test");
    Site const site = siteAt(place, place.heightMetres);
    auto const local = localCircumstances(event, basis.radii(), site);
    ASSERT_TRUE(local.c2) << place.what;
    SunPicture picture(place, event.eclipse.deltaT, 0.6 * degree, 512);
    for (auto law : {LimbDarkeningLaw::None, LimbDarkeningLaw::Hestroffer}) {
      glm::dvec3 const whole =
          picture.illuminance(local.maximum->instant, law, false);  // of an illuminance of 1 lx
      double worst = 0.0, worstOfThinnest = 0.0;
      for (double t : instantsOf(event, local)) {
        glm::dvec3 const fraction =
            picture.illuminance(event.track.instantAt(t), law, true) / whole;
        glm::dvec4 const expected = expectedFraction(event, basis.radii(), site, t, law);
        for (int k = 0; k < 3; ++k) {
          double const e = expected[k];
          if (e <= 0.0) {
            EXPECT_EQ(fraction[k], 0.0) << place.what << " " << t;
            continue;
          }
          double& largest = e > 1e-4 ? worst : worstOfThinnest;
          largest = testsupport::larger(largest, std::fabs(fraction[k] / e - 1.0));
        }
      }
      std::printf("%-26s %s: Sun in view within %.2e of the visible light, %.2e below 1e-4 of it\n",
                  place.what, law == LimbDarkeningLaw::None ? "uniform" : "limb-darkened", worst,
                  worstOfThinnest);
      EXPECT_LT(worst, 2e-3) << place.what;
      // A crescent half a second of arc wide: an eighth of a pixel.
      EXPECT_LT(worstOfThinnest, 5e-3) << place.what;
    }
  }
}

TEST_F(EclipseContacts, VisibleFractionOnTheGround) {
  EclipseBasis const basis;
  PictureRenderer renderer(testsupport::greyMap);
  for (Place const& place : kPlaces) {
    SolarEvent const event = solarEventOn(basis, place.eclipse, "test");
    Site const site = siteAt(place, 0.0);
    auto const local = localCircumstances(event, basis.radii(), site);
    ASSERT_TRUE(local.c2) << place.what;
    double worst = 0.0;
    for (double t : instantsOf(event, local)) {
      GroundWindow::View view;
      view.latitude = place.latitude;
      view.longitude = place.longitude;
      view.pixelMetres = 1.0;
      view.size = 1;
      Instant const when = event.track.instantAt(t);
      GroundWindow const window(renderer, view, when, event.eclipse.deltaT);
      view.eclipsed = false;
      GroundWindow const full(renderer, view, when, event.eclipse.deltaT);
      double const expected =
          expectedFraction(event, basis.radii(), site, t, LimbDarkeningLaw::None).x;
      double const fraction = window.at(0, 0) / full.at(0, 0);
      if (expected == 0.0) {
        EXPECT_EQ(fraction, 0.0) << place.what;
        continue;
      }
      worst = testsupport::larger(worst, std::fabs(fraction / expected - 1.0));
    }
    std::printf("%-26s ground within %.2e of the visible light\n", place.what, worst);
    EXPECT_LT(worst, 2e-3) << place.what;
  }
}

// The instant when a light goes out, between one when it shines and one when it does not.
template <class Shines>
double goesOut(Shines&& shines, double before, double after) {
  EXPECT_TRUE(shines(before));
  EXPECT_FALSE(shines(after));
  while (after - before > 0.005) {
    double const middle = 0.5 * (before + after);
    (shines(middle) ? before : after) = middle;
  }
  return 0.5 * (before + after);
}

TEST_F(EclipseContacts, SecondContactIsSeenWhenPredicted) {
  EclipseBasis const basis;
  PictureRenderer renderer(testsupport::greyMap);
  for (Place const& place : kPlaces) {
    SolarEvent const event = solarEventOn(basis, place.eclipse, "test");
    auto const onGround = localCircumstances(event, basis.radii(), siteAt(place, 0.0));
    if (onGround.type != "T") continue;
    auto const inView = localCircumstances(event, basis.radii(), siteAt(place, place.heightMetres));
    double const c2 = event.track.secondsAt(inView.c2->instant);
    SunPicture picture(place, event.eclipse.deltaT, 0.6 * degree, 512);
    double const seen = goesOut(
        [&](double t) {
          return picture.illuminance(event.track.instantAt(t), LimbDarkeningLaw::Hestroffer, true)
                     .y > 0.0;
        },
        c2 - 2.0, c2 + 2.0);
    double const ground2 = event.track.secondsAt(onGround.c2->instant);
    double const dark = goesOut(
        [&](double t) {
          GroundWindow::View view;
          view.latitude = place.latitude;
          view.longitude = place.longitude;
          view.pixelMetres = 1.0;
          view.size = 1;
          return GroundWindow(renderer, view, event.track.instantAt(t), event.eclipse.deltaT)
                     .at(0, 0) > 0.0;
        },
        ground2 - 2.0, ground2 + 2.0);
    std::printf("%-26s second contact: photosphere out %+.3f s, ground dark %+.3f s\n", place.what,
                seen - c2, dark - ground2);
    // The search ends within 5 ms.
    EXPECT_NEAR(seen, c2, 0.01) << place.what;
    EXPECT_NEAR(dark, ground2, 0.01) << place.what;
  }
}

}  // namespace
}  // namespace antumbra
