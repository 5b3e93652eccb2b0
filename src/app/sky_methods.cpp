#include "app/sky_methods.h"

#include "atmosphere/single_scattering.h"

namespace antumbra {
namespace {

const Direction<AirFrame> kUp{{0.0, 0.0, 1.0}};

SkyAnswer byReference(const SkyQuestion& request, const SkyProgress& progress) {
  SkyAnswer answer;
  size_t const n = request.wavelengths.size();
  size_t const total = (request.irradiance ? 1 : request.directions.size()) * n;
  answer.radiances.resize(request.irradiance ? 0 : total);
  for (size_t w = 0; w < n; ++w) {
    PathTracer const tracer(request.medium, request.sun, request.wavelengths[w],
                            request.groundRadius);
    size_t done = w * total / n;
    auto const partly = [&](double share) {
      if (progress) progress((static_cast<double>(done) + share) / static_cast<double>(total));
    };
    // Values must not share their errors: each has a seed of its own.
    PathTracerSettings settings = request.tracing;
    if (request.irradiance) {
      SingleScattering const direct(request.medium, request.sun, request.wavelengths[w],
                                    request.groundRadius);
      settings.seed = request.tracing.seed * 1000003u + w;
      answer.direct.push_back(direct.directIrradiance(request.camera, kUp));
      answer.diffuse.push_back(tracer.diffuseIrradiance(request.camera, kUp, settings, partly));
      continue;
    }
    for (size_t d = 0; d < request.directions.size(); ++d, ++done) {
      settings.seed = (request.tracing.seed * 1000003u + w) * 1000003u + d;
      answer.radiances[d * n + w] =
          tracer.radiance(request.camera, request.directions[d], settings, partly);
    }
  }
  return answer;
}

SkyAnswer bySingleScattering(const SkyQuestion& request, const SkyProgress& progress) {
  SkyAnswer answer;
  size_t const n = request.wavelengths.size();
  answer.radiances.resize(request.irradiance ? 0 : request.directions.size() * n);
  for (size_t w = 0; w < n; ++w) {
    SingleScattering const air(request.medium, request.sun, request.wavelengths[w],
                               request.groundRadius);
    if (request.irradiance) {
      answer.direct.push_back(air.directIrradiance(request.camera, kUp));
      answer.diffuse.push_back({air.diffuseIrradiance(request.camera, kUp), 0.0, 0});
    } else {
      for (size_t d = 0; d < request.directions.size(); ++d)
        answer.radiances[d * n + w].value = air.radiance(request.camera, request.directions[d]);
    }
    if (progress) progress(static_cast<double>(w + 1) / static_cast<double>(n));
  }
  return answer;
}

}  // namespace

const std::map<std::string, SkyMethod>& skyMethods() {
  static const std::map<std::string, SkyMethod> methods = [] {
    std::map<std::string, SkyMethod> all{{"reference", byReference},
                                         {"single", bySingleScattering}};
    for (std::string const preset : {"draft", "balanced", "accurate"})
      all[preset] = [preset](const SkyQuestion& question, const SkyProgress&) {
        return byPreset(preset, question);
      };
    return all;
  }();
  return methods;
}

}  // namespace antumbra
