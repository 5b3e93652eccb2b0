#include "app/error_option.h"

#include <fmt/format.h>

#include "document/document.h"
#include "document/input_error.h"

namespace antumbra {

double errorOption(const std::string& text, double smallest, double largest) {
  std::string number = text;
  bool const percent = !number.empty() && number.back() == '%';
  if (percent) number.pop_back();
  double const error = parseNumber(number, "--stderr") * (percent ? 0.01 : 1.0);
  if (!(error >= smallest && error <= largest))
    throw InputError(fmt::format("--stderr: found {}; allowed: {:g}% to {:g}%", text,
                                 100.0 * smallest, 100.0 * largest));
  return error;
}

}  // namespace antumbra
