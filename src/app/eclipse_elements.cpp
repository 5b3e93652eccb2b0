// `antumbra eclipse elements`: Besselian elements of a solar eclipse as polynomials.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/eclipse_options.h"
#include "document/text_output.h"
#include "eclipse/besselian.h"

namespace antumbra {
namespace {

void elements(const DatedEclipseOptions& options) {
  EclipseBasis const basis = options.shared.basis();
  SolarEvent const event = solarEventOn(basis, options.date, "DATE");
  BesselianPolynomials const p = besselianPolynomials(event, basis.radii());
  static constexpr const char* kNames[6] = {"x", "y", "d_deg", "mu_deg", "l1", "l2"};
  static constexpr const char* kUnits[6] = {"Earth radii", "Earth radii", "deg",
                                            "deg",         "Earth radii", "Earth radii"};
  if (options.format == "json") {
    nlohmann::ordered_json j;
    j["ecl_id"] = event.eclipse.id;
    j["convention"] = basis.convention.name;
    j["constants"] = {{"sun_radius_km", basis.convention.sunRadius / kilometre},
                      {"k_umbra", basis.convention.lunarKUmbra},
                      {"k_penumbra", basis.convention.lunarKPenumbra}};
    j["delta_t_s"] = p.deltaT / second;
    j["t0_jd_tt"] = p.reference.tt().value();
    j["t0_tt"] = formatIso(p.reference, TimeScale::Tt, 0);
    j["hours_from_t0"] = {-3.0, 3.0};
    for (std::size_t i = 0; i < 6; ++i)
      j[kNames[i]] = {{"coefficients", p.coefficients[i]},
                      {"largest_residual", p.largestResidual[i]}};
    j["tan_f1"] = p.tanF1;
    j["tan_f2"] = p.tanF2;
    writeTextFile(options.output, j.dump(2) + "\n");
    return;
  }
  std::string out = fmt::format("Besselian elements of the solar eclipse of {}\n{}\n",
                                event.eclipse.id, describe(basis));
  out += fmt::format(
      "t0 = {} (JD {:.6f}), delta T {:.2f} s; a0 + a1 t + a2 t^2 + a3 t^3, t in hours "
      "of TT, |t| <= 3\n",
      formatIso(p.reference, TimeScale::Tt, 0), p.reference.tt().value(), p.deltaT / second);
  for (std::size_t i = 0; i < 6; ++i) {
    auto const& c = p.coefficients[i];
    out += fmt::format("{:<7}{:>14.8f}{:>14.8f}{:>14.8f}{:>14.8f}   largest residual {:.1e} {}\n",
                       kNames[i], c[0], c[1], c[2], c[3], p.largestResidual[i], kUnits[i]);
  }
  out += fmt::format("tan f1 {:.8f}   tan f2 {:.8f}\n", p.tanF1, p.tanF2);
  writeTextFile(options.output, out);
}

}  // namespace

void addEclipseElements(CLI::App& eclipse) {
  auto* const command = eclipse.add_subcommand("elements", "Besselian elements as polynomials");
  auto options = std::make_shared<DatedEclipseOptions>();
  options->addTo(*command, {"table", "json"});
  command->footer("Example:\n  antumbra eclipse elements 2027-08-02");
  command->callback([options] { elements(*options); });
}

}  // namespace antumbra
