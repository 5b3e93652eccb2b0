#include "passes/sun_occlusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/query.h"

namespace antumbra {
namespace {

constexpr int kSide = 256;  // pixels of the target
constexpr int kCells = 8;   // cells along a side, each a source of glare
constexpr std::size_t kCellCount = std::size_t{kCells} * kCells;
constexpr std::size_t kCellBytes = kCellCount * sizeof(glm::vec4);
// A little more than the disc, so that its edge is not the target's.
constexpr double kWholeReach = 1.0 + 2.0 / kSide;

bool hides(const Silhouette& s, glm::dvec2 p) {
  glm::dvec3 const q(p, 1.0);
  return glm::dot(q, s.quadric * q) > 0.0 && glm::dot(s.front, q) > 0.0;
}

// Sums of a cell: light (red, green, blue, luminance), and u and v weighted by luminance, and
// count.
struct CellSums {
  glm::dvec4 light{0.0};
  glm::dvec2 moment{0.0};  // of u, v in the window
  double count = 0.0;
};

VisibleSun combine(const std::array<CellSums, kCellCount>& cells, const PlaneWindow& window,
                   double discSamples, double visibleSamples) {
  VisibleSun visible;
  visible.discSamples = static_cast<std::uint64_t>(discSamples);
  visible.visibleSamples = static_cast<std::uint64_t>(visibleSamples);
  if (visibleSamples <= 0.0) return visible;
  glm::dvec4 light(0.0);
  glm::dvec2 moment(0.0);
  double count = 0.0;
  for (CellSums const& cell : cells) {
    light += cell.light;
    moment += cell.moment;
    count += cell.count;
  }
  if (count <= 0.0 || light.w <= 0.0) return visible;
  double const pixelArea =
      4.0 * std::fabs(window.along.x * window.across.y - window.along.y * window.across.x) /
      (kSide * kSide);
  visible.area = window.whole && discSamples > 0.0 ? visibleSamples / discSamples
                                                   : visibleSamples * pixelArea / std::numbers::pi;
  // Brightness is relative to the disc's mean: the light is the area times the mean of what shows.
  visible.light = visible.area * glm::dvec3(light) / count;
  auto const placeOf = [&](glm::dvec2 uv) {
    return window.middle + uv.x * window.along + uv.y * window.across;
  };
  visible.centroid = placeOf(moment / light.w);
  visible.sourceSpacing =
      2.0 * std::max(glm::length(window.along), glm::length(window.across)) / kCells;
  for (CellSums const& cell : cells)
    if (cell.light.w > 0.0)
      visible.sources.push_back({glm::vec2(placeOf(cell.moment / cell.light.w)),
                                 static_cast<float>(cell.light.w / light.w)});
  return visible;
}

}  // namespace

PlaneWindow occlusionWindow(std::span<const Silhouette> silhouettes) {
  PlaneWindow whole;
  whole.along = {kWholeReach, 0.0};
  whole.across = {0.0, kWholeReach};
  // A body over the centre is convex and leaves one arc of the limb: the crescent lies between.
  auto const cover = std::find_if(silhouettes.begin(), silhouettes.end(), [](const Silhouette& s) {
    return hides(s, {0.0, 0.0});
  });
  if (cover == silhouettes.end()) return whole;
  constexpr int kRim = 4096;
  std::vector<bool> open(kRim);
  int openCount = 0;
  glm::dvec2 sum(0.0);
  for (int i = 0; i < kRim; ++i) {
    double const a = 2.0 * std::numbers::pi * i / kRim;
    glm::dvec2 const limb(std::cos(a), std::sin(a));
    open[static_cast<std::size_t>(i)] = !hides(*cover, limb);
    if (open[static_cast<std::size_t>(i)]) {
      ++openCount;
      sum += limb;
    }
  }
  // Much more than half the limb: no crescent.
  if (openCount == 0 || openCount > kRim * 6 / 10 || glm::length(sum) < 0.5 * openCount)
    return whole;
  glm::dvec2 const outward = glm::normalize(sum);
  glm::dvec2 const sideways(-outward.y, outward.x);
  int const stride = std::max(1, openCount / 64);
  double low = 1.0, left = 1.0, right = -1.0;
  for (int i = -1; i <= kRim; ++i) {
    // One step beyond either end of the arc, for the ends lie between the samples.
    int near = 0;
    for (int k = -1; k <= 1; ++k) near += open[static_cast<std::size_t>((i + k + kRim) % kRim)];
    // Within the arc the outline is smooth: every so often is enough.
    if (near == 0 || (near == 3 && i % stride != 0)) continue;
    double const a = 2.0 * std::numbers::pi * i / kRim;
    glm::dvec2 const limb(std::cos(a), std::sin(a));
    // Where the radius leaves the body, by bisection between the centre and the limb.
    double inner = 0.0, outer = 1.0;
    for (int k = 0; k < 50; ++k) {
      double const middle = 0.5 * (inner + outer);
      (hides(*cover, middle * limb) ? inner : outer) = middle;
    }
    low = std::min({low, inner * glm::dot(limb, outward), glm::dot(limb, outward)});
    left = std::min(left, glm::dot(limb, sideways));
    right = std::max(right, glm::dot(limb, sideways));
  }
  PlaneWindow window;
  window.whole = false;
  double const margin = 0.02;
  double const height = 0.5 * (1.0 - low) * (1.0 + margin);
  window.middle = 0.5 * (1.0 + low) * outward + 0.5 * (left + right) * sideways;
  window.along = 0.5 * (right - left) * (1.0 + margin) * sideways;
  window.across = std::max(height, 1e-7) * outward;
  return window;
}

VisibleSun analyticVisibleSun(const SunPlane& plane, const glsl::LimbDarkening& law,
                              std::span<const Silhouette> silhouettes) {
  PlaneWindow const window = occlusionWindow(silhouettes);
  std::array<CellSums, kCellCount> cells{};
  double disc = 0.0, seen = 0.0;
  double const tangentSquared = plane.tangent() * plane.tangent();
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      glm::dvec2 const uv = 2.0 * (glm::dvec2(x, y) + 0.5) / double(kSide) - 1.0;
      glm::dvec2 const p = window.middle + uv.x * window.along + uv.y * window.across;
      double const squared = glm::dot(p, p);
      if (squared > 1.0) continue;
      disc += 1.0;
      if (std::any_of(silhouettes.begin(), silhouettes.end(),
                      [&](const Silhouette& s) { return hides(s, p); }))
        continue;
      seen += 1.0;
      glm::dvec4 const brightness =
          glsl::solarBrightness(law, std::sqrt((1.0 - squared) / (1.0 + squared * tangentSquared)));
      auto const cell = static_cast<std::size_t>(y * kCells / kSide * kCells + x * kCells / kSide);
      cells[cell].light += brightness;
      cells[cell].moment += brightness.w * uv;
      cells[cell].count += 1.0;
    }
  return combine(cells, window, disc, seen);
}

struct SunOcclusion::State {
  struct Slot {
    gl::Query disc{GL_SAMPLES_PASSED};
    gl::Query visible{GL_SAMPLES_PASSED};
    GLuint readBuffer = 0;
    GLsync fence = nullptr;
    PlaneWindow window;
  };
  static constexpr std::size_t kSlots = 4;

  gl::Program occluder = gl::Program::fullScreen("passes/sun_occluder.frag");
  gl::Program mesh =
      gl::Program::render("passes/sun_occluder_mesh.vert", "passes/sun_occluder_mesh.frag");
  gl::Program disc = gl::Program::fullScreen("passes/sun_occlusion.frag");
  gl::Program cells = gl::Program::fullScreen("passes/sun_cells.frag");
  gl::Texture colour = gl::Texture::plane(GL_RGBA32F, kSide, kSide, gl::Filter::Nearest);
  gl::Texture depth = gl::Texture::plane(GL_DEPTH_COMPONENT32F, kSide, kSide, gl::Filter::Nearest);
  gl::Texture light = gl::Texture::plane(GL_RGBA32F, kCells, kCells, gl::Filter::Nearest);
  gl::Texture moments = gl::Texture::plane(GL_RGBA32F, kCells, kCells, gl::Filter::Nearest);
  gl::Framebuffer target = gl::Framebuffer({&colour}, &depth);
  gl::Framebuffer cellTarget = gl::Framebuffer({&light, &moments});
  std::array<Slot, kSlots> slots;
  GLuint meshArray = 0;
  std::size_t next = 0;  // slot of the next question; the one before holds the last
  bool asked = false;
  std::optional<VisibleSun> latest;

  State() {
    glCreateVertexArrays(1, &meshArray);
    glEnableVertexArrayAttrib(meshArray, 0);
    glVertexArrayAttribFormat(meshArray, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(meshArray, 0, 0);
    for (Slot& slot : slots) {
      glCreateBuffers(1, &slot.readBuffer);
      glNamedBufferStorage(slot.readBuffer, 2 * kCellBytes, nullptr,
                           GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
    }
  }
  ~State() {
    glDeleteVertexArrays(1, &meshArray);
    for (Slot& slot : slots) {
      if (slot.fence) glDeleteSync(slot.fence);
      glDeleteBuffers(1, &slot.readBuffer);
    }
  }

  // Takes a slot's answer in; its fence has been reached.
  void collect(Slot& slot) {
    glDeleteSync(slot.fence);
    slot.fence = nullptr;
    std::array<glm::vec4, 2 * kCellCount> read;
    glGetNamedBufferSubData(slot.readBuffer, 0, 2 * kCellBytes, read.data());
    std::array<CellSums, kCellCount> sums{};
    for (std::size_t i = 0; i < kCellCount; ++i) {
      sums[i].light = read[i];
      sums[i].moment = glm::dvec2(read[kCellCount + i]);
      sums[i].count = read[kCellCount + i].z;
    }
    auto const all = static_cast<double>(slot.disc.wait());
    auto const seen = static_cast<double>(slot.visible.wait());
    latest = combine(sums, slot.window, all, seen);
    latest->fromQuery = true;
  }
};

SunOcclusion::SunOcclusion() : state_(std::make_unique<State>()) {}
SunOcclusion::~SunOcclusion() = default;

void SunOcclusion::ask(const SunInView& sun, const SunPlane& plane,
                       std::span<const Silhouette> silhouettes,
                       std::span<const MeshInView> meshes) {
  State& s = *state_;
  State::Slot& slot = s.slots[s.next];
  if (slot.fence) {
    // The oldest question: its answer has mostly come, else there is no room for another.
    if (glClientWaitSync(slot.fence, 0, 0) == GL_TIMEOUT_EXPIRED) return;
    s.collect(slot);
  }
  slot.window = occlusionWindow(silhouettes);
  PlaneWindow const& w = slot.window;
  auto const setWindow = [&](const gl::Program& program) {
    setSunPlane(program, ProjectionKind::Fisheye, plane, sun.law, silhouettes);
    program.set("windowMiddle", glm::vec2(w.middle))
        .set("windowAlong", glm::vec2(w.along))
        .set("windowAcross", glm::vec2(w.across))
        .set("targetSide", static_cast<float>(kSide));
  };
  s.target.bind();
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  float const none[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  float const far = 0.0f;  // reversed depth
  glClearNamedFramebufferfv(s.target.id(), GL_COLOR, 0, none);
  glClearNamedFramebufferfv(s.target.id(), GL_DEPTH, 0, &far);

  // What is in front: depth alone.
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthFunc(GL_ALWAYS);
  if (!silhouettes.empty()) {
    setWindow(s.occluder);
    s.occluder.use();
    gl::drawFullScreen();
  }
  if (!meshes.empty()) {
    // From camera axes to the window: u and v over the depth along the Sun's axis.
    glm::dmat2 const intoWindow = glm::inverse(glm::dmat2(w.along, w.across));
    glm::dvec3 const px = plane.across().u / plane.tangent(), py = plane.up().u / plane.tangent();
    glm::dvec3 const axis = plane.centre().u;
    glm::dvec3 const x = px - w.middle.x * axis, y = py - w.middle.y * axis;
    glm::dvec3 const u = intoWindow[0][0] * x + intoWindow[1][0] * y;
    glm::dvec3 const v = intoWindow[0][1] * x + intoWindow[1][1] * y;
    s.mesh.set("windowFromCamera", glm::mat3(glm::transpose(glm::dmat3(u, v, axis))));
    s.mesh.use();
    GLint previousArray = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &previousArray);
    glBindVertexArray(s.meshArray);
    for (MeshInView const& mesh : meshes) {
      glVertexArrayVertexBuffer(s.meshArray, 0, mesh.corners->id(), 0, 3 * sizeof(float));
      glDrawArrays(GL_TRIANGLES, 0, mesh.cornerCount);
    }
    glBindVertexArray(static_cast<GLuint>(previousArray));
  }

  // The disc, counted without the depth test and with it.
  setWindow(s.disc);
  s.disc.use();
  glDepthMask(GL_FALSE);
  glDepthRange(0.0, 0.5);  // farther than bodies (1) and meshes (0.75)
  slot.disc.begin();
  gl::drawFullScreen();
  slot.disc.end();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_GREATER);
  slot.visible.begin();
  gl::drawFullScreen();
  slot.visible.end();
  glDepthRange(0.0, 1.0);
  queriesIssued_ += 2;
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);

  // Light and place by cells, read later.
  s.cellTarget.bind();
  s.colour.bind(0);
  s.cells.set("targetSide", kSide).set("cellsAcross", kCells);
  s.cells.use();
  gl::drawFullScreen();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, slot.readBuffer);
  glGetTextureImage(s.light.id(), 0, GL_RGBA, GL_FLOAT, kCellBytes, nullptr);
  glGetTextureImage(s.moments.id(), 0, GL_RGBA, GL_FLOAT, kCellBytes,
                    reinterpret_cast<void*>(kCellBytes));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  slot.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  s.next = (s.next + 1) % State::kSlots;
  s.asked = true;
}

std::optional<VisibleSun> SunOcclusion::newest() {
  State& s = *state_;
  // From the oldest to the newest, as far as the device has come.
  for (std::size_t i = 0; i < State::kSlots; ++i) {
    State::Slot& slot = s.slots[(s.next + i) % State::kSlots];
    if (!slot.fence) continue;
    if (glClientWaitSync(slot.fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED) break;
    s.collect(slot);
  }
  return s.latest;
}

VisibleSun SunOcclusion::wait() {
  State& s = *state_;
  if (!s.asked) throw std::logic_error("SunOcclusion::wait without a question");
  for (std::size_t i = 0; i < State::kSlots; ++i) {
    State::Slot& slot = s.slots[(s.next + i) % State::kSlots];
    if (!slot.fence) continue;
    glClientWaitSync(slot.fence, GL_SYNC_FLUSH_COMMANDS_BIT, ~GLuint64{0});
    s.collect(slot);
  }
  return *s.latest;
}

}  // namespace antumbra
