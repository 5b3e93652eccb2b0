#include "app/run_program.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "document/input_error.h"
#include "gl/device_error.h"

namespace antumbra {
namespace {

// Refuses a command, or a command of a command, that does not exist.
void requireKnownCommand(const CLI::App& program, int argc, char** argv, int at = 1) {
  auto const commands = program.get_subcommands(nullptr);
  if (argc <= at || argv[at][0] == '-' || commands.empty()) return;
  std::string known;
  for (const CLI::App* command : commands) {
    if (command->check_name(argv[at])) return requireKnownCommand(*command, argc, argv, at + 1);
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw InputError(fmt::format("found the command \"{}\"; allowed: {}", argv[at], known));
}

// The command whose options were being read.
const CLI::App& innermost(const CLI::App& program) {
  auto const parsed = program.get_subcommands();
  return parsed.empty() ? program : innermost(*parsed.front());
}

// What the option parser's own messages leave out: what is allowed.
std::string explained(const CLI::App& program, const CLI::ParseError& error) {
  std::string const message = error.what();
  auto const options = innermost(program).get_options();
  if (dynamic_cast<const CLI::ConversionError*>(&error)) {
    for (const CLI::Option* option : options) {
      auto const start = message.find(option->get_name() + " = ");
      if (option->get_name().empty() || start == std::string::npos) continue;
      std::string const type = option->get_type_name();
      return fmt::format("{}: found \"{}\"; allowed: {}", option->get_name(),
                         message.substr(start + option->get_name().size() + 3),
                         type == "INT"    ? "a whole number"
                         : type == "UINT" ? "a whole number, not negative"
                                          : "a number");
    }
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
    for (const CLI::Option* option : options) {
      if (!message.starts_with(option->get_name() + ": ")) continue;
      return option->count() == 0 || option->results().size() <= 1
                 ? fmt::format("{}: found no value; allowed: one", option->get_name())
                 : fmt::format("{}: found {} times; allowed: once", option->get_name(),
                               option->results().size());
    }
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) {
    std::string known;
    for (const CLI::Option* option : options)
      known += (known.empty() ? "" : ", ") + option->get_name();
    return fmt::format("{}; allowed: {}", message, known);
  }
  return message;
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
    if (error.get_exit_code() == 0) return program.exit(error);
    fmt::print(stderr, "{}: {}\nRun with --help for more information.\n", program.get_name(),
               explained(program, error));
    return 2;
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
