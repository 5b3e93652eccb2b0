#include "scene/star_catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra {
namespace {

const StarCatalogue& catalogue() {
  static const StarCatalogue loaded = StarCatalogue::load(catalogsFolder() / "stars");
  return loaded;
}

Direction<Icrs> directionOf(double raDegrees, double decDegrees) {
  Angle const ra = raDegrees * degree, dec = decDegrees * degree;
  return {{cos(dec) * cos(ra), cos(dec) * sin(ra), sin(dec)}};
}

Instant atJulianYear(double year) { return Instant::fromTt({2451545.0, 365.25 * (year - 2000.0)}); }

TEST(StarCatalogue, AgreesWithTheHipparcosCatalogueAtItsOwnEpoch) {
  std::ifstream file(rootFolder() / "tests/authorities/hipparcos_1997.csv");
  ASSERT_TRUE(file);
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'h') continue;
    std::istringstream in(line);
    double hip, ra, dec, parallax, pmRa, pmDec, v, bv;
    char comma;
    in >> hip >> comma >> ra >> comma >> dec >> comma >> parallax >> comma >> pmRa >> comma >>
        pmDec >> comma >> v >> comma >> bv;
    ASSERT_TRUE(in) << line;
    const Star& star = catalogue().byNumber(static_cast<int>(hip));
    // Brought back 8.75 years. Steps of 0.0001 degrees allow 0.25" on the diagonal.
    auto const direction = directionAt(star, atJulianYear(1991.25));
    EXPECT_LT(angleBetween(direction, directionOf(ra, dec)) / arcsecond, 0.27) << line;
    AngularRate const masPerYear = 1e-3 * arcsecond / (365.25 * day);
    EXPECT_NEAR(star.motionEast / masPerYear, pmRa, 0.56) << line;  // step 1, source 0.1
    EXPECT_NEAR(star.motionNorth / masPerYear, pmDec, 0.56) << line;
    // Listed to 0.1 mas.
    // rounding.
    EXPECT_NEAR(star.parallax / (1e-3 * arcsecond), parallax, 0.11) << line;
    // XHIP's V and B-V are Hipparcos' but for variables: Betelgeuse 0.0-1.6.
    EXPECT_NEAR(star.magnitudeV, v, 0.015) << line;
    ASSERT_TRUE(star.colorBv) << line;
    EXPECT_NEAR(*star.colorBv, bv, 0.0015) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 6);
}

TEST(StarCatalogue, ProperMotionMoves61CygniByItsPublishedRate) {
  // 5.281" a year at position angle 51.9 degrees (ESA 1997).
  const Star& star = catalogue().byNumber(104214);
  auto const before = directionAt(star, atJulianYear(1900.0));
  auto const after = directionAt(star, atJulianYear(2100.0));
  EXPECT_NEAR(angleBetween(before, after) / arcsecond, 200.0 * 5.281, 1.0);
  EXPECT_GT(after.u.z, before.u.z);  // northward
}

TEST(StarCatalogue, HasTheNumberOfStarsThatTheSkyHas) {
  // Counts of an independent edition of Hipparcos (kstars-data 3.6.2 stars.dat): 5044 to V = 6, 15
  // 544 to V = 7; of the Yale Bright Star Catalogue to 2, 3, 4, 5 within a few variable stars.
  EXPECT_EQ(catalogue().countBrighterThan(6.0), 5044u);
  EXPECT_EQ(catalogue().countBrighterThan(7.0), 15544u);
  EXPECT_NEAR(static_cast<double>(catalogue().countBrighterThan(2.0)), 48.0, 3.0);
  EXPECT_NEAR(static_cast<double>(catalogue().countBrighterThan(4.0)), 515.0, 10.0);
  EXPECT_EQ(catalogue().countBrighterThan(-2.0), 0u);
  EXPECT_EQ(catalogue().countBrighterThan(9.0), catalogue().stars.size());
}

TEST(StarCatalogue, ListsEachStarOnceAndTheBrightestFirst) {
  std::set<int> numbers;
  for (const Star& star : catalogue().stars) numbers.insert(star.hipparcosNumber);
  EXPECT_EQ(numbers.size(), catalogue().stars.size());
  EXPECT_EQ(catalogue().stars[0].hipparcosNumber, catalogue().byName("Sirius").hipparcosNumber);
  EXPECT_EQ(catalogue().stars[1].hipparcosNumber, catalogue().byName("Canopus").hipparcosNumber);
}

TEST(StarCatalogue, KnowsNames) {
  EXPECT_EQ(catalogue().byName("Polaris").hipparcosNumber, 11767);
  EXPECT_EQ(catalogue().nameByHipparcosNumber.at(27989).designation, "α Ori");
  EXPECT_THROW(catalogue().byName("Nemesis"), InputError);
  EXPECT_THROW(catalogue().byNumber(87937), InputError);  // Barnard's star: V 9.5
}

class MalformedStars : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / "antumbra_star_catalogue_test";
    std::filesystem::create_directories(folder_);
    for (const char* name : {"hipparcos_v8.bin", "names.csv"})
      std::filesystem::copy_file(catalogsFolder() / "stars" / name, folder_ / name,
                                 std::filesystem::copy_options::overwrite_existing);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string message() {
    try {
      StarCatalogue::load(folder_);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }
  std::filesystem::path folder_;
};

TEST_F(MalformedStars, AreAnErrorThatNamesTheFile) {
  EXPECT_EQ(message(), "");
  auto const stars = folder_ / "hipparcos_v8.bin";
  std::filesystem::resize_file(stars, std::filesystem::file_size(stars) - 1);
  EXPECT_THAT(message(), ::testing::HasSubstr("hipparcos_v8.bin: found"));
  std::ofstream(stars) << "something else altogether";
  EXPECT_THAT(message(), ::testing::HasSubstr("not a star catalogue"));
  std::filesystem::remove(stars);
  EXPECT_THAT(message(), ::testing::HasSubstr("cannot be read"));
}

TEST_F(MalformedStars, NamesAreCheckedLineByLine) {
  std::ofstream(folder_ / "names.csv") << "hip,name,designation\n11767,Polaris,α UMi\nx,y,z\n";
  EXPECT_THAT(message(), ::testing::HasSubstr("names.csv:3"));
}

}  // namespace
}  // namespace antumbra
