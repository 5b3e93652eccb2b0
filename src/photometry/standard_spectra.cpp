#include "photometry/standard_spectra.h"

#include <cmath>

#include "document/paths.h"

namespace antumbra {
namespace {

std::vector<Spectrum> read(const char* name) {
  return readSpectra(catalogsFolder() / "spectra" / name);
}

bool within(const Spectrum& spectrum, Length wavelength) {
  return wavelength >= spectrum.first() && wavelength <= spectrum.last();
}

}  // namespace

const Spectrum& solarSpectrum() {
  static const Spectrum sun = read("solar_e490.csv").at(0);
  return sun;
}

double solarIrradiance(Length wavelength) { return solarSpectrum().at(wavelength); }

glm::dvec3 colourMatching(Length wavelength) {
  static const std::vector<Spectrum> observer = read("cie1931.csv");
  if (!within(observer.at(0), wavelength)) return glm::dvec3(0.0);
  return {observer[0].at(wavelength), observer.at(1).at(wavelength), observer.at(2).at(wavelength)};
}

double photopicEfficiency(Length wavelength) { return colourMatching(wavelength).y; }

double scotopicEfficiency(Length wavelength) {
  static const Spectrum rods = read("scotopic_cie1951.csv").at(0);
  return within(rods, wavelength) ? rods.at(wavelength) : 0.0;
}

double ozoneCrossSection(Length wavelength) {
  static const Spectrum ozone = read("ozone_233k.csv").at(0);
  return ozone.at(wavelength);
}

double rayleighCrossSection(Length wavelength) {
  double const um = wavelength.si * 1e6;
  double const squareMetrePerSquareCentimetre = 1e-4;
  // Coefficients: table 3; the law changes at 0.5 um.
  double const crossSection =
      um < 0.5 ? 3.01577e-28 * std::pow(um, -(3.55212 + 1.35579 * um + 0.11563 / um))
               : 4.01061e-28 * std::pow(um, -(3.99668 + 0.00110298 * um + 0.0271393 / um));
  return crossSection * squareMetrePerSquareCentimetre;
}

}  // namespace antumbra
