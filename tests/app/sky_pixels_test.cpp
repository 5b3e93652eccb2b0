// `antumbra sky` against the pixels of pictures, as a user would compare them: a scene of the real
// Earth is rendered to an EXR file, the options that `antumbra sky` wants are those that the file's
// metadata give, and each pixel's direction about the vertical follows from the camera's azimuth
// and altitude alone. From the ground, the air and space, by day, at dusk and in twilight.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/packing.hpp>
#include <iomanip>
#include <numbers>

#include "app/commands.h"
#include "document/paths.h"

namespace antumbra {
namespace {

namespace fs = std::filesystem;
constexpr double kDegree = std::numbers::pi / 180.0;

struct Shot {
  const char* name;
  double heightKm;
  double latitude;
  const char* time;
  const char* look;  // "zenith", "nadir", or azimuth and altitude in degrees
  double field;      // degrees; a fisheye where above 120
  int size = 120;    // pixels
};

struct Pixel {
  double x, y;             // from the left and the top
  double zenith, azimuth;  // degrees; from north through east
};

// The direction of each pixel about the vertical, from the projection's definition.
std::vector<Pixel> pixelsOf(const Shot& shot, int step) {
  double azimuth = 0.0, altitude = 0.0;
  std::string const look = shot.look;
  bool const flat = look != "zenith" && look != "nadir";
  if (flat) std::sscanf(shot.look, "%lf %lf", &azimuth, &altitude);
  using Vector = std::array<double, 3>;  // east, north, up
  auto const cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  double const a = azimuth * kDegree, h = altitude * kDegree;
  Vector const forward =
      flat ? Vector{std::sin(a) * std::cos(h), std::cos(a) * std::cos(h), std::sin(h)}
           : Vector{0.0, 0.0, look == "zenith" ? 1.0 : -1.0};
  Vector right = flat ? Vector{std::cos(a), -std::sin(a), 0.0} : cross(forward, {0.0, 1.0, 0.0});
  Vector const up = cross(right, forward);
  std::vector<Pixel> pixels;
  double const half = 0.5 * shot.field * kDegree;
  for (int y = step / 2; y < shot.size; y += step)
    for (int x = step / 2; x < shot.size; x += step) {
      double const px = 2.0 * (x + 0.5) / shot.size - 1.0, py = 1.0 - 2.0 * (y + 0.5) / shot.size;
      double const r = std::hypot(px, py);
      double ahead = 1.0, across = std::tan(half);
      if (shot.field > 120.0) {
        if (r > 0.99) continue;
        ahead = std::cos(r * half);
        across = r > 0.0 ? std::sin(r * half) / r : half;
      }
      Vector d;
      for (std::size_t i = 0; i < 3; ++i)
        d[i] = ahead * forward[i] + across * (px * right[i] + py * up[i]);
      pixels.push_back({double(x), double(y), std::atan2(std::hypot(d[0], d[1]), d[2]) / kDegree,
                        std::atan2(d[0], d[1]) / kDegree});
    }
  return pixels;
}

struct Exr {
  std::vector<float> rgb;
  std::string sky;
};

Exr renderToExr(const Shot& shot, const std::string& preset, const fs::path& folder) {
  std::string const look = shot.look;
  bool const flat = look != "zenith" && look != "nadir";
  auto const space = look.find(' ');
  std::ofstream(folder / "scene.toml")
      << "title = \"t\"\ntime = \"" << shot.time << "\"\nbodies = [\"Sun\", \"Earth\"]\n"
      << "quality = \"" << preset << "\"\n[camera]\nlatitude = \"" << shot.latitude
      << " deg\"\nlongitude = \"10 deg\"\nheight = \"" << shot.heightKm << " km\"\n"
      << (flat ? "azimuth = \"" + look.substr(0, space) + " deg\"\naltitude = \"" +
                     look.substr(space + 1) + " deg\"\n"
               : "target = \"" + look + "\"\n")
      << "[picture]\nprojection = \"" << (shot.field > 120.0 ? "fisheye" : "perspective")
      << "\"\nfield = \"" << shot.field << " deg\"\nwidth = " << shot.size
      << "\nheight = " << shot.size << "\n[display]\nlimiting_magnitude = -10.0\n"
      << "[sun]\ndrawn = false\n[surface]\nEarth = 0.12\n";
  CLI::App program;
  addRenderCommand(program);
  testing::internal::CaptureStdout();
  program.parse("render " + (folder / "scene.toml").string() + " -o " +
                (folder / "picture.exr").string());
  (void)testing::internal::GetCapturedStdout();
  auto const input = OIIO::ImageInput::open((folder / "picture.exr").string());
  Exr exr;
  if (!input) return exr;
  exr.sky = input->spec().get_string_attribute("antumbra:sky");
  exr.rgb.resize(static_cast<std::size_t>(shot.size * shot.size * 3));
  input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, exr.rgb.data());
  return exr;
}

double halved(float value) { return double(glm::unpackHalf1x16(glm::packHalf1x16(value))); }

double numberAfter(const std::string& options, const std::string& key) {
  return std::stod(options.substr(options.find(key) + key.size()));
}

struct Comparison {
  int count = 0;
  double mean = 0.0, worst = 0.0, worstColour = 0.0, worstHalf = 0.0;
};

Comparison compare(const Shot& shot, const std::string& preset, bool asSphere) {
  auto const folder = fs::temp_directory_path() / ("antumbra_pixels_" + std::to_string(::getpid()));
  fs::create_directory(folder);
  Exr const exr = renderToExr(shot, preset, folder);
  auto pixels = pixelsOf(shot, shot.size / 20);
  // A pixel on the horizon shows some of either side. Its dip on the ellipsoid lies between those
  // of the spheres of its least and greatest curvature, seen from space of its radii.
  double const pixel =
      (shot.field > 120.0 ? shot.field / shot.size
                          : 2.0 * std::tan(0.5 * shot.field * kDegree) / shot.size / kDegree);
  auto const dipOf = [&](double radius) {
    return std::acos(radius / (radius + shot.heightKm)) / kDegree;
  };
  double const low = 90.0 + dipOf(6399.6) - 1.5 * pixel, high = 90.0 + dipOf(6335.4) + 1.5 * pixel;
  std::erase_if(pixels, [&](const Pixel& p) { return p.zenith > low && p.zenith < high; });
  EXPECT_FALSE(exr.sky.empty()) << shot.name;
  std::string options = exr.sky;
  double const sunAzimuth = numberAfter(options, "--sun-azimuth ");
  if (asSphere) {
    auto const body = options.find("--body"), altitude = options.find("--altitude-km");
    options.erase(body, altitude - body);
    auto const from = options.find("--sun-azimuth"), to = options.find("--sun-distance");
    options.erase(from, to - from);
  }
  {
    std::ofstream out(folder / "directions.csv");
    out << "view_zenith_deg,rel_azimuth_deg\n" << std::setprecision(12);
    for (auto const& p : pixels)
      out << p.zenith << ',' << std::remainder(sunAzimuth - p.azimuth, 360.0) << '\n';
  }
  CLI::App program;
  addSkyCommand(program);
  testing::internal::CaptureStdout();
  program.parse("sky " + options + " --directions " + (folder / "directions.csv").string());
  std::istringstream printed(testing::internal::GetCapturedStdout());
  fs::remove_all(folder);
  std::string line;
  std::getline(printed, line);
  Comparison result;
  for (auto const& p : pixels) {
    std::getline(printed, line);
    double zenith = 0.0, turn = 0.0, luminance = 0.0, x = 0.0, y = 0.0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &zenith, &turn, &luminance, &x, &y),
              5)
        << line;
    auto const* c = &exr.rgb[static_cast<std::size_t>((p.y * shot.size + p.x) * 3)];
    // Linear sRGB to XYZ: IEC 61966-2-1.
    double const X = 0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2];
    double const Y = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    double const Z = 0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2];
    if (luminance < 1e-5) {  // the darkest night, below the light of the stars
      EXPECT_LT(Y, 1e-5) << line;
      continue;
    }
    double const error = Y / luminance - 1.0;
    double const colour = std::hypot(X / (X + Y + Z) - x, Y / (X + Y + Z) - y);
    if (std::getenv("SHOW_SKY_ERRORS") && (std::fabs(error) > 1e-3 || colour > 1e-3))
      std::printf("%s: drawn %.6g %+.3f %% colour %.5f rgb %g %g %g\n", line.c_str(), Y,
                  100.0 * error, colour, double(c[0]), double(c[1]), double(c[2]));
    double const inHalf = 0.2126 * halved(c[0]) + 0.7152 * halved(c[1]) + 0.0722 * halved(c[2]);
    result.worstHalf = std::max(result.worstHalf, std::fabs(inHalf / Y - 1.0));
    ++result.count;
    result.mean += std::fabs(error);
    result.worst = std::max(result.worst, std::fabs(error));
    result.worstColour = std::max(result.worstColour, colour);
  }
  result.mean /= result.count;
  return result;
}

// SKY_PIXELS=all takes every preset for every picture; SKY_PIXELS=sphere asks for a sphere of the
// medium's radius instead of the spheroid and only prints what that costs. 16-bit files would
// add up to 0.05 %: printed as well.
TEST(SkyPixels, SkyPrintsWhatPicturesShow) {
  using Presets = std::vector<std::string>;
  const char* const chosen = std::getenv("SKY_PIXELS");
  std::string const mode = chosen ? chosen : "";
  for (auto const& [shot, own] : {
           std::pair{
               Shot{"ground, noon, dome", 0.002, 45.0, "2027-08-02T11:30:00Z", "zenith", 180.0},
               Presets{"balanced"}},
           {{"ground, dusk", 0.002, 20.0, "2027-08-02T17:30:00Z", "280 12", 60.0}, {}},
           {{"ground, twilight, dome", 0.3, 60.0, "2027-08-02T21:20:00Z", "zenith", 180.0},
            {"accurate"}},
           {{"10 km, day", 10.0, 45.0, "2027-08-02T15:30:00Z", "200 -5", 80.0}, {}},
           {{"10 km, twilight", 10.0, 30.0, "2027-08-02T18:40:00Z", "290 5", 80.0}, {"balanced"}},
           {{"30 km, dusk, dome", 30.0, 45.0, "2027-08-02T19:00:00Z", "zenith", 180.0}, {}},
           {{"400 km, day", 400.0, 50.0, "2027-08-02T12:00:00Z", "200 -30", 100.0}, {"draft"}},
           {{"400 km, dusk", 400.0, 30.0, "2027-08-02T17:50:00Z", "290 -30", 100.0}, {"accurate"}},
           {{"400 km, twilight", 400.0, 30.0, "2027-08-02T18:50:00Z", "290 -20", 100.0},
            {"balanced"}},
           {{"36 000 km, day", 36000.0, 30.0, "2027-08-02T11:00:00Z", "nadir", 20.0, 300},
            {"balanced"}},
           {{"36 000 km, dusk", 36000.0, 45.0, "2027-08-02T17:30:00Z", "nadir", 20.0, 300},
            {"draft"}},
       })
    for (auto const& preset : mode == "all" ? Presets{"draft", "balanced", "accurate"} : own) {
      auto const c = compare(shot, preset, mode == "sphere");
      std::printf("%-23s %-8s n %3d  mean %.4f %%  worst %.4f %%  colour %.5f  half %.3f %%\n",
                  shot.name, preset.c_str(), c.count, 100.0 * c.mean, 100.0 * c.worst,
                  c.worstColour, 100.0 * c.worstHalf);
      if (mode == "sphere") continue;
      EXPECT_GT(c.count, 90) << shot.name;
      EXPECT_LT(c.worst, 1e-3) << shot.name;
      EXPECT_LT(c.worstColour, 1e-4) << shot.name;
    }
}

}  // namespace
}  // namespace antumbra
