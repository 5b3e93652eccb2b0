#include "passes/sky_sampler.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

#include "atmosphere/hemisphere_nodes.h"
#include "passes/air_sky.h"
#include "passes/air_tables.h"
#include "passes/body_shadows.h"
#include "passes/eclipsed_source.h"

namespace antumbra {

Direction<AirFrame> airDirectionOf(const SkyDirection& direction) {
  Angle const z = direction.viewZenith, a = direction.relativeAzimuth;
  return {{sin(z) * cos(a), sin(z) * sin(a), cos(z)}};
}

SkyDirection skyDirectionOf(const Direction<AirFrame>& direction) {
  glm::dvec3 const& u = direction.u;
  return {arcTangent(std::hypot(u.x, u.y), u.z), arcTangent(u.y, u.x)};
}

namespace {

struct Probe {  // std430, passes/air_probe.comp
  glm::vec4 ray, start, direction;
};

// The ray in the sphere's own axes, or nothing where it misses the air.
std::optional<Probe> probeOf(const Medium& medium, const SkyRequest& request,
                             const SkyDirection& look) {
  double const radius = medium.radius.si, top = medium.topHeight.si;
  double height = request.altitude.si;
  glm::dvec3 const direction = airDirectionOf(look).u;
  glm::dvec3 const sun(sin(request.sunZenith), 0.0, cos(request.sunZenith));
  glm::dvec3 start(0.0, 0.0, radius + height);
  double rise = start.z * direction.z;
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

}  // namespace

// Tables of some wavelengths, and the programs that read them.
struct SkyTables {
  std::unique_ptr<AirTables> own;
  const AirTables& tables;
  std::size_t first, count;  // of the sampler's wavelengths
  std::map<std::string, gl::Program> programs;
  std::map<std::pair<std::size_t, bool>, AirSky> skies;  // by number of casters, with a corona
  std::unique_ptr<EclipsedSource> eclipsed;
  std::size_t eclipsedCount = 0;
  LimbDarkeningLaw law = LimbDarkeningLaw::Hestroffer;

  SkyTables(const Medium& medium, const std::vector<Length>& wavelengths, const AirQuality& quality,
            Angle sunRadius, std::size_t from)
      : own(std::make_unique<AirTables>(medium, medium.radius, wavelengths, quality, sunRadius)),
        tables(*own),
        first(from),
        count(wavelengths.size()) {}
  SkyTables(const AirTables& given, std::size_t wavelengths)
      : tables(given), first(0), count(wavelengths) {}

  std::vector<glm::vec4> run(const std::vector<Probe>& probes, const gl::Definitions& definitions,
                             const AirQuality& quality) {
    std::string key;
    for (auto const& [name, value] : definitions) key += name + "=" + value + ";";
    auto found = programs.find(key);
    if (found == programs.end())
      found =
          programs.emplace(key, gl::Program::compute("passes/air_probe.comp", definitions)).first;
    tables.bind();
    QuadratureBlock const nodes(quality.viewSamples, quality.groundSamples);
    nodes.bind();
    gl::Buffer in, out;
    in.write(std::span<const Probe>(probes));
    std::vector<glm::vec4> radiances(probes.size() * static_cast<std::size_t>(tables.layers()));
    out.write(std::span<const glm::vec4>(radiances));
    in.bindStorage(0);
    out.bindStorage(1);
    found->second.use();
    glDispatchCompute(static_cast<GLuint>((probes.size() + 31) / 32), 1, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glGetNamedBufferSubData(out.id(), 0,
                            static_cast<GLsizeiptr>(radiances.size() * sizeof(glm::vec4)),
                            radiances.data());
    return radiances;
  }
};

struct SkySampler::State {
  Medium medium;
  AirQuality quality;
  std::size_t count;
  bool betweenNodes;
  std::vector<std::unique_ptr<SkyTables>> parts;
};

SkySampler::SkySampler(const Medium& medium, const std::vector<Length>& wavelengths,
                       const AirQuality& quality, Angle sunRadius, bool betweenNodes)
    : state_(new State{medium, quality, wavelengths.size(), betweenNodes, {}}) {
  for (std::size_t first = 0; first < wavelengths.size(); first += 4) {
    auto const begin = wavelengths.begin() + static_cast<std::ptrdiff_t>(first);
    auto const size = std::min<std::size_t>(4, wavelengths.size() - first);
    state_->parts.push_back(std::make_unique<SkyTables>(
        medium, std::vector<Length>(begin, begin + static_cast<std::ptrdiff_t>(size)), quality,
        sunRadius, first));
  }
}
SkySampler::SkySampler(const Medium& medium, const AirTables& tables)
    : state_(new State{medium, tables.quality(), tables.wavelengths().size(), true, {}}) {
  state_->parts.push_back(std::make_unique<SkyTables>(tables, state_->count));
}
SkySampler::~SkySampler() = default;

std::vector<double> SkySampler::sample(const SkyRequest& request) {
  auto& s = *state_;
  std::vector<double> result(request.directions.size() * s.count, 0.0);
  glm::dvec3 const sun(sin(request.sunZenith), 0.0, cos(request.sunZenith));
  for (auto const& part : s.parts) {
    auto& own = *part;
    auto& tables = own.tables;
    auto const layers = static_cast<std::size_t>(tables.layers());
    gl::Definitions shadowFlags;
    std::unique_ptr<BodyShadows> shadows;
    if (!request.casters.empty()) {
      shadows =
          std::make_unique<BodyShadows>(request.casters, 1.0, request.law, tables.wavelengths(),
                                        s.medium.topRadius(), request.corona);
      // The grids' nodes serve further requests.
      if (!own.eclipsed || own.eclipsedCount != request.casters.size() || own.law != request.law)
        own.eclipsed = std::make_unique<EclipsedSource>(tables, request.law, request.casters.size(),
                                                        s.betweenNodes);
      own.eclipsedCount = request.casters.size();
      own.law = request.law;
      own.eclipsed->update(tables, request.casters, 1.0);
      shadowFlags = shadows->definitions();
      auto const more = own.eclipsed->definitions();
      shadowFlags.insert(shadowFlags.end(), more.begin(), more.end());
      shadows->bind();
      own.eclipsed->bind();
    }
    auto definitions = tables.definitions();
    definitions.insert(definitions.end(), shadowFlags.begin(), shadowFlags.end());
    for (const char* flag : {"AIR_SINGLE", "AIR_SOURCE", "ECLIPSED_DIRECTIONS"})
      definitions.emplace_back(flag, "");
    bool const useTable = AirSky::serves(tables, request.altitude);
    if (useTable) {
      definitions.emplace_back("AIR_SKY", "");
      auto const sky =
          own.skies
              .try_emplace({request.casters.size(), request.corona != nullptr}, tables, shadowFlags)
              .first;
      sky->second.update(tables, request.altitude, {0.0, 0.0, 1.0}, sun);
      sky->second.bind();
    }
    std::vector<Probe> probes;
    std::vector<std::size_t> whose;
    for (std::size_t i = 0; i < request.directions.size(); ++i)
      if (auto const probe = probeOf(s.medium, request, request.directions[i])) {
        probes.push_back(*probe);
        whose.push_back(i);
      }
    if (probes.empty()) continue;
    auto const radiances = own.run(probes, definitions, s.quality);
    for (std::size_t p = 0; p < probes.size(); ++p)
      for (std::size_t w = 0; w < own.count; ++w)
        result[whose[p] * s.count + own.first + w] =
            static_cast<double>(radiances[p * layers + w / 4][static_cast<int>(w % 4)]);
  }
  return result;
}

std::vector<double> sampleSky(const Medium& medium, const SkyRequest& request,
                              const AirQuality& quality) {
  return SkySampler(medium, request.wavelengths, quality, request.sunRadius).sample(request);
}

std::vector<SkyIrradiance> sampleSkyIrradiance(const Medium& medium, const SkyRequest& request,
                                               const AirQuality& quality) {
  return SkySampler(medium, request.wavelengths, quality, request.sunRadius).irradiance(request);
}

std::vector<SkyIrradiance> SkySampler::irradiance(const SkyRequest& request) {
  auto const nodes = hemisphereNodes(request.sunZenith);
  SkyRequest sky = request;
  sky.directions.clear();
  for (auto const& node : nodes) sky.directions.push_back(skyDirectionOf(node.direction));
  auto const radiances = sample(sky);
  std::size_t const count = request.wavelengths.size();
  std::vector<SkyIrradiance> result(count, {0.0, 0.0});
  for (std::size_t d = 0; d < nodes.size(); ++d)
    for (std::size_t w = 0; w < count; ++w)
      result[w].diffuse += nodes[d].weight * radiances[d * count + w];
  return result;
}

}  // namespace antumbra
