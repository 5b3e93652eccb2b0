#include "tonemap/tone_map.h"

#include <fmt/format.h>

#include <vector>

#include "gl/view_block.h"
#include "photometry/colour.h"
#include "photometry/standard_spectra.h"

namespace antumbra {
namespace {

constexpr int kCellsAcross = 96;
constexpr int kCellsUp = 96;
constexpr std::size_t kCellCount = std::size_t{kCellsAcross} * kCellsUp;
constexpr int kTaps = 4;  // each way in a cell

gl::Definitions meterDefinitions(ProjectionKind kind) {
  gl::Definitions definitions = gl::projectionDefinition(kind);
  definitions.emplace_back("kTaps", fmt::format("{}", kTaps));
  definitions.emplace_back("kDarkest", fmt::format("{:e}", kMeterFloor));
  return definitions;
}

}  // namespace

ToneMap::ToneMap(ProjectionKind kind)
    : meter_(gl::Program::fullScreen("tonemap/meter.frag", meterDefinitions(kind))),
      display_(gl::Program::fullScreen("tonemap/display.frag")),
      edges_(gl::Program::fullScreen("tonemap/display.frag", {{"EDGES", ""}})),
      cells_(gl::Texture::plane(GL_RG32F, kCellsAcross, kCellsUp, gl::Filter::Nearest)),
      cellTarget_({&cells_}) {
  setAdaptedWhite(linearSrgbFromXyz(xyzOfRelativeRadiance([](Length) { return 1.0; })));
  glCreateBuffers(1, &readBuffer_);
  glNamedBufferStorage(readBuffer_, kCellCount * sizeof(MeterCell), nullptr,
                       GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
}

ToneMap::~ToneMap() {
  if (fence_) glDeleteSync(fence_);
  glDeleteBuffers(1, &readBuffer_);
}

void ToneMap::drawMeter(const gl::Texture& picture) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  cellTarget_.bind();
  picture.bind(0);
  meter_.use();
  meter_.set("cells", glm::ivec2(kCellsAcross, kCellsUp));
  gl::drawFullScreen();
}

MeterReading ToneMap::measure(const gl::Texture& picture) {
  drawMeter(picture);
  std::vector<MeterCell> cells(kCellCount);
  glGetTextureImage(cells_.id(), 0, GL_RG, GL_FLOAT,
                    static_cast<GLsizei>(kCellCount * sizeof(MeterCell)), cells.data());
  return readMeter(cells);
}

std::optional<MeterReading> ToneMap::measureWithoutWaiting(const gl::Texture& picture) {
  std::optional<MeterReading> arrived;
  if (fence_) {
    GLenum const state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    if (state == GL_TIMEOUT_EXPIRED) return arrived;
    glDeleteSync(fence_);
    fence_ = nullptr;
    std::vector<MeterCell> cells(kCellCount);
    glGetNamedBufferSubData(readBuffer_, 0, kCellCount * sizeof(MeterCell), cells.data());
    arrived = readMeter(cells);
  }
  drawMeter(picture);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, readBuffer_);
  glGetTextureImage(cells_.id(), 0, GL_RG, GL_FLOAT,
                    static_cast<GLsizei>(kCellCount * sizeof(MeterCell)), nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  return arrived;
}

void ToneMap::setAdaptedWhite(glm::dvec3 adaptedWhite) {
  channelGains_ = luminanceOf(adaptedWhite) / adaptedWhite;
}

void ToneMap::apply(const gl::Texture& picture, Exposure exposure, const gl::Framebuffer* target,
                    glm::ivec2 tileOrigin, bool dither, std::span<const PixelBounds> edges) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_FRAMEBUFFER_SRGB);
  if (target) target->bind();
  picture.bind(0);
  auto const draw = [&](const gl::Program& program) {
    program.set("perCandela", static_cast<float>(1.0 / exposure.whiteLuminance))
        .set("channelGains", channelGains_)
        .set("tileOrigin", glm::vec2(tileOrigin))
        .set("rodThreshold", static_cast<float>(exposure.rodThreshold.value_or(-1.0)))
        .set("ditherSteps", dither ? 1.0f : 0.0f)
        .use();
    gl::drawFullScreen();
  };
  draw(display_);
  for (PixelBounds const& b : edges) {
    glm::ivec2 const low = glm::max(glm::ivec2(b.x0, b.y0) - tileOrigin, glm::ivec2(0));
    glm::ivec2 const high = glm::min(glm::ivec2(b.x1, b.y1) - tileOrigin,
                                     glm::ivec2(picture.width(), picture.height()));
    if (high.x <= low.x || high.y <= low.y) continue;
    glEnable(GL_SCISSOR_TEST);
    glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
    draw(edges_);
    glDisable(GL_SCISSOR_TEST);
  }
}

}  // namespace antumbra
