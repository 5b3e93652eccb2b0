// Immutable textures that own their name.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gl/api.h"

namespace antumbra::gl {

enum class Filter { Nearest, Linear, Mipmapped };
enum class Wrap { Clamp, Repeat, RepeatHorizontally };

class Texture {
 public:
  Texture() = default;
  // `format` is a sized internal format as GL_RGBA32F. `levels` 0 means a full chain.
  static Texture plane(GLenum format, int width, int height, Filter filter = Filter::Linear,
                       Wrap wrap = Wrap::Clamp, int levels = 1);
  static Texture volume(GLenum format, int width, int height, int depth,
                        Filter filter = Filter::Linear);
  static Texture layers(GLenum format, int width, int height, int count,
                        Filter filter = Filter::Linear);
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;

  explicit operator bool() const { return id_ != 0; }
  GLuint id() const { return id_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int depth() const { return depth_; }
  GLenum format() const { return format_; }
  // Storage of the first level, and of a whole chain, in bytes.
  std::size_t bytes() const;

  void bind(int unit) const;
  void bindImage(int unit, GLenum access) const;  // whole texture, level 0, layered
  // Uploads level 0 (all of it) and rebuilds the chain where there is one. Components per texel
  // 1-4.
  void upload(std::span<const float> texels, int components);
  void upload(std::span<const unsigned char> texels, int components);
  void buildMipmaps();
  std::vector<float> readRgba() const;  // level 0, four floats a texel, first row at the bottom

 private:
  void uploadAny(const void* texels, std::size_t count, int components, GLenum type);
  GLuint id_ = 0;
  GLenum target_ = 0;
  GLenum format_ = 0;
  int width_ = 0, height_ = 0, depth_ = 1, levels_ = 1;
};

// Bytes of one texel of a sized internal format that this project uses.
std::size_t bytesPerTexel(GLenum format);

}  // namespace antumbra::gl
