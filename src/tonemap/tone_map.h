// The display stage: meters a picture of absolute luminance on the GPU and turns it into 8-bit
// sRGB. Curve and colour: shaders/shared/tone_curve.glsl. Works from 1e-5 to 1.6e9 cd/m2 in floats.
#pragma once

#include <optional>
#include <span>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "tonemap/exposure.h"
#include "view/projection.h"

namespace antumbra {

class ToneMap {
 public:
  // `kind` is that of the pictures that will be metered (their pixels' solid angles weigh them).
  explicit ToneMap(ProjectionKind kind);
  ~ToneMap();
  ToneMap(const ToneMap&) = delete;
  ToneMap& operator=(const ToneMap&) = delete;

  // `picture`: linear sRGB, cd/m2, the whole picture; its view block is bound at 0. Waits for the
  // device: off line.
  MeterReading measure(const gl::Texture& picture);
  // Live: starts a measurement, unless one is under way, and returns the newest that has arrived.
  std::optional<MeterReading> measureWithoutWaiting(const gl::Texture& picture);

  // The display's white (D65) stands for `adaptedWhite`, linear sRGB of any scale: the default is
  // sunlight without air, to which the eye outdoors and a camera's daylight setting are adapted,
  // and which would show pinkish otherwise. Von Kries' adaptation on the channels of sRGB; whites
  // keep their luminance.
  void setAdaptedWhite(glm::dvec3 adaptedWhite);

  // Draws `picture` (or a tile of it that begins at `tileOrigin`) into `target` of the same size,
  // an RGBA8 texture or a window (framebuffer already bound, null). Opaque. `dither` off is for
  // tests. Where the exposure is an eye's, its rods take part (shaders/shared/night_vision.glsl).
  // `edges`: where pixels of the whole picture may be marked in alpha (display.frag).
  void apply(const gl::Texture& picture, Exposure exposure, const gl::Framebuffer* target,
             glm::ivec2 tileOrigin = {0, 0}, bool dither = true,
             std::span<const PixelBounds> edges = {});

 private:
  void drawMeter(const gl::Texture& picture);
  gl::Program meter_, display_, edges_;
  glm::vec3 channelGains_{1.0f};
  gl::Texture cells_;
  gl::Framebuffer cellTarget_;
  GLuint readBuffer_ = 0;
  GLsync fence_ = nullptr;
};

}  // namespace antumbra
