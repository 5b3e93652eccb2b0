#include "gl/program.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace antumbra::gl {
namespace {

GLuint compile(GLenum kind, const std::string& path, const Definitions& definitions) {
  ShaderSource const source = loadShader(path, definitions);
  GLuint const shader = glCreateShader(kind);
  const char* text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    glDeleteShader(shader);
    throw std::runtime_error(
        fmt::format("shaders/{} does not compile:\n{}", path, explainLog(log, source)));
  }
  return shader;
}

GLuint link(std::initializer_list<GLuint> shaders, const std::string& name) {
  GLuint const program = glCreateProgram();
  for (GLuint s : shaders) glAttachShader(program, s);
  glLinkProgram(program);
  for (GLuint s : shaders) glDeleteShader(s);
  GLint ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (!ok) {
    char log[4096] = {};
    glGetProgramInfoLog(program, sizeof log, nullptr, log);
    glDeleteProgram(program);
    throw std::runtime_error(fmt::format("shaders/{} does not link:\n{}", name, log));
  }
  return program;
}

}  // namespace

Program Program::render(const std::string& vertex, const std::string& fragment,
                        const Definitions& definitions) {
  Program p;
  p.id_ = link({compile(GL_VERTEX_SHADER, vertex, definitions),
                compile(GL_FRAGMENT_SHADER, fragment, definitions)},
               fragment);
  return p;
}

Program Program::fullScreen(const std::string& fragment, const Definitions& definitions) {
  return render("passes/full_screen.vert", fragment, definitions);
}

Program Program::compute(const std::string& path, const Definitions& definitions) {
  Program p;
  p.id_ = link({compile(GL_COMPUTE_SHADER, path, definitions)}, path);
  return p;
}

Program::~Program() {
  if (id_) glDeleteProgram(id_);
}
Program::Program(Program&& other) noexcept { *this = std::move(other); }
Program& Program::operator=(Program&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(locations_, other.locations_);
  return *this;
}

void Program::use() const { glUseProgram(id_); }

GLint Program::location(const char* name) const {
  auto const found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  return locations_[name] = glGetUniformLocation(id_, name);
}

const Program& Program::set(const char* name, float v) const {
  return glProgramUniform1f(id_, location(name), v), *this;
}
const Program& Program::set(const char* name, int v) const {
  return glProgramUniform1i(id_, location(name), v), *this;
}
const Program& Program::set(const char* name, const glm::vec2& v) const {
  return glProgramUniform2f(id_, location(name), v.x, v.y), *this;
}
const Program& Program::set(const char* name, const glm::vec3& v) const {
  return glProgramUniform3f(id_, location(name), v.x, v.y, v.z), *this;
}
const Program& Program::set(const char* name, const glm::vec4& v) const {
  return glProgramUniform4f(id_, location(name), v.x, v.y, v.z, v.w), *this;
}
const Program& Program::set(const char* name, const glm::ivec2& v) const {
  return glProgramUniform2i(id_, location(name), v.x, v.y), *this;
}
const Program& Program::set(const char* name, const glm::ivec3& v) const {
  return glProgramUniform3i(id_, location(name), v.x, v.y, v.z), *this;
}
const Program& Program::set(const char* name, const glm::mat3& v) const {
  return glProgramUniformMatrix3fv(id_, location(name), 1, GL_FALSE, &v[0][0]), *this;
}
const Program& Program::set(const char* name, const glm::mat4& v) const {
  return glProgramUniformMatrix4fv(id_, location(name), 1, GL_FALSE, &v[0][0]), *this;
}
const Program& Program::setArray(const char* name, const glm::vec3* v, int count) const {
  return glProgramUniform3fv(id_, location(name), count, &v[0].x), *this;
}
const Program& Program::setArray(const char* name, const glm::vec4* v, int count) const {
  return glProgramUniform4fv(id_, location(name), count, &v[0].x), *this;
}
const Program& Program::setArray(const char* name, const float* v, int count) const {
  return glProgramUniform1fv(id_, location(name), count, v), *this;
}

void drawFullScreen() {
  // An empty vertex array for attribute-less drawing, one per context; it lives as long as that.
  GLint bound = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  GLuint vertexArray = static_cast<GLuint>(bound);
  if (!bound) {
    glCreateVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
  }
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace antumbra::gl
