#include "app/draw_timing.h"

#include <algorithm>
#include <vector>

#include "app/processor_clock.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace antumbra {
namespace {

double secondsOn(DrawClock clock) {
  return clock == DrawClock::Wall ? secondsOfClock(CLOCK_MONOTONIC) : processorSeconds();
}

}  // namespace

double medianSeconds(const std::function<void()>& draw, int repeats, DrawClock clock) {
  draw();
  glFinish();
  std::vector<double> seconds;
  for (int i = 0; i < std::max(repeats, 7); ++i) {
    double const start = secondsOn(clock);
    draw();
    glFinish();
    seconds.push_back(secondsOn(clock) - start);
  }
  auto const middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

double fillUnitSeconds(int width, int height, DrawClock clock) {
  constexpr int kWidth = 256, kHeight = 128;
  auto table =
      gl::Texture::plane(GL_RGBA16F, kWidth, kHeight, gl::Filter::Linear, gl::Wrap::Repeat);
  std::vector<float> texels;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      texels.insert(texels.end(),
                    {static_cast<float>(x) / 255.0f, static_cast<float>(y) / 127.0f, 0.5f, 1.0f});
  table.upload(texels, 4);
  auto const target = gl::Texture::plane(GL_RGBA16F, width, height);
  gl::Framebuffer const framebuffer({&target});
  auto const program = gl::Program::fullScreen("bench/fill_unit.frag");
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  return medianSeconds(
      [&] {
        framebuffer.bind();
        table.bind(0);
        program.use();
        gl::drawFullScreen();
      },
      7, clock);
}

}  // namespace antumbra
