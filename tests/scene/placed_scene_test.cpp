// The camera's axes and the places of bodies, against horizontal coordinates computed another way.
#include "scene/placed_scene.h"

#include <gtest/gtest.h>

#include "ephemeris/apparent.h"
#include "geodesy/site.h"

namespace antumbra {
namespace {

constexpr const char* kPartial = "2027-08-02T09:05:06Z";

Scene domeAt(double latitude, double longitude) {
  Scene s;
  s.file = "test";
  s.bodies = {"Sun", "Moon", "Earth"};
  s.camera.latitude = latitude * degree;
  s.camera.longitude = longitude * degree;
  s.camera.height = 76.0 * metre;
  s.camera.target = "zenith";
  s.camera.up = CameraPlacement::Up::North;
  s.picture = {ProjectionKind::Fisheye, 180.0 * degree, 1000, 1000};
  return s;
}

PlacedScene place(const Scene& scene, const char* time) {
  return placeScene(scene, parseInstant(time, "test"), BodyCatalogue::standard(),
                    Ephemeris::standard(), DeltaT::standard());
}

Direction<CameraAxes> towards(const PlacedScene& placed, double azimuth, double altitude) {
  return (placed.cameraFromIcrs *
          placed.enuFromIcrs.inverse())(enuFromHorizontal({azimuth * degree, altitude * degree}));
}

TEST(PlacedScene, ADomeMasterHasNorthAboveAndEastLeft) {
  PlacedScene const placed = place(domeAt(25.687, 32.640), kPartial);
  EXPECT_NEAR(towards(placed, 0.0, 0.0).u.y, 1.0, 1e-12);
  EXPECT_NEAR(towards(placed, 90.0, 0.0).u.x, -1.0, 1e-12);
  EXPECT_NEAR(towards(placed, 0.0, 90.0).u.z, -1.0, 1e-12);
}

TEST(PlacedScene, TiltLeansTheAxisTowardTheLowerEdge) {
  Scene scene = domeAt(25.687, 32.640);
  scene.camera.tilt = 20.0 * degree;
  PlacedScene const placed = place(scene, kPartial);
  // The lower edge is south: the axis now points to altitude 70 degrees in azimuth 180.
  EXPECT_NEAR(towards(placed, 180.0, 70.0).u.z, -1.0, 1e-12);
}

TEST(PlacedScene, RollTurnsThePictureCounterClockwise) {
  Scene scene = domeAt(25.687, 32.640);
  scene.camera.roll = 90.0 * degree;
  // North, which was above, is now at the left.
  EXPECT_NEAR(towards(place(scene, kPartial), 0.0, 0.0).u.x, -1.0, 1e-12);
}

TEST(PlacedScene, SunAndMoonStandWhereTheSiteSeesThem) {
  PlacedScene const placed = place(domeAt(25.687, 32.640), kPartial);
  Site const site{25.687 * degree, 32.640 * degree, 76.0 * metre};
  auto const observer = observerAt(Ephemeris::standard(), site, placed.when);
  for (auto const& b : placed.bodies) {
    if (b.body->name == "Earth") continue;
    auto const seen = apparentPlace(Ephemeris::standard(), bodyNamed(b.body->name, "test"),
                                    observer, placed.when);
    // What the header owns up to: diurnal aberration, 0.32" at most at the equator.
    EXPECT_LT(angleBetween(b.fromCamera, seen.displacement) / arcsecond, 0.33) << b.body->name;
  }
}

TEST(PlacedScene, ATargetIsInTheMiddleOfThePicture) {
  Scene scene = domeAt(25.687, 32.640);
  scene.camera.target = "Moon";
  scene.camera.up = CameraPlacement::Up::Zenith;
  PlacedScene const placed = place(scene, kPartial);
  for (auto const& b : placed.bodies)
    if (b.body->name == "Moon") {
      EXPECT_NEAR(placed.cameraFromIcrs(directionOf(b.fromCamera)).u.z, -1.0, 1e-12);
      EXPECT_TRUE(b.neighbours.empty() || b.neighbours.front().body->name != "Moon");
    }
}

}  // namespace
}  // namespace antumbra
