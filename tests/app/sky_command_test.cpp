// `antumbra sky`: its output formats, and what bad input is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/commands.h"
#include "document/input_error.h"
#include "document/paths.h"
#include "medium/medium.h"
#include "photometry/magnitude.h"

namespace antumbra {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string bruneton() { return mediumFile("reference_bruneton2017").string(); }

// What the command prints, or the message of its InputError.
std::string sky(const std::string& options) {
  CLI::App program;
  addSkyCommand(program);
  testing::internal::CaptureStdout();
  std::string complaint;
  try {
    program.parse("sky " + options);
  } catch (const InputError& error) {
    complaint = error.what();
  } catch (const CLI::ParseError& error) {
    complaint = std::string("command line: ") + error.what();
  }
  std::string const printed = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(complaint.empty() || printed.empty()) << "half an answer before an error";
  return complaint.empty() ? printed : complaint;
}

class SkyCommand : public testing::Test {
 protected:
  SkyCommand()
      : directions_(std::filesystem::temp_directory_path() /
                    ("antumbra_sky_" + std::to_string(::getpid()) + ".csv")) {}
  ~SkyCommand() override { std::filesystem::remove(directions_); }
  // Options with a file of these directions.
  std::string look(const std::string& lines, const std::string& options) {
    std::ofstream(directions_) << lines;
    return sky("--medium " + bruneton() + " --directions " + directions_.string() + " " + options);
  }
  std::filesystem::path directions_;
};

const std::string kTwo = "view_zenith_deg,rel_azimuth_deg\n45,0\n100.50,-90\n";

TEST_F(SkyCommand, PrintsRowsInInputOrderWavelengthsInnermost) {
  std::string const out =
      look(kTwo, "--sun-zenith 60 --wavelengths 550,440 --method single --altitude-km 10");
  std::istringstream in(out);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u) << out;
  EXPECT_EQ(lines[0], "view_zenith_deg,rel_azimuth_deg,wavelength_nm,radiance,stderr");
  EXPECT_TRUE(lines[1].starts_with("45,0,550,")) << out;
  EXPECT_TRUE(lines[2].starts_with("45,0,440,")) << out;
  EXPECT_TRUE(lines[3].starts_with("100.50,-90,550,")) << out;
}

TEST_F(SkyCommand, SiUnitsAreTheSunTimesTheRelativeOnes) {
  auto const valueOf = [](const std::string& out) {
    double value = 0.0;
    EXPECT_EQ(std::sscanf(out.c_str() + out.find("45,0,550,"), "45,0,550,%lf", &value), 1) << out;
    return value;
  };
  std::string const options = "--sun-zenith 60 --wavelengths 550 --method single";
  double const ratio = valueOf(look(kTwo, options + " --units SI")) / valueOf(look(kTwo, options));
  double const far = valueOf(look(kTwo, options + " --units SI --sun-distance-au 2")) /
                     valueOf(look(kTwo, options + " --units SI"));
  EXPECT_NEAR(far, 0.25, 1e-5);    // six printed digits
  EXPECT_NEAR(ratio, 1.86, 0.03);  // W m-2 nm-1 at 550 nm, ASTM E490
}

TEST_F(SkyCommand, LuminanceAndIrradiance) {
  std::string const base = "--medium " + bruneton() + " --sun-zenith 30 --method single ";
  EXPECT_THAT(sky(base + "--irradiance --wavelengths 550"),
              testing::StartsWith("wavelength_nm,direct,diffuse\n550,0.735"));
  EXPECT_THAT(sky(base + "--irradiance --luminance"),
              testing::StartsWith("direct_lx,diffuse_lx,x,y\n"));
  EXPECT_THAT(look(kTwo, "--sun-zenith 30 --method single --luminance"),
              testing::StartsWith("view_zenith_deg,rel_azimuth_deg,luminance_cd_m2,x,y\n45,0,"));
}

TEST_F(SkyCommand, ASpheroidChangesTheLightALittle) {
  std::string const options = "--sun-zenith 60 --wavelengths 550 --method single --altitude-km 2 ";
  auto const radianceOf = [](const std::string& out) {
    double zenith = 0.0, turn = 0.0, wavelength = 0.0, radiance = 0.0;
    std::sscanf(out.c_str() + out.find('\n') + 1, "%lf,%lf,%lf,%lf", &zenith, &turn, &wavelength,
                &radiance);
    return radiance;
  };
  double const sphere = radianceOf(look(kTwo, options));
  // The Earth's flattening changes an angle by 0.19 deg and a length by 0.34 % at most.
  double const spheroid =
      radianceOf(look(kTwo, options + "--body Earth --latitude 45 --sun-azimuth 120"));
  EXPECT_NE(spheroid, sphere);
  EXPECT_NEAR(spheroid / sphere, 1.0, 0.01);
}

TEST_F(SkyCommand, OccultedAxisHasNoDirectLight) {
  std::string const base =
      "--medium " + bruneton() + " --sun-zenith 35 --wavelengths 550 --irradiance --method single ";
  EXPECT_THAT(sky(base + "--occulter ratio=1.0515,shift-km=0"), HasSubstr("550,0,"));
  // The light of the crescent by an independent quadrature of I = mu^alpha over it: 7.2774e-4 of
  // the Sun's, at the direct irradiance of the uneclipsed 0.68886.
  double direct = 0.0, diffuse = 0.0;
  std::string const out = sky(base + "--occulter ratio=1.0515,shift-km=100");
  ASSERT_EQ(std::sscanf(out.c_str() + out.find("550,"), "550,%lf,%lf", &direct, &diffuse), 2)
      << out;
  EXPECT_NEAR(direct / (7.2774e-4 * 0.68886), 1.0, 1e-3);
  EXPECT_GT(diffuse, 0.0);
}

TEST_F(SkyCommand, SeveralOccultersHideTheSunByTheirUnion) {
  std::string const base =
      "--medium " + bruneton() + " --sun-zenith 35 --wavelengths 550 --irradiance --method single ";
  std::string const left = "--occulter ratio=1.0515,shift-km=-900 ";
  std::string const right = "--occulter ratio=1.0515,shift-km=900 ";
  auto const direct = [&](const std::string& occulters) {
    std::string const out = sky(base + occulters);
    auto const row = out.find("550,");
    return row == std::string::npos ? -1.0 : std::atof(out.c_str() + row + 4);
  };
  double const alone = direct(left);
  EXPECT_GT(alone, 0.1);
  EXPECT_NEAR(direct(left + left), alone, 3e-4);  // what the union's arcs are held to
  // From either side the two discs, larger than the Sun, leave two cusps of it.
  double const both = direct(left + right);
  EXPECT_LT(both, 0.15 * alone);
  EXPECT_GT(both, 0.0);
  std::string seven;
  for (int i = 0; i < 7; ++i) seven += right;
  EXPECT_THAT(sky(base + seven), AllOf(HasSubstr("found 7 times"), HasSubstr("up to 6")));
  EXPECT_THAT(sky(base + left + "--occulter ratio=1.05"), HasSubstr("shift-km= is missing"));
}

// The two numbers behind a line that ends with `header`.
std::pair<double, double> firstTwo(const std::string& out, const std::string& header) {
  double first = -1.0, second = -1.0;
  auto const at = out.find(header);
  EXPECT_NE(at, std::string::npos) << out;
  if (at == std::string::npos) return {first, second};
  EXPECT_EQ(std::sscanf(out.c_str() + at + header.size(), "%lf,%lf", &first, &second), 2) << out;
  return {first, second};
}

// Mid-totality under a high Sun by the programs of pictures. Expected: 4.1 lx on the horizontal by
// the luxmeter of 2006-03-29 and by the Monte Carlo of eclipse_mc_reference.csv (whose medium this
// is; bar 15 %), and the zenith as sky quality meters of 2017-08-21 read it, with 0.2 mag for their
// band.
TEST_F(SkyCommand, TotalityIsAsBrightAsMeasured) {
  double measuredLux = 0.0, brightest = 0.0, faintest = 0.0;
  std::ifstream in(rootFolder() / "tests/authorities/eclipse_solar_published.csv");
  for (std::string line; std::getline(in, line);) {
    auto const value = line.substr(line.find(',') + 1);
    if (line.starts_with("horizontal illuminance at mid-totality")) measuredLux = std::stod(value);
    if (line.starts_with("zenith sky brightness at totality")) {
      ASSERT_EQ(std::sscanf(value.c_str(), "%lf-%lf", &brightest, &faintest), 2) << line;
    }
  }
  ASSERT_EQ(measuredLux, 4.1);
  std::string const totality = "--sun-zenith 35 --occulter ratio=1.0515,shift-km=0 --luminance ";
  for (std::string const method : {"balanced", "accurate"})
    for (std::string const corona : {"", " --corona 0.5"}) {
      if (method == "accurate" && !corona.empty()) continue;  // the corona is no matter of presets
      std::string const options = totality + "--method " + method + corona;
      auto const [direct, diffuse] = firstTwo(
          sky("--medium " + bruneton() + " --irradiance " + options), "direct_lx,diffuse_lx,x,y\n");
      auto const out = look("view_zenith_deg,rel_azimuth_deg\n0,0\n", options);
      auto const zenith = surfaceBrightnessOfLuminance(firstTwo(out, "x,y\n0,0,").first);
      std::printf("%s%s: %.2f lx (%.3f direct), zenith %.2f mag/arcsec2\n", method.c_str(),
                  corona.c_str(), direct + diffuse, direct, zenith);
      EXPECT_NEAR((direct + diffuse) / measuredLux, 1.0, 0.15) << options;
      EXPECT_GT(zenith, brightest - 0.14) << options;
      EXPECT_LT(zenith, faintest + 0.27) << options;
      if (corona.empty()) {
        EXPECT_EQ(direct, 0.0);
      } else {
        // 0.98e-6 of 133 klx, through the air's 0.85 to 0.83 of a slant by 35 degrees.
        EXPECT_NEAR(direct, 0.09, 0.01);
      }
    }
}

TEST_F(SkyCommand, BadInputNamesOptionFindingAndAllowance) {
  std::string const wave = "--sun-zenith 60 --wavelengths 550 --method single ";
  EXPECT_THAT(sky("--sun-zenith 60 --medium /nowhere.toml"), HasSubstr("/nowhere.toml"));
  EXPECT_THAT(look(kTwo, "--wavelengths 550 --sun-zenith nan"), HasSubstr("--sun-zenith"));
  EXPECT_THAT(look(kTwo, "--wavelengths 550 --sun-zenith 181"),
              AllOf(HasSubstr("181"), HasSubstr("180")));
  EXPECT_THAT(look(kTwo, "--wavelengths 200 --sun-zenith 60"),
              AllOf(HasSubstr("200 nm"), HasSubstr("360")));
  EXPECT_THAT(look(kTwo, "--sun-zenith 60"), HasSubstr("--wavelengths: missing"));
  EXPECT_THAT(look(kTwo, "--sun-zenith 60 --wavelengths 550 --method best"),
              AllOf(HasSubstr("best"), HasSubstr("reference")));
  EXPECT_THAT(look(kTwo, wave + "--units cgs"), HasSubstr("--units"));
  EXPECT_THAT(look(kTwo, wave + "--sun-distance-au 0"), HasSubstr("--sun-distance-au"));
  EXPECT_THAT(look(kTwo, wave + "--sun ring"), HasSubstr("--sun"));
  EXPECT_THAT(look(kTwo, wave + "--format json"), HasSubstr("--format"));
  EXPECT_THAT(look(kTwo, wave + "--albedo 1.5"), HasSubstr("--albedo"));
  EXPECT_THAT(look(kTwo, wave + "--altitude-km -7000"), HasSubstr("--altitude-km"));
  EXPECT_THAT(look(kTwo, wave + "--stderr 0%"), HasSubstr("--stderr"));
  EXPECT_THAT(look(kTwo, wave + "--seed -1"), HasSubstr("--seed"));
  EXPECT_THAT(look(kTwo, wave + "--limb-darkening quadratic"), HasSubstr("neckel"));
  EXPECT_THAT(look(kTwo, wave + "--occulter ratio=1.05"), HasSubstr("shift-km= is missing"));
  EXPECT_THAT(look(kTwo, wave + "--occulter ratio=-1,shift-km=0"), HasSubstr("ratio"));
  EXPECT_THAT(look(kTwo, wave + "--body Earth --latitude 45"), HasSubstr("--sun-azimuth"));
  EXPECT_THAT(look(kTwo, wave + "--latitude 45"), HasSubstr("without --body"));
  std::string const there = wave + "--sun-azimuth 90 --latitude ";
  EXPECT_THAT(look(kTwo, there + "91 --body Earth"),
              AllOf(HasSubstr("91"), HasSubstr("-90 to 90")));
  EXPECT_THAT(look(kTwo, there + "45 --body Erath"), AllOf(HasSubstr("Erath"), HasSubstr("Earth")));
  EXPECT_THAT(look(kTwo, there + "45 --body Earth --occulter ratio=1.05,shift-km=0"),
              HasSubstr("--occulter"));
  EXPECT_THAT(look(kTwo, wave + "--corona 0.5"), HasSubstr("--occulter"));
  EXPECT_THAT(look(kTwo, wave + "--occulter ratio=1.05,shift-km=0 --corona 2"),
              AllOf(HasSubstr("--corona"), HasSubstr("found 2"), HasSubstr("0 to 1")));
  EXPECT_THAT(look("", wave), HasSubstr("holds no direction"));
  EXPECT_THAT(look("zenith,azimuth\n1,2\n", wave), AllOf(HasSubstr(":1"), HasSubstr("header")));
  EXPECT_THAT(look(kTwo + "200,0\n", wave), AllOf(HasSubstr(":4"), HasSubstr("view_zenith_deg")));
  EXPECT_THAT(look(kTwo + "20\n", wave), AllOf(HasSubstr(":4"), HasSubstr("columns")));
  EXPECT_THAT(look(kTwo + "20,0,\n", wave), AllOf(HasSubstr(":4"), HasSubstr("3 columns")));
  EXPECT_THAT(look(kTwo + "20,\n", wave), AllOf(HasSubstr(":4"), HasSubstr("found \"\"")));
  EXPECT_THAT(look("\x01\xff\n", wave), HasSubstr("found \"\\x01\\xff\""));
  // The byte order mark of a spreadsheet.
  EXPECT_THAT(look("\xef\xbb\xbf" + kTwo, wave), testing::StartsWith("view_zenith_deg"));
  std::string const file = "--medium " + bruneton() + " " + wave, folder = "/tmp";
  EXPECT_THAT(sky(file + "--directions " + folder),
              AllOf(HasSubstr("--directions"), HasSubstr("cannot be read")));
  EXPECT_THAT(sky(wave + "--medium " + folder), HasSubstr("/tmp: cannot be read"));
}

TEST_F(SkyCommand, RefusesWhatIsEmptyTwiceOrMeansNothing) {
  std::string const wave = "--sun-zenith 60 --method single --wavelengths ";
  for (std::string const empty : {"--albedo", "--body", "--latitude", "--sun-azimuth", "--corona"})
    EXPECT_THAT(look(kTwo, wave + "550 " + empty + " \" \""), HasSubstr(empty)) << empty;
  EXPECT_THAT(look(kTwo, wave + "\" \""), HasSubstr("--wavelengths: found \"\""));
  EXPECT_THAT(look(kTwo, wave + "550,"), HasSubstr("--wavelengths: found \"\""));
  EXPECT_THAT(look(kTwo, wave + "550 --occulter ratio=1,ratio=2,shift-km=0"),
              AllOf(HasSubstr("ratio"), HasSubstr("allowed: once")));
  EXPECT_THAT(look(kTwo, wave + "550 --body Sun --latitude 1 --sun-azimuth 2"),
              AllOf(HasSubstr("found Sun"), HasSubstr("planets and moons")));
  EXPECT_THAT(look(kTwo, wave + "550 --altitude-km -20"),
              AllOf(HasSubstr("found -20"), HasSubstr("-19.08")));
  // No colour without the ends of the visible spectrum.
  for (std::string const few : {"550", "550,551", "550,600,650", "420,440,460"})
    EXPECT_THAT(look(kTwo, wave + few + " --luminance"),
                AllOf(HasSubstr("--luminance"), HasSubstr("470 nm"), HasSubstr("590 nm")))
        << few;
  EXPECT_THAT(look(kTwo, wave + "440,440,680 --luminance"),
              AllOf(HasSubstr("--wavelengths"), HasSubstr("ascending")));
}

// Nothing is moved without a word: pictures are drawn from the surface at least.
TEST_F(SkyCommand, SaysThatPresetsLookFromTheGroundAtLeast) {
  std::string const at = "--sun-zenith 60 --wavelengths 550 --method draft --altitude-km ";
  testing::internal::CaptureStderr();
  std::string const below = look(kTwo, at + "-0.43");
  std::string const note = testing::internal::GetCapturedStderr();
  EXPECT_EQ(below, look(kTwo, at + "0"));
  EXPECT_THAT(note, AllOf(HasSubstr("0.43 km below"), HasSubstr("draft")));
}

// Above the air the sky is black by every method.
TEST_F(SkyCommand, NoDiffuseLightAboveTheAir) {
  for (std::string const method : {"draft", "single"})
    EXPECT_EQ(sky("--medium " + bruneton() +
                  " --sun-zenith 60 --wavelengths 550 --irradiance --altitude-km 1000 --method " +
                  method),
              "wavelength_nm,direct,diffuse\n550,0.5,0\n");
}

}  // namespace
}  // namespace antumbra
