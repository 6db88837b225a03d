// Tests copies of a depth buffer to depth textures, as shadow maps use them.
#include "state/residency/testing/residency_scene.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state::residency_scene {
namespace {

class ResidencyOfDepthCopies : public Residency {
protected:
  /// Binds a framebuffer object with 24-bit depths, and draws over `rect` with the rasterizer.
  void bindTarget() {
    const auto generate =
        reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(hostFunction("glGenRenderbuffers"));
    const auto storage =
        reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(hostFunction("glRenderbufferStorage"));
    const GLuint framebuffer = framebufferOf(texture(GL_RGBA8, kWidth, kHeight));
    GLuint depth = 0;
    generate(1, &depth);
    gl().BindRenderbuffer(GL_RENDERBUFFER, depth);
    storage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kWidth, kHeight);
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    bindFramebuffer(framebuffer);
    changed();
    gl().ClearDepth(1);
    gl().Clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  }
  void drawDepth(const swrast::Rect &rect, float depth) {
    const char *reason = nullptr;
    const DrawTargets *const targets = residency().describeTargets(reason);
    ASSERT_NE(targets, nullptr) << reason;
    ASSERT_TRUE(residency().acquireTargets(rect, true, false));
    ASSERT_NE(targets->depthStencil, nullptr);
    swrast::fillDepthStencil(*targets->depthStencil, rect, true, depth, 0, 0);
  }
  /// Makes and binds a depth texture.
  GLuint map(GLenum internalFormat, int width, int height) {
    GLuint name = 0;
    gl().GenTextures(1, &name);
    gl().BindTexture(GL_TEXTURE_2D, name);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const std::vector<GLfloat> depths(std::size_t(width) * std::size_t(height), 0.125f);
    gl().TexImage2D(GL_TEXTURE_2D, 0, GLint(internalFormat), width, height, 0, GL_DEPTH_COMPONENT,
                    GL_FLOAT, depths.data());
    changed();
    return name;
  }
  float texel(int x, int y, int width, int height) {
    residency().synchronise("a test reads");
    std::vector<GLfloat> depths(std::size_t(width) * std::size_t(height));
    gl().GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return depths[std::size_t(y * width + x)];
  }
};

TEST_F(ResidencyOfDepthCopies, AWholeCopyMovesNoPixel) {
  bindTarget();
  const GLuint name = map(GL_DEPTH_COMPONENT24, kWidth, kHeight);
  drawDepth({0, 0, kWidth, kHeight}, 0.75f);
  drawDepth({3, 5, 2, 2}, 0.25f);
  CopyToTexture command = {.target = GL_TEXTURE_2D, .width = kWidth, .height = kHeight};
  command.texture = name;
  ASSERT_TRUE(residency().copyToTexture(command));
  EXPECT_EQ(statistics().copiesShared, 1u);
  drawDepth({0, 0, kWidth, kHeight}, 0.5f);
  EXPECT_NEAR(texel(3, 5, kWidth, kHeight), 0.25f, 1e-6f) << "the draw went to the texture too";
  EXPECT_NEAR(texel(5, 5, kWidth, kHeight), 0.75f, 1e-6f);
}

TEST_F(ResidencyOfDepthCopies, APartialCopyKeepsTheRest) {
  bindTarget();
  const GLuint name = map(GL_DEPTH_COMPONENT24, 16, 16);
  drawDepth({0, 0, kWidth, kHeight}, 0.75f);
  CopyToTexture command = {.target = GL_TEXTURE_2D, .width = 4, .height = 4};
  command.texture = name;
  command.destX = 2;
  command.destY = 3;
  ASSERT_TRUE(residency().copyToTexture(command));
  EXPECT_EQ(statistics().copiesInMemory, 1u);
  EXPECT_NEAR(texel(2, 3, 16, 16), 0.75f, 1e-6f);
  EXPECT_NEAR(texel(5, 6, 16, 16), 0.75f, 1e-6f);
  EXPECT_NEAR(texel(6, 6, 16, 16), 0.125f, 1e-6f);
  EXPECT_NEAR(texel(1, 3, 16, 16), 0.125f, 1e-6f);
}

TEST_F(ResidencyOfDepthCopies, WhatConvertsIsTheHosts) {
  bindTarget();
  const GLuint name = map(GL_DEPTH_COMPONENT16, kWidth, kHeight);
  drawDepth({0, 0, kWidth, kHeight}, 0.75f);
  CopyToTexture command = {.target = GL_TEXTURE_2D, .width = kWidth, .height = kHeight};
  command.texture = name;
  EXPECT_FALSE(residency().copyToTexture(command)) << "another layout";
  command.texture = map(GL_DEPTH_COMPONENT24, kWidth, kHeight);
  drawDepth({0, 0, kWidth, kHeight}, 0.75f);
  gl().PixelTransferf(GL_DEPTH_SCALE, 0.5f);
  changed();
  EXPECT_FALSE(residency().copyToTexture(command)) << "PixelTransfer acts on it";
  gl().PixelTransferf(GL_DEPTH_SCALE, 1);
}

} // namespace
} // namespace arbiter::state::residency_scene
