// The precomputed tables of one body's air, for a list of wavelengths: densities, phase functions,
// optical depths to the top, and the source of multiple scattering (moments of the radiance that
// has been scattered or reflected at least once, over height and the Sun's zenith angle).
//
// The source is iterated by orders: for every cell the radiance from a set of directions, marched
// through the previous order's moments with the ground's reflection, is projected on harmonics up
// to `degree`. Between cells it is interpolated by the eighth root of the mean radiance and by the
// harmonics' shares of it, for twilight falls by a factor of four from cell to cell. For molecules
// two degrees are exact (their phase function has no others). Of peaked constituents the forward
// peak counts as no scattering (medium/forward_peak.h): the depths that light is marched with leave
// it out, and sunlight scattered once keeps it, blurred by the peaks on its way. In air thicker
// than light reaches the orders converge too slowly: there their fixed point is solved for
// (passes/thick_air.h). Errors: configs/quality/README.md.
//
// In a medium that refracts, direct sunlight comes along bent rays (bent_sun_texels.h), from a
// table like that of the depths; what reaches the camera goes straight.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "medium/forward_peak.h"
#include "medium/medium.h"
#include "passes/air_quality.h"
#include "passes/bent_sun_texels.h"
#include "quantity/quantity.h"

namespace antumbra {

// Phase functions as the tables take them: by constituent and wavelength.
struct AirPhases {
  int degree = 2;
  std::vector<std::vector<ForwardPeak>> of;
};

// Uniforms of interface/air.glsl, as many as a medium and its wavelengths need.
std::vector<glm::vec4> airBlockOf(const Medium* medium, const std::vector<Length>& wavelengths,
                                  Length groundRadius, double lowestSunCosine, Angle sunRadius,
                                  const std::vector<std::size_t>& order, const AirPhases& phases);

class AirTables {
 public:
  // `groundRadius` is the equatorial radius of the body in hand (the medium's own for a sphere).
  // `wavelengths` are padded to a multiple of four by repeating the last. Needs a context.
  AirTables(const Medium& medium, Length groundRadius, const std::vector<Length>& wavelengths,
            const AirQuality& quality, Angle sunRadius);

  // The Sun's disc as tables of bent sunlight take it: in steps of 2 %, so that they serve pictures
  // of several months.
  static Angle discOf(Angle sunRadius);

  // Of every program that includes interface/air.glsl.
  const gl::Definitions& definitions() const { return definitions_; }
  // Binds uniform block 1 and texture units 2 to 5.
  void bind() const;
  int layers() const { return layers_; }
  int peakedCount() const { return peaked_; }
  // Whether the medium holds haze enough for the knobs of haze.
  bool hazy() const { return hazy_; }
  // Whether sunlight is bent.
  bool bent() const { return bent_; }
  Length groundRadius() const { return groundRadius_; }
  Length top() const { return top_; }
  // Of the source table: no light comes from air whose Sun is lower.
  double lowestSunCosine() const { return lowestSunCosine_; }
  const std::vector<Length>& wavelengths() const { return wavelengths_; }
  const AirQuality& quality() const { return quality_; }
  std::size_t bytes() const;
  double precomputeSeconds() const { return precomputeSeconds_; }
  // Orders or, in thick air, steps that the source took, and what the last still changed
  // (ThickAirSolver::change()).
  int orders() const { return orders_; }
  double lastChange() const { return lastChange_; }
  // The brightest mean radiance at any height under a Sun of this zenith angle over that of any
  // Sun.
  double brightnessUnder(double sunCosine) const;
  const gl::Texture& source() const { return source_; }
  const gl::Texture& depths() const { return depths_; }

 private:
  std::vector<double> sourceLevels(const Medium& medium, const std::vector<std::size_t>& order,
                                   const AirPhases& phases) const;
  BentSunTexels bentSun(const Medium& medium, Angle sunRadius) const;
  void buildDensities(const Medium& medium, const std::vector<std::size_t>& order,
                      const std::vector<double>& levels, const std::vector<float>& sunOnGround);
  void buildPhases(const Medium& medium, const std::vector<std::size_t>& order,
                   const AirPhases& phases);
  std::vector<PeaksOnTheWay> peaksOnTheWay(const Medium& medium,
                                           const std::vector<std::size_t>& order,
                                           const AirPhases& phases) const;
  void buildDepths(const BentSunTexels& sun, const std::vector<PeaksOnTheWay>& ways);
  // Of the source's rows, m.
  std::vector<double> sourceHeights(const std::vector<double>& levels) const;
  void buildSource(const Medium& medium, const std::vector<std::size_t>& order,
                   const AirPhases& phases, const std::vector<double>& levels);
  // Tables in 16 bits; returns the radiance of a value of the source.
  float halve();
  void measureSource();

  AirQuality quality_;
  Length groundRadius_, top_;
  double lowestSunCosine_ = -1.0;
  std::vector<Length> wavelengths_;
  int layers_ = 1;
  int constituents_ = 0;
  int peaked_ = 0;
  bool hazy_ = false;
  bool thick_ = false;
  bool bent_ = false;
  int degree_ = 2;
  int orders_ = 0;
  double lastChange_ = 0.0;
  gl::Definitions definitions_;
  gl::Buffer block_;
  gl::Texture densities_, phases_, depths_, source_;
  std::vector<double> brightest_;  // mean radiance by the source table's column
  double precomputeSeconds_ = 0.0;
};

// Binds Gauss-Legendre nodes to uniform block 3.
class QuadratureBlock {
 public:
  // Up to 64 of each.
  explicit QuadratureBlock(int many, int few = 0);
  void bind() const { buffer_.bindUniform(3); }

 private:
  gl::Buffer buffer_;
};

}  // namespace antumbra
