// Pictures to files: PNG for the screen, EXR for measuring. Written to a temporary file beside the
// target and renamed, so that a file is whole or absent. Decoded maps come from here as well.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "eclipse/drawing.h"
#include "gl/decoded_image.h"

namespace antumbra {

// What a picture shows, for its file's metadata: name (as "antumbra:time") and text.
using Metadata = std::vector<std::pair<std::string, std::string>>;

// 8-bit sRGB, three components, first row at the top. Throws InputError if the folder is missing or
// cannot be written.
void writePng(const std::filesystem::path& file, int width, int height,
              const std::vector<std::uint8_t>& srgb, const Metadata& metadata);

// Linear absolute luminance, cd/m2 in each of linear-sRGB R, G, B (32-bit float, Rec. 709
// primaries), first row at the top.
void writeExr(const std::filesystem::path& file, int width, int height,
              const std::vector<float>& linear, const Metadata& metadata);

// Refuses a file name that neither writer takes, or whose folder does not exist (InputError opened
// by `where`), before any work is done.
void checkOutputFile(const std::filesystem::path& file, const std::string& where);

// The drawing in 8-bit sRGB, three components, first row at the top.
std::vector<std::uint8_t> rasterised(const Drawing& drawing);

// Throws InputError (opened by `where`) if the file is missing or is no readable image.
DecodedImage readImage(const std::filesystem::path& file, const std::string& where);

}  // namespace antumbra
