// A headless context for the tests of one program, made once and current for each of them.
#pragma once

#include <gtest/gtest.h>

#include "gl/context.h"

namespace antumbra::testsupport {

class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    static gl::HeadlessContext context;
    static bool const prepared = (gl::prepareContext(), true);
    (void)prepared;
  }
};

}  // namespace antumbra::testsupport
