// A buffer of plain structs, for uniform and storage blocks and vertices.
#pragma once

#include <span>
#include <utility>

#include "gl/api.h"

namespace antumbra::gl {

class Buffer {
 public:
  Buffer() = default;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  Buffer(Buffer&& other) noexcept { *this = std::move(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Buffer() {
    if (id_) glDeleteBuffers(1, &id_);
  }
  // Replaces the whole content.
  template <class T>
  void write(std::span<const T> items, GLenum usage = GL_DYNAMIC_DRAW) {
    if (!id_) glCreateBuffers(1, &id_);
    glNamedBufferData(id_, static_cast<GLsizeiptr>(items.size_bytes()), items.data(), usage);
  }
  template <class T>
  void write(const T& item) {
    write(std::span<const T>(&item, 1));
  }
  void bindUniform(int binding) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), id_);
  }
  void bindStorage(int binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), id_);
  }
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

}  // namespace antumbra::gl
