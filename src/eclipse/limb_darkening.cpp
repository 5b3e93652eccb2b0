// Coefficients and normalisation of the laws of solar limb darkening.
#include "eclipse/limb_darkening.h"

#include <fmt/format.h>

#include <cmath>

#include "document/input_error.h"

namespace antumbra {
namespace {

constexpr Length kMicrometre{1e-6};

LimbProfile hestroffer(double micrometres) {
  if (!(micrometres >= 0.3 && micrometres <= 1.1)) {
    throw InputError(fmt::format(
        "limb darkening 'hestroffer': wavelength {} um is outside 0.3-1.1 um", micrometres));
  }
  LimbProfile profile;
  // Hestroffer & Magnan 1998, equation 4 (as used by the reference data).
  profile.exponent = -0.023 + 0.292 / micrometres;
  return profile;
}

LimbProfile neckel(double micrometres) {
  double inverse = 1.0 / micrometres;
  double fifth = std::pow(inverse, 5.0);
  LimbProfile profile;
  // Neckel 2005, Table I; the coefficients of each range sum to 1 at every wavelength.
  if (micrometres >= 0.42257 && micrometres <= 1.1) {
    profile.polynomial = {
        0.75267 - 0.265577 * inverse, 0.93874 + 0.265577 * inverse - 0.004095 * fifth,
        -1.89287 + 0.012582 * fifth,  2.42234 - 0.017117 * fifth,
        -1.71150 + 0.011977 * fifth,  0.49062 - 0.003347 * fifth};
  } else if (micrometres >= 0.385 && micrometres < 0.42257) {
    profile.polynomial = {
        0.09900 + 0.010643 * inverse, 1.96884 - 0.010643 * inverse - 0.009166 * fifth,
        -2.80511 + 0.024873 * fifth,  3.32780 - 0.029317 * fifth,
        -2.17878 + 0.018273 * fifth,  0.58825 - 0.004663 * fifth};
  } else if (micrometres >= 0.3 && micrometres <= 0.37298) {
    profile.polynomial = {
        0.35601 - 0.085217 * inverse, 1.11529 + 0.085217 * inverse - 0.001871 * fifth,
        -0.67237 + 0.003589 * fifth,  0.18696 - 0.002415 * fifth,
        0.00038 + 0.000897 * fifth,   0.01373 - 0.000200 * fifth};
  } else {
    throw InputError(
        fmt::format("limb darkening 'neckel': wavelength {} um is outside 0.3-0.37298 um and "
                    "0.385-1.1 um",
                    micrometres));
  }
  return profile;
}

}  // namespace

LimbDarkeningLaw parseLimbDarkeningLaw(std::string_view name, const std::string& where) {
  if (name == "hestroffer") return LimbDarkeningLaw::Hestroffer;
  if (name == "neckel") return LimbDarkeningLaw::Neckel;
  if (name == "none") return LimbDarkeningLaw::None;
  throw InputError(
      fmt::format("{}: found the unknown limb darkening \"{}\"; allowed: hestroffer, neckel, none",
                  where, name));
}

LimbProfile limbProfile(LimbDarkeningLaw law, Length wavelength) {
  double micrometres = wavelength / kMicrometre;
  switch (law) {
    case LimbDarkeningLaw::Hestroffer:
      return hestroffer(micrometres);
    case LimbDarkeningLaw::Neckel:
      return neckel(micrometres);
    case LimbDarkeningLaw::None:
      break;
  }
  return {};
}

glsl::LimbDarkening limbDarkening(LimbDarkeningLaw law, const std::array<Length, 4>& wavelengths) {
  glsl::LimbDarkening shared;
  std::array<glm::dvec4*, 6> brightness{&shared.brightness0, &shared.brightness1,
                                        &shared.brightness2, &shared.brightness3,
                                        &shared.brightness4, &shared.brightness5};
  std::array<glm::dvec4*, 6> ring{&shared.ring0, &shared.ring1, &shared.ring2,
                                  &shared.ring3, &shared.ring4, &shared.ring5};
  for (int channel = 0; channel < 4; ++channel) {
    LimbProfile profile = limbProfile(law, wavelengths[static_cast<std::size_t>(channel)]);
    shared.exponent[channel] = profile.exponent;
    // Mean over the disc: the integral of I(mu) 2 mu over mu.
    double mean = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
      mean += 2.0 * profile.polynomial[k] / (static_cast<double>(k) + 2.0 + profile.exponent);
    }
    for (std::size_t k = 0; k < 6; ++k) {
      double share = profile.polynomial[k] / mean;
      (*brightness[k])[channel] = share;
      (*ring[k])[channel] = 2.0 * share / (static_cast<double>(k) + 2.0 + profile.exponent);
    }
  }
  return shared;
}

std::array<float, 52> packedForShader(const glsl::LimbDarkening& law) {
  std::array<float, 52> packed{};
  std::array<const glm::dvec4*, 13> rows{
      &law.exponent,    &law.brightness0, &law.brightness1, &law.brightness2, &law.brightness3,
      &law.brightness4, &law.brightness5, &law.ring0,       &law.ring1,       &law.ring2,
      &law.ring3,       &law.ring4,       &law.ring5};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (int channel = 0; channel < 4; ++channel) {
      packed[4 * row + static_cast<std::size_t>(channel)] =
          static_cast<float>((*rows[row])[channel]);
    }
  }
  return packed;
}

}  // namespace antumbra
