#include "gl/framebuffer.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace antumbra::gl {

Framebuffer::Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth) {
  glCreateFramebuffers(1, &id_);
  std::vector<GLenum> buffers;
  for (const Texture* colour : colours) {
    GLenum const attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    glNamedFramebufferTexture(id_, attachment, colour->id(), 0);
    buffers.push_back(attachment);
    width_ = colour->width();
    height_ = colour->height();
  }
  if (depth) {
    glNamedFramebufferTexture(id_, GL_DEPTH_ATTACHMENT, depth->id(), 0);
    width_ = depth->width();
    height_ = depth->height();
  }
  glNamedFramebufferDrawBuffers(id_, static_cast<GLsizei>(buffers.size()), buffers.data());
  GLenum const status = glCheckNamedFramebufferStatus(id_, GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error(
        fmt::format("framebuffer {}x{} is incomplete ({:#x})", width_, height_, status));
}

Framebuffer::~Framebuffer() {
  if (id_) glDeleteFramebuffers(1, &id_);
}
Framebuffer::Framebuffer(Framebuffer&& other) noexcept { *this = std::move(other); }
Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  return *this;
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  glViewport(0, 0, width_, height_);
}

}  // namespace antumbra::gl
