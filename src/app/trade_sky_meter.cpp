#include "app/trade_sky_meter.h"

#include <algorithm>
#include <cmath>

#include "app/processor_clock.h"
#include "document/paths.h"
#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "gl/view_block.h"
#include "output/image_file.h"
#include "passes/air_tables.h"
#include "passes/bodies.h"
#include "passes/sky_sampler.h"
#include "photometry/colour.h"

namespace antumbra {
namespace {

// Of the tables computed so far, by the pass's own clock.
double secondsOfTables(const BodiesPass& bodies) {
  double sum = 0.0;
  for (auto const& [name, seconds] : bodies.precomputeSeconds()) sum += seconds;
  return sum;
}

// A target of the picture's size with its view.
struct Canvas {
  gl::Texture texture;
  gl::Framebuffer framebuffer;
  gl::Buffer viewBlock;
  explicit Canvas(const Projection& picture)
      : texture(gl::Texture::plane(GL_RGBA32F, picture.width, picture.height)),
        framebuffer({&texture}) {
    viewBlock.write(gl::viewBlockOf(picture));
  }
  void draw(BodiesPass& bodies, const PlannedBody& body, const Projection& picture) {
    framebuffer.bind();
    viewBlock.bindUniform(0);
    bodies.draw(body, picture, {0, 0}, {picture.width, picture.height});
  }
};

// The air over plain ground, at so many pixels a side to a sample, in cd/m2.
std::vector<glm::dvec3> pixelsAt(BodiesPass& bodies, const AirView& view, const PlannedBody& plain,
                                 int scale) {
  bodies.useAirScale(scale);
  bodies.prepare(plain, view.picture, {});
  Canvas canvas(view.picture);
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  canvas.framebuffer.bind();
  glClear(GL_COLOR_BUFFER_BIT);
  canvas.draw(bodies, plain, view.picture);
  auto const texels = canvas.texture.readRgba();
  std::vector<glm::dvec3> colours;
  for (std::size_t i = 0; i < texels.size(); i += 4)
    colours.emplace_back(texels[i], texels[i + 1], texels[i + 2]);
  return colours;
}

ScaleError scaleErrorOf(const std::vector<glm::dvec3>& fine,
                        const std::vector<glm::dvec3>& coarse) {
  ScaleError error;
  double count = 0.0, brightest = 0.0;
  for (auto const& colour : fine) brightest = std::max(brightest, luminanceOf(colour));
  for (std::size_t i = 0; i < fine.size(); ++i) {
    // What no exposure shows beside the rest says nothing.
    if (luminanceOf(fine[i]) < 1e-4 * brightest) continue;
    double const relative = luminanceOf(coarse[i]) / luminanceOf(fine[i]) - 1.0;
    if (relative == 0.0 && fine[i] == coarse[i]) {
      ++count;
      continue;
    }
    glm::dvec3 const expected = xyzFromLinearSrgb(fine[i]);
    ++count;
    error.luminance += std::fabs(relative);
    if (std::fabs(relative) > std::fabs(error.worst)) error.worst = relative;
    error.worstDeltaE = std::max(
        error.worstDeltaE, deltaE2000(expected, xyzFromLinearSrgb(coarse[i]), 2.0 * expected.y));
  }
  error.luminance /= std::max(count, 1.0);
  return error;
}

double drawSeconds(BodiesPass& bodies, const AirView& view, int repeats, DrawClock clock) {
  auto const& picture = view.picture;
  Canvas canvas(picture);
  double seconds = 0.0;
  if (bodies.repeatSky(view.body))
    seconds += medianSeconds([&] { bodies.repeatSky(view.body); }, repeats, clock);
  return seconds + medianSeconds([&] { canvas.draw(bodies, view.body, picture); }, repeats, clock);
}

// `share`: of the light of each direction that its pixel shows.
SkyError errorOf(const AirView& view, const AirTables& tables, const ReferenceSky& reference,
                 const std::vector<glm::dvec3>& share) {
  SkySampler sampler(view.question.medium, tables);
  SkyRequest request;
  request.altitude = Length(view.question.camera.m.z) - view.question.medium.radius;
  request.sunZenith = view.sunZenith;
  request.sunRadius = view.question.sun.discRadius;
  for (auto const& d : view.question.directions) request.directions.push_back(skyDirectionOf(d));
  auto colours = coloursOf(view, tables.wavelengths(), sampler.sample(request));
  for (std::size_t d = 0; d < share.size(); ++d) colours[d] *= share[d];
  return errorAgainst(reference, colours);
}

}  // namespace

AirMeasurement overall(const std::vector<AirMeasurement>& views) {
  AirMeasurement m;
  auto const share = 1.0 / static_cast<double>(views.size());
  for (auto const& v : views) {
    m.error.luminance += share * v.error.luminance;
    m.error.deltaE += share * v.error.deltaE;
    m.error.worstDeltaE = std::max(m.error.worstDeltaE, v.error.worstDeltaE);
    m.scale.luminance += share * v.scale.luminance;
    m.scale.worstDeltaE = std::max(m.scale.worstDeltaE, v.scale.worstDeltaE);
    if (std::fabs(v.scale.worst) > std::fabs(m.scale.worst)) m.scale.worst = v.scale.worst;
    if (std::fabs(v.error.worst) > std::fabs(m.error.worst)) m.error.worst = v.error.worst;
    m.cost.fillUnits += share * v.cost.fillUnits;
    m.cost.milliseconds += share * v.cost.milliseconds;
    m.cost.precomputeSeconds += v.cost.precomputeSeconds;
    m.cost.mebibytes = std::max(m.cost.mebibytes, v.cost.mebibytes);
  }
  return m;
}

AirMeter::AirMeter(const std::vector<AirView>& views, const std::vector<ReferenceSky>& references,
                   int repeats, DrawClock clock)
    : views_(views), references_(references), repeats_(repeats), clock_(clock) {}

std::vector<AirMeasurement> AirMeter::measure(const AirQuality& quality) {
  BodiesPass bodies(
      [this](const std::string& file, const std::string& where) {
        auto& image = images_[file];
        if (image.texels.empty()) image = readImage(catalogsFolder() / file, where);
        return image;
      },
      quality);
  std::vector<AirMeasurement> all;
  double wallBefore = 0.0;
  std::map<std::pair<int, int>, double> units;  // in the same run as what they measure
  for (std::size_t i = 0; i < views_.size(); ++i) {
    auto const& view = views_[i];
    AirMeasurement m;
    int const built = bodies.tablesBuilt();
    PlannedBody plain = view.body;  // maps are no part of the time to compute tables
    plain.map = plain.waterMask = plain.nightMap = "";
    double const before = processorSeconds();
    bodies.prepare(plain, view.picture, {});
    double const processor = processorSeconds() - before;
    bodies.prepare(view.body, view.picture, {});
    if (bodies.tablesBuilt() > built)
      m.cost.precomputeSeconds =
          clock_ == DrawClock::Wall ? secondsOfTables(bodies) - wallBefore : processor;
    wallBefore = secondsOfTables(bodies);
    std::size_t bytes = 0;
    for (auto const& [name, count] : bodies.residentBytes())
      if (!name.starts_with("map ")) bytes += count;
    m.cost.mebibytes = static_cast<double>(bytes) / 1048576.0;
    auto& unit = units[{view.picture.width, view.picture.height}];
    if (unit == 0.0) unit = fillUnitSeconds(view.picture.width, view.picture.height, clock_);
    double const seconds = drawSeconds(bodies, view, repeats_, clock_);
    m.cost.milliseconds = 1e3 * seconds;
    m.cost.fillUnits = seconds / unit;
    std::vector<glm::dvec3> share;
    if (quality.airScale > 1) {
      plain.albedo =
          glm::vec3(static_cast<float>(view.question.medium.groundAlbedo.at(550.0 * nanometre)));
      plain.mapFactor = glm::vec3(1.0f);
      plain.nightLuminance = 0.0;
      auto const fine = pixelsAt(bodies, view, plain, 1);
      auto const coarse = pixelsAt(bodies, view, plain, quality.airScale);
      m.scale = scaleErrorOf(fine, coarse);
      for (auto const& pixel : view.pixels) {
        auto const at = static_cast<std::size_t>(pixel.y * view.picture.width + pixel.x);
        share.push_back(coarse[at] / glm::max(fine[at], glm::dvec3(1e-12)));
      }
    }
    m.error = errorOf(view, *bodies.airOf(view.body), references_[i], share);
    all.push_back(m);
  }
  return all;
}

}  // namespace antumbra
