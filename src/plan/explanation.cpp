// The plan as text; how sunlight travels in each of its airs is measured by the rays themselves.
#include "plan/explanation.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

#include "atmosphere/bent_sunlight.h"

namespace antumbra {
namespace {

// How sunlight travels in an air.
std::string waysOfSunlight(const Medium& medium) {
  if (!BentSunlight::bends(medium, medium.radius)) return "straight: no refraction of its own";
  BentSunlight const rays(medium, medium.radius, Length(0.0),
                          {{medium.refractivity.at(550.0 * nanometre),
                            std::vector<double>(medium.constituents.size(), 0.0)}});
  Angle const lift(std::acos(rays.horizonCosine(0, 0.0)) - 0.5 * std::numbers::pi);
  return fmt::format("bent and thinned by refraction, {:.1f}' on the ground's horizon",
                     lift / arcminute);
}

}  // namespace

std::string explain(const RenderPlan& plan) {
  std::string out;
  auto const section = [&](const char* title, const std::vector<Reason>& lines) {
    out += fmt::format("{}\n", title);
    if (lines.empty()) out += "  none\n";
    for (auto const& line : lines) out += fmt::format("  {:<18} {}\n", line.what, line.why);
  };
  section("bodies", plan.drawn);
  section("atmosphere tables", plan.tables);
  std::vector<Reason> sunlight;
  std::set<std::string> media;
  for (auto const& body : plan.bodies)
    if (!body.atmosphere.empty() && media.insert(body.atmosphere).second)
      sunlight.push_back(
          {body.atmosphere, waysOfSunlight(readMedium(mediumFile(body.atmosphere)))});
  section("sunlight in air", sunlight);
  section("shadow pairs", plan.shadows);
  section("passes", plan.passes);
  if (!plan.sky.empty()) section("the same air in numbers", plan.sky);
  section("left out", plan.leftOut);
  return out;
}

}  // namespace antumbra
