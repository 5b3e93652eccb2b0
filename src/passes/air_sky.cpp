#include "passes/air_sky.h"

#include <algorithm>
#include <cmath>

namespace antumbra {
namespace {

struct SkyBlock {  // std140, interface/air_sky.glsl
  glm::vec4 up, sunward, side, dip;
};

gl::Definitions definitionsOf(const AirTables& tables, const gl::Definitions& shadows) {
  auto d = tables.definitions();
  for (const char* flag : {"AIR_SINGLE", "AIR_SOURCE", "AIR_SEPARATE", "AIR_CUTS"})
    d.emplace_back(flag, "");
  d.insert(d.end(), shadows.begin(), shadows.end());
  if (!shadows.empty()) d.emplace_back("ECLIPSED_DIRECTIONS", "");
  d.emplace_back("AIR_SKY_FORMAT",
                 tables.quality().storage == AirStorage::Half ? "rgba16f" : "rgba32f");
  return d;
}

}  // namespace

AirSky::AirSky(const AirTables& tables, const gl::Definitions& shadowDefinitions)
    : program_(
          gl::Program::compute("passes/air_sky.comp", definitionsOf(tables, shadowDefinitions))),
      nodes_(shadowDefinitions.empty() ? tables.quality().skySamples
                                       : tables.quality().eclipseSkySamples),
      wholeTurn_(!shadowDefinitions.empty()) {
  auto const& q = tables.quality();
  // The same azimuths as in half a turn, so that nothing jumps where an eclipse begins.
  int const width = wholeTurn_ ? 2 * q.skyWidth - 1 : q.skyWidth;
  GLenum const format = q.storage == AirStorage::Half ? GL_RGBA16F : GL_RGBA32F;
  joint_ = gl::Texture::layers(format, width, q.skyHeight, tables.layers());
  peaked_ =
      gl::Texture::layers(format, width, q.skyHeight, tables.layers() * tables.peakedCount() + 1);
}

void AirSky::update(const AirTables& tables, Length cameraHeight, const glm::dvec3& up,
                    const glm::dvec3& sun) {
  double const sunCosine = std::clamp(glm::dot(up, sun), -1.0, 1.0);
  glm::dvec3 level = sun - up * sunCosine;
  if (glm::length(level) < 1e-9)  // the Sun in the zenith: any azimuth will do
    level = glm::cross(up, std::fabs(up.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0));
  glm::dvec3 const sunward = glm::normalize(level);
  glm::dvec3 const side = glm::cross(up, sunward);
  // Half floats hold values up to 65504: a radiance of 1/sr is 1024 by day; in twilight, where the
  // brightest direction has at most some hundred times the mean, the more the darker its air is.
  float const scale =
      tables.quality().storage == AirStorage::Half
          ? static_cast<float>(1024.0 / std::max(tables.brightnessUnder(sunCosine), 1e-9))
          : 1.0f;
  double const h = std::max(cameraHeight.si, 0.0), radius = tables.groundRadius().si;
  SkyBlock const block{
      glm::vec4(glm::vec3(up), static_cast<float>(h)),
      glm::vec4(glm::vec3(sunward), static_cast<float>(sunCosine)),
      glm::vec4(glm::vec3(side), wholeTurn_ ? 1.0f : 0.0f),
      glm::vec4(static_cast<float>(std::atan2(std::sqrt(h * (2.0 * radius + h)), radius)), scale,
                1.0f / scale, 0.0f)};
  block_.write(block);
  tables.bind();
  nodes_.bind();
  block_.bindUniform(6);
  program_.use();
  joint_.bindImage(0, GL_WRITE_ONLY);
  peaked_.bindImage(1, GL_WRITE_ONLY);
  glDispatchCompute(static_cast<GLuint>((joint_.width() + 7) / 8),
                    static_cast<GLuint>((joint_.height() + 7) / 8), 1);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void AirSky::bind() const {
  block_.bindUniform(6);
  joint_.bind(6);
  peaked_.bind(7);
}

}  // namespace antumbra
