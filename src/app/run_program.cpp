#include "app/run_program.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "document/input_error.h"
#include "gl/device_error.h"

namespace antumbra {
namespace {

void requireKnownCommand(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string known;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    if (command->check_name(argv[1])) return;
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw InputError(fmt::format("found the command \"{}\"; allowed: {}", argv[1], known));
}

}  // namespace

int runProgram(CLI::App& program, int argc, char** argv) {
  auto const say = [&](const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", program.get_name(), error.what());
  };
  try {
    requireKnownCommand(program, argc, argv);
    program.parse(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw std::runtime_error("standard output cannot be written");
    return 0;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const InputError& error) {
    say(error);
    return 2;
  } catch (const DeviceError& error) {
    say(error);
    return 3;
  } catch (const std::exception& error) {
    say(error);
    return 1;
  }
}

}  // namespace antumbra
