// A render target made of textures that somebody else owns.
#pragma once

#include <initializer_list>

#include "gl/texture.h"

namespace antumbra::gl {

class Framebuffer {
 public:
  Framebuffer() = default;
  // Colour attachments in order; `depth` may be null. Throws std::runtime_error if incomplete.
  explicit Framebuffer(std::initializer_list<const Texture*> colours,
                       const Texture* depth = nullptr);
  ~Framebuffer();
  Framebuffer(Framebuffer&& other) noexcept;
  Framebuffer& operator=(Framebuffer&& other) noexcept;

  // Binds for drawing and sets the viewport to the whole target.
  void bind() const;
  GLuint id() const { return id_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  GLuint id_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace antumbra::gl
