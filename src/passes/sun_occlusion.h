// How much of the Sun's disc can be seen, asked of the device: the disc is drawn into a small
// target of its own, in which every body (ray cast as its outline) and every mesh (rasterised)
// takes part, once without and once with the depth test. Occlusion queries count both; the answer
// is read in a later frame, so that nothing waits. The small target also gives the light of what is
// visible (limb darkening) and where it lies.
//
// Near totality the target is laid over the crescent that the covering body leaves, so that a
// thread of 1e-4 solar radii still spans pixels. Measured (tests/passes/sun_occlusion_gl_test.cpp):
// area within 0.1 % of the disc over partial, annular and total passages, and within 1 % of itself
// down to a visible area of 1e-4; meshes within 0.3 % of the disc.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/buffer.h"
#include "passes/sun_plane.h"

namespace antumbra {

// A part of the visible Sun, as a source of glare.
struct SunSource {
  glm::vec2 place{0.0f};  // in the Sun's plane
  float share = 0.0f;     // of the visible luminance
};

struct VisibleSun {
  double area = 0.0;               // share of the disc's area
  glm::dvec3 light{0.0};           // share of the disc's light, linear sRGB channels
  glm::dvec2 centroid{0.0};        // of the visible luminance, in the Sun's plane
  std::vector<SunSource> sources;  // at most 64; shares add to 1
  double sourceSpacing = 0.0;      // of neighbouring sources, solar radii
  bool fromQuery = false;
  std::uint64_t discSamples = 0;     // without the depth test, in the part of the plane looked at
  std::uint64_t visibleSamples = 0;  // with it
};

// Opaque triangles in metres from the camera along camera axes, three vec3 each, between the camera
// and the Sun. The buffer must live until the call returns.
struct MeshInView {
  const gl::Buffer* corners = nullptr;
  int cornerCount = 0;
};

// A parallelogram of the Sun's plane: middle + u * along + v * across, u and v from -1 to 1.
struct PlaneWindow {
  glm::dvec2 middle{0.0};
  glm::dvec2 along{1.0, 0.0};
  glm::dvec2 across{0.0, 1.0};
  bool whole = true;  // the whole disc
};
// The whole disc, or the crescent that a body leaves which covers the disc's centre.
PlaneWindow occlusionWindow(std::span<const Silhouette> silhouettes);

// The same numbers from the outlines alone, in double precision on the CPU: for a Sun outside the
// picture (whose glare still reaches into it), and to cross-check the query. Meshes take no part.
VisibleSun analyticVisibleSun(const SunPlane& plane, const glsl::LimbDarkening& law,
                              std::span<const Silhouette> silhouettes);

class SunOcclusion {
 public:
  SunOcclusion();
  ~SunOcclusion();

  // Draws the target and begins two queries, unless all slots of the ring still wait for the
  // device. Changes the bound framebuffer and viewport. Leaves blending and depth test off.
  void ask(const SunInView& sun, const SunPlane& plane, std::span<const Silhouette> silhouettes,
           std::span<const MeshInView> meshes = {});
  // Live: the newest answer that has arrived since the start, if any. Never waits.
  std::optional<VisibleSun> newest();
  // Off line: the answer to the last `ask`. Waits for the device.
  VisibleSun wait();
  // Since the start: for `--explain` and tests.
  int queriesIssued() const { return queriesIssued_; }

 private:
  struct State;
  std::unique_ptr<State> state_;
  int queriesIssued_ = 0;
};

}  // namespace antumbra
