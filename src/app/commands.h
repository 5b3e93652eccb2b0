// The commands of the program: each adds its subcommand to the command line and, when chosen, runs.
#pragma once

#include <CLI/CLI.hpp>

namespace antumbra {}  // namespace antumbra
