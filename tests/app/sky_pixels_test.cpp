// `antumbra sky` against the pixels of pictures: the same light in the same direction, from the
// ground, from the air and from space, in perspective and in a dome.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>

#include "app/commands.h"
#include "document/paths.h"
#include "gl/context.h"
#include "medium/medium.h"
#include "photometry/colour.h"
#include "picture/picture_renderer.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

// Sun and Earth alone; a sphere of the medium's radius, grey as the medium's ground.
BodyCatalogue roundEarth(const Medium& medium) {
  auto const folder = std::filesystem::temp_directory_path() /
                      ("antumbra_round_earth_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::filesystem::copy_file(catalogsFolder() / "bodies/sun.toml", folder / "sun.toml");
  double const km = medium.radius / kilometre, albedo = medium.groundAlbedo.at(550.0 * nanometre);
  std::ofstream(folder / "earth.toml")
      << "name = \"Earth\"\nkind = \"planet\"\nparent = \"sun\"\nephemeris = \"Earth\"\n"
      << "color_index_bv = 0.2\natmosphere = \"reference_bruneton2017\"\n[figure]\n"
      << "equatorial_radius = \"" << km << " km\"\npolar_radius = \"" << km << " km\"\n"
      << "[surface]\nscattering = \"lambert\"\nbond_albedo = 0.1\ngeometric_albedo = 0.1\n"
      << "reflectance = [" << albedo << ", " << albedo << ", " << albedo << "]\n"
      << "[[magnitude]]\nto = \"180 deg\"\nform = \"polynomial\"\ncoefficients = [-4.0]\n";
  auto catalogue = BodyCatalogue::load(folder);
  std::filesystem::remove_all(folder);
  return catalogue;
}

struct Shot {
  const char* name;
  Length height;
  const char* time;
  ProjectionKind kind;
  Angle field;
  const char* target;  // or empty: toward the horizon
  int size;            // in pixels; 20 x 20 are compared
};

struct Comparison {
  int count = 0, beyond = 0;  // beyond 0.1 %
  double mean = 0.0, worst = 0.0;
};

Comparison compare(const Shot& shot, const std::string& preset) {
  Medium const medium = readMedium(catalogsFolder() / "atmospheres/reference_bruneton2017.toml");
  Scene scene;
  scene.time = shot.time;
  scene.quality = preset;
  scene.bodies = {"Sun", "Earth"};
  scene.camera.height = shot.height;
  scene.camera.latitude = 20.0 * degree;
  scene.camera.longitude = 10.0 * degree;
  scene.camera.target = shot.target;
  scene.camera.azimuth = 75.0 * degree;
  scene.camera.altitude = 12.0 * degree;
  scene.picture = {shot.kind, shot.field, shot.size, shot.size};
  scene.display.automaticExposure = false;
  scene.display.limitingMagnitude = -10.0;  // no stars
  auto const catalogue = roundEarth(medium);
  auto const placed = placeScene(scene, parseInstant(shot.time, "test"), catalogue,
                                 Ephemeris::standard(), DeltaT::standard());
  auto plan = makeRenderPlan(scene, placed);
  plan.drawSun = plan.queryOcclusion = plan.glareFromOutside =
      false;  // neither its disc nor its glare is the sky's
  FinishedPicture picture;
  {
    gl::HeadlessContext const context;
    gl::prepareContext();
    picture = PictureRenderer([](auto&&...) { return DecodedImage(); }).finish(scene, placed, plan);
  }
  // The Sun and the pixels' directions about the vertical.
  PlacedBody const& earth = placed.bodies[placed.anchor];
  glm::dvec3 const up = glm::normalize(-placed.cameraFromIcrs(earth.fromCamera).m);
  glm::dvec3 const sun = glm::normalize(placed.cameraFromIcrs(earth.sunFromBody).m);
  double const cosine = glm::dot(up, sun);
  glm::dvec3 const toward = glm::normalize(sun - cosine * up), side = glm::cross(up, toward);
  auto const file = std::filesystem::temp_directory_path() /
                    ("antumbra_pixels_" + std::to_string(::getpid()) + ".csv");
  std::vector<double> luminances;
  {
    std::ofstream out(file);
    out << "view_zenith_deg,rel_azimuth_deg\n" << std::setprecision(12);
    for (int y = 3; y < shot.size; y += shot.size / 20)
      for (int x = 3; x < shot.size; x += shot.size / 20) {
        auto const look = scene.picture.directionAt(x + 0.5, y + 0.5);
        if (!look) continue;
        double const z = glm::dot(look->u, up), a = glm::dot(look->u, toward);
        double const b = glm::dot(look->u, side);
        // A pixel on the horizon shows some of either side.
        double const dip = std::acos(medium.radius / (medium.radius + shot.height));
        double const edge = std::asin(std::clamp(z, -1.0, 1.0)) + dip;
        if (std::fabs(edge) < 1.5 * scene.picture.pixelAngle().si) continue;
        auto const* p =
            &picture.linear[static_cast<std::size_t>(((shot.size - 1 - y) * shot.size + x) * 3)];
        luminances.push_back(luminanceOf(glm::dvec3(p[0], p[1], p[2])));
        out << std::atan2(std::hypot(a, b), z) / degree.si << ',' << std::atan2(b, a) / degree.si
            << '\n';
      }
  }
  CLI::App program;
  addSkyCommand(program);
  testing::internal::CaptureStdout();
  program.parse(
      "sky --medium " + (catalogsFolder() / "atmospheres/reference_bruneton2017.toml").string() +
      fmt::format(" --altitude-km {:.12g} --sun-zenith {:.12g} --sun disc --luminance --method {} "
                  "--sun-distance-au {:.9g} --directions {}",
                  shot.height / kilometre, std::acos(cosine) / degree.si, preset,
                  glm::length(earth.sunFromBody.m) / astronomicalUnit.si, file.string()));
  std::istringstream printed(testing::internal::GetCapturedStdout());
  std::filesystem::remove(file);
  std::string line;
  std::getline(printed, line);
  Comparison result;
  for (double drawn : luminances) {
    std::getline(printed, line);
    double zenith = 0.0, azimuth = 0.0, found = 0.0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &zenith, &azimuth, &found), 3) << line;
    if (found < 1e-5) {  // the darkest night
      EXPECT_LT(drawn, 1e-5) << line;
      continue;
    }
    double const error = std::fabs(drawn / found - 1.0);
    if (std::getenv("SHOW_SKY_ERRORS") && error > 1e-3)
      std::printf("%s: drawn %.6g %+.3f %%\n", line.c_str(), drawn, 100.0 * (drawn / found - 1.0));
    ++result.count;
    result.mean += error;
    result.beyond += error > 1e-3;
    result.worst = std::max(result.worst, error);
  }
  result.mean /= result.count;
  return result;
}

// The sky, and all that a camera low in the air sees, within 0.1 %. Ground seen from higher up is
// drawn by tiles: those at the horizon and the terminator take more samples than `sky` does.
TEST(SkyPixels, SkyPrintsWhatPicturesShow) {
  struct Case {
    Shot shot;
    std::string preset;
    double worst, beyond;  // share beyond 0.1 %
  };
  for (auto const& [shot, preset, worst, beyond] :
       {Case{{"ground, dome", 2.0 * metre, "2027-08-02T09:00:00Z", ProjectionKind::Fisheye,
              180.0 * degree, "zenith", 120},
             "balanced",
             1e-3,
             0.0},
        Case{{"ground, dusk", 2.0 * metre, "2027-08-02T18:00:00Z", ProjectionKind::Perspective,
              60.0 * degree, "", 120},
             "draft",
             1e-3,
             0.0},
        Case{{"10 km, perspective", 10.0 * kilometre, "2027-08-02T16:30:00Z",
              ProjectionKind::Perspective, 80.0 * degree, "", 120},
             "draft",
             1e-3,
             0.0},
        Case{{"30 km, dome", 30.0 * kilometre, "2027-08-02T16:30:00Z", ProjectionKind::Fisheye,
              180.0 * degree, "zenith", 120},
             "balanced",
             1e-3,
             0.0},
        Case{{"1000 km", 1000.0 * kilometre, "2027-08-02T12:00:00Z", ProjectionKind::Perspective,
              100.0 * degree, "nadir", 300},
             "balanced",
             0.03,
             0.02},
        Case{{"20 000 km", 20000.0 * kilometre, "2027-08-02T16:00:00Z", ProjectionKind::Perspective,
              40.0 * degree, "nadir", 300},
             "balanced",
             0.03,
             0.2}}) {
    auto const c = compare(shot, preset);
    std::printf("%-20s n %d  mean %.4f %%  worst %.3f %%  beyond 0.1 %%: %d\n", shot.name, c.count,
                100.0 * c.mean, 100.0 * c.worst, c.beyond);
    EXPECT_GT(c.count, 100) << shot.name;
    EXPECT_LT(c.worst, worst) << shot.name;
    EXPECT_LE(c.beyond, beyond * c.count) << shot.name;
  }
}

}  // namespace
}  // namespace antumbra
