// `antumbra eclipse at`: an eclipse seen from one place.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/eclipse_at_lunar.h"
#include "app/eclipse_options.h"
#include "document/text_output.h"
#include "eclipse/local_circumstances.h"

namespace antumbra {
namespace {

struct Options : DatedEclipseOptions {
  std::string site;
};

using Json = nlohmann::ordered_json;

Json siteJson(const Site& site) {
  return {{"lat_deg", rounded(site.latitude / degree, 6)},
          {"lon_deg_east", rounded(site.longitude / degree, 6)},
          {"height_m", rounded(site.height / metre, 3)}};
}

Json solarReport(const SolarEvent& event, const EclipseBasis& basis,
                 const LocalCircumstances& local) {
  Duration const deltaT = event.eclipse.deltaT;
  std::vector<std::pair<std::string, const std::optional<LocalContact>*>> const contacts{
      {"C1", &local.c1},
      {"C2", &local.c2},
      {"max", &local.maximum},
      {"C3", &local.c3},
      {"C4", &local.c4}};
  Json j;
  j["ecl_id"] = event.eclipse.id;
  j["type"] = local.type;
  j["kind"] = "solar";
  j["convention"] = basis.convention.name;
  j["delta_t_s"] = rounded(deltaT / second, 3);
  Json times, details, below = Json::array();
  for (auto const& [name, contact] : contacts) {
    times[name] = *contact ? Json(ut1Text((*contact)->instant, deltaT)) : Json(nullptr);
    if (!*contact) {
      details[name] = nullptr;
      continue;
    }
    LocalContact const& c = **contact;
    details[name] = {{"sun_alt_deg", rounded(c.sun.altitude / degree, 3)},
                     {"sun_az_deg", rounded(c.sun.azimuth / degree, 3)},
                     {"position_angle_deg", rounded(c.positionAngle * 180.0 / M_PI, 2)},
                     {"zenith_angle_deg", rounded(c.zenithAngle * 180.0 / M_PI, 2)},
                     {"above_horizon", c.aboveHorizon}};
    if (!c.aboveHorizon) below.push_back(name);
  }
  j["contacts_ut1"] = times;
  bool const any = local.maximum.has_value();
  j["magnitude"] = any ? Json(rounded(local.magnitude, 6)) : Json(nullptr);
  j["obscuration"] = any ? Json(rounded(local.obscuration, 6)) : Json(nullptr);
  j["duration_s"] = local.c2 ? Json(rounded(local.duration / second, 3)) : Json(nullptr);
  j["visibility"] = local.visibility;
  j["below_horizon"] = below;
  Json horizon = Json::array();
  for (auto const& e : local.horizonEvents)
    horizon.push_back({{"event", e.name},
                       {"time_ut1", ut1Text(e.instant, deltaT)},
                       {"magnitude", rounded(e.magnitude, 6)}});
  j["sunrise_sunset"] = horizon;
  j["details"] = details;
  j["global_type"] = event.eclipse.type;
  j["saros"] = event.eclipse.saros;
  j["constants"] = {{"sun_radius_km", rounded(basis.convention.sunRadius / kilometre, 1)},
                    {"k_umbra", basis.convention.lunarKUmbra},
                    {"k_penumbra", basis.convention.lunarKPenumbra},
                    {"lunar_limb", "smooth sphere; the real limb shifts contacts by up to 3 s"}};
  return j;
}

std::string solarTable(const Json& j, const std::string& basis) {
  std::string out =
      fmt::format("Solar eclipse of {} at {}, {} ({} m): {}\n{}\n", j["ecl_id"].get<std::string>(),
                  j["site"]["lat_deg"].dump(), j["site"]["lon_deg_east"].dump(),
                  j["site"]["height_m"].dump(), j["type"].get<std::string>(), basis);
  out +=
      fmt::format("delta T {} s; {}\n", j["delta_t_s"].dump(), j["visibility"].get<std::string>());
  if (j["magnitude"].is_null()) return out;
  out += "       UT1                       Sun alt   Sun az  pos.angle  zen.angle\n";
  for (auto const& [name, value] : j["contacts_ut1"].items()) {
    if (value.is_null()) continue;
    auto const& d = j["details"][name];
    out += fmt::format("{:<5}  {:<24}  {:7.3f}  {:7.3f}  {:9.2f}  {:9.2f}{}\n", name,
                       value.get<std::string>(), d["sun_alt_deg"].get<double>(),
                       d["sun_az_deg"].get<double>(), d["position_angle_deg"].get<double>(),
                       d["zenith_angle_deg"].get<double>(),
                       d["above_horizon"].get<bool>() ? "" : "  below the horizon");
  }
  for (auto const& e : j["sunrise_sunset"])
    out += fmt::format("{} {} with magnitude {:.3f}\n", e["event"].get<std::string>(),
                       e["time_ut1"].get<std::string>(), e["magnitude"].get<double>());
  out += fmt::format("magnitude {:.5f}, obscuration {:.5f}", j["magnitude"].get<double>(),
                     j["obscuration"].get<double>());
  if (!j["duration_s"].is_null())
    out += fmt::format(", duration {:.2f} s", j["duration_s"].get<double>());
  return out + "\n";
}

void at(const Options& options) {
  EclipseBasis const basis = options.shared.basis();
  Site const site = parseSite(options.site, "--site");
  auto const event = eclipseOn(basis, options.date, "DATE");
  auto const* solar = std::get_if<SolarEvent>(&event);
  Json j = solar ? solarReport(*solar, basis, localCircumstances(*solar, basis.radii(), site))
                 : lunarReport(std::get<LunarEvent>(event), basis, site);
  j["site"] = siteJson(site);
  writeTextFile(options.output, options.format == "json" ? j.dump(2) + "\n"
                                : solar                  ? solarTable(j, describe(basis))
                                                         : lunarTable(j, describe(basis)));
}

}  // namespace

void addEclipseAt(CLI::App& eclipse) {
  auto* const command =
      eclipse.add_subcommand("at", "a solar or lunar eclipse seen from one place");
  auto options = std::make_shared<Options>();
  command->add_option("--site", options->site, "LAT,LON,HEIGHT: degrees, degrees east, metres")
      ->required();
  options->addTo(*command, {"table", "json"});
  command->footer(
      "Examples:\n  antumbra eclipse at 2027-08-02 --site=25.687,32.640,76 --format json\n"
      "  antumbra eclipse at 2028-12-31 --site=47.4,8.5,400    (lunar)");
  command->callback([options] { at(*options); });
}

}  // namespace antumbra
