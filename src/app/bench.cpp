// antumbra-bench: what drawing and positions cost. A program of its own, without image formats or
// windows, that runs on a bare machine (tools/bundle). Dispatch only.
#include "app/bench_commands.h"
#include "app/run_program.h"

int main(int argc, char** argv) {
  CLI::App program{"antumbra-bench: time per pass in fill units and milliseconds, memory, tables",
                   "antumbra-bench"};
  program.require_subcommand(1);
  antumbra::addPictureBench(program);
  antumbra::addEphemerisBench(program);
  return antumbra::runProgram(program, argc, argv);
}
