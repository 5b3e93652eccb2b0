// Predictions of solar eclipses against an independent program on JPL DE431.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <chrono>
#include <cmath>
#include <map>

#include "document/input_error.h"
#include "eclipse/besselian.h"
#include "eclipse/central_path.h"
#include "eclipse/eclipse_search.h"
#include "eclipse/local_circumstances.h"
#include "tests/support/csv.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

// Metres between two places given in degrees, for short distances.
double metresBetween(double latitudeA, double longitudeA, double latitudeB, double longitudeB) {
  double const turn = std::remainder(longitudeA - longitudeB, 360.0);
  return 111.2e3 * std::hypot(latitudeA - latitudeB, turn * std::cos(latitudeA * M_PI / 180.0));
}

// What a list of differences comes to; checked against the bars and printed.
class Differences {
 public:
  void add(double value) {
    sumOfSquares_ += value * value;
    largest_ = testsupport::larger(largest_, std::fabs(value));
    ++count_;
  }
  double rms() const { return std::sqrt(sumOfSquares_ / std::max(count_, 1)); }
  double largest() const { return largest_; }
  int count() const { return count_; }
  void print(const char* name, const char* unit) const {
    std::printf("%-28s %4d values, rms %.2e, largest %.2e %s\n", name, count_, rms(), largest_,
                unit);
  }

 private:
  double sumOfSquares_ = 0.0, largest_ = 0.0;
  int count_ = 0;
};

const std::vector<SolarEclipse>& twoCenturies() {
  static const std::vector<SolarEclipse> all =
      solarEclipses(EclipseBasis{}, startOfYear(1900), startOfYear(2101));
  return all;
}

TEST(SolarPrediction, FindsEveryEclipseOfTwoCenturies) {
  // The count of Espenak & Meeus, NASA/TP-2006-214141, for these years.
  EXPECT_EQ(twoCenturies().size(), 454u);
}

TEST(SolarPrediction, GlobalCircumstancesAgree) {
  std::map<std::string, SolarEclipse> found;
  for (auto const& e : twoCenturies()) found[e.id] = e;
  Differences time, position, gamma, magnitude, duration, width, contact;
  for (auto const& row : readCsv("tests/authorities/solar_eclipses.csv")) {
    ASSERT_TRUE(found.count(row.text("ecl_id"))) << row.text("ecl_id");
    SolarEclipse const& e = found[row.text("ecl_id")];
    EXPECT_EQ(e.type, row.text("type_k_nasa")) << e.id;
    EXPECT_EQ(e.saros, static_cast<int>(row.number("nasa_saros"))) << e.id;
    time.add((e.greatest.tt().value() - row.number("jd_tt_greatest")) * 86400.0);
    gamma.add(e.gamma - row.number("gamma"));
    bool const central = row.number("central") > 0.5;
    EXPECT_EQ(e.central, central) << e.id;
    magnitude.add(e.magnitude -
                  row.number(central ? "magnitude_k_nasa" : "disc_fraction_magnitude_kpen"));
    // The Earth turns with delta T: compare at the printed one.
    double const turned = e.place.longitude / degree -
                          1.00273791 * (e.deltaT / second - row.number("deltaT_s")) / 240.0;
    if (central && row.number("sun_alt_deg") > 5.0)
      position.add(metresBetween(e.place.latitude / degree, turned, row.number("lat_deg"),
                                 row.number("lon_deg_east")));
    if (e.duration) duration.add(*e.duration / second - row.number("duration_s_k_nasa"));
    if (e.width && row.number("sun_alt_deg") > 10.0)
      width.add(*e.width / metre - 1e3 * row.number("width_km_k_nasa"));
    auto const contactOf = [&](const std::optional<Instant>& t, const char* column) {
      EXPECT_EQ(t.has_value(), !row.empty(column)) << e.id << " " << column;
      if (t && !row.empty(column)) contact.add((t->tt().value() - row.number(column)) * 86400.0);
    };
    contactOf(e.p1, "P1_jd_tt");
    contactOf(e.u1, "U1_jd_tt");
    contactOf(e.c1, "C1_jd_tt");
    contactOf(e.c4, "C4_jd_tt");
    contactOf(e.u4, "U4_jd_tt");
    contactOf(e.p4, "P4_jd_tt");
  }
  time.print("greatest", "s");
  position.print("greatest, place", "m");
  gamma.print("gamma", "");
  magnitude.print("magnitude", "");
  duration.print("duration", "s");
  width.print("width", "m");
  contact.print("P, U, C contacts", "s");
  // The bars of the field: the authority itself is good to 0.1-0.3 s and 0.1 km.
  EXPECT_LT(time.rms(), 0.1);
  EXPECT_LT(time.largest(), 0.25);
  EXPECT_LT(position.largest(), 500.0);
  EXPECT_LT(gamma.largest(), 1e-5);
  // 1e-5, and what the rounding of the authority adds.
  EXPECT_LT(magnitude.largest(), 1.5e-5);
  EXPECT_LT(duration.largest(), 0.1);
  EXPECT_LT(width.largest(), 200.0);
  // Grazing contacts multiply small errors.
  EXPECT_LT(contact.rms(), 1.0);
}

// The authority takes the path's direction as the azimuth, five seconds before the instant, of the
// geodesic to five seconds after it. Meridians converge over those seconds, so that its line across
// the path stands askew by up to 0.33 degrees where a low Sun makes the umbra run at 5 km/s. This
// azimuth reproduces its line.
double authorityAzimuth(const SolarEvent& event, const ShadowRadii& radii, double seconds) {
  auto const before = centralPlace(event.track, radii, seconds - 5.0);
  auto const after = centralPlace(event.track, radii, seconds + 5.0);
  double distance = 0, azimuth = 0, unused = 0;
  GeographicLib::Geodesic::WGS84().Inverse(before->latitude / degree, before->longitude / degree,
                                           after->latitude / degree, after->longitude / degree,
                                           distance, azimuth, unused);
  return azimuth;
}

TEST(SolarPrediction, CentralLinesAgree) {
  Differences place, limit, grazed, duration, width, ratio;
  auto const& geodesic = GeographicLib::Geodesic::WGS84();
  std::map<std::string, SolarEvent> events;
  EclipseBasis const basis;
  for (auto const& row : readCsv("tests/authorities/solar_central_lines.csv")) {
    std::string const id = row.text("ecl_id");
    if (!events.count(id)) events.emplace(id, solarEventOn(basis, id, "test"));
    SolarEvent const& event = events.at(id);
    double const jd = row.number("jd_tt");
    auto const point =
        centralPoint(event.track, basis.radii(),
                     event.track.secondsAt(Instant::fromTt({std::floor(jd), jd - std::floor(jd)})));
    ASSERT_TRUE(point) << id << " " << jd;
    // The printed longitude is that of the printed delta T; both give the ephemeris longitude.
    double const turn = -1.00273791 * (event.eclipse.deltaT / second) / 240.0;
    double const printed = row.number("lon_ephemeris_deg_east") - row.number("lon_deg_east");
    EXPECT_EQ(point->phase == CentralPhase::Total ? "T" : "A", row.text("phase_k_nasa"));
    ratio.add(point->magnitude - row.number("moon_sun_ratio_k_nasa"));
    place.add(metresBetween(point->place.latitude / degree, point->place.longitude / degree + turn,
                            row.number("lat_deg"), row.number("lon_ephemeris_deg_east")));
    duration.add(point->duration / second - row.number("duration_s_k_nasa"));
    double const altitude = row.number("sun_alt_deg");
    if (altitude > 10.0) width.add(point->width / metre - 1e3 * row.number("width_km_k_nasa"));
    ASSERT_TRUE(point->left && point->right);
    auto const grazedOn = [&](const Site& ours, double turnOfLine, const char* latitude,
                              const char* longitude) {
      double distance = 0, a = 0, b = 0, lat = 0, lon = 0;
      geodesic.Inverse(point->place.latitude / degree, point->place.longitude / degree,
                       ours.latitude / degree, ours.longitude / degree, distance, a, b);
      geodesic.Direct(point->place.latitude / degree, point->place.longitude / degree,
                      authorityAzimuth(event, basis.radii(), point->seconds) + turnOfLine, distance,
                      lat, lon);
      grazed.add(
          metresBetween(lat, lon + turn, row.number(latitude), row.number(longitude) + printed));
    };
    if (altitude > 5.0) {
      grazedOn(*point->left, -90.0, "left_limit_lat", "left_limit_lon");
      grazedOn(*point->right, 90.0, "right_limit_lat", "right_limit_lon");
    }
    if (altitude > 10.0) {
      limit.add(metresBetween(point->left->latitude / degree,
                              point->left->longitude / degree + turn, row.number("left_limit_lat"),
                              row.number("left_limit_lon") + printed));
      limit.add(
          metresBetween(point->right->latitude / degree, point->right->longitude / degree + turn,
                        row.number("right_limit_lat"), row.number("right_limit_lon") + printed));
    }
  }
  place.print("central line", "m");
  limit.print("limits", "m");
  grazed.print("limits on the same line", "m");
  duration.print("duration", "s");
  width.print("width", "m");
  EXPECT_GT(place.count(), 50);
  EXPECT_LT(place.largest(), 200.0);
  EXPECT_LT(limit.largest(), 400.0);
  EXPECT_GT(grazed.count(), limit.count());
  EXPECT_LT(grazed.largest(), 40.0);  // twice what the central points differ by
  EXPECT_LT(duration.largest(), 0.1);
  EXPECT_LT(width.largest(), 200.0);
  EXPECT_LT(ratio.largest(), 3e-6);
}

// Seconds of a day from "2027-08-02T10:02:06.606".
double secondsOfDay(const std::string& iso) {
  return 3600.0 * std::stod(iso.substr(11, 2)) + 60.0 * std::stod(iso.substr(14, 2)) +
         std::stod(iso.substr(17));
}

TEST(SolarPrediction, LocalContactsAgree) {
  Differences contact, maximum, magnitude, obscuration, altitude;
  for (auto const& row : readCsv("tests/authorities/solar_local.csv")) {
    EclipseBasis basis;
    basis.deltaT = row.number("deltaT_s") * second;
    SolarEvent const event = solarEventOn(basis, row.text("ecl_id"), "test");
    Site const site{row.number("lat_deg") * degree, row.number("lon_deg_east") * degree,
                    row.number("height_m") * metre};
    auto const local = localCircumstances(event, basis.radii(), site);
    EXPECT_EQ(local.type, row.text("type")) << row.text("site");
    auto const compare = [&](const std::optional<LocalContact>& c, const char* column,
                             Differences& into) {
      EXPECT_EQ(c.has_value(), !row.empty(column)) << row.text("site") << " " << column;
      if (c && !row.empty(column))
        into.add(secondsOfDay(ut1Text(c->instant, event.eclipse.deltaT)) -
                 secondsOfDay(row.text(column)));
    };
    compare(local.c1, "C1_ut1", contact);
    compare(local.c2, "C2_ut1_k_nasa", contact);
    compare(local.maximum, "max_ut1", maximum);
    compare(local.c3, "C3_ut1_k_nasa", contact);
    compare(local.c4, "C4_ut1", contact);
    magnitude.add(local.magnitude - row.number("magnitude"));
    obscuration.add(local.obscuration - row.number("obscuration"));
    altitude.add(local.c1->sun.altitude / degree - row.number("alt_C1"));
  }
  contact.print("local contacts", "s");
  maximum.print("local maximum", "s");
  magnitude.print("local magnitude", "");
  EXPECT_LT(contact.rms(), 0.08);
  EXPECT_LT(contact.largest(), 0.2);
  EXPECT_LT(maximum.largest(), 1.0);  // a flat maximum
  EXPECT_LT(magnitude.largest(), 2e-5);
  EXPECT_LT(obscuration.largest(), 3e-5);
  EXPECT_LT(altitude.largest(), 0.002);
}

TEST(SolarPrediction, BesselianElementsAgree) {
  Differences plane, axis, radii;
  EclipseBasis const basis;
  std::map<std::string, SolarEvent> events;
  for (auto const& row : readCsv("tests/authorities/solar_besselian.csv")) {
    std::string const id = row.text("ecl_id");
    if (!events.count(id)) events.emplace(id, solarEventOn(basis, id, "test"));
    SolarEvent const& event = events.at(id);
    double const jd = row.number("jd_tt");
    double const seconds =
        event.track.secondsAt(Instant::fromTt({std::floor(jd), jd - std::floor(jd)}));
    auto const e = besselianElements(event.track, basis.radii(), seconds);
    plane.add(6378137.0 * (e.x - row.number("x")));
    plane.add(6378137.0 * (e.y - row.number("y")));
    axis.add(3600.0 * (e.dDegrees - row.number("d_deg")));
    radii.add(6378137.0 * (e.l1 - row.number("l1")));
    radii.add(6378137.0 * (e.l2 - row.number("l2")));
    auto const p = besselianPolynomials(event, basis.radii());
    double const hours = (event.track.secondsAt(p.reference) - seconds) / -3600.0;
    auto const& c = p.coefficients[0];
    if (std::fabs(hours) < 3.0) {
      // The residual that the polynomials state, and a digit for its sampling.
      EXPECT_NEAR(c[0] + hours * (c[1] + hours * (c[2] + hours * c[3])), e.x,
                  1.3 * p.largestResidual[0]);
    }
  }
  plane.print("Besselian x, y", "m");
  axis.print("Besselian d", "arcsec");
  radii.print("Besselian l1, l2", "m");
  EXPECT_LT(plane.largest(), 100.0);
  EXPECT_LT(axis.largest(), 0.1);
  EXPECT_LT(radii.largest(), 5.0);
}

// Three eclipses of five millennia hang on half a kilometre, a third of an arcsecond of the Moon:
// on 0050-10-04 the penumbra just reaches the Earth, on -1577-03-30 the umbra does, and on
// 0332-03-13 the antumbra just does not. Places of JPL DE431 decide as the series do.
TEST(SolarPrediction, BorderCasesAreThoseOfDe431) {
  EclipseBasis const basis;
  std::map<std::string, std::string> const types{
      {"0050-10-04", "P"}, {"-1577-03-30", "Tnc"}, {"0332-03-13", "P"}};
  int rows = 0;
  for (auto const& row : readCsv("tests/authorities/solar_border_cases.csv")) {
    std::string const id = row.text("ecl_id");
    auto const place = [&](const std::string& body) {
      return 1e3 * glm::dvec3(row.number(body + "_x_km"), row.number(body + "_y_km"),
                              row.number(body + "_z_km"));
    };
    SolarEvent const event = solarEventOn(basis, id, "test");
    EXPECT_EQ(event.eclipse.type, types.at(id));
    auto const truth = shadowPairMetres(place("sun"), place("moon"), basis.radii());
    double const jd = row.number("jd_tt");
    auto const ours = event.track.shadowAt(
        event.track.secondsAt(Instant::fromTt({std::floor(jd), jd - std::floor(jd)})),
        basis.radii());
    EXPECT_LT(penumbraClearance(truth).metres, 0.0) << id;
    EXPECT_LT(penumbraClearance(ours).metres, 0.0) << id;
    EXPECT_EQ(umbraClearance(truth).metres < 0.0, types.at(id) == "Tnc") << id;
    EXPECT_EQ(umbraClearance(ours).metres < 0.0, types.at(id) == "Tnc") << id;
    std::printf("%s: penumbra %+.0f m (DE431 %+.0f m), umbra %+.0f m (DE431 %+.0f m)\n", id.c_str(),
                penumbraClearance(ours).metres, penumbraClearance(truth).metres,
                umbraClearance(ours).metres, umbraClearance(truth).metres);
    // 0.4" of the Moon: the error of the series so long ago.
    EXPECT_NEAR(umbraClearance(ours).metres, umbraClearance(truth).metres, 800.0) << id;
    ++rows;
  }
  EXPECT_EQ(rows, 3);
}

// On 2044-02-28 the antumbra leaves the Earth to the right of the central line: annularity has no
// limit there, though the cone comes out again on the night side, 1400 km on.
TEST(SolarPrediction, ALimitBeyondTheTerminatorDoesNotExist) {
  EclipseBasis const basis;
  SolarEvent const event = solarEventOn(basis, "2044-02-28", "test");
  EXPECT_EQ(event.eclipse.type, "A");
  EXPECT_FALSE(event.eclipse.width);
  auto const point =
      centralPoint(event.track, basis.radii(), event.track.secondsAt(event.eclipse.greatest));
  ASSERT_TRUE(point);
  EXPECT_TRUE(point->left);
  EXPECT_FALSE(point->right);
  // Every limit that is given lies where the Sun is up.
  for (auto const& p : centralLine(event.track, basis.radii(), event.eclipse, 60.0 * second))
    for (auto const& limit : {p.left, p.right})
      if (limit) {
        double deepest = -1e9, when = 0.0;
        for (double t = p.seconds - 900.0; t < p.seconds + 900.0; t += 10.0) {
          double const depth = umbraDepth(event.track, basis.radii(), itrsMetres(*limit), t);
          if (depth > deepest) deepest = depth, when = t;
        }
        EXPECT_NEAR(deepest, 0.0, 200.0);  // ten seconds of sampling about the top
        EXPECT_GT(solarAppearance(event.track, basis.radii(), *limit, when).sun.altitude / degree,
                  -0.4);
      }
}

TEST(SolarPrediction, FootprintIsTheEdgeOfTheUmbra) {
  EclipseBasis const basis;
  for (const char* id : {"2027-08-02", "2023-10-14", "2005-04-08"}) {
    SolarEvent const event = solarEventOn(basis, id, "test");
    double const t = event.track.secondsAt(event.eclipse.greatest) + 600.0;
    auto const outline = umbraFootprint(event.track, basis.radii(), t);
    EXPECT_GE(outline.size(), 60u) << id;
    for (auto const& s : outline)
      EXPECT_NEAR(umbraDepth(event.track, basis.radii(), itrsMetres(s), t), 0.0, 0.01) << id;
  }
}

TEST(SolarPrediction, TellsTheNearestEclipsesOfAWrongDate) {
  try {
    solarEventOn(EclipseBasis{}, "2027-08-03", "DATE");
    FAIL();
  } catch (const InputError& error) {
    std::string const message = error.what();
    EXPECT_NE(message.find("2027-08-02"), std::string::npos) << message;
    EXPECT_NE(message.find("2028-01-26"), std::string::npos) << message;
  }
  EXPECT_THROW(startOfDate("2027-02-30", "DATE"), InputError);
  EXPECT_THROW(startOfDate("2027-8-2", "DATE"), InputError);
  EXPECT_THROW(solarEclipses(EclipseBasis{}, startOfYear(4000), startOfYear(4002)), SpanError);
}

TEST(SolarPrediction, ALocalCircumstanceTakesLessThanAMillisecond) {
  EclipseBasis const basis;
  SolarEvent const event = solarEventOn(basis, "2027-08-02", "test");
  auto const start = std::chrono::steady_clock::now();
  constexpr int kSites = 50;
  int seen = 0;
  for (int i = 0; i < kSites; ++i) {
    Site const site{(20.0 + 0.1 * i) * degree, 30.0 * degree, 0.0 * metre};
    seen += localCircumstances(event, basis.radii(), site).c1.has_value();
  }
  double const each =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / kSites;
  std::printf("local circumstances: %.3f ms a site\n", 1e3 * each);
  EXPECT_EQ(seen, kSites);
  EXPECT_LT(each, 5e-3);  // five times the bar, for a machine shared with other work
}

}  // namespace
}  // namespace antumbra
