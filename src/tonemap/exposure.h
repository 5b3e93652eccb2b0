// How bright a picture is shown: the luminance that a display's white stands for.
//
// Automatic exposure reads a meter of cells (tone_map.h). It leaves out the brightest 2 % of the
// picture's solid angle (a Sun of 1e9 cd/m2, highlights) and everything more than ten stops below
// what is left (black space, the mask of a dome has no weight at all), and puts the mean of log
// luminance of the rest at a grey that falls with the scene's own level, as the eye's impression of
// night does: the key of Krawczyk, Myszkowski & Seidel 2005 (SCCG, "Perceptual effects in real-time
// tone mapping", eq. 11), 1.03 - 2 / (2 + log10(L + 1)), times kDisplayKeyScale; the 98th
// percentile stays within two stops above white. Pure functions of the meter: an off-line picture
// does not depend on those before it.
#pragma once

#include <optional>
#include <span>

#include "quantity/quantity.h"

namespace antumbra {

// Display white in cd/m2; what is below the tone curve's knee is shown in proportion to it.
struct Exposure {
  double whiteLuminance = 1.0e4;
  // An eye: luminance that its rods can just see, cd/m2. A camera has none.
  std::optional<double> rodThreshold = std::nullopt;
};

// `ev100`: exposure value at ISO 100. A reflected-light meter (ISO 2720, K = 12.5) puts the
// luminance 0.125 * 2^EV at middle grey, 18 % of white.
Exposure exposureOfEv(double ev100);
double evOfExposure(Exposure exposure);

struct MeterCell {
  float log2Luminance = 0.0f;  // log2 of cd/m2
  float solidAngle = 0.0f;     // sr; 0 outside the picture
};

struct MeterReading {
  double meanLuminance = 0.0;  // geometric, of what counts, cd/m2
  double highLuminance = 0.0;  // 98th percentile, cd/m2
  double darkShare = 0.0;      // of the solid angle left out as too dark
  bool black = true;           // nothing above the meter's floor
};

// Luminance below which the meter sees black, cd/m2: a tenth of the darkest natural night sky.
inline constexpr double kMeterFloor = 2.0e-5;

MeterReading readMeter(std::span<const MeterCell> cells);

struct AutomaticExposure {
  double compensationStops = 0.0;  // brighter if positive
  // The most that is ever brought out: white at 0.03 cd/m2 shows a moonless sky (2e-4 cd/m2) just
  // above black, and a star of sixth magnitude at a tenth of white in a field of 60 degrees.
  double darkestWhite = 0.03;
};
Exposure exposureFor(const MeterReading& reading, const AutomaticExposure& settings = {});

// For live use: moves from one exposure towards another as exp(-t / time constant) in stops, faster
// towards the bright (0.4 s) than towards the dark (1.5 s).
Exposure adaptedExposure(Exposure now, Exposure target, Duration passed);

}  // namespace antumbra
