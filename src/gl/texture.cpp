#include "gl/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

namespace antumbra::gl {
namespace {

void setSampling(GLuint id, Filter filter, Wrap wrap) {
  GLint const magnify = filter == Filter::Nearest ? GL_NEAREST : GL_LINEAR;
  GLint const minify = filter == Filter::Mipmapped ? GL_LINEAR_MIPMAP_LINEAR : magnify;
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, minify);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, magnify);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, wrap == Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, wrap == Wrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

GLenum layoutOf(int components) {
  constexpr GLenum layouts[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  if (components < 1 || components > 4)
    throw std::logic_error(fmt::format("texture upload with {} components", components));
  return layouts[components - 1];
}

}  // namespace

Texture Texture::plane(GLenum format, int width, int height, Filter filter, Wrap wrap, int levels) {
  Texture t;
  t.target_ = GL_TEXTURE_2D;
  t.format_ = format;
  t.width_ = width;
  t.height_ = height;
  unsigned const largest = static_cast<unsigned>(std::max(width, height));
  t.levels_ = filter != Filter::Mipmapped ? 1 : levels ? levels : std::bit_width(largest);
  glCreateTextures(t.target_, 1, &t.id_);
  glTextureStorage2D(t.id_, t.levels_, format, width, height);
  setSampling(t.id_, filter, wrap);
  return t;
}

Texture Texture::volume(GLenum format, int width, int height, int depth, Filter filter) {
  Texture t;
  t.target_ = GL_TEXTURE_3D;
  t.format_ = format;
  t.width_ = width;
  t.height_ = height;
  t.depth_ = depth;
  glCreateTextures(t.target_, 1, &t.id_);
  glTextureStorage3D(t.id_, 1, format, width, height, depth);
  setSampling(t.id_, filter, Wrap::Clamp);
  return t;
}

Texture Texture::layers(GLenum format, int width, int height, int count, Filter filter) {
  Texture t;
  t.target_ = GL_TEXTURE_2D_ARRAY;
  t.format_ = format;
  t.width_ = width;
  t.height_ = height;
  t.depth_ = count;
  glCreateTextures(t.target_, 1, &t.id_);
  glTextureStorage3D(t.id_, 1, format, width, height, count);
  setSampling(t.id_, filter, Wrap::Clamp);
  return t;
}

Texture::~Texture() {
  if (id_) glDeleteTextures(1, &id_);
}
Texture::Texture(Texture&& other) noexcept { *this = std::move(other); }
Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(target_, other.target_);
  std::swap(format_, other.format_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(depth_, other.depth_);
  std::swap(levels_, other.levels_);
  return *this;
}

std::size_t Texture::bytes() const {
  std::size_t total = 0;
  for (int level = 0; level < levels_; ++level)
    total += static_cast<std::size_t>(std::max(width_ >> level, 1)) *
             static_cast<std::size_t>(std::max(height_ >> level, 1)) *
             static_cast<std::size_t>(depth_) * bytesPerTexel(format_);
  return total;
}

void Texture::bind(int unit) const { glBindTextureUnit(static_cast<GLuint>(unit), id_); }

void Texture::bindImage(int unit, GLenum access) const {
  glBindImageTexture(static_cast<GLuint>(unit), id_, 0, GL_TRUE, 0, access, format_);
}

void Texture::uploadAny(const void* texels, std::size_t count, int components, GLenum type) {
  std::size_t const wanted = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                             static_cast<std::size_t>(depth_) *
                             static_cast<std::size_t>(components);
  if (count != wanted)
    throw std::logic_error(
        fmt::format("texture upload: {} components given, {} wanted", count, wanted));
  GLenum const layout = layoutOf(components);
  if (target_ == GL_TEXTURE_2D)
    glTextureSubImage2D(id_, 0, 0, 0, width_, height_, layout, type, texels);
  else
    glTextureSubImage3D(id_, 0, 0, 0, 0, width_, height_, depth_, layout, type, texels);
  buildMipmaps();
}

void Texture::upload(std::span<const float> texels, int components) {
  uploadAny(texels.data(), texels.size(), components, GL_FLOAT);
}
void Texture::upload(std::span<const unsigned char> texels, int components) {
  uploadAny(texels.data(), texels.size(), components, GL_UNSIGNED_BYTE);
}

void Texture::buildMipmaps() {
  if (levels_ > 1) glGenerateTextureMipmap(id_);
}

std::vector<float> Texture::readRgba() const {
  std::vector<float> texels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                            static_cast<std::size_t>(depth_) * 4);
  glGetTextureImage(id_, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(float)),
                    texels.data());
  return texels;
}

std::size_t bytesPerTexel(GLenum format) {
  switch (format) {
    case GL_R8:
      return 1;
    case GL_R16F:
      return 2;
    case GL_RGB8:
    case GL_SRGB8:
      return 3;
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_R32F:
    case GL_RG16F:
    case GL_DEPTH_COMPONENT32F:
    case GL_R11F_G11F_B10F:
      return 4;
    case GL_RGB16F:
      return 6;
    case GL_RGBA16F:
    case GL_RG32F:
      return 8;
    case GL_RGB32F:
      return 12;
    case GL_RGBA32F:
      return 16;
    default:
      throw std::logic_error(fmt::format("texel size of format {:#x} is not listed", format));
  }
}

}  // namespace antumbra::gl
