// The map of a solar eclipse: Lambert's azimuthal equal-area projection about the place of greatest
// eclipse, with land, graticule, the umbra's path and footprints, limits, isolines and time marks.
#pragma once

#include "eclipse/drawing.h"
#include "eclipse/eclipse_curves.h"

namespace antumbra {

// `basis` is what a note below the map says of convention and delta T.
Drawing eclipseMap(const SolarEvent& event, const EclipseCurves& curves, const std::string& basis);

}  // namespace antumbra
