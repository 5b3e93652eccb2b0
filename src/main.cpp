// Antumbra: the command line. Dispatch only; every command lives in app/.
#include "app/commands.h"
#include "app/run_program.h"

int main(int argc, char** argv) {
  CLI::App program{"Antumbra: eclipses and their light, from space to the ground", "antumbra"};
  program.set_version_flag("--version", std::string("antumbra ") + ANTUMBRA_VERSION);
  program.require_subcommand(1);
  antumbra::addRenderCommand(program);
  antumbra::addSkyCommand(program);
  antumbra::addViewCommand(program);
  antumbra::addEclipseCommand(program);
  antumbra::addEphemerisCommand(program);
  antumbra::addTradeCommand(program);
  return antumbra::runProgram(program, argc, argv);
}
