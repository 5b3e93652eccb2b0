// What `antumbra eclipse at` says about a lunar eclipse: contacts, and where the Moon stands then.
#include "app/eclipse_at_lunar.h"

#include <fmt/format.h>

#include <cmath>

namespace antumbra {
namespace {

using Json = nlohmann::ordered_json;

// From the first to the second, null where they do not occur.
Json secondsBetween(const std::optional<Instant>& from, const std::optional<Instant>& to) {
  return from && to ? Json(rounded((*to - *from) / second, 1)) : Json(nullptr);
}

}  // namespace

double rounded(double value, int decimals) {
  double const scale = std::pow(10.0, decimals);
  double const r = std::round(value * scale) / scale;
  return r == 0.0 ? 0.0 : r;
}

Json lunarReport(const LunarEvent& event, const EclipseBasis& basis, const Site& site) {
  LunarEclipse const& e = event.eclipse;
  auto const local = lunarLocalCircumstances(event, basis, site);
  Json j;
  j["ecl_id"] = e.id;
  j["type"] = e.type;
  j["kind"] = "lunar";
  j["convention"] = basis.convention.name;
  j["delta_t_s"] = rounded(e.deltaT / second, 3);
  Json times, details, below = Json::array();
  for (std::size_t i = 0; i < local.contacts.size(); ++i) {
    std::string const name = LunarLocalCircumstances::kNames[i];
    auto const& contact = local.contacts[i];
    times[name] = contact ? Json(ut1Text(contact->instant, e.deltaT)) : Json(nullptr);
    details[name] = contact ? Json{{"moon_alt_deg", rounded(contact->moon.altitude / degree, 3)},
                                   {"moon_az_deg", rounded(contact->moon.azimuth / degree, 3)},
                                   {"above_horizon", contact->aboveHorizon}}
                            : Json(nullptr);
    if (contact && !contact->aboveHorizon) below.push_back(name);
  }
  j["contacts_ut1"] = times;
  j["umbral_magnitude"] = rounded(e.umbralMagnitude, 5);
  j["penumbral_magnitude"] = rounded(e.penumbralMagnitude, 5);
  j["penumbral_duration_s"] = secondsBetween(e.p1, e.p4);
  j["partial_duration_s"] = secondsBetween(e.u1, e.u4);
  j["total_duration_s"] = secondsBetween(e.u2, e.u3);
  j["visibility"] = local.visibility;
  j["below_horizon"] = below;
  Json horizon = Json::array();
  for (auto const& h : local.horizonEvents)
    horizon.push_back({{"event", h.name},
                       {"time_ut1", ut1Text(h.instant, e.deltaT)},
                       {"umbral_magnitude", rounded(h.umbralMagnitude, 5)}});
  j["moonrise_moonset"] = horizon;
  j["details"] = details;
  j["saros"] = e.saros;
  j["constants"] = {{"sun_radius_km", rounded(basis.convention.sunRadius / kilometre, 1)},
                    {"k_penumbra", basis.convention.lunarKPenumbra},
                    {"shadow_enlargement", nameOf(basis.enlargement)}};
  return j;
}

std::string lunarTable(const Json& j, const std::string& basis) {
  std::string const type = j["type"].get<std::string>();
  std::string out = fmt::format(
      "Lunar eclipse of {} at {}, {} ({} m): {}\n{}\ndelta T {} s; {}\n"
      "       UT1                      Moon alt  Moon az\n",
      j["ecl_id"].get<std::string>(), j["site"]["lat_deg"].dump(), j["site"]["lon_deg_east"].dump(),
      j["site"]["height_m"].dump(), type == "T" ? "total" : (type == "P" ? "partial" : "penumbral"),
      basis, j["delta_t_s"].dump(), j["visibility"].get<std::string>());
  for (auto const& [name, value] : j["contacts_ut1"].items()) {
    if (value.is_null()) continue;
    auto const& d = j["details"][name];
    out += fmt::format("{:<5}  {:<24}  {:7.3f}  {:7.3f}{}\n", name, value.get<std::string>(),
                       d["moon_alt_deg"].get<double>(), d["moon_az_deg"].get<double>(),
                       d["above_horizon"].get<bool>() ? "" : "  below the horizon");
  }
  for (auto const& e : j["moonrise_moonset"])
    out += fmt::format("{} {} with umbral magnitude {:.3f}\n", e["event"].get<std::string>(),
                       e["time_ut1"].get<std::string>(), e["umbral_magnitude"].get<double>());
  return out + fmt::format("umbral magnitude {:.4f}, penumbral {:.4f}\n",
                           j["umbral_magnitude"].get<double>(),
                           j["penumbral_magnitude"].get<double>());
}

}  // namespace antumbra
