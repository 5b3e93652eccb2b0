// A picture of absolute luminance that a pass has drawn, read back, for tests.
#pragma once

#include <functional>
#include <vector>

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/view_block.h"

namespace antumbra::testsupport {

// Solid angle of a pixel by the triangles between its corners' directions (Van Oosterom & Strackee
// 1983): independent of the shared functions that shaders use. 0 in a mask.
inline double pixelSolidAngle(const Projection& projection, int x, int y) {
  glm::dvec3 corner[4];
  int const dx[] = {0, 1, 1, 0}, dy[] = {0, 0, 1, 1};
  for (int i = 0; i < 4; ++i) {
    auto const d = projection.directionAt(x + dx[i], y + dy[i]);
    if (!d) return 0.0;
    corner[i] = d->u;
  }
  auto const triangle = [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    double const volume = std::fabs(glm::dot(a - b, glm::cross(b - c, c)));
    return 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
  };
  return triangle(corner[0], corner[1], corner[2]) + triangle(corner[0], corner[2], corner[3]);
}

struct SkyPicture {
  Projection projection;
  gl::Texture texture;
  gl::Framebuffer framebuffer;
  gl::Buffer view;
  std::vector<float> texels;

  explicit SkyPicture(const Projection& p)
      : projection(p),
        texture(gl::Texture::plane(GL_RGBA32F, p.width, p.height)),
        framebuffer({&texture}) {
    view.write(gl::viewBlockOf(p));
  }
  // Clears, draws, reads back.
  void draw(const std::function<void()>& pass) {
    view.bindUniform(0);
    framebuffer.bind();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    pass();
    texels = texture.readRgba();
  }
  glm::dvec3 at(int x, int y) const {
    auto const i = static_cast<std::size_t>(4 * (y * projection.width + x));
    return {texels[i], texels[i + 1], texels[i + 2]};
  }
  // Sum of luminance times solid angle: lux in linear sRGB.
  glm::dvec3 illuminance() const {
    glm::dvec3 sum(0.0);
    for (int y = 0; y < projection.height; ++y)
      for (int x = 0; x < projection.width; ++x)
        if (at(x, y) != glm::dvec3(0.0)) sum += at(x, y) * pixelSolidAngle(projection, x, y);
    return sum;
  }
};

}  // namespace antumbra::testsupport
