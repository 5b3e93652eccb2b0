#include "photometry/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "document/document.h"

namespace antumbra {

Spectrum::Spectrum(std::vector<double> wavelengthsNm, std::vector<double> values, std::string name)
    : wavelengthsNm_(std::move(wavelengthsNm)), values_(std::move(values)), name_(std::move(name)) {
  if (wavelengthsNm_.size() < 2 || wavelengthsNm_.size() != values_.size())
    throw InputError(
        fmt::format("{}: found {} wavelengths and {} values; allowed: two or more, as "
                    "many of each",
                    name_, wavelengthsNm_.size(), values_.size()));
  for (size_t i = 0; i + 1 < wavelengthsNm_.size(); ++i)
    if (!(wavelengthsNm_[i] < wavelengthsNm_[i + 1]))
      throw InputError(fmt::format("{}: found wavelength {} nm after {} nm; allowed: ascending",
                                   name_, wavelengthsNm_[i + 1], wavelengthsNm_[i]));
}

Length Spectrum::first() const {
  return isConstant() ? Length(0.0) : wavelengthsNm_.front() * nanometre;
}
Length Spectrum::last() const {
  return isConstant() ? Length(std::numeric_limits<double>::infinity())
                      : wavelengthsNm_.back() * nanometre;
}

double Spectrum::at(Length wavelength) const {
  if (isConstant()) return constant_;
  // A wavelength that was written in nm may have lost its last bit in metres.
  double const roundingNm = 1e-9;
  double const nm = wavelength / nanometre;
  if (!(nm >= wavelengthsNm_.front() - roundingNm && nm <= wavelengthsNm_.back() + roundingNm))
    throw InputError(fmt::format("{}: found wavelength {:g} nm; allowed: {:g} to {:g} nm", name_,
                                 nm, wavelengthsNm_.front(), wavelengthsNm_.back()));
  auto const after = std::upper_bound(wavelengthsNm_.begin() + 1, wavelengthsNm_.end() - 1, nm);
  auto const i = static_cast<size_t>(after - wavelengthsNm_.begin());
  double const t = (nm - wavelengthsNm_[i - 1]) / (wavelengthsNm_[i] - wavelengthsNm_[i - 1]);
  return values_[i - 1] + t * (values_[i] - values_[i - 1]);
}

std::vector<Spectrum> readSpectra(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw InputError(file.string() + ": cannot be read");
  std::vector<double> wavelengths;
  std::vector<std::vector<double>> columns;
  std::string line;
  size_t count = 0;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    std::string const where = fmt::format("{}:{}", file.string(), number);
    std::vector<std::string> cells;
    std::istringstream cut(line);
    for (std::string cell; std::getline(cut, cell, ',');) cells.push_back(cell);
    if (count == 0) {
      count = cells.size();
      if (count < 2)
        throw InputError(where +
                         ": found one column; allowed: wavelength_nm and one or more others");
      columns.resize(count - 1);
      continue;
    }
    if (cells.size() != count)
      throw InputError(fmt::format("{}: found {} columns; allowed: {} as in the header", where,
                                   cells.size(), count));
    wavelengths.push_back(parseNumber(cells[0], where));
    for (size_t c = 1; c < count; ++c) columns[c - 1].push_back(parseNumber(cells[c], where));
  }
  std::vector<Spectrum> spectra;
  for (auto& column : columns)
    spectra.emplace_back(wavelengths, std::move(column), file.filename().string());
  if (spectra.empty()) throw InputError(file.string() + ": holds no spectrum");
  return spectra;
}

}  // namespace antumbra
