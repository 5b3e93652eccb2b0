// The one exception for bad input: what a user wrote, where, what was found and what is allowed.
// Commands print it as it is and exit with status 2.
#pragma once

#include <stdexcept>
#include <string>

namespace antumbra {

class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace antumbra
