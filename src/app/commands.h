// The commands of the program. Each function adds one subcommand to the command line; its callback
// runs when the user chose it. Callbacks throw InputError (status 2), DeviceError (3) or anything
// else (1); main() prints the message.
#pragma once

#include <CLI/CLI.hpp>

namespace antumbra {

void addRenderCommand(CLI::App& program);
void addSkyCommand(CLI::App& program);
void addViewCommand(CLI::App& program);
void addEclipseCommand(CLI::App& program);
void addEphemerisCommand(CLI::App& program);
// `trade` has one subcommand per subject, each in a file of its own.
void addTradeCommand(CLI::App& program);
void addTradeEphemeris(CLI::App& trade);
void addTradeTotality(CLI::App& trade);
void addTradeShadows(CLI::App& trade);
void addTradeSky(CLI::App& trade);

}  // namespace antumbra
