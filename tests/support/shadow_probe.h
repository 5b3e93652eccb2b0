// Visible sunlight at a list of points, as the programs look it up.
#pragma once

#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "passes/body_shadows.h"

namespace antumbra::testsupport {

// By a program of shaders/bench/shadow_probe.comp, which gives the first four wavelengths; what it
// reads besides the shadows is bound. `places` in scaled space, metres from the receiver's centre.
inline std::vector<glm::vec4> lightAt(const BodyShadows& shadows, const gl::Program& probe,
                                      const std::vector<glm::vec4>& places) {
  gl::Buffer in, out;
  in.write(std::span<const glm::vec4>(places));
  std::vector<glm::vec4> light(places.size());
  out.write(std::span<const glm::vec4>(light));
  in.bindStorage(0);
  out.bindStorage(1);
  shadows.bind();
  probe.use();
  glDispatchCompute(static_cast<GLuint>((places.size() + 31) / 32), 1, 1);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(light.size() * sizeof(glm::vec4)),
                          light.data());
  return light;
}
inline std::vector<glm::vec4> lightAt(const BodyShadows& shadows,
                                      const std::vector<glm::vec4>& places) {
  auto definitions = shadows.definitions();
  definitions.emplace_back("AIR_LAYERS", "1");
  return lightAt(shadows, gl::Program::compute("bench/shadow_probe.comp", definitions), places);
}

}  // namespace antumbra::testsupport
