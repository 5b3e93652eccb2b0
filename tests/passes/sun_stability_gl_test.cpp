// Random Suns, occulters, pictures: no NaN, no infinity, no negative light, and no sunlight where
// the whole disc is hidden.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "passes/corona.h"
#include "passes/glare.h"
#include "passes/stars.h"
#include "passes/sun.h"
#include "plan/render_plan.h"
#include "tests/passes/sun_scene.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/sky_picture.h"

namespace antumbra {
namespace {

using SunStabilityGlTest = testsupport::GlTest;

TEST_F(SunStabilityGlTest, LightIsFiniteAndNotNegative) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  SunOcclusion occlusion;
  for (ProjectionKind kind :
       {ProjectionKind::Perspective, ProjectionKind::Fisheye, ProjectionKind::Equirectangular}) {
    SunPass sunPass(kind);
    CoronaPass corona(kind);
    GlarePass glare(kind);
    StarsPass stars(kind);
    for (int i = 0; i < 40; ++i) {
      // Fields from 0.01 to 170 degrees (perspective) or 360 (fisheye).
      double const widest = kind == ProjectionKind::Perspective ? 170.0 : 360.0;
      Projection const p{
          kind, std::pow(10.0, -2.0 + unit(random) * std::log10(widest * 100.0)) * degree, 32, 32};
      // From 0.01 to 100 au, anywhere or near the axis.
      glm::dvec3 const aim = i % 2 ? glm::dvec3(normal(random), normal(random), normal(random))
                                   : glm::dvec3(0.3 * p.field.si * normal(random),
                                                0.3 * p.field.si * normal(random), -1.0);
      SunInView sun = testsupport::sunAt(aim);
      double const au = std::pow(10.0, -2.0 + 4.0 * unit(random));
      sun.centre.m *= au;
      sun.illuminanceLux /= au * au;
      sun.north = {glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)))};
      SunPlane const plane(sun);
      std::vector<SpheroidInView> bodies;
      if (i % 3)
        bodies.push_back(testsupport::moonBefore(sun, std::pow(10.0, -1.0 + 1.3 * unit(random)),
                                                 {normal(random), normal(random)}));
      if (i % 4 == 1) {
        // The ground, a metre below.
        Length const r = 6.4e6 * metre;
        glm::dvec3 const down =
            glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        bodies.push_back({{(r.si + 1.0) * down}, {down}, r, r});
      }
      std::vector<Silhouette> const outlines = plane.silhouettes(bodies, glsl::kCoronaEnd);
      occlusion.ask(sun, plane, outlines);
      VisibleSun const visible = occlusion.wait();
      ASSERT_TRUE(std::isfinite(visible.area) && visible.area >= 0.0 && visible.area < 1.01) << i;
      StarPoint const star{glm::vec3(plane.centre().u), glm::vec3(1e-3f)};
      testsupport::SkyPicture picture(p);
      double sunlight = 0.0;
      picture.draw([&] { sunPass.draw(p, sun, plane, outlines); });
      for (float value : picture.texels) sunlight += value;
      bool const sealed = analyticVisibleSun(plane, sun.law, outlines).area == 0.0;
      if (sealed) {
        EXPECT_EQ(sunlight, 32.0 * 32.0) << i;
      }  // alpha alone
      Eye eye;
      eye.magnification = magnificationOf(p);
      picture.draw([&] {
        stars.draw({{star}});
        stars.drawHalos(p, {{star}}, eye);
        sunPass.draw(p, sun, plane, outlines);
        corona.draw(p, sun, plane, outlines, {unit(random)});
        glare.draw(p, plane, visible, sun.illuminanceLux, eye);
      });
      for (float value : picture.texels)
        ASSERT_TRUE(std::isfinite(value) && value >= 0.0f) << nameOf(kind) << " case " << i;
    }
  }
}

}  // namespace
}  // namespace antumbra
