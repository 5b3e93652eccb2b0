#include "scene/overlay_settings.h"

#include <fmt/format.h>

namespace antumbra {
namespace {

constexpr std::size_t kMostCones = 4;

double positive(const Table& table, const char* key, double low, double high) {
  double const value = table.number(key);
  if (!(value >= low && value <= high))
    table.fail(key, fmt::format("found {}; allowed: {} to {} pixels", value, low, high));
  return value;
}

}  // namespace

OverlaySettings readOverlays(const Table& table) {
  OverlaySettings o;
  o.eclipse = table.text("eclipse", "");
  o.eclipseWhere = table.where("eclipse");
  o.centralLine = table.boolean("central_line", false);
  o.limits = table.boolean("limits", false);
  o.penumbraLimits = table.boolean("penumbra_limits", false);
  o.isolines = table.boolean("isolines", false);
  o.horizonCurves = table.boolean("horizon_curves", false);
  o.footprint = table.boolean("footprint", false);
  if (table.has("time_marks")) {
    o.timeMarks = table.duration("time_marks");
    if (*o.timeMarks < 1.0 * minute)
      table.fail("time_marks", fmt::format("found {} s; allowed: 1 min or more", o.timeMarks->si));
  }
  o.obscurationLabels = table.boolean("obscuration_labels", false);
  if (table.has("cones")) o.cones = table.texts("cones");
  o.conesWhere = table.where("cones");
  if (o.cones.size() > kMostCones)
    table.fail("cones",
               fmt::format("found {} bodies; allowed: at most {}", o.cones.size(), kMostCones));
  if (table.has("cone_length")) {
    o.coneLength = table.length("cone_length");
    if (!(o.coneLength->si > 0.0)) table.fail("cone_length", "allowed: above 0 m");
  }
  o.clock = table.boolean("clock", false);
  if (table.has("clock_site"))
    o.clockSite = parseSite(table.text("clock_site"), table.where("clock_site"));
  o.legend = table.boolean("legend", false);
  if (table.has("line_width")) o.lineWidth = positive(table, "line_width", 0.5, 20.0);
  if (table.has("text_size")) o.textSize = positive(table, "text_size", 6.0, 200.0);
  return o;
}

}  // namespace antumbra
