// Keys, mouse and wheel of the window, without one.
#include "app/view_controls.h"

#include <gtest/gtest.h>

namespace antumbra {
namespace {

Scene exampleScene() {
  Scene s;
  s.picture = {ProjectionKind::Perspective, 60.0 * degree, 600, 400};
  s.camera.azimuth = 10.0 * degree;
  return s;
}

TEST(ViewControls, StandsStillUntilSpaceIsPressed) {
  ViewControls c(exampleScene());
  c.advance(2.0 * second);
  EXPECT_EQ(c.timeOffset(), Duration());
  c.togglePause();
  c.advance(2.0 * second);
  EXPECT_EQ(c.timeOffset(), 2.0 * second);
}

TEST(ViewControls, RatesRunThroughOneToBackwards) {
  ViewControls c(exampleScene());
  c.changeRate(+1);
  EXPECT_EQ(c.rate(), 5.0);
  c.changeRate(-1);
  c.changeRate(-1);
  EXPECT_EQ(c.rate(), -1.0);
  for (int i = 0; i < 40; ++i) c.changeRate(+1);
  EXPECT_EQ(c.rate(), 864000.0);
  c.step(-1);
  EXPECT_EQ(c.timeOffset(), -10.0 * day);
}

TEST(ViewControls, DragTurnsTheSkyWithTheMouse) {
  ViewControls c(exampleScene());
  double const pixel = c.scene().picture.pixelAngle() / degree;
  c.drag(10.0, 20.0);
  EXPECT_NEAR(c.scene().camera.azimuth / degree, 10.0 - 10.0 * pixel, 1e-9);
  EXPECT_NEAR(c.scene().camera.altitude / degree, 20.0 * pixel, 1e-9);
  c.drag(0.0, 1e6);
  EXPECT_NEAR(c.scene().camera.altitude / degree, 89.9, 1e-9);
}

TEST(ViewControls, ZoomStaysWithinTheProjection) {
  ViewControls c(exampleScene());
  c.zoom(1.0);
  EXPECT_NEAR(c.scene().picture.field / degree, 54.0, 1e-9);
  c.zoom(-100.0);
  EXPECT_NEAR(c.scene().picture.field / degree, 150.0, 1e-9);
}

}  // namespace
}  // namespace antumbra
