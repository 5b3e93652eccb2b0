// Where the project's own files (catalogs, configs, shaders) lie: the folder named by the
// environment variable ANTUMBRA_ROOT, else the folder of the program or one above it that holds
// `catalogs` and `shaders`, else the source tree it was built from.
#pragma once

#include <filesystem>

namespace antumbra {

// Throws InputError if ANTUMBRA_ROOT is set but holds no `catalogs` folder.
std::filesystem::path rootFolder();
inline std::filesystem::path catalogsFolder() { return rootFolder() / "catalogs"; }
inline std::filesystem::path configsFolder() { return rootFolder() / "configs"; }
inline std::filesystem::path shadersFolder() { return rootFolder() / "shaders"; }

}  // namespace antumbra
