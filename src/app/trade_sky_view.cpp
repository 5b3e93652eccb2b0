#include "app/trade_sky_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "atmosphere/scaled_sphere.h"
#include "document/input_error.h"
#include "document/text_output.h"
#include "document/whole_file.h"
#include "photometry/colour.h"
#include "photometry/spectral_weights.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

constexpr int kReferenceWavelengths = 16;
constexpr Angle kFromSun = 1.0 * degree;
// A direction that does not reach its error by then keeps the larger one.
constexpr uint64_t kMostPaths = uint64_t{1} << 20;

const PlannedBody& bodyWithAir(const SceneSession::Moment& moment) {
  const PlannedBody* found = nullptr;
  for (auto const& body : moment.plan.bodies)
    if (!body.atmosphere.empty() && (!found || body.cameraInAir || !found->cameraInAir))
      found = &body;
  if (!found)
    throw InputError(moment.scene.file +
                     ": shows no body with air; allowed: a scene whose camera sees one");
  if (!found->casters.empty())
    throw InputError(
        fmt::format("{}: {} is eclipsed by {} at that time; allowed: a time without an eclipse "
                    "(--time), or antumbra trade totality",
                    moment.scene.file, found->name, found->casters.front().name));
  return *found;
}

// What the reference depends on, to know a file again.
nlohmann::ordered_json descriptionOf(const AirView& view) {
  auto const& q = view.question;
  nlohmann::ordered_json d;
  std::ifstream in(mediumFile(view.body.atmosphere));
  std::stringstream content;
  content << in.rdbuf();
  d["medium"] = view.body.atmosphere;
  d["medium_hash"] = std::hash<std::string>()(content.str());
  d["camera_m"] = fmt::format("{:.6f}", q.camera.m.z);
  d["sun_zenith_deg"] = fmt::format("{:.6f}", view.sunZenith / degree);
  d["relative_error"] = q.tracing.relativeError;
  d["seed"] = q.tracing.seed;
  d["wavelengths"] = q.wavelengths.size();
  for (auto const& direction : q.directions)
    d["directions"].push_back(
        fmt::format("{:.6f} {:.6f} {:.6f}", direction.u.x, direction.u.y, direction.u.z));
  return d;
}

ReferenceSky skyOf(const AirView& view, const std::vector<double>& values,
                   const std::vector<double>& errors) {
  ReferenceSky sky;
  auto const& wavelengths = view.question.wavelengths;
  sky.colours = coloursOf(view, wavelengths, values);
  auto const weights = linearSrgbWeights(wavelengths);
  std::size_t const n = wavelengths.size();
  for (std::size_t d = 0; d < sky.colours.size(); ++d) {
    double variance = 0.0;
    for (std::size_t w = 0; w < n; ++w)
      variance += std::pow(luminanceOf(weights[w]) * errors[d * n + w], 2.0);
    sky.relativeErrors.push_back(std::sqrt(variance) * view.illuminanceFactor /
                                 luminanceOf(sky.colours[d]));
  }
  return sky;
}

}  // namespace

double ReferenceSky::meanRelativeError() const {
  double sum = 0.0;
  for (double e : relativeErrors) sum += e;
  return sum / static_cast<double>(relativeErrors.size());
}

AirView airViewOf(const SceneSession::Moment& moment, std::size_t count) {
  AirView view;
  view.scene = moment.scene.file;
  view.body = bodyWithAir(moment);
  view.picture = moment.plan.picture;
  auto const& body = view.body;
  auto& q = view.question;
  q.medium = readMedium(mediumFile(body.atmosphere));
  q.medium.radius = body.equatorialRadius;
  double const radius = body.equatorialRadius.si, height = std::max(body.cameraHeight.si, 0.01);
  q.camera = {{0.0, 0.0, radius + height}};
  q.groundRadius = body.equatorialRadius;
  ScaledSphere const sphere(body.equatorialRadius, body.polarRadius,
                            body.bodyFromCamera(-body.centre), directionOf(body.sun));
  view.sunZenith = sphere.sunZenith();
  double const sunDistance = glm::length(body.sun.m);
  view.illuminanceFactor = std::pow(astronomicalUnit.si / sunDistance, 2.0);
  q.sun.toSun.u = {sin(view.sunZenith), 0.0, cos(view.sunZenith)};
  q.sun.discRadius = q.sun.occultedRadius = Angle(kSolarRadiusIau.si / sunDistance);
  q.wavelengths = defaultWavelengths(kReferenceWavelengths);
  q.tracing.maxPaths = kMostPaths;

  double const top = q.medium.topHeight.si;
  auto const meetsAir = [&](const glm::dvec3& d) {
    if (height <= top) return true;
    double const rise = (radius + height) * d.z;
    return rise < 0.0 && rise * rise > (height - top) * (2.0 * radius + height + top);
  };
  // Multiples of the powers of the plastic number's inverse fill a square evenly.
  constexpr double kStepX = 0.7548776662466927, kStepY = 0.5698402909980532;
  std::size_t const most = 200 * count;
  for (std::size_t i = 1; i <= most && q.directions.size() < count; ++i) {
    auto const fraction = [&](double step) {
      double const x = 0.5 + step * static_cast<double>(i);
      return x - std::floor(x);
    };
    glm::dvec2 const place(fraction(kStepX) * view.picture.width,
                           fraction(kStepY) * view.picture.height);
    auto const direction = view.picture.directionAt(place.x, place.y);
    if (!direction) continue;
    glm::dvec3 const own = sphere(body.bodyFromCamera(*direction)).u;
    if (glm::dot(own, q.sun.toSun.u) > cos(kFromSun) || !meetsAir(own)) continue;
    q.directions.push_back({own});
    view.pixels.emplace_back(glm::floor(place));
  }
  if (q.directions.size() < count)
    throw InputError(fmt::format(
        "{}: {} of {} directions of the picture meet the air of {}; allowed: a picture that shows "
        "more of it",
        moment.scene.file, q.directions.size(), most, body.name));
  return view;
}

std::vector<ReferenceSky> referenceSkies(const std::vector<AirView>& views, const std::string& file,
                                         const std::function<void(std::size_t, double)>& progress) {
  using json = nlohmann::ordered_json;
  json descriptions = json::array();
  for (auto const& view : views) descriptions.push_back(descriptionOf(view));
  std::vector<ReferenceSky> skies;
  if (!file.empty() && std::filesystem::exists(file)) {
    try {
      auto const stored = json::parse(std::ifstream(file));
      json found = json::array();
      for (auto const& sky : stored.at("skies")) found.push_back(sky.at("of"));
      if (found != descriptions)
        throw InputError(fmt::format(
            "--reference: {} was made for other scenes, media or errors; allowed: a file that "
            "this command wrote with the same settings, or a new name",
            file));
      for (std::size_t i = 0; i < views.size(); ++i) {
        auto const& sky = stored.at("skies")[i];
        auto const radiances = sky.at("radiances").get<std::vector<double>>();
        auto const errors = sky.at("standard_errors").get<std::vector<double>>();
        auto const& q = views[i].question;
        std::size_t const count = q.directions.size() * q.wavelengths.size();
        if (radiances.size() != count || errors.size() != count)
          throw InputError(
              fmt::format("--reference: {}: found {} radiances and {} errors; allowed: {}", file,
                          radiances.size(), errors.size(), count));
        skies.push_back(skyOf(views[i], radiances, errors));
      }
      return skies;
    } catch (const json::exception& error) {
      throw InputError(fmt::format("--reference: {}: {}", file, error.what()));
    }
  }
  if (!file.empty()) requireWritable(file, "--reference");
  json stored;
  stored["what"] =
      "L / E0 in 1/sr of each direction, wavelengths innermost, and standard errors, by "
      "the path tracer of antumbra sky --method reference";
  for (std::size_t i = 0; i < views.size(); ++i) {
    auto const answer = skyMethods().at("reference")(
        views[i].question, [&](double share) { progress(i, std::min(share, 1.0)); });
    std::vector<double> values, errors;
    for (auto const& e : answer.radiances) {
      values.push_back(e.value);
      errors.push_back(e.standardError);
    }
    stored["skies"].push_back(
        {{"of", descriptions[i]}, {"radiances", values}, {"standard_errors", errors}});
    skies.push_back(skyOf(views[i], values, errors));
  }
  if (!file.empty()) writeTextFile(file, stored.dump(1) + "\n");
  return skies;
}

std::vector<glm::dvec3> coloursOf(const AirView& view, const std::vector<Length>& wavelengths,
                                  const std::vector<double>& radiances) {
  auto const weights = linearSrgbWeights(wavelengths);
  std::vector<glm::dvec3> colours;
  for (std::size_t d = 0; d * weights.size() < radiances.size(); ++d) {
    glm::dvec3 rgb(0.0);
    for (std::size_t w = 0; w < weights.size(); ++w)
      rgb += weights[w] * radiances[d * weights.size() + w];
    colours.push_back(rgb * view.illuminanceFactor);
  }
  return colours;
}

SkyError errorAgainst(const ReferenceSky& reference, const std::vector<glm::dvec3>& colours) {
  SkyError error;
  auto const count = static_cast<double>(colours.size());
  for (std::size_t d = 0; d < colours.size(); ++d) {
    glm::dvec3 const expected = xyzFromLinearSrgb(reference.colours[d]);
    glm::dvec3 const found = xyzFromLinearSrgb(colours[d]);
    double const relative = found.y / expected.y - 1.0;
    double const difference = deltaE2000(expected, found, 2.0 * expected.y);
    error.luminance += std::fabs(relative) / count;
    error.deltaE += difference / count;
    error.worstDeltaE = std::max(error.worstDeltaE, difference);
    if (std::fabs(relative) > std::fabs(error.worst)) {
      error.worst = relative;
      error.worstDirection = d;
    }
  }
  return error;
}

}  // namespace antumbra
