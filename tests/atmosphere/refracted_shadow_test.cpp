// Light refracted into a shadow: against rays traced through their differential equation, against a
// brute-force count of rays from the whole disc, against published dimming, and without air against
// the geometric shadow.
#include "atmosphere/refracted_shadow.h"
#include "atmosphere/refracted_shadow_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "eclipse/shadow_pair.h"
#include "photometry/standard_spectra.h"
#include "tests/support/csv.h"

namespace antumbra {
namespace {

constexpr Length kEarth{6371e3};
constexpr ShadowStation kMoon{Length(695700e3), Length(149597870.7e3), Length(384400e3)};

Medium medium(const std::string& name) { return readMedium(mediumFile(name)); }

// A ray through the air by d/ds (n dr/ds) = grad n in two dimensions, Runge-Kutta of fourth order
// with steps of `step` metres; the gradient from central differences over 1 m. `b`: distance of the
// incoming line from the centre. Depth by Simpson's rule along the same steps.
struct TracedRay {
  double bending = 0.0, depth = 0.0;
  bool lost = false;
};

TracedRay traceByEquation(const Medium& m, double b, Length wavelength, double step) {
  const DensityProfile* density = nullptr;
  for (Constituent const& c : m.constituents)
    if (c.name == m.refractingConstituent) density = &c.density;
  double const n0 = m.refractivity.at(wavelength), ground = kEarth.si;
  double const top = ground + m.topHeight.si;
  auto const excess = [&](double r) { return n0 * density->atMetres(r - ground); };
  auto const slope = [&](double r) { return (excess(r + 0.5) - excess(r - 0.5)); };
  auto const extinction = [&](double r) {
    return m.extinctionAt(Length(r - ground), wavelength) / InverseLength(1.0);
  };
  // State: place, and n times the direction.
  struct State {
    glm::dvec2 place, ray;
  };
  auto const change = [&](State const& s) {
    double const r = glm::length(s.place);
    return State{s.ray / (1.0 + excess(r)), slope(r) * s.place / r};
  };
  auto const along = [](State const& s, State const& d, double h) {
    return State{s.place + h * d.place, s.ray + h * d.ray};
  };
  State s{{-std::sqrt(top * top - b * b), b}, {1.0, 0.0}};
  TracedRay out;
  while (true) {
    State const k1 = change(s), k2 = change(along(s, k1, 0.5 * step)),
                k3 = change(along(s, k2, 0.5 * step)), k4 = change(along(s, k3, step));
    State const mid = along(s, k2, 0.5 * step);
    State next = s;
    next.place += step / 6.0 * (k1.place + 2.0 * k2.place + 2.0 * k3.place + k4.place);
    next.ray += step / 6.0 * (k1.ray + 2.0 * k2.ray + 2.0 * k3.ray + k4.ray);
    double const r = glm::length(next.place);
    if (r < ground) {
      out.lost = true;
      return out;
    }
    if (r > top && next.place.x > 0.0) break;
    out.depth += step / 6.0 *
                 (extinction(glm::length(s.place)) + 4.0 * extinction(glm::length(mid.place)) +
                  extinction(r));
    s = next;
  }
  out.bending = -std::atan2(s.ray.y, s.ray.x);
  return out;
}

TEST(LimbRays, AgreeWithTheRaysDifferentialEquation) {
  Medium const m = medium("earth");
  Length const green = 550.0 * nanometre;
  for (double height : {100.0, 1500.0, 5000.0, 11000.0, 21000.0, 38000.0}) {
    LimbRay const ray = limbRay(m, kEarth, Length(height), m.refractivity.at(green));
    TracedRay const traced = traceByEquation(m, ray.impact.si, green, 250.0);
    ASSERT_FALSE(traced.lost) << height;
    double depth = 0.0;
    for (std::size_t c = 0; c < m.constituents.size(); ++c)
      depth += ray.columns[c].si *
               (m.constituents[c].scattering.at(green) + m.constituents[c].absorption.at(green));
    // 0.3 % of the bending: the kinks of the tabulated density under steps of 250 m.
    EXPECT_NEAR(traced.bending / ray.bending.si, 1.0, 3e-3) << height;
    EXPECT_NEAR(traced.depth / depth, 1.0, 3e-3) << height;
  }
}

// The shadow by brute force: rays from random points of the disc through random points of the limb,
// bent by the traced rays' angle about the body's centre in three dimensions, counted in rings of
// the plane behind. Bins are 200 km wide.
std::vector<double> countedShadow(const Medium& m, Length wavelength, int rays, int bins) {
  // Traced once over the impact parameter; rows 100 m apart below 30 km, 250 m to 60 km.
  std::vector<double> at, bending, depth;
  double const ground = kEarth.si, top = ground + m.topHeight.si;
  for (double b = ground; b <= top; b += b < ground + 30e3   ? 100.0
                                         : b < ground + 60e3 ? 250.0
                                                             : 1000.0) {
    TracedRay const ray = traceByEquation(m, b, wavelength, 250.0);
    at.push_back(b);
    bending.push_back(ray.bending);
    depth.push_back(ray.lost ? INFINITY : ray.depth);
  }
  LimbProfile const profile = limbProfile(LimbDarkeningLaw::Hestroffer, wavelength);
  double const mean = 2.0 / (profile.exponent + 2.0);
  std::mt19937_64 random(20281231);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double const outer = ground + 3700e3;  // beyond the penumbra of the bins counted
  std::vector<double> light(static_cast<std::size_t>(bins), 0.0);
  double const D = kMoon.sunDistance.si, L = kMoon.behind.si, sun = kMoon.sunRadius.si;
  for (int i = 0; i < rays; ++i) {
    // Strata: dense air, thin air, close beside all air, far beside it.
    constexpr std::array<int, 8> kStratum{0, 0, 0, 1, 2, 2, 2, 3};
    constexpr std::array<double, 4> kShare{3.0 / 8.0, 1.0 / 8.0, 3.0 / 8.0, 1.0 / 8.0};
    std::array<double, 5> const edges{ground, ground + 15e3, top, top + 300e3, outer};
    auto const stratum = static_cast<std::size_t>(kStratum[static_cast<std::size_t>(i % 8)]);
    double const from = edges[stratum], to = edges[stratum + 1];
    double const b0 = std::sqrt(from * from + (to * to - from * from) * uniform(random));
    double const area = std::numbers::pi * (to * to - from * from);
    double const turn = 2.0 * std::numbers::pi * uniform(random);
    double const radius = sun * std::sqrt(uniform(random));
    double const mu = std::sqrt(1.0 - radius * radius / (sun * sun));
    double const brightness = std::pow(mu, profile.exponent) / mean;
    glm::dvec3 const source(radius, 0.0, -D);
    glm::dvec3 const through(b0 * std::cos(turn), b0 * std::sin(turn), 0.0);
    glm::dvec3 direction = glm::normalize(through - source);
    // The line's own point nearest the centre.
    glm::dvec3 const nearest = through - glm::dot(through, direction) * direction;
    double const b = glm::length(nearest);
    if (b < ground) continue;
    double transmittance = 1.0, angle = 0.0;
    if (b < top) {
      auto const after = std::upper_bound(at.begin() + 1, at.end() - 1, b);
      auto const k = static_cast<std::size_t>(after - at.begin());
      double const t = (b - at[k - 1]) / (at[k] - at[k - 1]);
      if (!std::isfinite(depth[k - 1]) || !std::isfinite(depth[k])) continue;
      transmittance = std::exp(-(depth[k - 1] + t * (depth[k] - depth[k - 1])));
      angle = bending[k - 1] + t * (bending[k] - bending[k - 1]);
    }
    glm::dvec3 const out = nearest / b;
    glm::dvec3 const bent = std::cos(angle) * direction - std::sin(angle) * out;
    // The outgoing line is as far from the centre as the incoming one.
    glm::dvec3 const foot = b * (std::cos(angle) * out + std::sin(angle) * direction);
    double const rest = (L - foot.z) / bent.z;
    glm::dvec3 const landing = foot + rest * bent;
    double const rho = std::hypot(landing.x, landing.y);
    auto const bin = static_cast<std::size_t>(rho / 200e3);
    if (bin < light.size())
      light[bin] += area / (kShare[stratum] * rays) * brightness * transmittance;
  }
  double const focus = (1.0 + L / D) * (1.0 + L / D);
  for (std::size_t bin = 0; bin < light.size(); ++bin) {
    double const inner = 200e3 * double(bin), edge = inner + 200e3;
    light[bin] *= focus / (std::numbers::pi * (edge * edge - inner * inner));
  }
  return light;
}

TEST(RefractedShadow, AgreesWithRaysCountedByBruteForce) {
  Medium m = medium("earth");
  // Cloud heights count from tangent points; leave them out of a comparison of rays.
  m.clearHeights.clear();
  m.clearShares.clear();
  Length const orange = 600.0 * nanometre;
  RefractedShadow const shadow(m, kEarth, {orange}, LimbDarkeningLaw::Hestroffer);
  constexpr int kBins = 40;
  auto const counted = countedShadow(m, orange, 8000000, kBins);
  for (int bin = 1; bin < kBins; bin += 2) {
    // Mean of the ring, by Simpson's rule over its area.
    double mean = 0.0, weight = 0.0;
    for (int k = 0; k <= 40; ++k) {
      double const rho = 200e3 * (bin + k / 40.0), w = rho * (k == 0 || k == 40 ? 1
                                                              : k % 2           ? 4
                                                                                : 2);
      mean += w * shadow.lightAt(kMoon, Length(rho))[0];
      weight += w;
    }
    mean /= weight;
    // Twice the count's own noise: 3 % in the umbra, 1 % outside.
    EXPECT_NEAR(counted[static_cast<std::size_t>(bin)] / mean, 1.0, bin < 24 ? 0.03 : 0.01)
        << bin * 200 << " km";
  }
}

TEST(RefractedShadow, WithoutAirIsTheGeometricShadow) {
  Medium empty;
  empty.radius = kEarth;
  empty.topHeight = 100.0 * kilometre;
  empty.constituents.push_back({"nothing", DensityProfile::exponential(8.0 * kilometre),
                                Spectrum(0.0), Spectrum(0.0), PhaseFunction::isotropic()});
  Length const green = 550.0 * nanometre;
  for (auto law : {LimbDarkeningLaw::Hestroffer, LimbDarkeningLaw::Neckel}) {
    RefractedShadow const shadow(empty, kEarth, {green}, law);
    auto const darkening = limbDarkening(law, {green, green, green, green});
    glm::dvec3 const sun(0.0, 0.0, -(kMoon.sunDistance.si + kMoon.behind.si));
    auto const pair = shadowPairMetres(sun, glm::dvec3(0.0, 0.0, -kMoon.behind.si),
                                       {kMoon.sunRadius, kEarth, kEarth});
    for (double rho = 100e3; rho < 8500e3; rho += 200e3) {
      double const exact = glsl::visibleSunlight(pair, darkening, glm::dvec3(rho, 0.0, 0.0)).x;
      // 2e-4 of the whole Sun: quadrature over the limb's nodes near the disc's edge.
      EXPECT_NEAR(shadow.lightAt(kMoon, Length(rho))[0], exact, 2e-4) << rho;
    }
    EXPECT_NEAR(shadow.lightAt(kMoon, shadow.reach(kMoon))[0], 1.0, 1e-4);
  }
}

double published(const std::string& quantity, std::size_t which = 0) {
  for (auto const& row : readCsv("tests/authorities/eclipse_lunar_published.csv"))
    if (row.text("quantity") == quantity && which-- == 0) return row.number("value");
  throw std::runtime_error(quantity + ": not in the authority file");
}

// Dimming weighted by sunlight and `sensitivity`, as a function of the distance from the axis, by
// straight lines in the logarithm.
struct Dimming {
  std::vector<double> logarithms;
  double stepMetres = 50e3;
  double at(double rho) const {
    double const x = std::min(rho / stepMetres, double(logarithms.size()) - 1.001);
    auto const i = static_cast<std::size_t>(x);
    return std::exp(logarithms[i] + (x - double(i)) * (logarithms[i + 1] - logarithms[i]));
  }
};

std::vector<Length> visible(double firstNm, double lastNm) {
  std::vector<Length> w;
  for (double nm = firstNm; nm <= lastNm; nm += 20.0) w.push_back(nm * nanometre);
  return w;
}

Dimming photopicDimming(const std::string& name, double lastMetres) {
  auto const wavelengths = visible(400.0, 720.0);
  RefractedShadow const shadow(medium(name), kEarth, wavelengths, LimbDarkeningLaw::Hestroffer);
  Dimming dimming;
  for (double rho = 0.0; rho <= lastMetres; rho += dimming.stepMetres) {
    auto const light = shadow.lightAt(kMoon, Length(rho));
    double sum = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < light.size(); ++i) {
      double const w = solarIrradiance(wavelengths[i]) * photopicEfficiency(wavelengths[i]);
      sum += w * light[i];
      whole += w;
    }
    dimming.logarithms.push_back(std::log(sum / whole));
  }
  return dimming;
}

// Published for the irradiance of a molecular sea-level Earth without ozone; here the visible band,
// 400 to 700 nm, at the Moon's mean distance.
TEST(RefractedShadow, CentreOfACleanUmbraIsAsDimAsPublished) {
  auto const wavelengths = visible(400.0, 700.0);
  RefractedShadow const shadow(medium("earth_molecular"), kEarth, wavelengths,
                               LimbDarkeningLaw::Hestroffer);
  auto const light = shadow.lightAt(kMoon, Length(0.0));
  double sum = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    double const w =
        solarIrradiance(wavelengths[i]) * (i == 0 || i + 1 == light.size() ? 0.5 : 1.0);
    sum += w * light[i];
    whole += w;
  }
  double const wanted =
      published("umbra-centre irradiance reduction clean molecular atmosphere no ozone");
  RecordProperty("dimming", std::to_string(whole / sum));
  EXPECT_NEAR(whole / sum / wanted, 1.0, 0.15) << whole / sum;
}

// V of the full Moon at mean distance, -12.73 (Allen), dimmed over its disc, which is uniform.
double eclipsedMagnitude(const Dimming& dimming, double gammaEarthRadii) {
  double sum = 0.0;
  int count = 0;
  for (int i = -40; i <= 40; ++i)
    for (int j = -40; j <= 40; ++j) {
      double const x = i / 40.0 * 1737.4e3, y = j / 40.0 * 1737.4e3;
      if (x * x + y * y > 1737.4e3 * 1737.4e3) continue;
      sum += dimming.at(std::hypot(x + gammaEarthRadii * 6378137.0, y));
      ++count;
    }
  return -12.73 - 2.5 * std::log10(sum / count);
}

TEST(RefractedShadow, EclipsedMoonOfTheOrdinaryAirIsAsBrightAsMeasured) {
  Dimming const dimming = photopicDimming("earth", 4600e3);
  // Gamma of 1990-02-09, 2007-03-03 and 2022-11-08 (JPL DE431; NASA canon).
  struct Row {
    double gamma, measured;
  };
  double const brightest = published("eclipsed Moon minimum visual magnitude", 0);
  double const faintest = published("eclipsed Moon minimum visual magnitude", 1);
  for (auto const& [gamma, measured] :
       {Row{0.4148, brightest}, Row{0.3175, faintest},
        Row{0.2570, published("eclipsed Moon minimum visual magnitude", 2)}}) {
    double const v = eclipsedMagnitude(dimming, gamma);
    EXPECT_GT(v, brightest) << gamma;
    EXPECT_LT(v, faintest) << gamma;
    // Air differs from year to year: the three measured ones scatter by as much.
    EXPECT_NEAR(v, measured, 0.7) << gamma;
  }
  // A deep umbra's centre is dimmed "of the order of 100" beyond the clean one.
  double const extra = photopicDimming("earth_molecular", 100e3).at(0.0) / dimming.at(0.0);
  EXPECT_GT(extra, 30.0);
  EXPECT_LT(extra, 300.0);
}

TEST(RefractedShadow, VolcanicAirDarkensTheMoonByMagnitudes) {
  double const v = eclipsedMagnitude(photopicDimming("earth_volcanic", 4600e3), 0.3);
  EXPECT_GT(v, 1.0);
  EXPECT_LT(v, 5.0);
}

// Copper inside, turquoise at the rim: red over blue falls below that of sunlight where ozone takes
// the orange light from rays high in the air.
TEST(RefractedShadow, CentreIsRedAndTheRimIsBlue) {
  std::vector<Length> const w{440.0 * nanometre, 560.0 * nanometre, 600.0 * nanometre};
  RefractedShadow const shadow(medium("earth"), kEarth, w, LimbDarkeningLaw::Hestroffer);
  auto const centre = shadow.lightAt(kMoon, 1000.0 * kilometre);
  EXPECT_GT(centre[2] / centre[0], 30.0);
  auto const rim = shadow.lightAt(kMoon, 4550.0 * kilometre);
  EXPECT_LT(rim[2] / rim[0], 0.9);
  RefractedShadow const clean(medium("earth_molecular"), kEarth, w, LimbDarkeningLaw::Hestroffer);
  auto const without = clean.lightAt(kMoon, 4550.0 * kilometre);
  EXPECT_GT(without[2] / without[0], 1.0);  // no ozone, no turquoise
}

// Observers place the umbra's edge where light falls steepest: 1.3 to 2.3 % beyond the shadow of a
// bare Earth (Danjon adds 1/85 of the Moon's parallax, 1.6 %; Chauvenet 1/50).
TEST(RefractedShadow, AirEnlargesTheUmbraAsObserved) {
  Dimming const dimming = photopicDimming("earth", 5200e3);
  double steepest = 0.0, edge = 0.0;
  for (double rho = 4300e3; rho < 5000e3; rho += 5e3) {
    double const slope = std::log(dimming.at(rho + 25e3) / dimming.at(rho - 25e3));
    if (slope > steepest) {
      steepest = slope;
      edge = rho;
    }
  }
  double const sine = (kMoon.sunRadius.si - kEarth.si) / kMoon.sunDistance.si;
  double const bare = (kEarth.si - kMoon.behind.si * sine) / std::sqrt(1.0 - sine * sine);
  RecordProperty("enlargement_percent", std::to_string(100.0 * (edge / bare - 1.0)));
  EXPECT_GT(edge / bare, 1.010);
  EXPECT_LT(edge / bare, 1.026);
}

// Rows follow the light at stations between their nodes.
TEST(RefractedShadowTable, RowsAreWithinOnePercentOfTheLight) {
  std::vector<Length> const w{444.0 * nanometre, 632.0 * nanometre};
  Medium const m = medium("earth");
  RefractedShadow const shadow(m, kEarth, w, LimbDarkeningLaw::Hestroffer);
  RefractedShadowTable table(m, kEarth, kMoon.sunRadius, w, LimbDarkeningLaw::Hestroffer);
  for (double behind : {358e6, 381e6, 404e6}) {
    ShadowStation const at{kMoon.sunRadius, Length(1.4727e11), Length(behind)};
    auto const row = table.row(at);
    for (std::size_t place = 0; place < RefractedShadowTable::kPlaces; place += 9) {
      auto const light = shadow.lightAt(at, table.distance(static_cast<int>(place), at));
      for (std::size_t band = 0; band < 2; ++band)
        EXPECT_NEAR(std::exp2(row[place * 2 + band]) / light[band], 1.0, place ? 0.01 : 0.02)
            << place << " of " << RefractedShadowTable::kPlaces << " at " << behind;
    }
  }
  EXPECT_LE(table.nodesComputed(), 12);
  // The same station twice is the same row, whatever has been asked for between.
  ShadowStation const at{kMoon.sunRadius, Length(1.4727e11), Length(381e6)};
  RefractedShadowTable fresh(m, kEarth, kMoon.sunRadius, w, LimbDarkeningLaw::Hestroffer);
  EXPECT_EQ(table.row(at), fresh.row(at));
}

// Any body with air: Venus' refraction traps light below a height, Titan's air is thick, Mars'
// thin. Nothing is negative or infinite, and the shadow ends in free light.
TEST(RefractedShadow, ServesEveryMedium) {
  struct Row {
    const char* name;
    double radius, behind;
  };
  for (auto const& [name, radius, behind] :
       {Row{"venus", 6051.8e3, 1e9}, Row{"mars", 3396.2e3, 9.4e6}, Row{"titan", 2574.7e3, 1.2e9},
        Row{"earth_volcanic", 6371e3, 384400e3}}) {
    RefractedShadow const shadow(medium(name), Length(radius),
                                 {450.0 * nanometre, 650.0 * nanometre},
                                 LimbDarkeningLaw::Hestroffer);
    ShadowStation const at{Length(695700e3), Length(2e11), Length(behind)};
    double const reach = shadow.reach(at).si;
    for (int i = 0; i <= 40; ++i)
      for (double light : shadow.lightAt(at, Length(reach * i / 40.0))) {
        EXPECT_TRUE(std::isfinite(light)) << name;
        EXPECT_GE(light, 0.0) << name;
        EXPECT_LT(light, 1.2) << name;
      }
    EXPECT_NEAR(shadow.lightAt(at, Length(reach))[0], 1.0, 1e-4) << name;
  }
}

}  // namespace
}  // namespace antumbra
