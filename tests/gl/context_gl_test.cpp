// The headless context, programs with includes, textures and queries.
#include "gl/context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "document/input_error.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/query.h"
#include "tests/support/gl_fixture.h"

namespace antumbra {
namespace {

using GlTest = testsupport::GlTest;

TEST_F(GlTest, IsAtLeastVersion45) {
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(major * 10 + minor, 45) << gl::describeDevice().version;
}

TEST_F(GlTest, TexturesKeepFloats) {
  auto texture = gl::Texture::plane(GL_RGBA32F, 2, 1);
  std::vector<float> const texels{1.6e9f, 1e-5f, 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f};
  texture.upload(texels, 4);
  EXPECT_EQ(texture.readRgba(), texels);
  EXPECT_EQ(texture.bytes(), 32u);
}

TEST_F(GlTest, MissingShaderNamesItsPath) {
  EXPECT_THAT([] { gl::Program::fullScreen("passes/nothing.frag"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("passes/nothing.frag")));
}

TEST_F(GlTest, CompilerErrorsNameFileAndLine) {
  auto const source = gl::loadShader("interface/view.glsl");
  ASSERT_GE(source.files.size(), 2u);
  EXPECT_EQ(gl::explainLog("0:100007(3): error: x", source),
            "shaders/" + source.files[1] + ":7(3): error: x\n");
  EXPECT_EQ(gl::explainLog("0:9: error: y", source), "shaders/interface/view.glsl:9: error: y\n");
}

TEST_F(GlTest, QueryCountsTheSamplesOfATriangle) {
  auto const target = gl::Texture::plane(GL_RGBA16F, 16, 8);
  gl::Framebuffer const framebuffer({&target});
  framebuffer.bind();
  auto const program = gl::Program::fullScreen("bench/fill_unit.frag");
  program.use();
  gl::Query query(GL_SAMPLES_PASSED);
  query.begin();
  gl::drawFullScreen();
  query.end();
  EXPECT_TRUE(query.pending());
  EXPECT_EQ(query.wait(), 128u);
}

TEST(ContextChoice, RefusesAnUnknownPlatform) {
  setenv("ANTUMBRA_EGL", "window", 1);
  EXPECT_THROW(gl::HeadlessContext{}, InputError);
  unsetenv("ANTUMBRA_EGL");
}

}  // namespace
}  // namespace antumbra
