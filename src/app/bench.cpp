// antumbra-bench: what drawing and positions cost. A program of its own, without image formats or
// windows, that runs on a bare machine (tools/bundle). Dispatch only.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "app/bench_commands.h"
#include "document/input_error.h"
#include "gl/device_error.h"

int main(int argc, char** argv) {
  CLI::App program{"antumbra-bench: time per pass in fill units and milliseconds, memory, tables"};
  program.require_subcommand(1);
  antumbra::addFrameBench(program);
  try {
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const antumbra::InputError& error) {
    fmt::print(stderr, "antumbra-bench: {}\n", error.what());
    return 2;
  } catch (const antumbra::DeviceError& error) {
    fmt::print(stderr, "antumbra-bench: {}\n", error.what());
    return 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "antumbra-bench: {}\n", error.what());
    return 1;
  }
}
