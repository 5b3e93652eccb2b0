// Light of all orders in spherical air: a backward Monte Carlo path tracer, the reference that
// everything faster is judged by.
//
// A path leaves the camera, is scattered by the air or reflected by the ground (Lambert) until it
// fades, and at each such point receives the Sun's direct light (transmittance, phase function,
// share of the disc that occulters leave; bent in a medium that refracts, bent_sunlight.h).
// Unbiased but for the tabulated optical depths (4e-5); between its vertices light goes straight,
// and there is no polarisation. Variance is lowered by forced scattering on rays that leave the
// air, a first leg drawn half by collision and half by where single scattering comes from,
// directions drawn in part towards the bright horizon of twilight, later vertices in part from
// sunlit stretches, stratified first legs, and Russian roulette.
//
// Reproducible: the estimate depends on the seed and the settings, not on the number of threads.
#pragma once

#include <cstdint>
#include <functional>

#include "atmosphere/spectral_medium.h"
#include "atmosphere/sunlight.h"

namespace antumbra {

struct PathTracerSettings {
  double relativeError = 0.005;  // of the standard error that ends the work
  uint64_t seed = 1;
  uint64_t maxPaths = uint64_t{1} << 25;  // ends the work though the error is larger
                                          // (at least 4096)
  int maxOrders = 0;                      // scattering and reflection events to follow; 0: all
  int threads = 0;                        // 0: all cores
};

struct Estimate {
  double value = 0.0;
  double standardError = 0.0;  // of the mean, from independent batches
  uint64_t paths = 0;
};

class PathTracer {
 public:
  PathTracer(const Medium& medium, const Sunlight& sun, Length wavelength, Length groundRadius);
  // L / E0 in 1/sr, as SingleScattering::radiance, but of all orders. `progress` hears the expected
  // share done, from 0 to 1, now and then.
  using Progress = std::function<void(double)>;
  Estimate radiance(Position<AirFrame> camera, Direction<AirFrame> direction,
                    const PathTracerSettings& settings, const Progress& progress = {}) const;
  // Irradiance over E0 of a surface by all scattered and reflected light, without the direct.
  Estimate diffuseIrradiance(Position<AirFrame> point, Direction<AirFrame> normal,
                             const PathTracerSettings& settings,
                             const Progress& progress = {}) const;

  struct FirstLeg;  // where a view's first vertices lie

 private:
  struct Random;
  double pathLight(const FirstLeg& leg, double first, Random& random, int maxOrders) const;
  double directLight(const glm::dvec3& x, double radius, const glm::dvec3& toSun) const;
  glm::dvec3 drawSun(Random& random, double& weight) const;
  // The distance along a ray at which it leaves the shadow of the body and its dense air; the
  // beginning of the span where it starts outside.
  double sunlitFrom(const glm::dvec3& start, const glm::dvec3& direction,
                    const SpectralMedium::Span& span) const;
  // The distance along a ray at which the optical depth from `enter` reaches `depth`.
  double distanceAtDepth(const AirRay& ray, double enter, double leave, double depth) const;
  Estimate average(const std::function<double(Random&, double)>& path,
                   const PathTracerSettings& settings, const Progress& progress) const;

  SpectralMedium air_;
  Sunlight sun_;
  SunShadow shadow_;
  DiscProfile disc_;
  double twilightRadius_;  // below it, grazing sunlight is lost
};

}  // namespace antumbra
