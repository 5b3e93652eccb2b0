// `antumbra eclipse`: predictions. One geometry with the pictures (shaders/shared/eclipse.glsl).
#include "app/commands.h"
#include "app/eclipse_options.h"

namespace antumbra {

void addEclipseCommand(CLI::App& program) {
  auto* const eclipse = program.add_subcommand("eclipse", "predict eclipses and transits");
  eclipse->require_subcommand(1);
  eclipse->footer(
      "Examples:\n"
      "  antumbra eclipse list --kind solar --from 2020 --to 2030\n"
      "  antumbra eclipse at 2027-08-02 --site=25.687,32.640,76\n"
      "  antumbra eclipse path 2027-08-02 --step 5min --format geojson -o path.geojson\n"
      "  antumbra eclipse map 2027-08-02 -o map.svg\n"
      "  antumbra eclipse elements 2027-08-02");
  addEclipseList(*eclipse);
  addEclipseAt(*eclipse);
  addEclipsePath(*eclipse);
  addEclipseMap(*eclipse);
  addEclipseElements(*eclipse);
}

}  // namespace antumbra
