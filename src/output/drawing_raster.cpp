// A drawing made into pixels by Cairo; part of the image module, so that only pictures load it.
#include <cairo/cairo.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "output/image_codec.h"

namespace antumbra {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void dip(cairo_t* pen, const Ink& ink) {
  cairo_set_source_rgba(pen, ink.rgb[0] / 255.0, ink.rgb[1] / 255.0, ink.rgb[2] / 255.0,
                        ink.opacity);
}

void trace(cairo_t* pen, const DrawnShape& shape) {
  cairo_new_path(pen);
  for (auto const& path : shape.paths) {
    cairo_new_sub_path(pen);
    for (auto const& p : path) cairo_line_to(pen, p.x, p.y);
    if (shape.fill) cairo_close_path(pen);
  }
}

void draw(cairo_t* pen, const Drawing& drawing, const DrawnShape& shape) {
  cairo_save(pen);
  cairo_new_path(pen);  // a path outlives both what drew it and the saved state
  if (shape.clipped) {
    cairo_arc(pen, drawing.clipCentre.x, drawing.clipCentre.y, drawing.clipRadius, 0.0, 2.0 * M_PI);
    cairo_clip(pen);
  }
  trace(pen, shape);
  if (shape.fill) {
    dip(pen, *shape.fill);
    cairo_fill_preserve(pen);
  }
  if (shape.line) {
    dip(pen, *shape.line);
    cairo_set_line_width(pen, shape.lineWidth);
    double const dashes[] = {kDashLength, kDashGap};
    cairo_set_dash(pen, dashes, shape.dashed ? 2 : 0, 0.0);
    cairo_stroke(pen);
  }
  cairo_restore(pen);
}

void write(cairo_t* pen, const DrawnWords& words) {
  cairo_set_font_size(pen, words.size);
  cairo_text_extents_t extents;
  cairo_text_extents(pen, words.text.c_str(), &extents);
  double const share = words.anchor == DrawnWords::Anchor::Start    ? 0.0
                       : words.anchor == DrawnWords::Anchor::Middle ? 0.5
                                                                    : 1.0;
  cairo_move_to(pen, words.at.x - share * extents.x_advance, words.at.y);
  cairo_text_path(pen, words.text.c_str());
  if (words.halo) {
    dip(pen, kHalo);
    cairo_set_line_width(pen, kHaloWidth);
    cairo_stroke_preserve(pen);
  }
  dip(pen, words.ink);
  cairo_fill(pen);
}

}  // namespace

std::vector<std::uint8_t> cairoPixels(const Drawing& drawing) {
  Surface const surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, drawing.width, drawing.height),
      cairo_surface_destroy);
  Pen const pen(cairo_create(surface.get()), cairo_destroy);
  dip(pen.get(), drawing.background);
  cairo_paint(pen.get());
  cairo_set_line_join(pen.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_fill_rule(pen.get(), CAIRO_FILL_RULE_EVEN_ODD);
  cairo_select_font_face(pen.get(), kFontFamily, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  for (auto const& shape : drawing.shapes) draw(pen.get(), drawing, shape);
  // Glyphs overlap where letters touch: fill them by winding.
  cairo_set_fill_rule(pen.get(), CAIRO_FILL_RULE_WINDING);
  for (auto const& words : drawing.words) write(pen.get(), words);
  if (auto const status = cairo_status(pen.get()); status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("the drawing failed: ") + cairo_status_to_string(status));
  cairo_surface_flush(surface.get());
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  auto const stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  auto const width = static_cast<std::size_t>(drawing.width);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(width * static_cast<std::size_t>(drawing.height) * 3);
  for (std::size_t y = 0; y < static_cast<std::size_t>(drawing.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t pixel;  // 0xXXRRGGBB in the machine's order
      std::memcpy(&pixel, data + y * stride + 4 * x, sizeof pixel);
      for (int const shift : {16, 8, 0}) rgb.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  return rgb;
}

}  // namespace antumbra
