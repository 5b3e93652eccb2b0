// The knobs of the air's tables and marches, with their units; configs/quality/*.toml, section
// [air], gives a value for each. Measured errors and costs of the presets:
// configs/quality/README.md.
#pragma once

#include "document/document.h"

namespace antumbra {

// Of the tables of optical depth, phase functions and source, and of the sky tables; densities and
// the grid about a shadow stay in 32 bits. Half floats hold radiances by their roots or scaled by
// their brightest, so that twilight does not underflow.
enum class AirStorage { Float, Half };

// The defaults are the preset `balanced`.
struct AirQuality {
  AirStorage storage = AirStorage::Float;  // storage = "float" or "half"
  int wavelengths = 4;                     // a multiple of 4
  int orders = 4;      // in the source table, the rest as a geometric series; 0: single scattering
  int degree = 4;      // of the harmonics that hold scattered light,
  int hazeDegree = 6;  // and through haze (AirTables::hazy())
  int depthWidth = 256;        // texels of the optical depth over zenith angle
  int depthHeight = 64;        // and over height
  int sourceWidth = 64;        // texels of the source over the Sun's zenith angle
  int sourceHeight = 16;       // and over height
  int zenithDirections = 12;   // directions over which radiance is averaged
  int azimuthDirections = 6;   // in half a turn
  int sourceSamples = 16;      // samples a leg, when the source is computed
  int skySamples = 16;         // samples a leg, in the sky table
  int viewSamples = 12;        // samples a leg, per pixel: limb, twilight
  int groundSamples = 8;       // per pixel of sunlit ground seen through air
  int airScale = 1;            // pixels a side that share a sample of the air's light: 1, 2 or 4
  int skyWidth = 48;           // texels of the sky table over half a turn of azimuth
  int skyHeight = 128;         // and over zenith angle
  int eclipseDistances = 26;   // cells of the grid about a shadow's axis: distances from it,
  int eclipseAzimuths = 5;     // azimuths in half a turn,
  int eclipseHeights = 8;      // heights
  int eclipseZeniths = 16;     // directions over which radiance is averaged there
  int eclipseTurns = 8;        // in a whole turn
  int eclipseSamples = 5;      // samples a part of a leg
  int eclipseOrders = 4;       // of scattering
  int eclipseSkySamples = 16;  // samples a part of a leg in the sky table
  bool operator==(const AirQuality&) const = default;
  // Throws InputError with file and line for unknown keys and values out of range.
  static AirQuality read(const Table& table);
  // configs/quality/<name>.toml
  static AirQuality preset(const std::string& name);
};

}  // namespace antumbra
