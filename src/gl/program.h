// A linked program: vertex and fragment shader, or one compute shader.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>

#include "gl/api.h"
#include "gl/shader_source.h"

namespace antumbra::gl {

class Program {
 public:
  Program() = default;
  // Paths are relative to shaders/. Throws std::runtime_error with the compiler's log, file and
  // line.
  static Program render(const std::string& vertex, const std::string& fragment,
                        const Definitions& definitions = {});
  // A full-screen pass: one triangle without attributes (shaders/passes/full_screen.vert).
  static Program fullScreen(const std::string& fragment, const Definitions& definitions = {});
  static Program compute(const std::string& path, const Definitions& definitions = {});
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;

  void use() const;
  GLuint id() const { return id_; }
  // Uniforms by name; a name the compiler has removed is ignored, as GL does.
  const Program& set(const char* name, float value) const;
  const Program& set(const char* name, int value) const;
  const Program& set(const char* name, const glm::vec2& value) const;
  const Program& set(const char* name, const glm::vec3& value) const;
  const Program& set(const char* name, const glm::vec4& value) const;
  const Program& set(const char* name, const glm::ivec2& value) const;
  const Program& set(const char* name, const glm::ivec3& value) const;
  const Program& set(const char* name, const glm::mat3& value) const;
  const Program& set(const char* name, const glm::mat4& value) const;
  const Program& setArray(const char* name, const glm::vec3* values, int count) const;
  const Program& setArray(const char* name, const glm::vec4* values, int count) const;
  const Program& setArray(const char* name, const float* values, int count) const;

 private:
  GLint location(const char* name) const;
  GLuint id_ = 0;
  mutable std::map<std::string, GLint, std::less<>> locations_;
};

// Draws the triangle that covers the viewport; the program must be in use.
void drawFullScreen();

}  // namespace antumbra::gl
