#include "document/paths.h"

#include <cstdlib>
#include <system_error>

#include "document/input_error.h"

namespace antumbra {
namespace fs = std::filesystem;
namespace {

bool isRoot(const fs::path& folder) {
  return fs::is_directory(folder / "catalogs") && fs::is_directory(folder / "shaders");
}

fs::path findRoot() {
  if (const char* given = std::getenv("ANTUMBRA_ROOT")) {
    if (!isRoot(given))
      throw InputError(std::string("ANTUMBRA_ROOT: found \"") + given +
                       "\"; allowed: a folder that holds catalogs/ and shaders/");
    return given;
  }
  std::error_code ignored;
  fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (int up = 0; up < 2 && !folder.empty(); ++up, folder = folder.parent_path())
    if (isRoot(folder)) return folder;
  return ANTUMBRA_SOURCE_DIR;
}

}  // namespace

fs::path rootFolder() {
  static const fs::path root = findRoot();
  return root;
}

}  // namespace antumbra
