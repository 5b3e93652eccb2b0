// Requested errors are kept, with few terms.
#include "ephemeris/tier_measurement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/input_error.h"
#include "ephemeris/ephemeris.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

// `antumbra trade ephemeris` measures 1e5 dates; here fewer, drawn differently from those that made
// the table of tiers.
TEST(Tiers, RequestedErrorIsNeverExceeded) {
  for (const auto& body : tierBodies()) {
    TierMeasurer const measurer(body, TierSpan::NearPresent, 3000, 4711);
    for (double error : {10.0, 1.0, 0.1}) {
      auto const tier = tierFor(body, TierSpan::NearPresent, error * arcsecond);
      ASSERT_GT(tier.thresholdRadians, 0.0) << body;
      auto const m = measurer.measure(tier.thresholdRadians);
      EXPECT_EQ(m.terms, tier.terms) << body;
      EXPECT_LT(m.worst() / arcsecond, error) << body;
      // A bound that always holds is above what random dates reach.
      EXPECT_GT(m.droppedSum / arcsecond, m.heliocentricMax / arcsecond) << body;
    }
  }
}

TEST(Tiers, TermsStayNearThePublishedCurve) {
  // tests/authorities/truncation_curve.csv: terms and errors of the same theories cut at round
  // thresholds; between its rows log-log interpolation.
  std::map<std::string, std::vector<std::pair<double, double>>> curves;
  for (const auto& row : readCsv("tests/authorities/truncation_curve.csv"))
    if (row.number("geo_max_arcsec_vs_full") > 0.0)
      curves[row.text("body") == "Earth" ? "Sun" : row.text("body")].push_back(
          {row.number("geo_max_arcsec_vs_full"), row.number("n_terms")});
  for (const auto& body : tierBodies())
    for (double error : {10.0, 1.0, 0.1}) {
      auto const& curve = curves.at(body);
      double terms = 0.0;
      for (std::size_t i = 1; i < curve.size(); ++i)
        if (curve[i].first <= error && error <= curve[i - 1].first) {
          double const u =
              std::log(curve[i - 1].first / error) / std::log(curve[i - 1].first / curve[i].first);
          terms = curve[i - 1].second * std::pow(curve[i].second / curve[i - 1].second, u);
          break;
        }
      auto const tier = tierFor(body, TierSpan::NearPresent, error * arcsecond);
      EXPECT_LE(static_cast<double>(tier.terms), 1.5 * terms) << body << " " << error;
    }
}

TEST(Tiers, EphemerisKeepsTheRequestAndStatesItsBound) {
  Ephemeris const full({.theory = Theory::Series});
  for (double error : {10.0, 1.0, 0.1}) {
    Ephemeris const cut({.theory = Theory::Series, .error = error * arcsecond});
    for (int i = 0; i < 60; ++i) {
      auto const t = Instant::fromTt({2415100.0 + 1213.7 * i, 0.0});
      for (BodyId body :
           {BodyId::Sun, BodyId::Moon, BodyId::Venus, BodyId::Mars, BodyId::SaturnBarycentre}) {
        EXPECT_LT(angleBetween(cut.state(body, BodyId::Earth, t).position,
                               full.state(body, BodyId::Earth, t).position) /
                      arcsecond,
                  error)
            << nameOf(body);
        EXPECT_GE(cut.errorBound(body, BodyId::Earth, t).si,
                  full.errorBound(body, BodyId::Earth, t).si);
      }
    }
    // Far from the present the powers of time need terms of their own.
    auto const ancient = Instant::fromTt({700000.0, 0.0});
    EXPECT_LT(angleBetween(cut.state(BodyId::Mars, BodyId::Earth, ancient).position,
                           full.state(BodyId::Mars, BodyId::Earth, ancient).position) /
                  arcsecond,
              error);
  }
  EXPECT_THROW(Ephemeris({.error = -1.0 * arcsecond}), InputError);
}

TEST(Tiers, FullSeriesStayWithinTheStatedErrorPerMillennium) {
  Ephemeris const full({.theory = Theory::Series});
  for (const auto& row : readCsv("tests/authorities/geocentric_geometric.csv")) {
    auto const named = bodyFromName(row.text("body"));
    if (!named || *named == BodyId::Pluto) continue;
    auto const body = systemOf(*named);
    auto const t = Instant::fromTdb({row.number("jd_tdb"), 0.0});
    Displacement<Icrs> const truth{astronomicalUnit.si * glm::dvec3(row.number("x_au"),
                                                                    row.number("y_au"),
                                                                    row.number("z_au"))};
    auto const s = full.state(body, BodyId::Earth, t);
    EXPECT_LT(angleBetween(s.position, truth), full.errorBound(body, BodyId::Earth, t))
        << row.text("body") << " " << t.julianYear();
  }
}

}  // namespace
}  // namespace antumbra
