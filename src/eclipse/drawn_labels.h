// Words put on a drawing where they are free of each other, the more important first.
#pragma once

#include <string>
#include <vector>

#include "eclipse/drawing.h"

namespace antumbra {

class DrawnLabels {
 public:
  // A baseline's point and the side of the words that stands on it.
  struct Place {
    glm::dvec2 at;
    DrawnWords::Anchor anchor = DrawnWords::Anchor::Start;
  };

  explicit DrawnLabels(Drawing& drawing) : drawing_(drawing) {}

  // Writes `words` at the first of `places` where its box keeps 2 pixels from all boxes
  // taken so far and lies within the drawing's circle (without one, within the drawing); false, and
  // nothing written, if there is none.
  bool place(DrawnWords words, const std::vector<Place>& places);
  // Keeps words away from a rectangle.
  void keepFree(glm::dvec2 least, glm::dvec2 most) { taken_.push_back({least, most}); }
  // Estimate of the words' length in pixels.
  static double lengthOf(const DrawnWords& words);

 private:
  struct Box {
    glm::dvec2 least, most;
  };
  Drawing& drawing_;
  std::vector<Box> taken_;
};

}  // namespace antumbra
