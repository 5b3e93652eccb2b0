// Processor time of this thread: what a piece of work costs, whatever else the machine does.
#pragma once

#include <ctime>

namespace antumbra {

inline double threadMicroseconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
}

}  // namespace antumbra
