// The subcommands of antumbra-bench, as app/commands.h those of antumbra.
#pragma once

#include <CLI/CLI.hpp>

namespace antumbra {

void addPictureBench(CLI::App& program);
void addEphemerisBench(CLI::App& program);

}  // namespace antumbra
