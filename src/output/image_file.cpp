#include "output/image_file.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "document/input_error.h"
#include "document/whole_file.h"
#include "output/image_codec.h"

namespace antumbra {
namespace {

namespace fs = std::filesystem;

// The module lies beside the program. Loaded once, at the first picture.
const ImageCodec& codec() {
  static const ImageCodec* const loaded = [] {
    fs::path const file =
        fs::read_symlink("/proc/self/exe").parent_path() / "antumbra_image_codec.so";
    void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module)
      throw std::runtime_error(
          fmt::format("the image module cannot be loaded: {}; it is built with the program and "
                      "must stay beside it",
                      dlerror()));
    auto const entry =
        reinterpret_cast<decltype(&antumbraImageCodec)>(dlsym(module, "antumbraImageCodec"));
    if (!entry) throw std::runtime_error(fmt::format("{} is no image module", file.string()));
    return entry();
  }();
  return *loaded;
}

}  // namespace

void writePng(const fs::path& file, int width, int height, const std::vector<std::uint8_t>& srgb,
              const Metadata& metadata) {
  writeWholeFile(file, "-o", [&](const fs::path& temporary) {
    codec().writePng(temporary, width, height, srgb, metadata);
  });
}

std::vector<std::uint8_t> rasterised(const Drawing& drawing) { return codec().rasterised(drawing); }

void writeExr(const fs::path& file, int width, int height, const std::vector<float>& linear,
              const Metadata& metadata) {
  writeWholeFile(file, "-o", [&](const fs::path& temporary) {
    codec().writeExr(temporary, width, height, linear, metadata);
  });
}

void checkOutputFile(const fs::path& file, const std::string& where) {
  std::string const extension = file.extension().string();
  if (extension != ".png" && extension != ".exr")
    throw InputError(fmt::format("{}: found \"{}\"; allowed: a file ending in .png or .exr", where,
                                 file.string()));
  requireWritable(file, where);
}

DecodedImage readImage(const fs::path& file, const std::string& where) {
  return codec().readImage(file, where);
}

}  // namespace antumbra
