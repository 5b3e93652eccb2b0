// Processor time: what a piece of work costs, whatever else the machine does.
#pragma once

#include <ctime>

namespace antumbra {

inline double secondsOfClock(clockid_t clock) {
  timespec now;
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Of this thread.
inline double threadMicroseconds() { return 1e6 * secondsOfClock(CLOCK_THREAD_CPUTIME_ID); }
// Of all threads of this program.
inline double processorSeconds() { return secondsOfClock(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace antumbra
