// Radiance of the sky and the ground in given directions, by the programs that draw pictures, with
// tables computed for the wavelengths asked for.
#pragma once

#include <memory>
#include <vector>

#include "atmosphere/sunlight.h"
#include "eclipse/corona_light.h"
#include "eclipse/limb_darkening.h"
#include "eclipse/shadow_pair.h"
#include "medium/medium.h"
#include "passes/air_quality.h"
#include "quantity/quantity.h"

namespace antumbra {

class AirTables;

struct SkyDirection {
  Angle viewZenith;       // above 90 deg: down
  Angle relativeAzimuth;  // 0 toward the Sun
};
// Its unit vector: z through the camera, x toward the Sun's azimuth; and back.
Direction<AirFrame> airDirectionOf(const SkyDirection& direction);
SkyDirection skyDirectionOf(const Direction<AirFrame>& direction);

struct SkyRequest {
  Length altitude;       // above the medium's sphere; any height
  Angle sunZenith;       // at the camera
  Angle sunRadius{0.0};  // 0: a point
  std::vector<SkyDirection> directions;
  std::vector<Length> wavelengths;
  // Casters, in metres from the medium's centre; axes: z through the camera, x toward the Sun's
  // azimuth.
  std::vector<glsl::ShadowPair> casters;
  LimbDarkeningLaw law = LimbDarkeningLaw::Hestroffer;
  std::shared_ptr<const CoronaLight> corona;  // that shines past the casters, or none
};

// Over E0, by wavelength.
struct SkyIrradiance {
  double direct, diffuse;
};

// Tables for a medium and a list of wavelengths, kept for many requests. Needs a context.
class SkySampler {
 public:
  // `betweenNodes`: as in EclipsedSource.
  SkySampler(const Medium& medium, const std::vector<Length>& wavelengths,
             const AirQuality& quality, Angle sunRadius = Angle(0.0), bool betweenNodes = true);
  // By tables that exist already and outlive it; their ground's radius is the medium's.
  SkySampler(const Medium& medium, const AirTables& tables);
  ~SkySampler();
  SkySampler(const SkySampler&) = delete;
  SkySampler& operator=(const SkySampler&) = delete;
  // As sampleSky; the request's wavelengths and solar radius are those of the sampler.
  std::vector<double> sample(const SkyRequest& request);
  // As sampleSkyIrradiance.
  std::vector<SkyIrradiance> irradiance(const SkyRequest& request);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// L/E0 in 1/sr, without the solar disc: directions in the order given, wavelengths innermost. E0 is
// the irradiance outside the air. Needs a context.
std::vector<double> sampleSky(const Medium& medium, const SkyRequest& request,
                              const AirQuality& quality);

// Irradiance from above on a horizontal surface at the camera over E0, by wavelength: direct and
// diffuse (from above the air none).
std::vector<SkyIrradiance> sampleSkyIrradiance(const Medium& medium, const SkyRequest& request,
                                               const AirQuality& quality);

}  // namespace antumbra
