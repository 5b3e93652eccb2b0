// `antumbra eclipse path`: the central line and its limits.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/eclipse_options.h"
#include "app/row_table.h"
#include "document/input_error.h"
#include "document/text_output.h"
#include "eclipse/central_path.h"

namespace antumbra {
namespace {

struct Options : DatedEclipseOptions {
  std::string step = "5min", width = "limits";
};

using Json = nlohmann::ordered_json;

RowTable::Row rowOf(const CentralPoint& p, const SunMoonTrack& track, bool canon) {
  auto const latitude = [](const std::optional<Site>& s) {
    return s ? cell(s->latitude / degree, 6) : Cell();
  };
  auto const longitude = [](const std::optional<Site>& s) {
    return s ? cell(s->longitude / degree, 6) : Cell();
  };
  Length const width = canon ? p.canonWidth : p.width;
  return {{"jd_tt", cell(track.instantAt(p.seconds).tt().value(), 8)},
          {"lat_deg", cell(p.place.latitude / degree, 6)},
          {"lon_deg_east", cell(p.place.longitude / degree, 6)},
          {"sun_alt_deg", cell(p.sun.altitude / degree, 3)},
          {"sun_az_deg", cell(p.sun.azimuth / degree, 3)},
          {"magnitude", cell(p.magnitude, 6)},
          {"phase", p.phase == CentralPhase::Total ? "T" : "A"},
          {"duration_s", cell(p.duration / second, 2)},
          {"width_km", width.si > 0.0 ? cell(width / kilometre, 3) : Cell()},
          {"left_limit_lat_deg", latitude(p.left)},
          {"left_limit_lon_deg_east", longitude(p.left)},
          {"right_limit_lat_deg", latitude(p.right)},
          {"right_limit_lon_deg_east", longitude(p.right)}};
}

// A line of sites, cut where it crosses the antimeridian.
std::vector<std::vector<Site>> piecesOf(const std::vector<Site>& sites) {
  std::vector<std::vector<Site>> pieces;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    bool const cut = i == 0 || abs(sites[i].longitude - sites[i - 1].longitude) > 180.0 * degree;
    if (cut) pieces.emplace_back();
    pieces.back().push_back(sites[i]);
  }
  return pieces;
}

struct Line {
  std::string name;
  std::vector<Site> sites;
};

std::vector<Line> linesOf(const std::vector<CentralPoint>& points) {
  Line centre{"central line", {}}, left{"left limit", {}}, right{"right limit", {}};
  for (auto const& p : points) {
    centre.sites.push_back(p.place);
    if (p.left) left.sites.push_back(*p.left);
    if (p.right) right.sites.push_back(*p.right);
  }
  return {centre, left, right};
}

std::string geoJson(const SolarEvent& event, const EclipseBasis& basis,
                    const std::vector<CentralPoint>& points, bool canon) {
  Json features = Json::array();
  for (auto const& line : linesOf(points)) {
    Json coordinates = Json::array();
    for (auto const& piece : piecesOf(line.sites)) {
      Json part = Json::array();
      for (auto const& s : piece) part.push_back({s.longitude / degree, s.latitude / degree});
      if (piece.size() > 1) coordinates.push_back(part);
    }
    features.push_back({{"type", "Feature"},
                        {"properties", {{"name", line.name}}},
                        {"geometry", {{"type", "MultiLineString"}, {"coordinates", coordinates}}}});
  }
  for (auto const& p : points) {
    Json properties{{"name", formatIso(event.track.instantAt(p.seconds), TimeScale::Tt, 0)}};
    for (auto const& [name, value] : rowOf(p, event.track, canon)) {
      auto const* number = std::get_if<Decimal>(&value);
      if (name.find("lat") == std::string::npos && name.find("lon") == std::string::npos)
        properties[name] = number ? Json(number->value) : Json(textOf(value));
    }
    features.push_back(
        {{"type", "Feature"},
         {"properties", properties},
         {"geometry",
          {{"type", "Point"},
           {"coordinates", {p.place.longitude / degree, p.place.latitude / degree}}}}});
  }
  Json const all{{"type", "FeatureCollection"},
                 {"name", "solar eclipse of " + event.eclipse.id},
                 {"properties",
                  {{"ecl_id", event.eclipse.id},
                   {"type", event.eclipse.type},
                   {"delta_t_s", event.eclipse.deltaT / second},
                   {"basis", describe(basis)}}},
                 {"features", features}};
  return all.dump(1) + "\n";
}

std::string kml(const SolarEvent& event, const EclipseBasis& basis,
                const std::vector<CentralPoint>& points) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n";
  out += fmt::format(
      "<name>Solar eclipse of {} ({})</name>\n<description>{}; delta T {:.3f} s"
      "</description>\n",
      event.eclipse.id, event.eclipse.type, describe(basis), event.eclipse.deltaT / second);
  out +=
      "<Style id=\"line\"><LineStyle><color>ff0040ff</color><width>2</width></LineStyle></Style>\n";
  for (auto const& line : linesOf(points)) {
    out += fmt::format("<Placemark><name>{}</name><styleUrl>#line</styleUrl><MultiGeometry>\n",
                       line.name);
    for (auto const& piece : piecesOf(line.sites)) {
      out += "<LineString><tessellate>1</tessellate><coordinates>";
      for (auto const& s : piece)
        out += fmt::format("{:.6f},{:.6f} ", s.longitude / degree, s.latitude / degree);
      out += "</coordinates></LineString>\n";
    }
    out += "</MultiGeometry></Placemark>\n";
  }
  for (auto const& p : points)
    out += fmt::format(
        "<Placemark><name>{}</name><description>Sun altitude {:.1f} deg, {} {:.1f} s"
        "</description><Point><coordinates>{:.6f},{:.6f}</coordinates></Point></Placemark>\n",
        formatIso(event.track.instantAt(p.seconds), TimeScale::Ut1,
                  DeltaT::fixed(event.eclipse.deltaT), 0),
        p.sun.altitude / degree, p.phase == CentralPhase::Total ? "totality" : "annularity",
        p.duration / second, p.place.longitude / degree, p.place.latitude / degree);
  return out + "</Document>\n</kml>\n";
}

void path(const Options& options) {
  EclipseBasis const basis = options.shared.basis();
  Duration const step = parseStep(options.step, "--step");
  SolarEvent const event = solarEventOn(basis, options.date, "DATE");
  if (!event.eclipse.c1)
    throw InputError(fmt::format("DATE: the eclipse of {} is {}: it has no central line",
                                 options.date,
                                 event.eclipse.type == "P" ? "partial everywhere" : "not central"));
  auto const points = centralLine(event.track, basis.radii(), event.eclipse, step);
  bool const canon = options.width == "canon";
  if (options.format == "geojson") {
    writeTextFile(options.output, geoJson(event, basis, points, canon));
  } else if (options.format == "kml") {
    writeTextFile(options.output, kml(event, basis, points));
  } else {
    RowTable table;
    for (auto const& p : points) table.add(rowOf(p, event.track, canon));
    fmt::print(stderr, "{}; delta T {:.3f} s here\n", describe(basis),
               event.eclipse.deltaT / second);
    writeTextFile(options.output, table.text(options.format, {"jd_tt"}));
  }
}

}  // namespace

void addEclipsePath(CLI::App& eclipse) {
  auto* const command = eclipse.add_subcommand("path", "the central line and its limits");
  auto options = std::make_shared<Options>();
  command->add_option("--step", options->step, "between instants at whole steps of TT")
      ->capture_default_str();
  command
      ->add_option("--width", options->width,
                   "limits: between the limits along the ground; canon: the canons' formula")
      ->check(CLI::IsMember({"limits", "canon"}))
      ->capture_default_str();
  options->addTo(*command, {"csv", "json", "table", "geojson", "kml"});
  command->footer(
      "Example:\n  antumbra eclipse path 2027-08-02 --step 5min --format kml -o path.kml");
  command->callback([options] { path(*options); });
}

}  // namespace antumbra
