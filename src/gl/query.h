// Asynchronous queries: begun now, read in a later frame, never a stall unless one is asked for.
#pragma once

#include <cstdint>
#include <optional>

#include "gl/api.h"

namespace antumbra::gl {

class Query {
 public:
  // `kind` is GL_SAMPLES_PASSED or GL_TIME_ELAPSED.
  explicit Query(GLenum kind);
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  void begin();
  void end();
  bool pending() const { return pending_; }
  // The result if the device has it, without waiting.
  std::optional<std::uint64_t> poll();
  // Waits for the result. Must have been begun and ended.
  std::uint64_t wait();

 private:
  GLenum kind_;
  GLuint id_ = 0;
  bool pending_ = false;
};

}  // namespace antumbra::gl
