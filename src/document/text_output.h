// Tables as text to standard output or to a file that is whole or absent (temporary file, renamed).
#pragma once

#include <string>

namespace antumbra {

// `file` empty or "-": standard output. Throws InputError (naming -o) if the file cannot be
// written.
void writeTextFile(const std::string& file, const std::string& content);

}  // namespace antumbra
