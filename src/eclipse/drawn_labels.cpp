#include "eclipse/drawn_labels.h"

#include <algorithm>

namespace antumbra {
namespace {

// DejaVu Sans, in units of its size: the mean advance of lower-case English text is 0.58, of digits
// 0.64; capitals rise 0.73, descenders fall 0.24 (the font's own metrics).
constexpr double kAdvance = 0.62, kRise = 0.73, kFall = 0.24;

std::size_t letters(const std::string& utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

double DrawnLabels::lengthOf(const DrawnWords& words) {
  return kAdvance * words.size * static_cast<double>(letters(words.text));
}

bool DrawnLabels::place(DrawnWords words, const std::vector<Place>& places) {
  double const width = lengthOf(words);
  for (auto const& [at, anchor] : places) {
    double const before = anchor == DrawnWords::Anchor::Start    ? 0.0
                          : anchor == DrawnWords::Anchor::Middle ? 0.5 * width
                                                                 : width;
    Box const box{at + glm::dvec2(-before - 2.0, -kRise * words.size - 2.0),
                  at + glm::dvec2(width - before + 2.0, kFall * words.size + 2.0)};
    bool const inside = std::ranges::all_of(
        std::vector{box.least, box.most, glm::dvec2(box.least.x, box.most.y),
                    glm::dvec2(box.most.x, box.least.y)},
        [&](glm::dvec2 corner) {
          if (drawing_.clipRadius <= 0.0)
            return corner.x > 0.0 && corner.y > 0.0 && corner.x < drawing_.width &&
                   corner.y < drawing_.height;
          return glm::length(corner - drawing_.clipCentre) < drawing_.clipRadius;
        });
    bool const free = std::ranges::none_of(taken_, [&](const Box& other) {
      return box.least.x < other.most.x && other.least.x < box.most.x &&
             box.least.y < other.most.y && other.least.y < box.most.y;
    });
    if (!inside || !free) continue;
    words.at = at;
    words.anchor = anchor;
    drawing_.words.push_back(std::move(words));
    taken_.push_back(box);
    return true;
  }
  return false;
}

}  // namespace antumbra
