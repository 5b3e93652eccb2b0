#include "document/text_output.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "document/input_error.h"

namespace antumbra {

void writeTextFile(const std::string& file, const std::string& content) {
  if (file.empty() || file == "-") {
    if (std::fwrite(content.data(), 1, content.size(), stdout) != content.size() ||
        std::fflush(stdout) != 0)
      throw std::runtime_error("standard output cannot be written");
    return;
  }
  std::filesystem::path const part = file + ".part";
  std::ofstream out(part, std::ios::binary);
  out << content;
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, file, failed);
  if (!out || failed) {
    std::filesystem::remove(part, failed);
    throw InputError(
        fmt::format("-o: found \"{}\", which cannot be written; allowed: a file in an existing "
                    "folder, or - for standard output",
                    file));
  }
}

}  // namespace antumbra
