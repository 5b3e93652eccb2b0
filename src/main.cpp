// Antumbra: the command line. Dispatch only; every command lives in app/.
#include <fmt/format.h>

#include <exception>

#include "app/commands.h"
#include "document/input_error.h"
#include "gl/device_error.h"

int main(int argc, char** argv) {
  CLI::App program{"Antumbra: eclipses and their light, from space to the ground"};
  program.set_version_flag("--version", std::string("antumbra ") + ANTUMBRA_VERSION);
  program.require_subcommand(1);
  antumbra::addRenderCommand(program);
  antumbra::addViewCommand(program);
  antumbra::addEclipseCommand(program);
  try {
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const antumbra::InputError& error) {
    fmt::print(stderr, "antumbra: {}\n", error.what());
    return 2;
  } catch (const antumbra::DeviceError& error) {
    fmt::print(stderr, "antumbra: {}\n", error.what());
    return 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "antumbra: {}\n", error.what());
    return 1;
  }
}
