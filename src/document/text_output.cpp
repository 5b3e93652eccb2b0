#include "document/text_output.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "document/input_error.h"
#include "document/whole_file.h"

namespace antumbra {

void writeTextFile(const std::string& file, const std::string& content) {
  if (file.empty() || file == "-") {
    if (std::fwrite(content.data(), 1, content.size(), stdout) != content.size() ||
        std::fflush(stdout) != 0)
      throw std::runtime_error("standard output cannot be written");
    return;
  }
  writeWholeFile(file, "-o", [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out << content;
    out.close();
    if (!out)
      throw InputError(
          fmt::format("-o: found \"{}\", which cannot be written; allowed: a file in an existing "
                      "folder, or - for standard output",
                      file));
  });
}

}  // namespace antumbra
