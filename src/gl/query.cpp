#include "gl/query.h"

namespace antumbra::gl {

Query::Query(GLenum kind) : kind_(kind) { glCreateQueries(kind, 1, &id_); }
Query::~Query() { glDeleteQueries(1, &id_); }

void Query::begin() { glBeginQuery(kind_, id_); }
void Query::end() {
  glEndQuery(kind_);
  pending_ = true;
}

std::optional<std::uint64_t> Query::poll() {
  if (!pending_) return std::nullopt;
  GLint available = 0;
  glGetQueryObjectiv(id_, GL_QUERY_RESULT_AVAILABLE, &available);
  if (!available) return std::nullopt;
  return wait();
}

std::uint64_t Query::wait() {
  GLuint64 result = 0;
  glGetQueryObjectui64v(id_, GL_QUERY_RESULT, &result);
  pending_ = false;
  return result;
}

}  // namespace antumbra::gl
