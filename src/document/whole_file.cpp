#include "document/whole_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include "document/input_error.h"

namespace antumbra {
namespace fs = std::filesystem;

namespace {

// The file behind `target`'s links.
fs::path realFile(const fs::path& target, const std::string& where) {
  std::error_code error;
  fs::path const real = fs::weakly_canonical(target, error);
  if (error)
    throw InputError(fmt::format("{}: found \"{}\": {}", where, target.string(), error.message()));
  if (fs::exists(real) && !fs::is_regular_file(real))
    throw InputError(
        fmt::format("{}: found \"{}\", which is a folder or a device; allowed: a "
                    "regular file",
                    where, target.string()));
  return real;
}

}  // namespace

void requireWritable(const fs::path& target, const std::string& where) {
  fs::path const found = realFile(target, where).parent_path();
  fs::path const folder = found.empty() ? fs::path(".") : found;
  if (!fs::is_directory(folder))
    throw InputError(
        fmt::format("{}: folder \"{}\" does not exist; make it first", where, folder.string()));
  if (access(folder.c_str(), W_OK) != 0)
    throw InputError(fmt::format("{}: folder \"{}\" cannot be written to", where, folder.string()));
}

void writeWholeFile(const fs::path& target, const std::string& where,
                    const std::function<void(const fs::path& temporary)>& write) {
  fs::path const real = realFile(target, where);
  fs::path const temporary = real.parent_path() / fmt::format(".{}.{}{}", real.stem().string(),
                                                              getpid(), real.extension().string());
  std::error_code error;
  try {
    write(temporary);
    fs::rename(temporary, real);
  } catch (const fs::filesystem_error& failure) {
    fs::remove(temporary, error);
    throw InputError(fmt::format("{}: \"{}\" cannot be written: {}", where, target.string(),
                                 failure.code().message()));
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

}  // namespace antumbra
