// Colours: CIE XYZ, linear sRGB, chromaticity, colour difference, and the colour of a star.
// Absolute throughout: Y is luminance in cd/m2, and linear sRGB is scaled so that
// Y = 0.2126 R + 0.7152 G + 0.0722 B, each channel in cd/m2.
#pragma once

#include <glm/glm.hpp>

namespace antumbra {

// IEC 61966-2-1: primaries of ITU-R BT.709, white D65 (x 0.3127, y 0.3290).
glm::dvec3 linearSrgbFromXyz(glm::dvec3 xyz);
glm::dvec3 xyzFromLinearSrgb(glm::dvec3 rgb);
// Luminance of a linear sRGB colour, in the unit of its channels.
double luminanceOf(glm::dvec3 linearSrgb);
struct Chromaticity {
  double x, y;
};
// CIE 1931 chromaticity; the equal-energy point where XYZ is zero.
Chromaticity chromaticityOf(glm::dvec3 xyz);

// CIEDE2000 colour difference (CIE 142-2001; Sharma, Wu & Dalal 2005, Color Res. Appl. 30, 21),
// with the given luminance of a D65 white. About 1 is just noticeable side by side.
double deltaE2000(glm::dvec3 xyz, glm::dvec3 otherXyz, double whiteLuminance);

// Linear sRGB of luminance 1 of a star of colour index B-V: temperature by Ballesteros 2012
// (EPL 97, 34008, eq. 14), Planck spectrum, CIE 1931. To be honest: a star is not a black body;
// 4 % in temperature against tabulated main-sequence stars. Span: B-V from -0.4 to 4.
glm::dvec3 starColour(double bMinusV);
// Temperature in kelvin by the same formula.
double starTemperatureKelvin(double bMinusV);
// Linear sRGB of luminance 1 of a black body.
glm::dvec3 blackBodyColour(double kelvin);

}  // namespace antumbra
