// The letters of labels: catalogs/fonts/dejavu_sans.ttf through FreeType, as coverage of pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace antumbra {

// Coverage of one letter, first row at the top.
struct Glyph {
  int width = 0, height = 0;
  int left = 0;  // from the pen to the first column, pixels
  int top = 0;   // from the baseline up to the first row's upper edge, pixels
  double advance = 0.0;
  std::vector<std::uint8_t> coverage;
};

class Typeface {
 public:
  // Throws InputError naming the file if it is missing or no font.
  Typeface();
  ~Typeface();
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;

  // `size` is the em in pixels; `outline` > 0 widens the letter by so many pixels all round, for
  // halos. A letter that the font does not hold is an empty box.
  Glyph glyph(char32_t letter, double size, double outline = 0.0) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Letters of a text in UTF-8; what is malformed is left out.
std::u32string lettersOf(const std::string& utf8);

}  // namespace antumbra
