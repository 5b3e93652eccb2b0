#include "output/drawing_raster.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace antumbra {
namespace {

// Strokes on a grid four wide and six high, as pairs of digits x, y from the lower left; a space
// lifts the pen.
const std::map<char32_t, std::string_view>& alphabet() {
  static const std::map<char32_t, std::string_view> strokes{
      {U'A', "0004264440 0242"},
      {U'B', "00063645443303 3342413000"},
      {U'C', "4536160501103041"},
      {U'D', "00062644422000"},
      {U'E', "46060040 0333"},
      {U'F', "460600 0333"},
      {U'G', "45361605011030414323"},
      {U'H', "0006 4046 0343"},
      {U'I', "2026 1030 1636"},
      {U'J', "4641301001"},
      {U'K', "0006 4602 1340"},
      {U'L', "060040"},
      {U'M', "0006234640"},
      {U'N', "00064046"},
      {U'O', "100105163645413010"},
      {U'P', "00063645443303"},
      {U'Q', "100105163645413010 2240"},
      {U'R', "00063645443303 2340"},
      {U'S', "453616050413334241301001"},
      {U'T', "2026 0646"},
      {U'U', "060110304146"},
      {U'V', "062046"},
      {U'W', "0610243046"},
      {U'X', "0046 0640"},
      {U'Y', "062346 2320"},
      {U'Z', "06460040"},
      {U'0', "100105163645413010"},
      {U'1', "152620 1030"},
      {U'2', "05163645440040"},
      {U'3', "0516364544334241301001 1333"},
      {U'4', "30360242"},
      {U'5', "460604344341301001"},
      {U'6', "4536160501103041423303"},
      {U'7', "064610"},
      {U'8', "13040516364544331302011030414233"},
      {U'9', "0110304145361605041343"},
      {U'.', "2021"},
      {U',', "2110"},
      {U':', "2122 2425"},
      {U';', "2110 2425"},
      {U'-', "1333"},
      {U'+', "1333 2224"},
      {U'=', "1232 1434"},
      {U'%', "0046 0616 3040"},
      {U'/', "0046"},
      {U'(', "36252130"},
      {U')', "16252110"},
      {U'\'', "2625"},
      {U'"', "1615 3635"},
      {U'°', "1605142516"}};
  return strokes;
}

std::u32string capitals(const std::string& utf8) {
  std::u32string out;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    auto const c = static_cast<unsigned char>(utf8[i]);
    if (c == 0xC2 && i + 1 < utf8.size()) {
      out += static_cast<char32_t>(static_cast<unsigned char>(utf8[++i]));
    } else if (c < 0x80) {
      out += static_cast<char32_t>(c >= 'a' && c <= 'z' ? c - 32 : c);
    }
  }
  return out;
}

class Canvas {
 public:
  explicit Canvas(const Drawing& d)
      : width_(d.width),
        height_(d.height),
        centre_(d.clipCentre),
        radius_(d.clipRadius),
        rgb_(static_cast<std::size_t>(d.width * d.height) * 3),
        cover_(static_cast<std::size_t>(d.width * d.height)) {
    for (std::size_t i = 0; i < rgb_.size(); ++i) rgb_[i] = d.background.rgb[i % 3];
  }

  void fill(const std::vector<std::vector<glm::dvec2>>& paths, const Ink& ink, bool clipped) {
    begin();
    constexpr int kRows = 4;
    double top = height_, bottom = 0.0;
    for (auto const& path : paths)
      for (auto const& p : path) top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    int const first = std::max(0, static_cast<int>(top));
    int const last = std::min(height_ - 1, static_cast<int>(bottom));
    // Crossings of each line of samples, collected edge by edge.
    std::vector<std::vector<double>> crossings(
        static_cast<std::size_t>(std::max(last - first + 1, 0) * kRows));
    for (auto const& path : paths) {
      for (std::size_t i = 0, j = path.size() - 1; i < path.size(); j = i++) {
        glm::dvec2 a = path[j], b = path[i];
        if (a.y > b.y) std::swap(a, b);
        int const from = std::max(0, static_cast<int>(std::ceil((a.y - first) * kRows - 0.5)));
        int const to = std::min(static_cast<int>(crossings.size()) - 1,
                                static_cast<int>(std::ceil((b.y - first) * kRows - 0.5)) - 1);
        for (int row = from; row <= to; ++row) {
          double const y = first + (row + 0.5) / kRows;
          crossings[static_cast<std::size_t>(row)].push_back(a.x +
                                                             (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
      }
    }
    for (std::size_t row = 0; row < crossings.size(); ++row) {
      auto& xs = crossings[row];
      std::sort(xs.begin(), xs.end());
      int const y = first + static_cast<int>(row) / kRows;
      for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
        double const from = std::clamp(xs[i], 0.0, static_cast<double>(width_));
        double const to = std::clamp(xs[i + 1], 0.0, static_cast<double>(width_));
        for (int x = static_cast<int>(from); x < std::min(width_, static_cast<int>(std::ceil(to)));
             ++x)
          touch(x, y) +=
              static_cast<float>((std::min(to, x + 1.0) - std::max(from, x + 0.0)) / kRows);
      }
    }
    blend(ink, clipped);
  }

  void stroke(const std::vector<std::vector<glm::dvec2>>& paths, double lineWidth, bool dashed,
              const Ink& ink, bool clipped) {
    begin();
    for (auto const& path : paths) {
      double travelled = 0.0;
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        segment(path[i], path[i + 1], 0.5 * lineWidth, dashed ? travelled : -1.0);
        travelled += glm::length(path[i + 1] - path[i]);
      }
    }
    blend(ink, clipped);
  }

  void write(const DrawnWords& words) {
    std::u32string const text = capitals(words.text);
    double const unit = words.size / 9.0;
    double const advance = 5.6 * unit;
    double x = words.at.x;
    double const total = advance * static_cast<double>(text.size());
    if (words.anchor == DrawnWords::Anchor::Middle) x -= 0.5 * total;
    if (words.anchor == DrawnWords::Anchor::End) x -= total;
    std::vector<std::vector<glm::dvec2>> strokes;
    for (char32_t const c : text) {
      auto const glyph = alphabet().find(c);
      if (glyph != alphabet().end()) {
        std::vector<glm::dvec2> stroke;
        std::string_view const code = glyph->second;
        for (std::size_t i = 0; i < code.size();) {
          if (code[i] == ' ') {
            strokes.push_back(std::move(stroke));
            stroke.clear();
            ++i;
            continue;
          }
          if (i + 1 >= code.size()) break;
          stroke.emplace_back(x + unit * (code[i] - '0'), words.at.y - unit * (code[i + 1] - '0'));
          i += 2;
        }
        strokes.push_back(std::move(stroke));
      }
      x += advance;
    }
    double const width = std::max(0.13 * words.size, 1.0);
    if (words.halo) stroke(strokes, width + 3.0, false, Ink{{255, 255, 255}, 0.75}, false);
    stroke(strokes, width, false, words.ink, false);
  }

  std::vector<std::uint8_t> pixels() const {
    std::vector<std::uint8_t> out(rgb_.size());
    for (std::size_t i = 0; i < rgb_.size(); ++i)
      out[i] = static_cast<std::uint8_t>(std::clamp(std::lround(rgb_[i]), 0L, 255L));
    return out;
  }

 private:
  void begin() {
    for (std::size_t const i : touched_) cover_[i] = 0.0F;
    touched_.clear();
  }
  float& touch(int x, int y) {
    auto const i = static_cast<std::size_t>(y * width_ + x);
    if (cover_[i] == 0.0F) touched_.push_back(i);
    return cover_[i];
  }
  // `phase` is the length already travelled along a dashed line, or negative for a full one.
  void segment(glm::dvec2 a, glm::dvec2 b, double half, double phase) {
    double const length = glm::length(b - a);
    double const reach = half + 1.0;
    int const left = std::max(0, static_cast<int>(std::min(a.x, b.x) - reach));
    int const right = std::min(width_ - 1, static_cast<int>(std::max(a.x, b.x) + reach));
    int const top = std::max(0, static_cast<int>(std::min(a.y, b.y) - reach));
    int const bottom = std::min(height_ - 1, static_cast<int>(std::max(a.y, b.y) + reach));
    if (length > 4.0 * width_) return;
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        glm::dvec2 const p(x + 0.5, y + 0.5);
        double const along =
            length > 0.0 ? std::clamp(glm::dot(p - a, b - a) / length, 0.0, length) : 0.0;
        if (phase >= 0.0 && std::fmod(phase + along, 10.0) > 6.0) continue;
        glm::dvec2 const nearest = length > 0.0 ? a + (b - a) * (along / length) : a;
        double const cover =
            std::clamp(half + 0.5 - glm::length(p - nearest), 0.0, 1.0) * std::min(1.0, 2.0 * half);
        if (cover <= 0.0) continue;
        float& value = touch(x, y);
        value = std::max(value, static_cast<float>(cover));
      }
    }
  }
  void blend(const Ink& ink, bool clipped) {
    for (std::size_t const i : touched_) {
      double cover = std::min(static_cast<double>(cover_[i]), 1.0) * ink.opacity;
      if (clipped) {
        glm::dvec2 const p(static_cast<double>(i % static_cast<std::size_t>(width_)) + 0.5,
                           static_cast<double>(i / static_cast<std::size_t>(width_)) + 0.5);
        cover *= std::clamp(radius_ + 0.5 - glm::length(p - centre_), 0.0, 1.0);
      }
      for (std::size_t c = 0; c < 3; ++c) rgb_[3 * i + c] += cover * (ink.rgb[c] - rgb_[3 * i + c]);
    }
  }

  int width_, height_;
  glm::dvec2 centre_;
  double radius_;
  std::vector<double> rgb_;
  std::vector<float> cover_;
  std::vector<std::size_t> touched_;
};

}  // namespace

std::vector<std::uint8_t> rasterised(const Drawing& drawing) {
  Canvas canvas(drawing);
  for (auto const& shape : drawing.shapes) {
    if (shape.fill) canvas.fill(shape.paths, *shape.fill, shape.clipped);
    if (shape.line)
      canvas.stroke(shape.paths, shape.lineWidth, shape.dashed, *shape.line, shape.clipped);
  }
  for (auto const& words : drawing.words) canvas.write(words);
  return canvas.pixels();
}

}  // namespace antumbra
