#include "passes/typeface.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_STROKER_H
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "document/input_error.h"
#include "document/paths.h"

namespace antumbra {
namespace {

void require(FT_Error error, const char* what) {
  if (error) throw std::runtime_error(fmt::format("FreeType: {} failed ({})", what, error));
}

}  // namespace

struct Typeface::State {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  FT_Stroker stroker = nullptr;
};

Typeface::Typeface() : state_(std::make_unique<State>()) {
  auto const file = catalogsFolder() / "fonts" / "dejavu_sans.ttf";
  require(FT_Init_FreeType(&state_->library), "its start");
  if (FT_New_Face(state_->library, file.c_str(), 0, &state_->face) != 0) {
    FT_Done_FreeType(state_->library);
    throw InputError(fmt::format("{}: missing or no font", file.string()));
  }
  require(FT_Stroker_New(state_->library, &state_->stroker), "the outliner");
}

Typeface::~Typeface() {
  FT_Stroker_Done(state_->stroker);
  FT_Done_Face(state_->face);
  FT_Done_FreeType(state_->library);
}

Glyph Typeface::glyph(char32_t letter, double size, double outline) const {
  FT_Face const face = state_->face;
  // FreeType counts in 64ths of a pixel.
  auto const in64ths = [](double pixels) { return std::lround(64.0 * pixels); };
  require(FT_Set_Char_Size(face, in64ths(size), 0, 72, 72), "setting the size");
  require(FT_Load_Char(face, letter, FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT), "a letter");
  Glyph glyph;
  glyph.advance = static_cast<double>(face->glyph->linearHoriAdvance) / 65536.0;
  FT_Glyph drawn = nullptr;
  require(FT_Get_Glyph(face->glyph, &drawn), "copying a letter");
  if (outline > 0.0) {
    FT_Stroker_Set(state_->stroker, in64ths(outline), FT_STROKER_LINECAP_ROUND,
                   FT_STROKER_LINEJOIN_ROUND, 0);
    require(FT_Glyph_StrokeBorder(&drawn, state_->stroker, 0, 1), "outlining a letter");
  }
  require(FT_Glyph_To_Bitmap(&drawn, FT_RENDER_MODE_NORMAL, nullptr, 1), "drawing a letter");
  auto const* const bitmap = reinterpret_cast<FT_BitmapGlyph>(drawn);
  glyph.width = static_cast<int>(bitmap->bitmap.width);
  glyph.height = static_cast<int>(bitmap->bitmap.rows);
  glyph.left = bitmap->left;
  glyph.top = bitmap->top;
  for (int row = 0; row < glyph.height; ++row) {
    const std::uint8_t* const from = bitmap->bitmap.buffer + row * bitmap->bitmap.pitch;
    glyph.coverage.insert(glyph.coverage.end(), from, from + glyph.width);
  }
  FT_Done_Glyph(drawn);
  return glyph;
}

std::u32string lettersOf(const std::string& utf8) {
  std::u32string letters;
  for (std::size_t i = 0; i < utf8.size();) {
    auto const lead = static_cast<unsigned char>(utf8[i++]);
    int const more = lead < 0x80       ? 0
                     : lead >> 5 == 6  ? 1
                     : lead >> 4 == 14 ? 2
                     : lead >> 3 == 30 ? 3
                                       : -1;
    if (more < 0) continue;
    char32_t letter = more == 0 ? lead : lead & (0x3Fu >> more);
    for (int k = 0; k < more && i < utf8.size(); ++k)
      letter = letter << 6 | (static_cast<unsigned char>(utf8[i++]) & 0x3Fu);
    letters += letter;
  }
  return letters;
}

}  // namespace antumbra
