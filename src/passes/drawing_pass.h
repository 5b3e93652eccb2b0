// Draws a Drawing (lines, convex areas, words) over a picture in display colours, antialiased by
// distance: a line's edge and an area's edge run from full to none over one pixel.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "eclipse/drawing.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "passes/typeface.h"

namespace antumbra {

class DrawingPass {
 public:
  DrawingPass();
  ~DrawingPass();
  DrawingPass(const DrawingPass&) = delete;
  DrawingPass& operator=(const DrawingPass&) = delete;

  // Turns the drawing into triangles; its filled shapes must be convex. `drawing.height` is that of
  // the picture, whose rows run from the bottom up here. Throws InputError if the font is missing.
  void prepare(const Drawing& drawing);
  // Draws what was prepared last into the bound framebuffer, whose lower left corner is
  // `tileOrigin` of the picture. Blends sRGB values as they are; leaves blending off.
  void draw(glm::ivec2 tileOrigin, glm::ivec2 targetSize);

 private:
  struct Vertex {
    glm::vec2 pixel;   // of the picture, y up
    glm::vec4 shape;   // lines: across, half width, along or -1; letters: texel, 0
    glm::vec4 colour;  // sRGB as displayed, opacity
  };
  struct Placed {
    Glyph glyph;  // its coverage moved into the atlas
    glm::ivec2 texel{0};
  };
  void addLine(const std::vector<glm::dvec2>& path, const DrawnShape& shape);
  void addArea(const std::vector<glm::dvec2>& outline, const Ink& ink);
  void addWords(const DrawnWords& words, double outline, const Ink& ink);
  const Placed& placed(char32_t letter, double size, double outline);
  void triangle(const Vertex& a, const Vertex& b, const Vertex& c, bool letters);
  void uploadAtlas();

  gl::Program lines_, letters_;
  GLuint vertexArray_ = 0;
  gl::Buffer lineVertices_, letterVertices_;
  std::vector<Vertex> lineTriangles_, letterTriangles_;
  double height_ = 0.0;
  std::unique_ptr<Typeface> typeface_;
  std::map<std::tuple<char32_t, int, int>, Placed> placed_;  // letter, size, outline in 1/16 px
  std::vector<std::uint8_t> atlas_;  // rows of a fixed width, as many as the letters need
  glm::ivec2 nextTexel_{0};
  int shelf_ = 0;
  bool atlasChanged_ = false;
  gl::Texture texture_;
};

}  // namespace antumbra
