// Tests residency of the window's pixels against the real host: transfers, copies, and that the
// host's state is unchanged.
#include "state/residency/residency.h"

#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/residency/testing/residency_scene.h"

namespace arbiter::state::residency_scene {
namespace {

TEST_F(Residency, AFullDrawDownloadsNothing) {
  drawAll(0x11223344);
  EXPECT_EQ(statistics().downloads, 0u);
  EXPECT_TRUE(context().hostIsBehind);
  EXPECT_EQ(shadowPixel(5, 6), 0x11223344u);
  EXPECT_EQ(statistics().uploads, 0u);
  EXPECT_EQ(hostPixel(5, 6), 0x11223344u);
  EXPECT_EQ(statistics().uploads, 1u);
  residency().synchronise("again");
  EXPECT_EQ(statistics().uploads, 1u) << "uploaded twice";
}

TEST_F(Residency, APartOfADrawKeepsTheHostsPixels) {
  gl().ClearColor(0.2f, 0.4f, 0.6f, 1.0f);
  gl().Clear(GL_COLOR_BUFFER_BIT);
  draw({8, 4, 10, 10}, 0xFF000080);
  EXPECT_EQ(statistics().downloads, 1u);
  EXPECT_EQ(shadowPixel(0, 0), 0x336699FFu);
  EXPECT_EQ(shadowPixel(8, 4), 0xFF000080u);
  EXPECT_EQ(shadowPixel(17, 13), 0xFF000080u);
  EXPECT_EQ(shadowPixel(18, 13), 0x336699FFu);
  for (const auto &[x, y] : {std::pair{0, 0}, {8, 4}, {7, 4}, {17, 13}, {17, 14}, {63, 47}})
    EXPECT_EQ(hostPixel(x, y), shadowPixel(x, y)) << x << ", " << y;
}

TEST_F(Residency, AWholeCopyMovesNoPixel) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  drawAll(0x10203040);
  EXPECT_TRUE(copy(0, 0, 0, 0, kWidth, kHeight));
  EXPECT_EQ(statistics().copiesShared, 1u);
  drawAll(0x50607080);
  EXPECT_EQ(sampled(name, 3, 3), 0x10203040u) << "the draw went to the texture too";
  EXPECT_EQ(shadowPixel(3, 3), 0x50607080u);
  EXPECT_EQ(statistics().downloads + statistics().uploads, 0u);
  EXPECT_EQ(hostTexel(3, 3, kWidth, kHeight), 0x10203040u);
  EXPECT_EQ(hostPixel(3, 3), 0x50607080u);
}

TEST_F(Residency, ACopyIsOfTheRightRows) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    draw({0, y, kWidth, 1}, std::uint32_t(y) << 24 | 0xFF);
  ASSERT_TRUE(copy(0, 0, 0, 0, kWidth, kHeight));
  for (const int y : {0, 1, 20, kHeight - 1}) {
    EXPECT_EQ(sampled(name, 1, y), std::uint32_t(y) << 24 | 0xFF);
    EXPECT_EQ(hostTexel(1, y, kWidth, kHeight), std::uint32_t(y) << 24 | 0xFF);
    EXPECT_EQ(hostPixel(1, y), std::uint32_t(y) << 24 | 0xFF);
  }
}

TEST_F(Residency, APartialCopyKeepsTheRestOfTheTexture) {
  Bytes grey(64 * 64 * 4, 0x80);
  const GLuint name = texture(GL_RGBA8, 64, 64, grey.data());
  drawAll(0x01020304);
  EXPECT_TRUE(copy(10, 20, 2, 3, 5, 6));
  EXPECT_EQ(statistics().copiesInMemory, 1u);
  EXPECT_EQ(sampled(name, 9, 20), 0x80808080u);
  EXPECT_EQ(sampled(name, 10, 20), 0x01020304u);
  EXPECT_EQ(sampled(name, 14, 25), 0x01020304u);
  EXPECT_EQ(sampled(name, 15, 25), 0x80808080u);
  EXPECT_EQ(hostTexel(9, 20, 64, 64), 0x80808080u);
  EXPECT_EQ(hostTexel(14, 25, 64, 64), 0x01020304u);
  EXPECT_EQ(hostTexel(14, 26, 64, 64), 0x80808080u);
}

TEST_F(Residency, CopiesGiveEachBaseFormatItsComponents) {
  const struct {
    GLenum internalFormat;
    std::uint32_t expected;
  } rows[] = {{GL_RGBA8, 0x10203040},      {GL_RGB8, 0x102030FF},
              {GL_LUMINANCE8, 0x101010FF}, {GL_ALPHA8, 0x00000040},
              {GL_INTENSITY8, 0x10101010}, {GL_LUMINANCE8_ALPHA8, 0x10101040}};
  for (const auto &row : rows) {
    SCOPED_TRACE(row.internalFormat);
    const GLuint name = texture(row.internalFormat, kWidth, kHeight);
    drawAll(0x10203040);
    ASSERT_TRUE(copy(0, 0, 0, 0, kWidth, kHeight));
    EXPECT_EQ(sampled(name, 1, 1), row.expected);
    // Check it again after an upload and a download.
    residency().synchronise("test");
    residency().textureRedefined(GL_TEXTURE_2D);
    EXPECT_EQ(sampled(name, 1, 1), row.expected);
  }
}

TEST_F(Residency, TheHostsStateIsAsItWas) {
  const GLuint bound = texture(GL_RGBA8, 8, 8);
  gl().PixelStorei(GL_UNPACK_ROW_LENGTH, 77);
  gl().PixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
  gl().PixelStorei(GL_PACK_ALIGNMENT, 2);
  gl().PixelTransferf(GL_RED_SCALE, 0.5f);
  gl().Scissor(1, 2, 3, 4);
  gl().Enable(GL_SCISSOR_TEST);
  gl().ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  changed();
  draw({0, 0, kWidth - 1, kHeight}, 0x10203040); // a download
  residency().synchronise("test");               // an upload
  const auto integer = [&](GLenum pname) {
    GLint value = -1;
    gl().GetIntegerv(pname, &value);
    return value;
  };
  EXPECT_EQ(GLuint(integer(GL_TEXTURE_BINDING_2D)), bound);
  EXPECT_EQ(integer(GL_UNPACK_ROW_LENGTH), 77);
  EXPECT_EQ(integer(GL_UNPACK_SKIP_PIXELS), 3);
  EXPECT_EQ(integer(GL_PACK_ALIGNMENT), 2);
  EXPECT_EQ(integer(GL_DRAW_FRAMEBUFFER_BINDING), 0);
  EXPECT_EQ(integer(GL_READ_FRAMEBUFFER_BINDING), 0);
  GLfloat scale = 0;
  gl().GetFloatv(GL_RED_SCALE, &scale);
  EXPECT_EQ(scale, 0.5f);
  EXPECT_TRUE(gl().IsEnabled(GL_SCISSOR_TEST));
  gl().PixelTransferf(GL_RED_SCALE, 1.0f);
  EXPECT_EQ(directPixel(0, 0), 0x10203040u);
  GLuint next = 0;
  gl().GenTextures(1, &next);
  EXPECT_LT(next, 1000u) << "names of the layer's push the application's up";
  gl().GenFramebuffers(1, &next);
  EXPECT_LT(next, 1000u);
}

// A host may restore a whole group of state once anything in it was set, and then chooses draw
// buffers for a framebuffer that is no longer bound.
TEST_F(Residency, MovingPixelsSetsNothingThatPopAttribRestores) {
  const GLuint framebuffer = framebufferOf(texture(GL_RGBA8, 8, 8));
  gl().PushAttrib(GL_COLOR_BUFFER_BIT);
  bindFramebuffer(0);
  draw({0, 0, kWidth - 1, kHeight}, 0x10203040); // a download
  gl().PopAttrib();
  EXPECT_EQ(gl().GetError(), GLenum(GL_NO_ERROR));
  GLint buffer = 0;
  gl().GetIntegerv(GL_DRAW_BUFFER, &buffer);
  EXPECT_NE(buffer, GL_COLOR_ATTACHMENT0);
  gl().DeleteFramebuffers(1, &framebuffer);
}

TEST_F(Residency, ErrorsThatWaitStay) {
  gl().Enable(GLenum(0x1234));
  drawAll(0x10203040);
  residency().synchronise("test");
  EXPECT_EQ(context().errors.pending, GLenum(GL_INVALID_ENUM));
  context().errors.pending = GL_NO_ERROR;
}

TEST_F(Residency, ClearIsInMemoryWhereTheShadowIsValid) {
  EXPECT_FALSE(residency().clear(GL_COLOR_BUFFER_BIT)) << "the host was the last to draw";
  drawAll(0x10203040);
  gl().ClearColor(1.0f, 0.0f, 1.0f, 0.0f);
  EXPECT_TRUE(residency().clear(GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(shadowPixel(1, 1), 0xFF00FF00u);
  gl().Enable(GL_SCISSOR_TEST);
  gl().Scissor(4, 4, 2, 2);
  gl().ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
  gl().ClearColor(0.0f, 1.0f, 0.0f, 1.0f);
  EXPECT_TRUE(residency().clear(GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(shadowPixel(3, 4), 0xFF00FF00u);
  EXPECT_EQ(shadowPixel(4, 4), 0xFFFFFF00u);
  EXPECT_EQ(hostPixel(5, 5), 0xFFFFFF00u);
  EXPECT_EQ(hostPixel(6, 5), 0xFF00FF00u);
}

TEST_F(Residency, AClearOfDepthsThatTheHostHasMovesNoColors) {
  drawAll(0x10203040);
  const ResidencyStatistics before = statistics();
  gl().ClearDepth(0.25);
  EXPECT_TRUE(residency().clear(GL_DEPTH_BUFFER_BIT));
  GLfloat depth = -1;
  gl().ReadPixels(1, 1, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  EXPECT_NEAR(depth, 0.25f, 1e-6f);
  EXPECT_EQ(shadowPixel(1, 1), 0x10203040u);
  EXPECT_EQ(statistics().uploads, before.uploads);
  EXPECT_EQ(statistics().downloads, before.downloads);
}

TEST_F(Residency, FinishShowsThePixelsInTheApplicationsMemory) {
  drawAll(0x10203040);
  residency().flush(true);
  EXPECT_EQ(packed(&m_memory[0]), 0x10203040u);
  EXPECT_EQ(packed(&m_memory[m_memory.size() - 4]), 0x10203040u);
  EXPECT_EQ(statistics().uploads, 0u);
  draw({0, 0, 1, 1}, 0xFFFFFFFF);
  residency().flush(false);
  EXPECT_EQ(packed(&m_memory[0]), 0xFFFFFFFFu);
  EXPECT_EQ(packed(&m_memory[4]), 0x10203040u);
  // The host's pixels arrive too, once it draws.
  context().software->hostDraws("test");
  gl().ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  gl().Clear(GL_COLOR_BUFFER_BIT);
  residency().flush(true);
  EXPECT_EQ(packed(&m_memory[0]), 0u);
}

TEST_F(Residency, TheHostDrawsOverTheShadow) {
  drawAll(0x10203040);
  context().software->hostDraws("test");
  gl().Enable(GL_SCISSOR_TEST);
  gl().Scissor(0, 0, 2, 2);
  gl().ClearColor(1.0f, 1.0f, 1.0f, 1.0f);
  gl().Clear(GL_COLOR_BUFFER_BIT);
  draw({1, 1, 1, 1}, 0x000000FF);
  EXPECT_EQ(shadowPixel(0, 0), 0xFFFFFFFFu);
  EXPECT_EQ(shadowPixel(1, 1), 0x000000FFu);
  EXPECT_EQ(shadowPixel(2, 2), 0x10203040u);
}

TEST_F(Residency, PixelStoreIsFollowed) {
  EXPECT_EQ(residency().bitUnpacking().alignment, 4);
  constexpr struct {
    GLenum name;
    GLint value;
    bool followed;
  } kSteps[] = {{GL_UNPACK_ALIGNMENT, 1, true},     {GL_UNPACK_ALIGNMENT, 3, false},
                {GL_UNPACK_LSB_FIRST, 7, true},     {GL_UNPACK_ROW_LENGTH, 50, true},
                {GL_UNPACK_SKIP_ROWS, 2, true},     {GL_UNPACK_SKIP_PIXELS, 9, true},
                {GL_UNPACK_SKIP_PIXELS, -1, false}, {GL_PACK_ALIGNMENT, 1, false}};
  for (const auto &step : kSteps) {
    gl().PixelStorei(step.name, step.value);
    EXPECT_EQ(residency().pixelStored(step.name, step.value), step.followed);
  }
  (void)gl().GetError();
  for (const bool asked : {false, true}) {
    const BitUnpacking unpack = residency().bitUnpacking();
    EXPECT_EQ(unpack.alignment, 1) << asked;
    EXPECT_TRUE(unpack.lowestFirst);
    EXPECT_EQ(unpack.rowLength, 50);
    EXPECT_EQ(unpack.skipRows, 2);
    EXPECT_EQ(unpack.skipPixels, 9);
    context().dirty |= dirty::kPixelStore;
  }
}

int g_sizesAsked = 0;

/// Otherwise each frame would measure the window again, even if the host draws everything.
TEST_F(Residency, WhatIsKnownOfTargetsIsToldWithoutMeasuringTheWindow) {
  EXPECT_EQ(residency().targetsBefore(), nullptr) << "they were never described";
  Drawable drawable;
  drawable.kind = Drawable::Kind::Pbuffer;
  drawable.size = [](const Drawable &, int &width, int &height, bool) {
    ++g_sizesAsked;
    width = kWidth;
    height = kHeight;
    return true;
  };
  residency().enter(drawable);
  const char *reason = nullptr;
  ASSERT_NE(residency().describeTargets(reason), nullptr) << reason;
  const int asked = g_sizesAsked;
  EXPECT_GT(asked, 0);
  residency().hostSwaps();
  const DrawTargets *const before = residency().targetsBefore();
  ASSERT_NE(before, nullptr);
  EXPECT_EQ(g_sizesAsked, asked);
  EXPECT_TRUE(before->isWindow);
  EXPECT_GT(before->depthBits, 0);
  ASSERT_NE(residency().describeTargets(reason), nullptr) << reason;
  EXPECT_EQ(g_sizesAsked, asked + 1);

  changed(dirty::kFramebuffer);
  EXPECT_EQ(residency().targetsBefore(), nullptr) << "another framebuffer may be bound";
  ASSERT_NE(residency().describeTargets(reason), nullptr) << reason;
  residency().leave();
  residency().enter(drawable);
  EXPECT_EQ(residency().targetsBefore(), nullptr) << "the window may be another";
}

} // namespace
} // namespace arbiter::state::residency_scene
