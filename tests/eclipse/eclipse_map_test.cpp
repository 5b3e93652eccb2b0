// The curves of an eclipse lie where the circumstances say, and the map holds them.
#include "eclipse/eclipse_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "eclipse/local_circumstances.h"

namespace antumbra {
namespace {

TEST(EclipseCurves, LieWhereTheCircumstancesSay) {
  EclipseBasis const basis;
  SolarEvent const event = solarEventOn(basis, "2027-08-02", "test");
  // A coarse grid: the refinement of each crossing is what counts.
  EclipseCurves const curves = eclipseCurves(event, basis.radii(), 6.0 * degree);
  int isolines = 0, horizon = 0, penumbra = 0;
  for (auto const& curve : curves.curves) {
    for (std::size_t i = 0; i < curve.sites.size(); i += 7) {
      Site const& site = curve.sites[i];
      auto const local = localCircumstances(event, basis.radii(), site);
      if (curve.kind == CurveKind::EqualMagnitude && local.type == "P") {
        EXPECT_NEAR(local.magnitude, curve.magnitude, 0.01);
        ++isolines;
      }
      if (curve.kind == CurveKind::PenumbraLimit) {
        EXPECT_LT(local.magnitude, 0.02);
        ++penumbra;
      }
      if (curve.kind == CurveKind::MaximumOnHorizon && local.maximum) {
        EXPECT_NEAR(local.maximum->sun.altitude / degree, 0.0, 0.3);
        ++horizon;
      }
      if (curve.kind == CurveKind::CentralLine) {
        EXPECT_EQ(local.type, "T");
      }
    }
  }
  EXPECT_GT(isolines, 10);
  EXPECT_GT(penumbra, 2);
  EXPECT_GT(horizon, 2);
  EXPECT_GE(curves.marks.size(), 18u);  // 3.3 hours of totality, every ten minutes
}

TEST(EclipseMap, IsAWholeSvg) {
  EclipseBasis const basis;
  for (const char* id : {"2026-02-17", "2025-03-29"}) {
    SolarEvent const event = solarEventOn(basis, id, "test");
    std::string const svg =
        svgOf(eclipseMap(event, eclipseCurves(event, basis.radii(), 6.0 * degree), "the basis"));
    EXPECT_EQ(svg.rfind("</svg>\n"), svg.size() - 7);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_NE(svg.find("the basis"), std::string::npos);
    EXPECT_NE(svg.find(id), std::string::npos);
    EXPECT_EQ(std::count(svg.begin(), svg.end(), '<'), std::count(svg.begin(), svg.end(), '>'));
  }
}

}  // namespace
}  // namespace antumbra
