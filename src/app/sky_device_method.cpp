// The sky by the programs that draw pictures, with tables for the wavelengths asked for.
#include "app/sky_methods.h"
#include "atmosphere/single_scattering.h"
#include "gl/context.h"
#include "passes/air_quality.h"
#include "passes/sky_sampler.h"

namespace antumbra {

int colourWavelengths(const std::string& method) {
  return method == "reference" || method == "single" ? 8 : AirQuality::preset(method).wavelengths;
}

SkyRequest skyRequestOf(const SkyQuestion& question) {
  SkyRequest request;
  request.altitude = Length(glm::length(question.camera.m)) - question.medium.radius;
  request.sunZenith = skyDirectionOf(question.sun.toSun).viewZenith;
  request.sunRadius = question.sun.discRadius;
  request.wavelengths = question.wavelengths;
  request.law = question.sun.law;
  request.casters = SunShadow(question.sun, question.wavelengths.front()).pairs();
  request.corona = question.sun.corona;
  for (auto const& d : question.directions) request.directions.push_back(skyDirectionOf(d));
  return request;
}

SkyAnswer byPreset(const std::string& preset, const SkyQuestion& question) {
  gl::HeadlessContext const context;
  gl::prepareContext();
  SkyRequest const request = skyRequestOf(question);
  AirQuality const quality = AirQuality::preset(preset);
  SkyAnswer answer;
  if (question.irradiance) {
    for (auto const& e : sampleSkyIrradiance(question.medium, request, quality))
      answer.diffuse.push_back({e.diffuse, 0.0, 0});
    // Direct sunlight is no matter of method: optical depth and visible share in double precision.
    for (Length const wavelength : question.wavelengths)
      answer.direct.push_back(
          SingleScattering(question.medium, question.sun, wavelength, question.groundRadius)
              .directIrradiance(question.camera, {{0.0, 0.0, 1.0}}));
  } else {
    for (double radiance : sampleSky(question.medium, request, quality))
      answer.radiances.push_back({radiance, 0.0, 0});
  }
  return answer;
}

}  // namespace antumbra
