// What a scene wants drawn over its picture: the [overlays] section. Overlays are marks of a
// graphic, in display colours above the tone-mapped picture; the light in an EXR knows nothing of
// them.
//
//   [overlays]
//   eclipse = "2027-08-02"      # date of greatest eclipse, TT; default: within a day
//   central_line = true         # where the eclipse is central, all day long
//   limits = true               # of totality or annularity
//   penumbra_limits = true      # where magnitude at maximum is 0
//   isolines = true             # magnitude at maximum 0.2, 0.4, 0.6, 0.8
//   horizon_curves = true       # maximum and contacts at sunrise and sunset
//   footprint = true            # edge of the umbra or antumbra at the instant
//   time_marks = "10 min"       # on the central line, labelled with UT1; at least 1 min
//   obscuration_labels = true   # on the isolines of the illustrative look
//   cones = ["Moon"]            # whose umbra, antumbra and penumbra stand in space; at most 4
//   cone_length = "600000 km"   # from the caster; default: to the body that the shadow meets, else
//                               #   twice the umbra's length
//   clock = true                # contacts, the present and the phase: of the camera's place where
//                               #   that lies below 100 km on Earth, else of the whole eclipse
//   clock_site = "25.687,32.640,76"   # the clock's place instead
//   legend = true               # names of the lines
//   line_width = 1.5            # pixels, of the central line; 0.5 to 20
//   text_size = 14              # pixels, 6 to 200; default: the picture's smaller side over 40
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "geodesy/site.h"
#include "quantity/quantity.h"

namespace antumbra {

struct OverlaySettings {
  std::string eclipse;                              // empty: the one at hand
  std::string eclipseWhere = "[overlays] eclipse";  // opens messages about it
  bool centralLine = false;
  bool limits = false;
  bool penumbraLimits = false;
  bool isolines = false;
  bool horizonCurves = false;
  bool footprint = false;
  std::optional<Duration> timeMarks;
  bool obscurationLabels = false;
  std::vector<std::string> cones;
  std::string conesWhere = "[overlays] cones";
  std::optional<Length> coneLength;
  bool clock = false;
  std::optional<Site> clockSite;
  bool legend = false;
  double lineWidth = 1.5;
  std::optional<double> textSize;

  // Whether something of the curves on the globe is wanted.
  bool lines() const {
    return centralLine || limits || footprint || timeMarks || contours() || obscurationLabels;
  }
  // Of those, what takes a grid over the globe to find.
  bool contours() const { return penumbraLimits || isolines || horizonCurves; }
  bool any() const { return lines() || clock || !cones.empty(); }
};

// Throws InputError with file and line for wrong kinds, units and impossible values.
OverlaySettings readOverlays(const Table& table);

}  // namespace antumbra
