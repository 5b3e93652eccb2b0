// No usable graphics device: the program exits with status 3. The message names what was tried.
#pragma once

#include <stdexcept>

namespace antumbra {

class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace antumbra
