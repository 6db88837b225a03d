// Tests residency against the real host: textures, renderbuffers and depth buffers.
#include <functional>

#include "host/handlers.h"
#include "state/context/context.h"
#include "state/raster_draw/context_state.h"
#include "state/residency/residency.h"
#include "state/residency/testing/residency_scene.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state::residency_scene {
namespace {

TEST_F(Residency, TexturesAreRenderedToAndSampled) {
  const GLuint first = texture(GL_RGBA8, kWidth, kHeight);
  const GLuint second = texture(GL_RGBA8, kWidth, kHeight);
  const GLuint a = framebufferOf(first), b = framebufferOf(second);
  bindFramebuffer(a);
  drawAll(0x0A0B0C0D);
  bindFramebuffer(b);
  EXPECT_EQ(sampled(first, 2, 2), 0x0A0B0C0Du);
  drawAll(0x1A1B1C1D);
  bindFramebuffer(a);
  EXPECT_EQ(sampled(second, 2, 2), 0x1A1B1C1Du);
  EXPECT_EQ(shadowPixel(2, 2), 0x0A0B0C0Du);
  EXPECT_EQ(hostPixel(2, 2), 0x0A0B0C0Du);
  bindFramebuffer(b);
  EXPECT_EQ(hostPixel(2, 2), 0x1A1B1C1Du);
  EXPECT_EQ(statistics().downloads, 0u);
}

/// A shadow would take a gigabyte more, and a second to copy.
TEST_F(Residency, HugeTexturesStayTheHosts) {
  GLuint name = 0;
  gl().GenTextures(1, &name);
  gl().BindTexture(GL_TEXTURE_3D, name);
  gl().TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 512, 512, 1024, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
  if (gl().GetError() != GL_NO_ERROR)
    GTEST_SKIP() << "the host has no memory for a texture of 1 GiB";
  gl().TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  changed();
  const TextureLevels levels = {0, 0};
  EXPECT_FALSE(residency().describeTexture(name, abi::Dimension::Tex3D, levels, false));
  EXPECT_FALSE(residency().samplesTexture(name, abi::Dimension::Tex3D, levels));
  const char *reason = nullptr;
  EXPECT_EQ(residency().acquireTexture(name, abi::Dimension::Tex3D, levels, false, reason),
            nullptr);
  EXPECT_STREQ(reason, "texture");
  EXPECT_EQ(statistics().downloads, 0u);
  gl().TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  residency().textureRedefined(GL_TEXTURE_3D);
  EXPECT_TRUE(residency().samplesTexture(name, abi::Dimension::Tex3D, levels));
  EXPECT_NE(residency().acquireTexture(name, abi::Dimension::Tex3D, levels, false, reason),
            nullptr);
  gl().DeleteTextures(1, &name);
}

TEST_F(Residency, RenderbuffersGoToTheHostAndBack) {
  GLuint renderbuffer = 0, framebuffer = 0;
  const auto generate =
      reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(hostFunction("glGenRenderbuffers"));
  const auto storage =
      reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(hostFunction("glRenderbufferStorage"));
  generate(1, &renderbuffer);
  gl().BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  storage(GL_RENDERBUFFER, GL_RGBA8, kWidth, kHeight);
  gl().GenFramebuffers(1, &framebuffer);
  bindFramebuffer(framebuffer);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  for (int y = 0; y < kHeight; ++y)
    draw({0, y, kWidth, 1}, std::uint32_t(y) << 16 | 0x77);
  EXPECT_EQ(hostPixel(5, 7), 0x00070077u);
  EXPECT_EQ(hostPixel(5, kHeight - 1), std::uint32_t(kHeight - 1) << 16 | 0x77);
  context().software->hostDraws("test");
  gl().ClearColor(1.0f, 0.0f, 0.0f, 1.0f);
  gl().Enable(GL_SCISSOR_TEST);
  gl().Scissor(0, 0, 4, 4);
  gl().Clear(GL_COLOR_BUFFER_BIT);
  draw({0, 0, 1, 1}, 0x0000FFFF);
  EXPECT_EQ(shadowPixel(0, 0), 0x0000FFFFu);
  EXPECT_EQ(shadowPixel(3, 3), 0xFF0000FFu);
  EXPECT_EQ(shadowPixel(5, 7), 0x00070077u);
  EXPECT_EQ(hostPixel(0, 0), 0x0000FFFFu);
  EXPECT_TRUE(gl().IsEnabled(GL_SCISSOR_TEST));
}

/// A bound framebuffer that draws to a renderbuffer of its own.
struct RenderbufferScene {
  GLuint renderbuffer = 0, framebuffer = 0;
};

class ResidencyOfRenderbuffers : public Residency {
protected:
  RenderbufferScene scene(int width, int height) {
    RenderbufferScene made;
    reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(hostFunction("glGenRenderbuffers"))(
        1, &made.renderbuffer);
    gl().BindRenderbuffer(GL_RENDERBUFFER, made.renderbuffer);
    handlers::RenderbufferStorage(wholeOf(context()), GL_RENDERBUFFER, GL_RGBA8, width, height);
    gl().GenFramebuffers(1, &made.framebuffer);
    bindFramebuffer(made.framebuffer);
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 made.renderbuffer);
    changed();
    return made;
  }
};

TEST_F(ResidencyOfRenderbuffers, NewStorageConcernsNoOtherImage) {
  const GLuint other = framebufferOf(texture(GL_RGBA8, kWidth, kHeight));
  bindFramebuffer(other);
  drawAll(0x11223344);
  (void)scene(kWidth, kHeight);
  drawAll(0x55667788);
  handlers::RenderbufferStorage(wholeOf(context()), GL_RENDERBUFFER, GL_RGBA8, 8, 8);
  changed();
  draw({0, 0, 8, 8}, 0x0A0B0C0D);
  EXPECT_EQ(shadowPixel(7, 7), 0x0A0B0C0Du);
  EXPECT_EQ(statistics().uploads, 1u) << "its own pixels alone";
  EXPECT_EQ(statistics().downloads, 0u);
  EXPECT_EQ(hostPixel(7, 7), 0x0A0B0C0Du);
  bindFramebuffer(other);
  EXPECT_EQ(hostPixel(5, 7), 0x11223344u);
}

TEST_F(ResidencyOfRenderbuffers, RefusedStorageLeavesThePixels) {
  (void)scene(kWidth, kHeight);
  drawAll(0x55667788);
  handlers::RenderbufferStorage(wholeOf(context()), GL_RENDERBUFFER, GL_RGBA8, -1, 8);
  EXPECT_EQ(gl().GetError(), GLenum(GL_INVALID_VALUE));
  changed();
  draw({0, 0, 1, 1}, 0x0A0B0C0D);
  EXPECT_EQ(shadowPixel(5, 7), 0x55667788u);
  EXPECT_EQ(hostPixel(5, 7), 0x55667788u);
}

TEST_F(ResidencyOfRenderbuffers, ADeletedOneLivesOnWhereItIsAttached) {
  const GLuint other = framebufferOf(texture(GL_RGBA8, kWidth, kHeight));
  const RenderbufferScene made = scene(kWidth, kHeight);
  drawAll(0x55667788);
  bindFramebuffer(other);
  drawAll(0x11223344);
  handlers::DeleteRenderbuffers(wholeOf(context()), 1, &made.renderbuffer);
  EXPECT_EQ(statistics().uploads, 1u) << "those of the deleted one alone";
  EXPECT_EQ(hostPixel(5, 7), 0x11223344u);
  bindFramebuffer(made.framebuffer);
  changed();
  EXPECT_EQ(directPixel(5, 7), 0x55667788u);
}

/// Checks a texture or a renderbuffer: encoded pixels are moved unchanged, even while writes are
/// encoded. Only Clear encodes, so the host clears.
void checkSrgb(bool ofTexture, const std::function<void(std::uint32_t)> &drawAll,
               const std::function<std::uint32_t()> &hostPixel, state::Residency &residency,
               const host::HostTable &gl) {
  SCOPED_TRACE(ofTexture ? "texture" : "renderbuffer");
  gl.Enable(GL_FRAMEBUFFER_SRGB);
  drawAll(0x20407F3C);
  EXPECT_EQ(hostPixel(), 0x20407F3Cu) << "upload";
  gl.ClearColor(1.0f, 0.5f, 0.0f, 0.25f);
  EXPECT_FALSE(residency.clear(GL_COLOR_BUFFER_BIT));
  EXPECT_TRUE(gl.IsEnabled(GL_FRAMEBUFFER_SRGB));
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  EXPECT_TRUE(residency.clear(GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(hostPixel(), 0xFF800040u) << "cleared in memory";
}

TEST_F(Residency, SrgbIsMovedAsItIsHeld) {
  const GLuint name = texture(GL_SRGB8_ALPHA8, kWidth, kHeight);
  (void)framebufferOf(name);
  const auto all = [&](std::uint32_t rgba) { drawAll(rgba); };
  const auto pixel = [&] { return hostPixel(3, 3); };
  checkSrgb(true, all, pixel, residency(), gl());
  const char *reason = nullptr;
  const auto isEncoded = [&](GLuint texture) {
    const TextureImages *const images =
        residency().acquireTexture(texture, abi::Dimension::Tex2D, {}, false, reason);
    return images && images->complete && images->srgb;
  };
  EXPECT_EQ(sampled(name, 1, 1), 0xFF800040u);
  EXPECT_TRUE(isEncoded(name));
  EXPECT_FALSE(isEncoded(texture(GL_RGBA8, 8, 8)));

  GLuint renderbuffer = 0;
  reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(hostFunction("glGenRenderbuffers"))(1, &renderbuffer);
  gl().BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(hostFunction("glRenderbufferStorage"))(
      GL_RENDERBUFFER, GL_SRGB8_ALPHA8, kWidth, kHeight);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  changed();
  checkSrgb(false, all, pixel, residency(), gl());
}

TEST_F(Residency, UploadsOfTheApplicationReachBoth) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  drawAll(0x10203040);
  ASSERT_TRUE(copy(0, 0, 0, 0, kWidth, kHeight));
  const std::uint8_t texels[] = {1, 2, 3, 4, 5, 6, 7, 8};
  residency().texSubImage(GL_TEXTURE_2D, 0, 3, 5, 0, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl().TexSubImage2D(GL_TEXTURE_2D, 0, 3, 5, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  EXPECT_EQ(sampled(name, 3, 5), 0x01020304u);
  EXPECT_EQ(sampled(name, 4, 5), 0x05060708u);
  EXPECT_EQ(sampled(name, 5, 5), 0x10203040u);
  EXPECT_EQ(hostTexel(4, 5, kWidth, kHeight), 0x05060708u);
  EXPECT_EQ(hostTexel(4, 6, kWidth, kHeight), 0x10203040u);
}

TEST_F(Residency, ALevelThatIsDefinedAsItIsIsNotReadBack) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  const auto define = [&](GLint internalFormat, std::uint8_t value) {
    const Bytes texels(std::size_t(kWidth) * kHeight * 4, value);
    residency().texImage2D(GL_TEXTURE_2D, 0, internalFormat, kWidth, kHeight, 0, GL_RGBA,
                           GL_UNSIGNED_BYTE, texels.data());
    gl().TexImage2D(GL_TEXTURE_2D, 0, internalFormat, kWidth, kHeight, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    texels.data());
  };
  for (const std::uint8_t value : {0x10, 0x20}) { // the first definition is not known to match the
                                                  // earlier one
    define(GL_RGBA, value);
    EXPECT_EQ(sampled(name, 1, 1), 0x01010101u * value);
  }
  const std::uint64_t downloads = residency().statistics().downloads;
  for (const std::uint8_t value : {0x30, 0x40, 0x50}) {
    define(GL_RGBA, value);
    EXPECT_EQ(sampled(name, 1, 1), 0x01010101u * value);
  }
  EXPECT_EQ(residency().statistics().downloads, downloads);
  define(GL_RGB, 0x60);
  EXPECT_EQ(sampled(name, 1, 1) | 0xFFu, 0x606060FFu) << "another format";
  EXPECT_GT(residency().statistics().downloads, downloads);
}

TEST_F(Residency, DeletedAndRedefinedTexturesAreForgotten) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  drawAll(0x10203040);
  ASSERT_TRUE(copy(0, 0, 0, 0, kWidth, kHeight));
  residency().textureRedefined(GL_TEXTURE_2D);
  Bytes small(4 * 4 * 4, 0x22);
  gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, small.data());
  changed();
  EXPECT_EQ(sampled(name, 3, 3), 0x22222222u);
  EXPECT_FALSE(copy(0, 0, 0, 0, kWidth, kHeight)) << "an error that is the host's to raise";
  residency().texturesDeleted(1, &name);
  gl().DeleteTextures(1, &name);
  residency().synchronise("test");
  EXPECT_FALSE(gl().IsTexture(name)) << "a deleted texture came back";
}

TEST_F(Residency, ACopyMayDefineTheLevelThatItIs) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  drawAll(0x10203040);
  CopyToTexture command;
  command.texture = boundTexture();
  command.target = GL_TEXTURE_2D;
  command.defines = true;
  command.internalFormat = GL_RGBA8;
  command.width = kWidth;
  command.height = kHeight;
  EXPECT_TRUE(residency().copyToTexture(command));
  EXPECT_EQ(sampled(name, 1, 1), 0x10203040u);
  command.width = kWidth / 2;
  EXPECT_FALSE(residency().copyToTexture(command));
}

class ResidencyOfDepth : public Residency, public ::testing::WithParamInterface<GLenum> {
protected:
  /// Writes depth and stencil over `rect` with the rasterizer.
  void drawDepth(const swrast::Rect &rect, float depth, std::uint8_t stencil) {
    const char *reason = nullptr;
    const DrawTargets *const targets = residency().describeTargets(reason);
    ASSERT_NE(targets, nullptr) << reason;
    ASSERT_TRUE(residency().acquireTargets(rect, true, true));
    ASSERT_NE(targets->depthStencil, nullptr);
    swrast::fillDepthStencil(*targets->depthStencil, rect, true, depth,
                             targets->stencilBits != 0 ? 0xFF : 0, stencil);
  }
  float hostDepth(int x, int y) {
    residency().synchronise("a test reads");
    GLfloat depth = -1;
    gl().ReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth;
  }
  int hostStencil(int x, int y) {
    residency().synchronise("a test reads");
    GLubyte stencil = 0xEE;
    gl().ReadPixels(x, y, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    return stencil;
  }
};

TEST_P(ResidencyOfDepth, GoesToTheHostAndBack) {
  const GLenum format = GetParam();
  if (format != 0) {
    GLuint depth = 0, framebuffer = 0;
    const auto generate =
        reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(hostFunction("glGenRenderbuffers"));
    const auto storage =
        reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(hostFunction("glRenderbufferStorage"));
    framebuffer = framebufferOf(texture(GL_RGBA8, kWidth, kHeight));
    generate(1, &depth);
    gl().BindRenderbuffer(GL_RENDERBUFFER, depth);
    storage(GL_RENDERBUFFER, format, kWidth, kHeight);
    const bool both = format == GL_DEPTH24_STENCIL8;
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER,
                                 both ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                                 GL_RENDERBUFFER, depth);
    bindFramebuffer(framebuffer);
    changed();
  }
  const bool stencils = format == 0 || format == GL_DEPTH24_STENCIL8;
  const float slack = format == GL_DEPTH_COMPONENT16 ? 1e-4f : 1e-6f;
  gl().ClearDepth(0.75);
  gl().ClearStencil(0x5A);
  gl().Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  drawDepth({3, 5, 2, 2}, 0.25f, 0x33);
  EXPECT_EQ(statistics().downloads, 2u);
  EXPECT_NEAR(hostDepth(2, 5), 0.75f, slack);
  EXPECT_NEAR(hostDepth(3, 5), 0.25f, slack);
  EXPECT_NEAR(hostDepth(4, 6), 0.25f, slack);
  EXPECT_NEAR(hostDepth(4, 7), 0.75f, slack);
  if (stencils) {
    EXPECT_EQ(hostStencil(2, 5), 0x5A);
    EXPECT_EQ(hostStencil(3, 5), 0x33);
  }
  // The first clear is in memory, the second the host's.
  gl().ClearDepth(0.5);
  gl().Enable(GL_SCISSOR_TEST);
  gl().Scissor(0, 0, 4, 6);
  gl().StencilMask(0x0F);
  EXPECT_TRUE(residency().clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT));
  EXPECT_NEAR(hostDepth(3, 5), 0.5f, slack);
  EXPECT_NEAR(hostDepth(4, 5), 0.25f, slack);
  EXPECT_NEAR(hostDepth(10, 10), 0.75f, slack);
  if (stencils) {
    EXPECT_EQ(hostStencil(3, 5), 0x3A);
    EXPECT_EQ(hostStencil(4, 5), 0x33);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ResidencyOfDepth,
                         ::testing::Values(0, GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT24,
                                           GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT32,
                                           GL_DEPTH_COMPONENT32F));

TEST_F(Residency, Texture0IsOneOfEachTarget) {
  const char *reason = nullptr;
  const auto zero = [&](abi::Dimension dimension) {
    const TextureImages *const images = residency().acquireTexture(0, dimension, {}, false, reason);
    EXPECT_NE(images, nullptr) << reason;
    return images;
  };
  for (int i = 0; i < 2; ++i)
    EXPECT_FALSE(zero(abi::Dimension::Tex2D)->complete) << "without an image";
  const GLuint other = texture(GL_RGBA8, 4, 4); // is bound, and texture 0 can be queried all the
                                                // same
  EXPECT_FALSE(zero(abi::Dimension::Tex2D)->complete);
  gl().BindTexture(GL_TEXTURE_2D, 0);
  residency().textureRedefined(GL_TEXTURE_2D);
  const Bytes texels(4 * 4 * 4, 0x40), line(4 * 4, 0x80);
  gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  residency().textureRedefined(GL_TEXTURE_1D);
  gl().TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, line.data());
  gl().BindTexture(GL_TEXTURE_2D, other);
  const TextureImages *const flat = zero(abi::Dimension::Tex2D);
  ASSERT_TRUE(flat->complete);
  EXPECT_EQ(flat->view.levels[0].height, 4);
  EXPECT_EQ(flat->view.levels[0].base[5], 0x40);
  const TextureImages *const thin = zero(abi::Dimension::Tex1D);
  ASSERT_TRUE(thin->complete);
  EXPECT_EQ(thin->view.levels[0].height, 1);
  EXPECT_EQ(thin->view.levels[0].base[5], 0x80);
  EXPECT_EQ(flat->view.levels[0].base[5], 0x40) << "two textures";

  // Texels are given to the one that is bound.
  gl().BindTexture(GL_TEXTURE_2D, 0);
  const Bytes white(4 * 4 * 4, 0xFF);
  residency().texSubImage(GL_TEXTURE_2D, 0, 0, 0, 0, 4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                          white.data());
  EXPECT_EQ(zero(abi::Dimension::Tex2D)->view.levels[0].base[5], 0xFF);
  EXPECT_EQ(zero(abi::Dimension::Tex1D)->view.levels[0].base[5], 0x80);
  residency().textureRedefined(0);
  gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_FALSE(zero(abi::Dimension::Tex2D)->complete);
  EXPECT_TRUE(zero(abi::Dimension::Tex1D)->complete);
}

TEST_F(Residency, FeedbackReachesTexture0) {
  gl().BindTexture(GL_TEXTURE_2D, 0);
  gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kWidth, kHeight, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
  const char *reason = nullptr;
  const DrawTargets *const targets = residency().describeTargets(reason);
  ASSERT_NE(targets, nullptr) << reason;
  ASSERT_TRUE(residency().acquireTargets({}, false, false));
  constexpr float kColor[4] = {0, 1, 0, 1};
  swrast::fill(*targets->color[0], {0, 0, kWidth, kHeight}, kColor, 0xF);
  const CopyToTexture copy = {.target = GL_TEXTURE_2D, .width = kWidth, .height = kHeight};
  ASSERT_TRUE(residency().copyToTexture(copy));
  EXPECT_EQ(residency().statistics().copiesShared, 1u);
  residency().synchronise("the test");
  Bytes read(std::size_t(kWidth) * kHeight * 4);
  gl().GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  EXPECT_EQ(read[0], 0x00);
  EXPECT_EQ(read[1], 0xFF) << "the host was given it";
}

} // namespace
} // namespace arbiter::state::residency_scene
