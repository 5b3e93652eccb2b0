// --stderr: the standard error at which the path tracer stops.
#pragma once

#include <string>

namespace antumbra {

// "0.5%" or the share 0.005, in [smallest, largest] (shares). Throws InputError.
double errorOption(const std::string& text, double smallest, double largest);

}  // namespace antumbra
