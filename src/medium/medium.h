// The air of a body: a sphere of ground below a shell that holds constituents (molecules, dust,
// ozone, haze ...), each with a density over height, spectral coefficients and a phase function. No
// geometry and no light here: what scatters, how much, and whither.
//
// A medium is read from catalogs/atmospheres/*.toml (format: catalogs/atmospheres/README.md). Every
// fault of a file is an InputError with file, line, what was found and what is allowed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "medium/density.h"
#include "medium/phase_function.h"
#include "photometry/spectrum.h"
#include "quantity/quantity.h"

namespace antumbra {

using InverseLength = Quantity<-1, 0, 0>;

struct Constituent {
  std::string name;
  DensityProfile density;  // relative to where the coefficients hold; dimensionless
  Spectrum scattering;     // 1/m at density 1
  Spectrum absorption;     // 1/m at density 1
  PhaseFunction phase;
};

struct ConstituentCoefficients {
  InverseLength scattering;
  InverseLength absorption;
  InverseLength extinction() const { return scattering + absorption; }
};

struct Medium {
  std::string name;
  Length radius;          // of the ground, a sphere
  Length topHeight;       // of the boundary to empty space above the ground
  Spectrum groundAlbedo;  // Lambertian, 0 to 1
  // Refractivity n - 1 of the air at the ground, with the density of the constituent
  // `refractingConstituent` (its name; empty: the air does not refract).
  Spectrum refractivity;
  std::string refractingConstituent;
  std::vector<Constituent> constituents;
  // Share of the body's limb where no cloud (or land) stands in the way of a ray whose lowest point
  // is at a height: straight lines between the nodes, 1 above the last. Empty: 1 everywhere.
  std::vector<Length> clearHeights;
  std::vector<double> clearShares;

  double clearShareAt(Length height) const;
  Length topRadius() const { return radius + topHeight; }
  // One entry per constituent. Below the ground the density is that at the ground (400 m of it, at
  // the Dead Sea, miss 0.1 % of the Earth's air); above the top it is zero.
  std::vector<ConstituentCoefficients> coefficientsAt(Length height, Length wavelength) const;
  // Of all constituents together.
  InverseLength extinctionAt(Length height, Length wavelength) const;
  // Vertical optical depth of a constituent from the ground to the top; relative error 1e-6.
  double opticalDepth(size_t constituent, Length wavelength) const;
  // The span of wavelengths that every table covers.
  Length firstWavelength() const;
  Length lastWavelength() const;
  // Heights above the ground, ascending, between which every density is smooth.
  std::vector<Length> kinks() const;
};

// The file of a medium of catalogs/atmospheres, by its name there, as "earth".
std::filesystem::path mediumFile(const std::string& name);
Medium readMedium(const std::filesystem::path& file);
// From the text of such a file; `name` opens messages. Cross-section files are looked up in
// catalogs/.
Medium parseMedium(std::string_view content, const std::string& name);

}  // namespace antumbra
