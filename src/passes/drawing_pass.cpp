#include "passes/drawing_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace antumbra {
namespace {

constexpr int kAtlasWidth = 2048;  // texels: wider than a letter of the largest picture
constexpr int kKeptRows = 1024;    // of letters from earlier drawings
constexpr double kSharpest = 0.5;  // cosine of a bend that is still mitred
constexpr double kFeather = 1.0;   // pixels of a line's edge beyond its half width
constexpr Ink kDarkHalo{{6, 8, 16}, 0.75};

glm::vec4 colourOf(const Ink& ink) {
  return {glm::vec3(ink.rgb[0], ink.rgb[1], ink.rgb[2]) / 255.0f, static_cast<float>(ink.opacity)};
}

glm::dvec2 leftOf(glm::dvec2 along) { return {-along.y, along.x}; }

}  // namespace

DrawingPass::DrawingPass()
    : lines_(gl::Program::render("passes/drawing.vert", "passes/drawing.frag")),
      letters_(
          gl::Program::render("passes/drawing.vert", "passes/drawing.frag", {{"LETTERS", ""}})) {
  glCreateVertexArrays(1, &vertexArray_);
  struct {
    int components;
    std::size_t offset;
  } const attributes[] = {
      {2, offsetof(Vertex, pixel)}, {4, offsetof(Vertex, shape)}, {4, offsetof(Vertex, colour)}};
  for (GLuint i = 0; i < 3; ++i) {
    glEnableVertexArrayAttrib(vertexArray_, i);
    glVertexArrayAttribFormat(vertexArray_, i, attributes[i].components, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(attributes[i].offset));
    glVertexArrayAttribBinding(vertexArray_, i, 0);
  }
}

DrawingPass::~DrawingPass() { glDeleteVertexArrays(1, &vertexArray_); }

void DrawingPass::triangle(const Vertex& a, const Vertex& b, const Vertex& c, bool letters) {
  auto& list = letters ? letterTriangles_ : lineTriangles_;
  list.insert(list.end(), {a, b, c});
}

void DrawingPass::addLine(const std::vector<glm::dvec2>& given, const DrawnShape& shape) {
  std::vector<glm::dvec2> path;
  for (auto const& p : given)
    if (path.empty() || glm::length(p - path.back()) > 1e-3) path.push_back(p);
  if (path.size() < 2) return;
  bool const closed = path.size() > 3 && glm::length(given.front() - given.back()) < 1e-6;
  double const half = 0.5 * shape.lineWidth, reach = half + kFeather;
  glm::vec4 const colour = colourOf(*shape.line);
  auto const vertex = [&](glm::dvec2 p, double across, double along) {
    return Vertex{glm::vec2(p), glm::vec4(across, half, shape.dashed ? along : -1.0, 0.0), colour};
  };
  std::size_t const count = path.size();
  double along = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    glm::dvec2 const a = path[i], b = path[i + 1];
    double const length = glm::length(b - a);
    glm::dvec2 const here = (b - a) / length;
    // Sides meet on the bisector of a bend, unless it is sharp.
    auto const side = [&](std::size_t before, std::size_t at, std::size_t after) {
      glm::dvec2 const in = glm::normalize(path[at] - path[before]);
      glm::dvec2 const out = glm::normalize(path[after] - path[at]);
      double const cosine = glm::dot(in, out);
      if (cosine < kSharpest) return leftOf(here);
      return leftOf(in + out) / (1.0 + cosine);
    };
    glm::dvec2 const first = i > 0    ? side(i - 1, i, i + 1)
                             : closed ? side(count - 2, 0, 1)
                                      : leftOf(here);
    glm::dvec2 const second = i + 2 < count ? side(i, i + 1, i + 2)
                              : closed      ? side(count - 2, count - 1, 1)
                                            : leftOf(here);
    Vertex const corners[4] = {vertex(a - reach * first, -reach, along),
                               vertex(a + reach * first, reach, along),
                               vertex(b - reach * second, -reach, along + length),
                               vertex(b + reach * second, reach, along + length)};
    triangle(corners[0], corners[1], corners[2], false);
    triangle(corners[2], corners[1], corners[3], false);
    along += length;
  }
}

void DrawingPass::addArea(const std::vector<glm::dvec2>& outline, const Ink& ink) {
  // A fan whose rim is half a pixel outside the outline; `across` falls from the inside to there.
  std::size_t const count = outline.size();
  if (count < 3) return;
  glm::dvec2 middle(0.0);
  for (auto const& p : outline) middle += p / static_cast<double>(count);
  glm::vec4 const colour = colourOf(ink);
  auto const vertex = [&](glm::dvec2 p, double beyond) {
    return Vertex{glm::vec2(p), glm::vec4(std::max(beyond, 0.0), 0.0, -2.0, 0.0), colour};
  };
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec2 const a = outline[i], b = outline[(i + 1) % count];
    if (glm::length(b - a) < 1e-6) continue;
    auto const outward = [&](glm::dvec2 p) {
      glm::dvec2 const off = p - middle;
      double const length = glm::length(off);
      return length > 1e-6 ? off / length : glm::dvec2(0.0);
    };
    Vertex const innerA = vertex(a - 0.5 * outward(a), 0.0),
                 outerA = vertex(a + 0.5 * outward(a), 1.0);
    Vertex const innerB = vertex(b - 0.5 * outward(b), 0.0),
                 outerB = vertex(b + 0.5 * outward(b), 1.0);
    triangle(vertex(middle, 0.0), innerA, innerB, false);
    triangle(innerA, outerA, innerB, false);
    triangle(innerB, outerA, outerB, false);
  }
}

const DrawingPass::Placed& DrawingPass::placed(char32_t letter, double size, double outline) {
  auto const key = std::tuple(letter, static_cast<int>(std::lround(16.0 * size)),
                              static_cast<int>(std::lround(16.0 * outline)));
  auto const found = placed_.find(key);
  if (found != placed_.end()) return found->second;
  if (!typeface_) typeface_ = std::make_unique<Typeface>();
  Placed made;
  made.glyph = typeface_->glyph(letter, size, outline);
  int const width = made.glyph.width, height = made.glyph.height;
  if (nextTexel_.x + width > kAtlasWidth) nextTexel_ = {0, nextTexel_.y + shelf_}, shelf_ = 0;
  made.texel = nextTexel_;
  auto const end = static_cast<std::size_t>(made.texel.y + height) * kAtlasWidth;
  if (atlas_.size() < end) atlas_.resize(end, 0);
  for (int row = 0; row < height; ++row)
    std::copy_n(made.glyph.coverage.begin() + row * width, width,
                atlas_.begin() + (made.texel.y + row) * kAtlasWidth + made.texel.x);
  made.glyph.coverage.clear();
  nextTexel_.x += width + 1;
  shelf_ = std::max(shelf_, height + 1);
  atlasChanged_ = true;
  return placed_[key] = std::move(made);
}

void DrawingPass::addWords(const DrawnWords& words, double outline, const Ink& ink) {
  std::u32string const letters = lettersOf(words.text);
  double total = 0.0;
  for (char32_t const letter : letters) total += placed(letter, words.size, 0.0).glyph.advance;
  double pen = words.at.x - (words.anchor == DrawnWords::Anchor::Start    ? 0.0
                             : words.anchor == DrawnWords::Anchor::Middle ? 0.5 * total
                                                                          : total);
  double const baseline = height_ - std::round(words.at.y);
  glm::vec4 const colour = colourOf(ink);
  for (char32_t const letter : letters) {
    Placed const& p = placed(letter, words.size, outline);
    double const x = std::round(pen) + p.glyph.left, y = baseline + p.glyph.top;
    auto const corner = [&](int right, int down) {
      double const dx = right * p.glyph.width, dy = down * p.glyph.height;
      return Vertex{glm::vec2(x + dx, y - dy), glm::vec4(p.texel.x + dx, p.texel.y + dy, 0.0, 0.0),
                    colour};
    };
    triangle(corner(0, 0), corner(1, 0), corner(0, 1), true);
    triangle(corner(0, 1), corner(1, 0), corner(1, 1), true);
    pen += placed(letter, words.size, 0.0).glyph.advance;
  }
}

void DrawingPass::prepare(const Drawing& drawing) {
  lineTriangles_.clear();
  letterTriangles_.clear();
  height_ = drawing.height;
  if (nextTexel_.y > kKeptRows) {
    atlas_.clear();
    placed_.clear();
    nextTexel_ = {0, 0};
    shelf_ = 0;
  }
  for (auto const& shape : drawing.shapes)
    for (auto path : shape.paths) {
      for (auto& p : path) p.y = height_ - p.y;
      if (shape.fill) addArea(path, *shape.fill);
      if (shape.line) addLine(path, shape);
    }
  for (auto const& words : drawing.words)
    if (words.halo) addWords(words, std::max(1.2, 0.11 * words.size), kDarkHalo);
  for (auto const& words : drawing.words) addWords(words, 0.0, words.ink);
  lineVertices_.write(std::span<const Vertex>(lineTriangles_), GL_STREAM_DRAW);
  letterVertices_.write(std::span<const Vertex>(letterTriangles_), GL_STREAM_DRAW);
  if (letterTriangles_.empty() || !atlasChanged_) return;
  uploadAtlas();
}

void DrawingPass::uploadAtlas() {
  // Twice the rows at each growth, so that few textures are made.
  int const rows = static_cast<int>(std::bit_ceil(atlas_.size() / kAtlasWidth));
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (rows > most)
    throw std::runtime_error(
        fmt::format("the words of the overlays are too large for this device: their letters take "
                    "{} rows of {} texels, allowed are {}; choose a smaller text_size",
                    rows, kAtlasWidth, most));
  atlas_.resize(static_cast<std::size_t>(rows) * kAtlasWidth, 0);
  if (!texture_ || texture_.height() < rows)
    texture_ = gl::Texture::plane(GL_R8, kAtlasWidth, rows, gl::Filter::Nearest);
  atlas_.resize(static_cast<std::size_t>(texture_.height()) * kAtlasWidth, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  texture_.upload(std::span<const unsigned char>(atlas_), 1);
  atlasChanged_ = false;
}

void DrawingPass::draw(glm::ivec2 tileOrigin, glm::ivec2 targetSize) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  GLint previousArray = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &previousArray);
  glBindVertexArray(vertexArray_);
  auto const drawList = [&](const gl::Program& program, const gl::Buffer& vertices,
                            std::size_t count) {
    if (count == 0) return;
    glVertexArrayVertexBuffer(vertexArray_, 0, vertices.id(), 0, sizeof(Vertex));
    program.set("tileOrigin", glm::vec2(tileOrigin)).set("targetSize", glm::vec2(targetSize)).use();
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count));
  };
  drawList(lines_, lineVertices_, lineTriangles_.size());
  if (texture_) texture_.bind(0);
  drawList(letters_, letterVertices_, letterTriangles_.size());
  glBindVertexArray(static_cast<GLuint>(previousArray));
  glDisable(GL_BLEND);
}

}  // namespace antumbra
