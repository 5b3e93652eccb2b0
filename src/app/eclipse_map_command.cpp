// `antumbra eclipse map`: a solar eclipse on the globe, as SVG or PNG.
#include <fmt/format.h>

#include <filesystem>

#include "app/eclipse_options.h"
#include "document/input_error.h"
#include "document/text_output.h"
#include "eclipse/eclipse_map.h"
#include "output/image_file.h"

namespace antumbra {
namespace {

struct Options {
  std::string date, output;
  EclipseOptions shared;
};

void map(const Options& options) {
  std::filesystem::path const file(options.output);
  std::string const extension = file.extension().string();
  if (extension != ".svg" && extension != ".png")
    throw InputError(
        fmt::format("-o: found \"{}\"; allowed: a file ending in .svg or .png", options.output));
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path()))
    throw InputError(fmt::format("-o: there is no folder \"{}\"", file.parent_path().string()));
  EclipseBasis const basis = options.shared.basis();
  SolarEvent const event = solarEventOn(basis, options.date, "DATE");
  Drawing const drawing = eclipseMap(event, eclipseCurves(event, basis.radii()), describe(basis));
  if (extension == ".svg") {
    writeTextFile(options.output, svgOf(drawing));
  } else {
    writePng(file, drawing.width, drawing.height, rasterised(drawing),
             {{"antumbra:title", drawing.title}, {"antumbra:convention", describe(basis)}});
  }
  fmt::print(stderr, "{}: {}\n", options.output, drawing.title);
}

}  // namespace

void addEclipseMap(CLI::App& eclipse) {
  auto* const command = eclipse.add_subcommand("map", "the eclipse on the globe, as SVG or PNG");
  auto options = std::make_shared<Options>();
  command->add_option("date", options->date, "date of greatest eclipse (TT), YYYY-MM-DD")
      ->required();
  command->add_option("-o,--output", options->output, "map.svg or map.png")->required();
  options->shared.addTo(*command);
  command->footer("Example:\n  antumbra eclipse map 2027-08-02 -o map.svg");
  command->callback([options] { map(*options); });
}

}  // namespace antumbra
