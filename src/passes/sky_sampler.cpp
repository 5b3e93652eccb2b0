#include "passes/sky_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "document/input_error.h"
#include "passes/air_sky.h"
#include "passes/air_tables.h"
#include "passes/body_shadows.h"
#include "passes/body_tiles.h"
#include "passes/eclipsed_source.h"
#include "passes/gauss_legendre.h"

namespace antumbra {
namespace {

struct Probe {  // std430, passes/air_probe.comp
  glm::vec4 ray, start, direction;
};

// The ray in the sphere's own axes, or nothing where it misses the air.
std::optional<Probe> probeOf(const Medium& medium, const SkyRequest& request,
                             const SkyDirection& look) {
  double const radius = medium.radius.si, top = medium.topHeight.si;
  double height = request.altitude.si;
  double const z = cos(look.viewZenith), level = sin(look.viewZenith);
  glm::dvec3 const direction(level * cos(look.relativeAzimuth), level * sin(look.relativeAzimuth),
                             z);
  glm::dvec3 const sun(sin(request.sunZenith), 0.0, cos(request.sunZenith));
  glm::dvec3 start(0.0, 0.0, radius + height);
  double rise = start.z * z;
  double const groundRoot = rise * rise - height * (2.0 * radius + height);
  if (height > top) {
    double const topRoot = rise * rise - (height - top) * (2.0 * radius + height + top);
    if (rise >= 0.0 || topRoot <= 0.0) return std::nullopt;
    start += direction * (-rise - std::sqrt(topRoot));
    rise = -std::sqrt(topRoot);
    height = top;
  }
  return Probe{glm::vec4(height, rise, glm::dot(start, sun), glm::dot(direction, sun)),
               glm::vec4(glm::vec3(start), static_cast<float>(groundRoot)),
               glm::vec4(glm::vec3(direction), 0.0f)};
}

std::vector<double> sampleFour(const Medium& medium, const SkyRequest& request,
                               const AirQuality& quality, const std::vector<Length>& wavelengths) {
  AirTables const tables(medium, medium.radius, wavelengths, quality, request.sunRadius);
  std::unique_ptr<BodyShadows> shadows;
  if (!request.casters.empty())
    shadows = std::make_unique<BodyShadows>(request.casters, 1.0, request.law, tables.wavelengths(),
                                            medium.topRadius());
  gl::Definitions shadowFlags;
  std::unique_ptr<EclipsedSource> eclipsed;
  if (shadows) {
    shadowFlags = shadows->definitions();
    auto const more = EclipsedSource::definitions();
    shadowFlags.insert(shadowFlags.end(), more.begin(), more.end());
    eclipsed = std::make_unique<EclipsedSource>(tables, *shadows);
    eclipsed->update(tables, *shadows, request.casters.front(),
                     {sin(request.sunZenith), 0.0, cos(request.sunZenith)});
    shadows->bind();
    eclipsed->bind();
  }
  bool const useTable = AirSky::serves(tables, request.altitude);
  auto definitions = tables.definitions();
  definitions.insert(definitions.end(), shadowFlags.begin(), shadowFlags.end());
  for (const char* flag : {"AIR_SINGLE", "AIR_SOURCE", "ECLIPSED_HARMONICS"})
    definitions.emplace_back(flag, "");
  std::unique_ptr<AirSky> sky;
  if (useTable) {
    definitions.emplace_back("AIR_SKY", "");
    sky = std::make_unique<AirSky>(tables, shadowFlags);
    sky->update(tables, request.altitude, {0.0, 0.0, 1.0},
                {sin(request.sunZenith), 0.0, cos(request.sunZenith)});
    sky->bind();
  }
  // As pictures are drawn: sunlit ground from outside with the fewer samples.
  bool const sunlit = !useTable && cos(request.sunZenith) > kSunlitSine;
  std::vector<double> result(request.directions.size() * wavelengths.size(), 0.0);
  for (bool const ground : {false, true}) {
    std::vector<Probe> probes;
    std::vector<std::size_t> whose;
    for (std::size_t i = 0; i < request.directions.size(); ++i)
      if (auto const probe = probeOf(medium, request, request.directions[i])) {
        bool const meets = sunlit && probe->ray.y < 0.0f && probe->start.w > 0.0f;
        if (meets != ground) continue;
        probes.push_back(*probe);
        whose.push_back(i);
      }
    if (probes.empty()) continue;
    auto own = definitions;
    own.emplace_back(ground ? "BODY_GROUND" : "AIR_CUTS", "");
    auto const program = gl::Program::compute("passes/air_probe.comp", own);
    tables.bind();
    QuadratureBlock const nodes(ground ? quality.groundSamples : quality.viewSamples);
    nodes.bind();
    gl::Buffer in, out;
    in.write(std::span<const Probe>(probes));
    std::vector<glm::vec4> radiances(probes.size() * static_cast<std::size_t>(tables.layers()));
    out.write(std::span<const glm::vec4>(radiances));
    in.bindStorage(0);
    out.bindStorage(1);
    program.use();
    glDispatchCompute(static_cast<GLuint>((probes.size() + 31) / 32), 1, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glGetNamedBufferSubData(out.id(), 0,
                            static_cast<GLsizeiptr>(radiances.size() * sizeof(glm::vec4)),
                            radiances.data());
    for (std::size_t p = 0; p < probes.size(); ++p)
      for (std::size_t w = 0; w < wavelengths.size(); ++w)
        result[whose[p] * wavelengths.size() + w] =
            static_cast<double>(radiances[p * static_cast<std::size_t>(tables.layers()) + w / 4]
                                         [static_cast<int>(w % 4)]);
  }
  return result;
}

}  // namespace

std::vector<double> sampleSky(const Medium& medium, const SkyRequest& request,
                              const AirQuality& quality) {
  std::size_t const count = request.wavelengths.size();
  std::vector<double> result(request.directions.size() * count);
  for (std::size_t first = 0; first < count; first += 4) {
    std::size_t const size = std::min<std::size_t>(4, count - first);
    auto const begin = request.wavelengths.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<Length> const four(begin, begin + static_cast<std::ptrdiff_t>(size));
    auto const part = sampleFour(medium, request, quality, four);
    for (std::size_t d = 0; d < request.directions.size(); ++d)
      for (std::size_t w = 0; w < size; ++w) result[d * count + first + w] = part[d * size + w];
  }
  return result;
}

std::vector<SkyIrradiance> sampleSkyIrradiance(const Medium& medium, const SkyRequest& request,
                                               const AirQuality& quality) {
  if (request.altitude > medium.topHeight)
    throw InputError(
        fmt::format("irradiance: altitude {} km; allowed: up to the top of the air, "
                    "{} km",
                    request.altitude / kilometre, medium.topHeight / kilometre));
  // Quadrature over the upper hemisphere: dense toward the horizon and, by azimuth, uniform.
  auto const zenith = gaussLegendre(32);
  constexpr int turns = 64;
  SkyRequest sky = request;
  sky.directions.clear();
  std::vector<double> weights;
  for (auto const& node : zenith)
    for (int i = 0; i < turns; ++i) {
      double const x = static_cast<double>(node.x), cosine = x * x;
      sky.directions.push_back(
          {Angle(std::acos(cosine)), Angle(2.0 * std::numbers::pi * (i + 0.5) / turns)});
      weights.push_back(static_cast<double>(node.y) * 2.0 * x * cosine * 2.0 * std::numbers::pi /
                        turns);
    }
  auto const radiances = sampleSky(medium, sky, quality);
  std::size_t const count = request.wavelengths.size();
  std::vector<SkyIrradiance> result(count, {0.0, 0.0});
  for (std::size_t d = 0; d < weights.size(); ++d)
    for (std::size_t w = 0; w < count; ++w)
      result[w].diffuse += weights[d] * radiances[d * count + w];
  return result;
}

}  // namespace antumbra
