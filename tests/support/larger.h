// The larger of two errors; one that is no number fails the test, which std::max would pass over.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace antumbra::testsupport {

inline double larger(double worst, double error) {
  EXPECT_TRUE(std::isfinite(error));
  return std::max(worst, error);
}

}  // namespace antumbra::testsupport
