// An 8-bit picture in memory, and where the passes get one from: whoever runs them decodes files
// (with OpenImageIO) or reads raw texels, so that nothing here depends on image formats.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace antumbra {

struct DecodedImage {
  int width = 0;
  int height = 0;
  int components = 0;
  std::vector<unsigned char> texels;  // first row at the bottom, as OpenGL wants it
};

// Takes a file relative to catalogs/ and, for messages, where it was named.
using ImageSource = std::function<DecodedImage(const std::string& file, const std::string& where)>;

}  // namespace antumbra
