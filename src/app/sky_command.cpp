// `antumbra sky`: radiance, luminance and irradiance of a sky in given directions, by any method.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <optional>
#include <set>

#include "app/commands.h"
#include "app/direction_list.h"
#include "app/error_option.h"
#include "app/sky_methods.h"
#include "atmosphere/scaled_sphere.h"
#include "document/document.h"
#include "document/paths.h"
#include "photometry/colour.h"
#include "photometry/spectral_weights.h"
#include "photometry/standard_spectra.h"
#include "scene/body_catalogue.h"
#include "scene/footing.h"

namespace antumbra {
namespace {

struct Options {
  std::string medium, altitudeKm = "0", sunZenith, method = "reference", sun = "point",
                      units = "relative", seed = "1", sunDistanceAu = "1", error = "0.5%",
                      format = "csv", limbDarkening = "hestroffer";
  std::optional<std::string> directions, wavelengths, albedo, body, latitude, sunAzimuth, corona;
  std::vector<std::string> occulters;
  bool irradiance = false, luminance = false;
};

constexpr Length kMoonRadius{1737.4e3};  // IAU WGCCRE 2015 mean radius
// Where the first and last of the wavelengths of a colour lie at most and at least: the peaks of
// the observer's z and x lie at 446 and 599 nm (CIE 1931), with some room.
constexpr Length kBluest{470e-9}, kReddest{590e-9};
// Below the sphere, over its radius: the deepest basin, Hellas on Mars, lies 0.24 % below (Smith et
// al. 1999, Science 284, 1495). Deeper, the air of the ground's density that the methods assume
// means nothing.
constexpr double kDeepest = 0.003;

void chosenFrom(const std::string& value, const char* option,
                const std::vector<std::string>& allowed) {
  std::string list;
  for (auto const& a : allowed) {
    if (a == value) return;
    list += (list.empty() ? "" : ", ") + a;
  }
  throw InputError(fmt::format("{}: found \"{}\"; allowed: {}", option, value, list));
}

std::vector<Length> readWavelengths(const std::string& text, const Medium& medium) {
  std::vector<Length> wavelengths;
  // Without rounding a wavelength in nm out of a span that ends at it.
  double const first = std::max(medium.firstWavelength() / nanometre, 300.0);
  double const last = std::min(medium.lastWavelength() / nanometre, 1000.0);
  for (auto const& cell : cellsOf(text)) {
    double const nm = parseNumber(cell, "--wavelengths");
    if (!(nm >= first - 1e-6 && nm <= last + 1e-6))
      throw InputError(
          fmt::format("--wavelengths: found {} nm; allowed: {:g} to {:g} nm, the span of the "
                      "medium",
                      cell, first, last));
    wavelengths.push_back(nm * nanometre);
  }
  return wavelengths;
}

// A luminance and a colour need the spectrum where the eye sees.
void requireColour(const std::vector<Length>& wavelengths) {
  if (wavelengths.size() < 3 || wavelengths.front() > kBluest || wavelengths.back() < kReddest)
    throw InputError(fmt::format(
        "--wavelengths: found {}, {:g} to {:g} nm, with --luminance; allowed: three or more, "
        "ascending from {:g} nm or below to {:g} nm or beyond",
        wavelengths.size(), wavelengths.front() / nanometre, wavelengths.back() / nanometre,
        kBluest / nanometre, kReddest / nanometre));
  try {
    (void)linearSrgbWeights(wavelengths);
  } catch (const InputError& error) {
    throw InputError(std::string("--") + error.what());
  }
}

// ratio=R,shift-km=S[,azimuth-deg=A]: the shadow's axis passes through a point of the observer's
// horizontal plane, S km away at azimuth A from that of the Sun.
Occulter readOcculter(const std::string& text, const SkyQuestion& request) {
  double ratio = NAN, shiftKm = NAN, azimuth = 90.0;
  std::set<std::string> keys;
  for (auto const& cell : cellsOf(text)) {
    auto const equals = cell.find('=');
    std::string const key = cell.substr(0, equals);
    std::string const value = equals == std::string::npos ? "" : cell.substr(equals + 1);
    std::string const where = "--occulter: " + key;
    if (!keys.insert(key).second)
      throw InputError(fmt::format("{}: found twice in \"{}\"; allowed: once", where, text));
    if (key == "ratio")
      ratio = numberWithin(value, where, 1e-6, 300.0);
    else if (key == "shift-km")
      shiftKm = numberWithin(value, where, -1e9, 1e9);
    else if (key == "azimuth-deg")
      azimuth = numberWithin(value, where, -360.0, 360.0);
    else
      throw InputError(
          fmt::format("--occulter: found \"{}\"; allowed: ratio=, shift-km= and "
                      "azimuth-deg=, separated by commas",
                      cell));
  }
  if (std::isnan(ratio)) throw InputError("--occulter: ratio= is missing");
  if (std::isnan(shiftKm)) throw InputError("--occulter: shift-km= is missing");
  double const a = azimuth * (degree / radian);
  auto const axisPoint =
      request.camera + (shiftKm * kilometre) * Direction<AirFrame>{{std::cos(a), std::sin(a), 0.0}};
  return occulterByRatio(ratio, kMoonRadius, axisPoint, request.sun);
}

Direction<AirFrame> directionAt(double zenithDegrees, double azimuthDegrees) {
  return airDirectionOf({zenithDegrees * degree, azimuthDegrees * degree});
}

// The observer over a body's spheroid, in the sphere that stands for it: its height, the Sun and
// the directions, which are given about the spheroid's normal, change a little.
void placeOnSpheroid(const Options& options, double altitudeKm, const Body& body,
                     SkyQuestion& request) {
  double const latitude = numberWithin(*options.latitude, "--latitude", -90.0, 90.0);
  double const azimuth = numberWithin(*options.sunAzimuth, "--sun-azimuth", -360.0, 360.0);
  Footing const footing = footingOn(body, latitude * degree, 0.0 * degree, altitudeKm * kilometre);
  auto const bodyFromEnu = footing.enuFromBody.inverse();
  Angle const sunZenith = arcTangent(request.sun.toSun.u.x, request.sun.toSun.u.z);
  auto const level = [&](Angle turn) { return azimuth * degree - turn; };
  auto const enu = [&](Angle zenith, Angle turn) {
    return Direction<Enu>{
        {sin(zenith) * sin(level(turn)), sin(zenith) * cos(level(turn)), cos(zenith)}};
  };
  ScaledSphere const sphere(body.equatorialRadius, body.polarRadius, footing.fromCentre,
                            bodyFromEnu(enu(sunZenith, Angle(0.0))));
  request.medium.radius = request.groundRadius = sphere.radius();
  request.camera = {{0.0, 0.0, (sphere.radius() + sphere.height()).si}};
  request.sun.toSun = {{sin(sphere.sunZenith()), 0.0, cos(sphere.sunZenith())}};
  for (auto& d : request.directions) {
    auto const look = skyDirectionOf(d);
    d = sphere(bodyFromEnu(enu(look.viewZenith, look.relativeAzimuth)));
  }
}

void showProgress(double share) {
  int const width = 40, full = static_cast<int>(share * width);
  fmt::print(stderr, "\rsky [{:=<{}}{: <{}}] {:3.0f} %", "", full, "", width - full, 100.0 * share);
  if (share >= 1.0) fmt::print(stderr, "\r{: <60}\r", "");
  std::fflush(stderr);
}

void printLuminance(const SkyQuestion& request, const SkyAnswer& answer,
                    const std::vector<ViewDirection>& views, double sunlight) {
  auto weights = linearSrgbWeights(request.wavelengths);
  for (auto& weight : weights) weight *= sunlight;
  size_t const n = weights.size();
  auto const xyzOf = [&](auto const& value) {
    glm::dvec3 rgb(0.0);
    for (size_t w = 0; w < n; ++w) rgb += weights[w] * value(w);
    return xyzFromLinearSrgb(rgb);
  };
  if (request.irradiance) {
    auto const direct = xyzOf([&](size_t w) { return answer.direct[w]; });
    auto const diffuse = xyzOf([&](size_t w) { return answer.diffuse[w].value; });
    auto const c = chromaticityOf(direct + diffuse);
    fmt::print("direct_lx,diffuse_lx,x,y\n{:.6g},{:.6g},{:.5f},{:.5f}\n", direct.y, diffuse.y, c.x,
               c.y);
    return;
  }
  fmt::print("{},luminance_cd_m2,x,y\n", kDirectionsHeader);
  for (size_t d = 0; d < views.size(); ++d) {
    auto const xyz = xyzOf([&](size_t w) { return answer.radiances[d * n + w].value; });
    auto const c = chromaticityOf(xyz);
    fmt::print("{},{},{:.6g},{:.5f},{:.5f}\n", views[d].zenithText, views[d].azimuthText, xyz.y,
               c.x, c.y);
  }
}

void printSpectral(const SkyQuestion& request, const SkyAnswer& answer,
                   const std::vector<ViewDirection>& views, bool si, double sunlight) {
  size_t const n = request.wavelengths.size();
  std::vector<double> scale;
  for (Length w : request.wavelengths) scale.push_back(si ? sunlight * solarIrradiance(w) : 1.0);
  auto const nm = [&](size_t w) { return request.wavelengths[w] / nanometre; };
  if (request.irradiance) {
    fmt::print("wavelength_nm,direct,diffuse\n");
    for (size_t w = 0; w < n; ++w)
      fmt::print("{:g},{:.6g},{:.6g}\n", nm(w), scale[w] * answer.direct[w],
                 scale[w] * answer.diffuse[w].value);
    return;
  }
  fmt::print("{},wavelength_nm,radiance,stderr\n", kDirectionsHeader);
  for (size_t d = 0; d < views.size(); ++d)
    for (size_t w = 0; w < n; ++w) {
      Estimate const& e = answer.radiances[d * n + w];
      fmt::print("{},{},{:g},{:.6g},{:.3g}\n", views[d].zenithText, views[d].azimuthText, nm(w),
                 scale[w] * e.value, scale[w] * e.standardError);
    }
}

void runSky(const Options& options) {
  chosenFrom(options.format, "--format", {"csv"});
  chosenFrom(options.units, "--units", {"relative", "SI"});
  chosenFrom(options.sun, "--sun", {"point", "disc"});
  std::vector<std::string> names;
  for (auto const& [name, method] : skyMethods()) names.push_back(name);
  chosenFrom(options.method, "--method", names);
  if (options.luminance && options.units == "SI")
    throw InputError(
        "--units: found SI with --luminance, whose units are cd/m2 or lx; allowed: one of the two");

  if (options.medium.empty())
    throw InputError(
        "--medium: found \"\"; allowed: a medium file, as those of catalogs/atmospheres");
  SkyQuestion request;
  request.medium = readMedium(options.medium);
  if (options.albedo)
    request.medium.groundAlbedo = Spectrum(numberWithin(*options.albedo, "--albedo", 0.0, 1.0));
  double const radiusKm = request.medium.radius / kilometre;
  double const altitudeKm = parseNumber(options.altitudeKm, "--altitude-km");
  if (!(altitudeKm >= -kDeepest * radiusKm && altitudeKm <= 1e12))
    throw InputError(fmt::format(
        "--altitude-km: found {}; allowed: {:.4g} ({:g} % of the radius below the ground) to 1e12",
        options.altitudeKm, -kDeepest * radiusKm, 100.0 * kDeepest));
  request.camera = {{0.0, 0.0, (radiusKm + altitudeKm) * 1e3}};
  request.groundRadius = std::min(request.medium.radius, Length(request.camera.m.z));
  request.sun.toSun = directionAt(numberWithin(options.sunZenith, "--sun-zenith", 0.0, 180.0), 0.0);
  double const sunDistanceAu =
      numberWithin(options.sunDistanceAu, "--sun-distance-au", 0.01, 1000.0);
  if (options.sun == "disc") request.sun.discRadius = kReferenceSolarRadius / sunDistanceAu;
  request.sun.law = parseLimbDarkeningLaw(options.limbDarkening, "--limb-darkening");
  // More of them than a point unites (shaders/shared/several_casters.glsl) have no reference.
  if (options.occulters.size() > static_cast<size_t>(glsl::kMostDiscs))
    throw InputError(fmt::format("--occulter: found {} times; allowed: up to {} times",
                                 options.occulters.size(), glsl::kMostDiscs));
  for (auto const& text : options.occulters)
    request.sun.occulters.push_back(readOcculter(text, request));
  if (options.corona) {
    if (options.occulters.empty())
      throw InputError("--corona: found without --occulter, past which it shines; allowed: both");
    request.sun.corona = std::make_shared<CoronaLight>(
        numberWithin(*options.corona, "--corona", 0.0, 1.0), request.sun.law);
  }
  if (!options.wavelengths) {
    if (!options.luminance)
      throw InputError("--wavelengths: missing; it is required without --luminance");
    request.wavelengths = defaultWavelengths(colourWavelengths(options.method));
  } else {
    request.wavelengths = readWavelengths(*options.wavelengths, request.medium);
  }
  if (options.luminance) requireColour(request.wavelengths);
  request.irradiance = options.irradiance;
  request.tracing.relativeError = errorOption(options.error, 1e-5, 1.0);
  long const seed = parseInteger(options.seed, "--seed");
  if (seed < 0) throw InputError(fmt::format("--seed: found {}; allowed: 0 or more", seed));
  request.tracing.seed = static_cast<uint64_t>(seed);
  std::vector<ViewDirection> views;
  if (!options.irradiance) {
    if (!options.directions)
      throw InputError("--directions: missing; it is required without --irradiance");
    views = readDirections(*options.directions);
    for (auto const& v : views)
      request.directions.push_back(directionAt(v.zenithDegrees, v.azimuthDegrees));
  } else if (options.directions) {
    throw InputError(
        "--directions: found with --irradiance, which has none; allowed: one of the two");
  }

  if (options.body) {
    if (!options.latitude || !options.sunAzimuth)
      throw InputError("--body: found without --latitude or --sun-azimuth; allowed: all three");
    if (!options.occulters.empty())
      throw InputError("--occulter: found with --body; allowed: one of the two");
    Body const& body = BodyCatalogue::standard().body(*options.body, "--body");
    if (body.kind == "star")
      throw InputError(
          fmt::format("--body: found {}, a star; allowed: planets and moons", body.name));
    placeOnSpheroid(options, altitudeKm, body, request);
  } else if (options.latitude || options.sunAzimuth) {
    throw InputError(fmt::format("{}: found without --body; allowed: all three, or none",
                                 options.latitude ? "--latitude" : "--sun-azimuth"));
  }

  // Of the Sun at 1 au.
  double const sunlight = std::pow(sunDistanceAu, -2.0);

  double const below = request.medium.radius.si - request.camera.m.z;
  if (below > 1.0 && options.method != "reference" && options.method != "single")
    fmt::print(stderr,
               "antumbra: the camera is {:.3g} km below the ground's sphere; {} shows what is seen "
               "from that sphere\n",
               below / 1e3, options.method);

  SkyProgress progress;
  if (isatty(STDERR_FILENO)) progress = showProgress;
  SkyAnswer const answer = skyMethods().at(options.method)(request, progress);
  if (progress) progress(1.0);
  if (options.luminance)
    printLuminance(request, answer, views, sunlight);
  else
    printSpectral(request, answer, views, options.units == "SI", sunlight);
}

}  // namespace

void addSkyCommand(CLI::App& program) {
  auto* sky = program.add_subcommand(
      "sky", "Radiance, luminance and irradiance of a sky, as CSV on standard output");
  auto const options = std::make_shared<Options>();
  std::string methods;
  for (auto const& [name, method] : skyMethods()) methods += (methods.empty() ? "" : ", ") + name;
  sky->add_option("--medium", options->medium, "medium file (catalogs/atmospheres/README.md)")
      ->required();
  sky->add_option("--altitude-km", options->altitudeKm,
                  "camera's height above the ground's sphere, km; 0 by default");
  sky->add_option("--sun-zenith", options->sunZenith, "zenith angle of the Sun at the camera, deg")
      ->required();
  sky->add_option(
      "--directions", options->directions,
      "file (or - for standard input): a header view_zenith_deg,rel_azimuth_deg, then a line "
      "for each direction; azimuth 0 is towards the Sun and grows counter-clockwise seen from "
      "above, zenith above 90 looks down");
  sky->add_option(
      "--wavelengths", options->wavelengths,
      "nm, separated by commas; with --luminance by default those of the preset, or eight");
  sky->add_option("--method", options->method, "one of " + methods + "; reference by default");
  sky->add_option(
      "--sun", options->sun,
      "point (by default), or disc of 0.004653 rad at 1 au for the sunlight's directions");
  sky->add_option("--albedo", options->albedo, "of the ground, instead of the medium's");
  sky->add_option(
      "--units", options->units,
      "relative (by default: radiance over the Sun's irradiance, 1/sr) or SI (W m-2 sr-1 nm-1)");
  sky->add_option("--sun-distance-au", options->sunDistanceAu,
                  "of the medium's body, for SI units, luminance and the disc; 1 by default");
  sky->add_option("--body", options->body,
                  "a body of catalogs/bodies on whose spheroid the observer is; altitude, zenith "
                  "and azimuths are then about its normal (render --explain prints them)");
  sky->add_option("--latitude", options->latitude, "with --body: geodetic, deg");
  sky->add_option("--sun-azimuth", options->sunAzimuth,
                  "with --body: from north through east, deg");
  sky->add_option("--seed", options->seed, "of the random numbers of the reference; 1 by default");
  sky->add_option("--stderr", options->error,
                  "standard error at which the reference stops; 0.5% by default");
  sky->add_option("--format", options->format, "csv");
  sky->add_option(
         "--occulter", options->occulters,
         "ratio=R,shift-km=S[,azimuth-deg=A]: a Moon of R solar radii, seen from the point of the "
         "horizontal plane S km away through which the shadow's axis passes; given up to six "
         "times, as many Moons, and the union of their discs hides the Sun")
      ->allow_extra_args(false);
  sky->add_option(
      "--corona", options->corona,
      "phase of the solar cycle, 0 to 1, of a corona that shines past the occulter; none "
      "by default");
  sky->add_option("--limb-darkening", options->limbDarkening,
                  "hestroffer (by default), neckel or none");
  sky->add_flag("--irradiance", options->irradiance, "direct and diffuse, of the horizontal plane");
  sky->add_flag("--luminance", options->luminance, "cd/m2 (or lx) and chromaticity x, y");
  sky->footer(
      "A medium file with [refraction] bends sunlight on its way into the air, by all methods; "
      "the\n"
      "camera's rays, and all light without that section, go straight.\n"
      "Example:\n  printf 'view_zenith_deg,rel_azimuth_deg\\n45,0\\n' | antumbra sky \\\n"
      "    --medium catalogs/atmospheres/earth.toml --sun-zenith 60 --directions - \\\n"
      "    --wavelengths 440,550,680 --method reference --stderr 0.5%");
  sky->callback([options] { runSky(*options); });
}

}  // namespace antumbra
