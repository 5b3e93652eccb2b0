// A medium at one wavelength, tabulated for speed: what the reference integrators look up millions
// of times. Metres and 1/m throughout, in double precision.
//
// Coefficients are linear between 8192 nodes quadratic in height: relative error below 2e-5 for
// scale heights from 1/50 of the top. Optical depths to the top, from heights and cosines of the
// upward half only (a downward ray is the difference or sum of two upward ones), come from a table
// of 512 x 64 by cubic interpolation: within 4e-5, in optical depth, of quadrature for the Earth's
// air at 550 nm (tests/atmosphere).
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "atmosphere/bent_sunlight.h"
#include "medium/medium.h"

namespace antumbra {

// The phase function of one constituent at one wavelength.
class SpectralPhase {
 public:
  SpectralPhase(const PhaseFunction& phase, Length wavelength);
  double at(double cosine) const;  // 1/sr
  // A cosine drawn from two uniform numbers, with drawDensity (1/sr) near at(): exactly that for
  // the analytic kinds except Cornette-Shanks, which is drawn from Henyey-Greenstein.
  double draw(double u, double v) const;
  double drawDensity(double cosine) const;

 private:
  PhaseFunction::Kind kind_;
  double g_ = 0.0, backwardG_ = 0.0, share_ = 1.0;
  std::vector<double> angles_, values_, cumulative_;
};

// A straight ray in spherical air: everything about it but its azimuth.
struct AirRay {
  double startRadius, along, perigeeSquared;  // along: radial component of position, r cosine
  AirRay(const glm::dvec3& start, const glm::dvec3& direction);
  double radiusAt(double s) const;
  double cosineAt(double s, double radius) const { return (along + s) / radius; }
  // Height above a sphere without the cancellation of r - R.
  double heightAt(double s, double sphere) const;
  // Distances at which the line crosses a sphere; false if it does not.
  bool crossings(double sphere, double& first, double& second) const;
};

class SpectralMedium {
 public:
  // The ground is the medium's sphere, or the sphere of the camera where that lies below it.
  SpectralMedium(const Medium& medium, Length wavelength, Length groundRadius);

  double ground() const { return ground_; }
  double top() const { return top_; }
  double groundAlbedo() const { return albedo_; }
  size_t constituents() const { return phases_.size(); }
  const SpectralPhase& phase(size_t i) const { return phases_[i]; }

  double extinction(double height) const;
  // Scattering of every constituent into `each` (as many as constituents()); returns their sum.
  double scattering(double height, double* each) const;
  // Optical depth from a point at `radius` upwards (cosine >= 0) to the top.
  double depthToTop(double radius, double cosine) const;
  // Optical depth along a ray from distance a to b; both in the air, no ground between.
  double depthBetween(const AirRay& ray, double a, double b) const;
  // Towards the Sun; infinite where the ground is in the way.
  double depthToSpace(const glm::dvec3& point, double radius, const glm::dvec3& direction) const;
  // Sunlight is bent by the medium's refractivity from here on, where it has any.
  void bendSunlight();
  // From a point inside the air towards the Sun as bent, with the thinning of bent light; infinite
  // where the ground is in the way. Above the air, and without refraction, as depthToSpace.
  double depthToSun(const glm::dvec3& point, double radius, const glm::dvec3& toSun) const;
  // Where that light comes from at the point.
  glm::dvec3 apparentSun(const glm::dvec3& point, double radius, const glm::dvec3& toSun) const;
  // Direct quadrature of the same integral as depthBetween, by Gauss-Legendre on pieces between
  // heights where densities change character; relative error about 1e-7.
  double depthByQuadrature(const AirRay& ray, double a, double b) const;
  // Heights between which the extinction is smooth and changes by moderate factors.
  const std::vector<double>& breakHeights() const { return breaks_; }
  // The piece of a ray from `start` inside the air: [enter, leave], and whether it ends on the
  // ground. False if it misses the air.
  struct Span {
    double enter, leave;
    bool hitsGround;
  };
  bool spanOf(const AirRay& ray, Span& span) const;

 private:
  double exactExtinction(double height) const;
  template <class Extinction>
  double quadrature(const AirRay& ray, double a, double b, const Extinction& extinctionAt) const;
  double tabulated(const std::vector<double>& table, double height) const;

  const Medium* medium_;
  double wavelength_;
  std::shared_ptr<const BentSunlight> bent_;
  double ground_, top_, albedo_;
  std::vector<double> scattering_, total_;  // of each constituent at density 1
  std::vector<SpectralPhase> phases_;
  std::vector<double> breaks_;
  std::vector<double> extinctionTable_;
  std::vector<std::vector<double>> scatteringTables_;
  std::vector<double> meanExtinction_;  // of the upward rays: [height][cosine]
};

}  // namespace antumbra
