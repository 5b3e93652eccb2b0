// Draws bodies with their surfaces, shadows and air: one full-screen triangle each, clipped to the
// body's bounds, in any projection. Every pixel ray is met with the spheroid in the space in which
// it is a sphere; the light toward the camera is added to what lies behind, dimmed by the air and
// hidden by the surface (blending with two sources), so that bodies are drawn from far to near.
// Luminance is absolute, cd/m2 per channel of linear sRGB.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "eclipse/corona_light.h"
#include "eclipse/limb_darkening.h"
#include "gl/decoded_image.h"
#include "passes/air_quality.h"
#include "passes/rings.h"
#include "plan/planned_body.h"
#include "view/projection.h"

namespace antumbra {

class AirTables;
namespace gl {
class Buffer;
class Program;
}  // namespace gl

class BodiesPass {
 public:
  struct Look {
    bool illustrative = false;  // flat colours in the shadows, lines of equal obscuration
    LimbDarkeningLaw law = LimbDarkeningLaw::Hestroffer;
    // What lights what lies in shadows besides the Sun, or none.
    std::shared_ptr<const CoronaLight> corona;
  };
  // `exact`: what belongs to an instant is computed for that very instant (off line); otherwise
  // the light of rings may be that of a slightly earlier one (live).
  BodiesPass(ImageSource images, const AirQuality& quality, bool exact = true);
  ~BodiesPass();
  BodiesPass(const BodiesPass&) = delete;
  BodiesPass& operator=(const BodiesPass&) = delete;

  // Makes resident what the body needs: its maps, its air's tables (once per medium), and what
  // belongs to this picture alone: the shadows' tables and, low in its air, the sky about the
  // camera. Throws InputError for a faulty medium file or map.
  void prepare(const PlannedBody& body, const Projection& picture, const Look& look);
  // Draws a body that `prepare` has seen into the bound framebuffer, whose lower left corner is
  // `tileOrigin` of the picture; the view block is bound at 0. Leaves blending and scissor off.
  void draw(const PlannedBody& body, const Projection& picture, glm::ivec2 tileOrigin,
            glm::ivec2 targetSize);
  // Draws the half of its rings that stands beyond or before the globe, of a body that `prepare`
  // has seen with rings in the picture.
  void drawRings(const PlannedBody& body, RingsHalf half, glm::ivec2 tileOrigin,
                 glm::ivec2 targetSize);
  // Pixels a side that share a sample of the air's light, from the next `prepare` on, in place of
  // the quality's.
  void useAirScale(int pixels);
  // Draws again the sky table of a body, for measuring; false where it has none.
  bool repeatSky(const PlannedBody& body);

  // The tables of a prepared body's air, or none.
  const AirTables* airOf(const PlannedBody& body) const;
  int tablesBuilt() const;
  int shadowPairs() const;  // handed to shaders in the bodies last prepared
  std::vector<std::pair<std::string, std::size_t>> residentBytes() const;
  std::vector<std::pair<std::string, double>> precomputeSeconds() const;

 private:
  struct State;
  static void drawRectangles(State& s, const gl::Program& program, const gl::Buffer& corners,
                             std::size_t count, glm::ivec2 origin, glm::ivec2 size);
  std::unique_ptr<State> state_;
};

}  // namespace antumbra
