#include "eclipse/drawing.h"

#include <fmt/format.h>

namespace antumbra {
namespace {

std::string colour(const Ink& ink) {
  return fmt::format("#{:02x}{:02x}{:02x}", ink.rgb[0], ink.rgb[1], ink.rgb[2]);
}

std::string escaped(const std::string& text) {
  std::string out;
  for (char const c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string svgOf(const Drawing& drawing) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" "
      "font-family=\"{7}, Helvetica, Arial, sans-serif\">\n<title>{2}</title>\n"
      "<defs><clipPath id=\"globe\"><circle cx=\"{3:.2f}\" cy=\"{4:.2f}\" "
      "r=\"{5:.2f}\"/></clipPath>"
      "</defs>\n<rect width=\"{0}\" height=\"{1}\" fill=\"{6}\"/>\n",
      drawing.width, drawing.height, escaped(drawing.title), drawing.clipCentre.x,
      drawing.clipCentre.y, drawing.clipRadius, colour(drawing.background), kFontFamily);
  for (auto const& shape : drawing.shapes) {
    std::string path;
    for (auto const& points : shape.paths) {
      for (std::size_t i = 0; i < points.size(); ++i)
        path += fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', points[i].x, points[i].y);
      if (shape.fill) path += 'Z';
    }
    if (path.empty()) continue;
    out += fmt::format("<path d=\"{}\"", path);
    out += shape.fill ? fmt::format(" fill=\"{}\" fill-opacity=\"{:.2f}\" fill-rule=\"evenodd\"",
                                    colour(*shape.fill), shape.fill->opacity)
                      : std::string(" fill=\"none\"");
    if (shape.line)
      out += fmt::format(
          " stroke=\"{}\" stroke-opacity=\"{:.2f}\" stroke-width=\"{:.2f}\" "
          "stroke-linejoin=\"round\"",
          colour(*shape.line), shape.line->opacity, shape.lineWidth);
    if (shape.dashed) out += fmt::format(" stroke-dasharray=\"{} {}\"", kDashLength, kDashGap);
    if (shape.clipped) out += " clip-path=\"url(#globe)\"";
    out += "/>\n";
  }
  std::string const halo =
      fmt::format(" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{}\" paint-order=\"stroke\"",
                  colour(kHalo), kHaloWidth, kHalo.opacity);
  for (auto const& words : drawing.words) {
    const char* const anchor = words.anchor == DrawnWords::Anchor::Start    ? "start"
                               : words.anchor == DrawnWords::Anchor::Middle ? "middle"
                                                                            : "end";
    out += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" fill=\"{}\" "
        "text-anchor=\"{}\"{}>{}</text>\n",
        words.at.x, words.at.y, words.size, colour(words.ink), anchor, words.halo ? halo : "",
        escaped(words.text));
  }
  return out + "</svg>\n";
}

}  // namespace antumbra
