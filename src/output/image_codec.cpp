// The module that knows image formats: everything of image_file.h that needs OpenImageIO or Cairo,
// behind one exported function.
#include "output/image_codec.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>

#include "document/input_error.h"

namespace antumbra {
namespace {

namespace fs = std::filesystem;

void writeImage(const fs::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                const void* pixels) {
  auto const fail = [&](const std::string& why) {
    throw InputError(fmt::format("{}: cannot be written: {}", file.string(), why));
  };
  auto output = OIIO::ImageOutput::create(file.string());
  if (!output) fail(OIIO::geterror());
  if (!output->open(file.string(), spec)) fail(output->geterror());
  if (!output->write_image(type, pixels)) fail(output->geterror());
  if (!output->close()) fail(output->geterror());
}

OIIO::ImageSpec specOf(int width, int height, OIIO::TypeDesc type, const Metadata& metadata) {
  OIIO::ImageSpec spec(width, height, 3, type);
  for (auto const& [name, value] : metadata) spec.attribute(name, value);
  return spec;
}

void encodePng(const fs::path& file, int width, int height, const std::vector<std::uint8_t>& srgb,
               const Metadata& metadata) {
  auto spec = specOf(width, height, OIIO::TypeDesc::UINT8, metadata);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", 6);
  writeImage(file, spec, OIIO::TypeDesc::UINT8, srgb.data());
}

void encodeExr(const fs::path& file, int width, int height, const std::vector<float>& linear,
               const Metadata& metadata) {
  auto spec = specOf(width, height, OIIO::TypeDesc::FLOAT, metadata);
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("compression", "zip");
  // Rec. 709 primaries and white.
  static const float chromaticities[8] = {0.64f, 0.33f, 0.30f,   0.60f,
                                          0.15f, 0.06f, 0.3127f, 0.3290f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities);
  writeImage(file, spec, OIIO::TypeDesc::FLOAT, linear.data());
}

DecodedImage decodeImage(const fs::path& file, const std::string& where) {
  auto input = OIIO::ImageInput::open(file.string());
  if (!input)
    throw InputError(fmt::format("{}: image {} cannot be read: {}", where, file.string(),
                                 fs::exists(file) ? OIIO::geterror() : "no such file"));
  OIIO::ImageSpec const& spec = input->spec();
  DecodedImage image{spec.width, spec.height, std::min(spec.nchannels, 4), {}};
  auto const row =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.components);
  image.texels.resize(row * static_cast<std::size_t>(image.height));
  // Bottom row first: start at the last row and step backwards.
  auto const stride = static_cast<OIIO::stride_t>(row);
  if (!input->read_image(0, 0, 0, image.components, OIIO::TypeDesc::UINT8,
                         image.texels.data() + row * static_cast<std::size_t>(image.height - 1),
                         OIIO::AutoStride, -stride))
    throw InputError(
        fmt::format("{}: image {} cannot be decoded: {}", where, file.string(), input->geterror()));
  return image;
}

constexpr ImageCodec kCodec{encodePng, encodeExr, cairoPixels, decodeImage};

}  // namespace
}  // namespace antumbra

extern "C" const antumbra::ImageCodec* antumbraImageCodec() { return &antumbra::kCodec; }
