// Runs a command line and turns what it throws into a message and an exit status: 0 done, 2 bad
// input, 3 no usable graphics device, 1 anything else.
#pragma once

#include <CLI/CLI.hpp>

namespace antumbra {

int runProgram(CLI::App& program, int argc, char** argv);

}  // namespace antumbra
