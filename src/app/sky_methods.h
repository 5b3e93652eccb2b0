// How `antumbra sky` gets its numbers: each method answers the same request. The reference methods
// run on the processor (atmosphere/), the presets of configs/quality on the graphics device, by the
// programs that draw pictures.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "atmosphere/path_tracer.h"
#include "atmosphere/sunlight.h"
#include "passes/sky_sampler.h"

namespace antumbra {

struct SkyQuestion {
  Medium medium;
  // AirFrame with z through the camera and x towards the Sun's azimuth.
  Position<AirFrame> camera;
  Length groundRadius;  // the medium's, or the camera's where that lies below it
  Sunlight sun;
  std::vector<Direction<AirFrame>> directions;
  std::vector<Length> wavelengths;
  bool irradiance = false;  // of the horizontal plane, instead of radiances
  PathTracerSettings tracing;
};

struct SkyAnswer {
  std::vector<Estimate> radiances;  // L / E0, 1/sr: directions, wavelengths innermost
  std::vector<double> direct;       // E / E0, per wavelength
  std::vector<Estimate> diffuse;
};

using SkyProgress = std::function<void(double)>;
using SkyMethod = std::function<SkyAnswer(const SkyQuestion&, const SkyProgress&)>;
const std::map<std::string, SkyMethod>& skyMethods();

// How many wavelengths make a colour: a preset's own, as in pictures, else eight.
int colourWavelengths(const std::string& method);

// The question to the graphics device.
SkyRequest skyRequestOf(const SkyQuestion& question);

// One of the presets draft, balanced, accurate on the graphics device (sky_device_method.cpp).
SkyAnswer byPreset(const std::string& preset, const SkyQuestion& question);

}  // namespace antumbra
