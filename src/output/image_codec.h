// What the image module (image_codec.cpp, a shared object of its own) offers the program.
//
// OpenImageIO brings more than two hundred shared libraries, 0.15 s of every start; a command that
// makes no picture must not pay for them. So the module is loaded at the first picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "output/image_file.h"

namespace antumbra {

struct ImageCodec {
  void (*writePng)(const std::filesystem::path& file, int width, int height,
                   const std::vector<std::uint8_t>& srgb, const Metadata& metadata);
  void (*writeExr)(const std::filesystem::path& file, int width, int height,
                   const std::vector<float>& linear, const Metadata& metadata);
  std::vector<std::uint8_t> (*rasterised)(const Drawing& drawing);
  DecodedImage (*readImage)(const std::filesystem::path& file, const std::string& where);
};

// In drawing_raster.cpp.
std::vector<std::uint8_t> cairoPixels(const Drawing& drawing);

}  // namespace antumbra

extern "C" const antumbra::ImageCodec* antumbraImageCodec();
