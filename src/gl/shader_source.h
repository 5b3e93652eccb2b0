// GLSL from files under shaders/, with `#include "path"` resolved there and error messages that
// name the file. An include may stand under a condition; files guard themselves against a second
// one. Entry points name their parts; no text is generated but the version, the definitions and the
// line marks.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace antumbra::gl {

// `-D` of a shader: a name and its value ("" for a flag).
using Definitions = std::vector<std::pair<std::string, std::string>>;

struct ShaderSource {
  std::string text;                // ready for glShaderSource
  std::vector<std::string> files;  // in order of inclusion
};

// `path` is relative to shaders/, as "passes/body.frag". Throws InputError naming the including
// file and line if a file is missing.
ShaderSource loadShader(const std::string& path, const Definitions& definitions = {});

// A compiler's log with its line marks turned into "file:line".
std::string explainLog(const std::string& log, const ShaderSource& source);

}  // namespace antumbra::gl
