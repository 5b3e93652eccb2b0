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

TEST(EclipseMap, WritesNoWordsOverEachOther) {
  EclipseBasis const basis;
  for (const char* id : {"2021-12-04", "2027-08-02"}) {
    SolarEvent const event = solarEventOn(basis, id, "test");
    Drawing const map = eclipseMap(event, eclipseCurves(event, basis.radii(), 6.0 * degree), "");
    // A letter is at least half as wide as high; two baselines at least a size apart or side by
    // side.
    auto const span = [](const DrawnWords& w) {
      double const width = 0.5 * w.size * static_cast<double>(w.text.size());
      double const left = w.anchor == DrawnWords::Anchor::Start    ? w.at.x
                          : w.anchor == DrawnWords::Anchor::Middle ? w.at.x - 0.5 * width
                                                                   : w.at.x - width;
      return glm::dvec2(left, left + width);
    };
    EXPECT_GT(map.words.size(), 20u);
    for (std::size_t i = 0; i < map.words.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        auto const &a = map.words[i], &b = map.words[j];
        bool const sideBySide = span(a).x > span(b).y || span(b).x > span(a).y;
        EXPECT_TRUE(sideBySide || std::fabs(a.at.y - b.at.y) > 0.9 * std::min(a.size, b.size))
            << id << ": " << a.text << " over " << b.text;
      }
  }
}

}  // namespace
}  // namespace antumbra
