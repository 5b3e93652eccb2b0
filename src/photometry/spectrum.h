// A function of wavelength given by a table, linear between its nodes. Outside its span it has no
// value: asking raises an InputError that carries the span.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "quantity/quantity.h"

namespace antumbra {

class Spectrum {
 public:
  Spectrum() = default;
  // The same value at every wavelength.
  explicit Spectrum(double everywhere) : constant_(everywhere) {}
  // Wavelengths in nm, strictly ascending, with as many values. Throws InputError otherwise;
  // `name` opens the messages.
  Spectrum(std::vector<double> wavelengthsNm, std::vector<double> values, std::string name);
  double at(Length wavelength) const;
  // Span of the table; (0, infinity) for a constant.
  Length first() const;
  Length last() const;
  bool isConstant() const { return wavelengthsNm_.empty(); }
  const std::vector<double>& wavelengthsNm() const { return wavelengthsNm_; }
  const std::vector<double>& values() const { return values_; }
  const std::string& name() const { return name_; }

 private:
  double constant_ = 0.0;
  std::vector<double> wavelengthsNm_;
  std::vector<double> values_;
  std::string name_;
};

// A CSV of catalogs/spectra: lines starting with '#' are comments, then a header, then rows whose
// first column is the wavelength in nm. One spectrum per further column. Errors name file and line.
std::vector<Spectrum> readSpectra(const std::filesystem::path& file);

}  // namespace antumbra
