// Pixels to directions and back, and the rectangle around a cap.
#include "view/projection.h"

#include <gtest/gtest.h>

#include <random>

#include "document/input_error.h"

namespace antumbra {
namespace {

const Projection kAll[] = {
    {ProjectionKind::Perspective, 60.0 * degree, 1280, 720},
    {ProjectionKind::Perspective, 0.01 * degree, 640, 640},
    {ProjectionKind::Fisheye, 180.0 * degree, 1024, 1024},
    {ProjectionKind::Fisheye, 360.0 * degree, 512, 512},
    {ProjectionKind::Equirectangular, 360.0 * degree, 1024, 512},
};

TEST(Projection, RoundTripsWithinABillionthOfAPixel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.001, 0.999);
  for (auto const& p : kAll)
    for (int i = 0; i < 1000; ++i) {
      double const x = unit(random) * p.width, y = unit(random) * p.height;
      auto const direction = p.directionAt(x, y);
      if (!direction) continue;  // a fisheye's mask
      auto const back = p.pixelOf(*direction);
      ASSERT_TRUE(back) << nameOf(p.kind);
      EXPECT_NEAR(back->x, x, 1e-6) << nameOf(p.kind);
      EXPECT_NEAR(back->y, y, 1e-6) << nameOf(p.kind);
    }
}

TEST(Projection, FisheyeIsEquidistantWithItsMask) {
  Projection const dome{ProjectionKind::Fisheye, 180.0 * degree, 1000, 1000};
  auto const half = dome.directionAt(750.0, 500.0);
  ASSERT_TRUE(half);
  EXPECT_NEAR(angleBetween(*half, Direction<CameraAxes>{{0, 0, -1}}) / degree, 45.0, 1e-9);
  EXPECT_FALSE(dome.directionAt(2.0, 2.0));
  EXPECT_NEAR(dome.pixelAngle() / degree, 0.18, 1e-12);
}

TEST(Projection, BoundsHoldEveryPixelOfACap) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> logRadius(-4.0, 0.4);
  for (auto const& p : kAll)
    for (int i = 0; i < 40; ++i) {
      Direction<CameraAxes> const centre{
          glm::normalize(glm::dvec3{normal(random), normal(random), normal(random) - 1.0})};
      Angle const radius(std::pow(10.0, logRadius(random)));
      PixelBounds const b = boundsOfCap(p, centre, radius);
      for (int y = 0; y < p.height; y += 7)
        for (int x = 0; x < p.width; x += 7) {
          auto const d = p.directionAt(x + 0.5, y + 0.5);
          if (!d || angleBetween(*d, centre) >= radius) continue;
          ASSERT_TRUE(x >= b.x0 && x < b.x1 && y >= b.y0 && y < b.y1)
              << nameOf(p.kind) << " pixel " << x << "," << y << " radius " << radius / degree;
        }
    }
}

TEST(Projection, RefusesWhatCannotBeDrawn) {
  Projection p;
  p.width = 0;
  EXPECT_THROW(p.check("--size"), InputError);
  p = {ProjectionKind::Perspective, 180.0 * degree, 10, 10};
  EXPECT_THROW(p.check("field"), InputError);
  p = {ProjectionKind::Fisheye, Angle(std::nan("")), 10, 10};
  EXPECT_THROW(p.check("field"), InputError);
  p = {ProjectionKind::Fisheye, 360.0 * degree, 10, 10};
  EXPECT_NO_THROW(p.check("field"));
}

}  // namespace
}  // namespace antumbra
