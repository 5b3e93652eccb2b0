// Media: the reference columns, normalised phase functions, and what a faulty file is told.
#include "medium/medium.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Medium catalogue(const std::string& name) { return readMedium(mediumFile(name)); }

double sphereIntegral(const PhaseFunction& phase, Length wavelength) {
  // Substitution 1 - cosine = 2 t^4 from both ends resolves peaks of g = 0.99; midpoint rule.
  double sum = 0.0;
  int const n = 20000;
  for (int i = 0; i < n; ++i) {
    double const t = (i + 0.5) / n, gap = std::pow(t, 4.0), jacobian = 4.0 * std::pow(t, 3.0) / n;
    sum += jacobian * (phase.at(wavelength, 1.0 - gap) + phase.at(wavelength, gap - 1.0));
  }
  return 2.0 * std::numbers::pi * sum;
}

TEST(PhaseFunction, EveryKindIntegratesToOne) {
  Length const green = 550 * nanometre;
  std::vector<PhaseFunction> phases = {PhaseFunction::isotropic(), PhaseFunction::rayleigh()};
  for (double g : {-0.99, -0.5, 0.0, 0.8, 0.99}) {
    phases.push_back(PhaseFunction::henyeyGreenstein(Spectrum(g)));
    phases.push_back(PhaseFunction::cornetteShanks(Spectrum(g)));
  }
  phases.push_back(
      PhaseFunction::doubleHenyeyGreenstein(Spectrum(0.95), Spectrum(-0.4), Spectrum(0.7)));
  phases.push_back(PhaseFunction::table({0 * degree, 10 * degree, 180 * degree}, {30.0, 3.0, 1.0}));
  phases.push_back(PhaseFunction::legendre({1.0, 0.0, 0.1}));
  for (size_t i = 0; i < phases.size(); ++i)
    EXPECT_NEAR(sphereIntegral(phases[i], green), 1.0, 2e-6) << i;
}

TEST(PhaseFunction, LegendreMomentsOfRayleighAreRayleigh) {
  auto const series = PhaseFunction::legendre({1.0, 0.0, 0.1});
  auto const rayleigh = PhaseFunction::rayleigh();
  for (double x : {-1.0, -0.3, 0.0, 0.6, 1.0})
    EXPECT_NEAR(series.at(550 * nanometre, x) / rayleigh.at(550 * nanometre, x), 1.0, 1e-5) << x;
  EXPECT_NEAR(series.meanCosine(550 * nanometre), 0.0, 1e-6);
  EXPECT_NEAR(PhaseFunction::legendre({1.0, 0.3, 0.1}).meanCosine(550 * nanometre), 0.3, 1e-5);
}

TEST(PhaseFunction, RefusesWhatIsNone) {
  EXPECT_THROW(PhaseFunction::henyeyGreenstein(Spectrum(1.0)), InputError);
  EXPECT_THROW(PhaseFunction::legendre({1.0, 0.9}), InputError);  // negative backwards
  EXPECT_THROW(PhaseFunction::table({0 * degree, 90 * degree}, {1.0, 1.0}), InputError);
  EXPECT_THROW(PhaseFunction::table({0 * degree, 180 * degree}, {1.0, -1.0}), InputError);
}

// Vertical optical depths of tests/authorities/params_bruneton2017_earth.csv.
TEST(Medium, ReferenceColumnsOfBruneton2017) {
  Medium const m = catalogue("reference_bruneton2017");
  EXPECT_EQ(m.radius, 6360 * kilometre);
  EXPECT_EQ(m.topHeight, 60 * kilometre);
  std::ifstream in(rootFolder() / "tests/authorities/params_bruneton2017_earth.csv");
  ASSERT_TRUE(in);
  std::string line;
  int rows = 0;
  while (std::getline(in, line)) {
    double w, sun, rayleigh, mie, extinction, ozone, albedo, tauR, tauM, tauO;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &w, &sun, &rayleigh,
                    &mie, &extinction, &ozone, &albedo, &tauR, &tauM, &tauO) != 10)
      continue;
    ++rows;
    Length const wavelength = w * nanometre;
    // The columns of the table end at 60 km or at infinity: exp(-60/8) = 6e-4 apart.
    EXPECT_NEAR(m.opticalDepth(0, wavelength) / tauR, 1.0, 7e-4) << w;
    EXPECT_NEAR(m.opticalDepth(1, wavelength) / tauM, 1.0, 2e-4) << w;
    EXPECT_NEAR(m.opticalDepth(2, wavelength) / tauO, 1.0, 2e-4) << w;
    auto const at25 = m.coefficientsAt(25 * kilometre, wavelength);
    EXPECT_NEAR(at25[2].absorption.si / ozone, 1.0, 1e-9) << w;
    EXPECT_NEAR(at25[1].scattering.si / at25[1].extinction().si, 0.9, 1e-9) << w;
  }
  EXPECT_EQ(rows, 3);
}

TEST(Medium, EarthHasItsKnownColumns) {
  Medium const m = catalogue("earth");
  // Bucholtz 1995, table 5: Rayleigh optical depth of the US standard atmosphere at 1013.25 hPa,
  // 0.0970 at 550 nm; 1 % for the straight lines in the logarithm of density.
  EXPECT_NEAR(m.opticalDepth(0, 550 * nanometre), 0.0972, 0.0010);
  // 346 Dobson units times the mean cross section about 605 nm.
  EXPECT_NEAR(m.opticalDepth(1, 605 * nanometre), 346.5 * 2.687e20 * 5.019e-25, 5e-4);
}

TEST(Medium, DensityColumnsAgreeWithQuadrature) {
  auto const column = [](const DensityProfile& p) {
    double sum = 0.0;
    for (int i = 0; i < 60000; ++i) sum += p.atMetres(i + 0.5);
    return sum;
  };
  for (auto const& p :
       {DensityProfile::exponential(1.2 * kilometre),
        DensityProfile::table({10 * kilometre, 25 * kilometre, 40 * kilometre}, {0.0, 1.0, 0.0}),
        DensityProfile::logarithmicTable({1 * kilometre, 20 * kilometre, 30 * kilometre},
                                         {1.0, 0.1, 0.1})})
    EXPECT_NEAR(p.column(0 * metre, 60 * kilometre) / metre / column(p), 1.0, 1e-5);
}

TEST(Medium, BelowTheGroundAndAboveTheTop) {
  Medium const m = catalogue("reference_bruneton2017");
  Length const green = 550 * nanometre;
  EXPECT_EQ(m.extinctionAt(-430 * metre, green), m.extinctionAt(0 * metre, green));
  EXPECT_EQ(m.extinctionAt(60.001 * kilometre, green).si, 0.0);
}

const std::string kGood = R"(name = "x"
radius = "1000 km"
top = "50 km"
ground_albedo = 0.3
[[constituent]]
name = "gas"
source = "none"
density = { kind = "exponential", scale_height = "8 km" }
scattering = { per_metre = 1e-5 }
phase = { kind = "rayleigh" }
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  auto const at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
  try {
    (void)parseMedium(text, "m.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(MediumFile, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint(kGood), "no complaint");
  EXPECT_THAT(complaint(replaced(kGood, "\"1000 km\"", "\"-1000 km\"")),
              AllOf(HasSubstr("m.toml:2"), HasSubstr("radius"), HasSubstr("positive")));
  EXPECT_THAT(complaint(replaced(kGood, "\"1000 km\"", "\"1000 deg\"")),
              AllOf(HasSubstr("m.toml:2"), HasSubstr("wrong unit")));
  EXPECT_THAT(complaint(replaced(kGood, "\"50 km\"", "\"0 km\"")), HasSubstr("m.toml:3"));
  EXPECT_THAT(complaint(replaced(kGood, "0.3", "nan")), HasSubstr("m.toml:4"));
  EXPECT_THAT(complaint(replaced(kGood, "0.3", "1.3")),
              AllOf(HasSubstr("m.toml:4"), HasSubstr("1.3")));
  EXPECT_THAT(complaint(replaced(kGood, "\"8 km\"", "\"0 km\"")),
              AllOf(HasSubstr("m.toml:8"), HasSubstr("scale height")));
  EXPECT_THAT(complaint(replaced(kGood, "1e-5", "-1e-5")), HasSubstr("m.toml:9"));
  EXPECT_THAT(complaint(replaced(kGood, "per_metre", "per_meter")), HasSubstr("m.toml:9"));
  EXPECT_THAT(complaint(replaced(kGood, "\"rayleigh\"", "\"raleigh\"")),
              AllOf(HasSubstr("m.toml:10"), HasSubstr("raleigh"), HasSubstr("henyey_greenstein")));
  EXPECT_THAT(complaint(replaced(kGood, "\"rayleigh\"", "\"cornette_shanks\", g = 1.0")),
              HasSubstr("m.toml:10"));
  EXPECT_THAT(complaint(replaced(kGood, "phase = { kind = \"rayleigh\" }", "")),
              HasSubstr("phase"));
  EXPECT_THAT(complaint(replaced(kGood, "radius", "radios")),
              testing::AnyOf(HasSubstr("radius"), HasSubstr("radios")));
  EXPECT_THAT(complaint(kGood + "colour = 3\n"),
              AllOf(HasSubstr("m.toml:11"), HasSubstr("colour")));
  EXPECT_THAT(complaint(replaced(kGood, "{ kind = \"exponential\", scale_height = \"8 km\" }",
                                 "{ kind = \"table\", heights_km = [0, 5], values = [1, -1] }")),
              AllOf(HasSubstr("m.toml:8"), HasSubstr("-1"), HasSubstr("zero or more")));
  EXPECT_THROW(readMedium("/nonexistent.toml"), InputError);
}

TEST(MediumFile, EveryFileOfTheCatalogueLoads) {
  int count = 0;
  for (auto const& entry : std::filesystem::directory_iterator(catalogsFolder() / "atmospheres")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    Medium const m = readMedium(entry.path());
    EXPECT_FALSE(m.constituents.empty()) << entry.path();
    EXPECT_LE(m.firstWavelength() / nanometre, 365.0) << entry.path();
    EXPECT_GE(m.lastWavelength() / nanometre, 800.0) << entry.path();
    for (size_t i = 0; i < m.constituents.size(); ++i)
      EXPECT_TRUE(std::isfinite(m.opticalDepth(i, 550 * nanometre))) << entry.path();
  }
  EXPECT_GE(count, 4);
}

}  // namespace
}  // namespace antumbra
