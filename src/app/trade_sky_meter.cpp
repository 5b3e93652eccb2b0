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

namespace antumbra {
namespace {

// Of the tables computed so far, by the pass's own clock.
double secondsOfTables(const BodiesPass& bodies) {
  double sum = 0.0;
  for (auto const& [name, seconds] : bodies.precomputeSeconds()) sum += seconds;
  return sum;
}

double drawSeconds(BodiesPass& bodies, const AirView& view, int repeats, DrawClock clock) {
  auto const& picture = view.picture;
  auto const target = gl::Texture::plane(GL_RGBA32F, picture.width, picture.height);
  gl::Framebuffer const framebuffer({&target});
  gl::Buffer viewBlock;
  viewBlock.write(gl::viewBlockOf(picture));
  double seconds = 0.0;
  if (bodies.repeatSky(view.body))
    seconds += medianSeconds([&] { bodies.repeatSky(view.body); }, repeats, clock);
  return seconds + medianSeconds(
                       [&] {
                         framebuffer.bind();
                         viewBlock.bindUniform(0);
                         bodies.draw(view.body, picture, {0, 0}, {picture.width, picture.height});
                       },
                       repeats, clock);
}

SkyError errorOf(const AirView& view, const AirTables& tables, const ReferenceSky& reference) {
  SkySampler sampler(view.question.medium, tables);
  SkyRequest request;
  request.altitude = Length(view.question.camera.m.z) - view.question.medium.radius;
  request.sunZenith = view.sunZenith;
  request.sunRadius = view.question.sun.discRadius;
  for (auto const& d : view.question.directions)
    request.directions.push_back(
        {arcTangent(std::hypot(d.u.x, d.u.y), d.u.z), arcTangent(d.u.y, d.u.x)});
  return errorAgainst(reference, coloursOf(view, tables.wavelengths(), sampler.sample(request)));
}

}  // namespace

AirMeasurement overall(const std::vector<AirMeasurement>& views) {
  AirMeasurement m;
  auto const share = 1.0 / static_cast<double>(views.size());
  for (auto const& v : views) {
    m.error.luminance += share * v.error.luminance;
    m.error.deltaE += share * v.error.deltaE;
    m.error.worstDeltaE = std::max(m.error.worstDeltaE, v.error.worstDeltaE);
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
    m.error = errorOf(view, *bodies.airOf(view.body), references_[i]);
    all.push_back(m);
  }
  return all;
}

}  // namespace antumbra
