// Which parts of a picture show a body's ground alone (sunlit, at dusk or at night), its air alone,
// both, or nothing of it: the picture is cut into tiles, and each is classed by the cone of its
// directions about the body's centre in scaled space. Conservative: a tile of ground holds ground
// alone, a tile of air no ground. Nothing is drawn where nothing can be seen, and no pixel pays for
// the part it does not show.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "view/projection.h"

namespace antumbra {

// Ground alone: Sunlit, where every ray takes few samples (air_geometry.glsl, fewSamplesShare),
// Dusk, where every ray takes many, and Night, where neither it nor the air before it receives any
// sunlight. Both: what is neither, or shows ground and air. Coarse: of the same kind, and with the
// pixels around as smooth as a sample for several pixels wants it.
enum class BodyPart { Sunlit, Dusk, Night, Air, Both, CoarseSunlit, CoarseDusk, CoarseAir };
inline constexpr std::size_t kBodyParts = 8;

// Where the air's light is sampled once for several pixels and interpolated: never within reach of
// a limb, a horizon, the edge of a mask or the Sun, nor beyond the terminator; and air only from
// within, where it has no limb.
struct CoarseTiles {
  int scale = 1;  // pixels a side; 1: nowhere
  bool air = false;
};

// Rectangles of each part, in pixels of the picture, as corners of triangles.
using BodyTiles = std::array<std::vector<glm::vec2>, kBodyParts>;

// `scaledFromCamera` turns camera axes into scaled space; `up` is the unit vector from the centre
// to the camera there, `sun` that to the Sun, `height` the camera's above the ground (positive),
// `reach` that of the air's top, 0 without air. Lengths in metres. `nightSine`: the sine of the
// Sun's height (negative) below which a place is dark, at whatever height.
BodyTiles bodyTiles(const Projection& picture, const PixelBounds& bounds,
                    const glm::dmat3& scaledFromCamera, const glm::dvec3& up, const glm::dvec3& sun,
                    double radius, double height, double reach, double nightSine,
                    CoarseTiles coarse = {});

}  // namespace antumbra
