// A drawing of filled areas, lines and words, in pixels with y down: written as SVG here, made into
// pixels elsewhere.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace antumbra {

// Words are set in this family, dashes and halos drawn to these measures in pixels, by every
// writer.
inline constexpr const char* kFontFamily = "DejaVu Sans";
inline constexpr double kDashLength = 6.0, kDashGap = 4.0, kHaloWidth = 3.0;

struct Ink {
  std::array<int, 3> rgb{0, 0, 0};
  double opacity = 1.0;
};

inline constexpr Ink kHalo{{255, 255, 255}, 0.8};

struct DrawnShape {
  std::vector<std::vector<glm::dvec2>> paths;
  std::optional<Ink> fill;  // even-odd, each path closed
  std::optional<Ink> line;
  double lineWidth = 1.0;
  bool dashed = false;
  bool clipped = true;  // to the drawing's circle
};

struct DrawnWords {
  std::string text = {};
  glm::dvec2 at{0.0};  // baseline
  double size = 14.0;
  Ink ink = {};
  enum class Anchor { Start, Middle, End } anchor = Anchor::Start;
  bool halo = false;
};

struct Drawing {
  int width = 0, height = 0;
  Ink background{{255, 255, 255}, 1.0};
  glm::dvec2 clipCentre{0.0};
  double clipRadius = 0.0;
  std::string title;
  std::vector<DrawnShape> shapes;  // in this order
  std::vector<DrawnWords> words;   // above all shapes
};

std::string svgOf(const Drawing& drawing);

}  // namespace antumbra
