#include "gl/shader_source.h"

#include <fmt/format.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra::gl {
namespace {

// Lines are marked as file * kLinesPerFile + line: some compilers lose the second number of
// `#line`.
constexpr std::size_t kLinesPerFile = 100000;
constexpr int kDeepestInclude = 32;

void appendFile(const std::string& path, const std::string& from, int depth, ShaderSource& source) {
  if (depth > kDeepestInclude)
    throw InputError(
        fmt::format("{}: shader files include each other in a circle: {}", from, path));
  std::ifstream stream(shadersFolder() / path);
  if (!stream)
    throw InputError(
        fmt::format("{}: shader file shaders/{} is missing or unreadable", from, path));
  std::size_t const index = source.files.size();
  source.files.push_back(path);
  source.text += fmt::format("#line {}\n", index * kLinesPerFile + 1);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    auto const start = line.find_first_not_of(" \t");
    if (start != std::string::npos && line.compare(start, 8, "#include") == 0) {
      auto const open = line.find('"');
      auto const close = line.find('"', open + 1);
      if (open == std::string::npos || close == std::string::npos)
        throw InputError(fmt::format("shaders/{}:{}: found \"{}\"; allowed: #include \"path\"",
                                     path, number, line));
      appendFile(line.substr(open + 1, close - open - 1),
                 fmt::format("shaders/{}:{}", path, number), depth + 1, source);
      source.text +=
          fmt::format("#line {}\n", index * kLinesPerFile + static_cast<std::size_t>(number) + 1);
    } else {
      source.text += line + '\n';
    }
  }
}

}  // namespace

ShaderSource loadShader(const std::string& path, const Definitions& definitions) {
  ShaderSource source;
  source.text = "#version 450 core\n";
  for (auto const& [name, value] : definitions)
    source.text += fmt::format("#define {} {}\n", name, value);
  appendFile(path, "program", 0, source);
  return source;
}

std::string explainLog(const std::string& log, const ShaderSource& source) {
  static const std::regex place(R"(^(\d+)[:(](\d+)\)?)");
  std::stringstream in(log);
  std::string line, out;
  while (std::getline(in, line)) {
    std::smatch match;
    if (std::regex_search(line, match, place)) {
      auto const mark = static_cast<std::size_t>(std::stoul(match[2]));
      std::size_t const index = mark / kLinesPerFile;
      if (index < source.files.size())
        line = fmt::format("shaders/{}:{}{}", source.files[index], mark % kLinesPerFile,
                           match.suffix().str());
    }
    out += line + '\n';
  }
  return out;
}

}  // namespace antumbra::gl
