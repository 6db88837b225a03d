// Residency against the host that there is: OSMesa, by its context alone. Draws of the rasterizer
// are stood in for by fills of what acquireTargets() gives.
#include "state/residency/residency.h"

#include <cstring>
#include <functional>
#include <vector>

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/lifecycle.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/share/share_group.h"
#include "swrast/image/copy_pixels.h"
#include "swrast/image/image.h"

namespace arbiter::state::software {
namespace {

constexpr int kWidth = 64, kHeight = 48;

struct OsMesa {
  decltype(&OSMesaCreateContextExt) create = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaGetProcAddress) address = nullptr;
};
const OsMesa &osMesa() {
  static const OsMesa s_real = [] {
    OsMesa real;
    if (void *const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL)) {
      const auto get = [&](auto &function, const char *name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
      };
      get(real.create, "OSMesaCreateContextExt");
      get(real.makeCurrent, "OSMesaMakeCurrent");
      get(real.destroy, "OSMesaDestroyContext");
      get(real.address, "OSMesaGetProcAddress");
    }
    return real;
  }();
  return s_real;
}

const host::HostTable &table() {
  static const host::HostTable s_table = [] {
    host::HostTable made;
    (void)host::loadHostTable(
        made, [](const char *name) { return reinterpret_cast<void *>(osMesa().address(name)); });
    return made;
  }();
  return s_table;
}

using Bytes = std::vector<std::uint8_t>;

class Residency : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_NE(osMesa().create, nullptr) << "the test is built where OSMesa is";
    m_osmesa = osMesa().create(OSMESA_RGBA, 24, 8, 0, nullptr);
    m_memory.resize(std::size_t(kWidth) * kHeight * 4);
    ASSERT_TRUE(osMesa().makeCurrent(m_osmesa, m_memory.data(), GL_UNSIGNED_BYTE, kWidth, kHeight));
    m_context = createContext(Provider::OsMesa, &table(), nullptr);
    Drawable drawable;
    drawable.kind = Drawable::Kind::Memory;
    drawable.width = kWidth;
    drawable.height = kHeight;
    drawable.memory = m_memory.data();
    drawable.memoryFormat = GL_RGBA;
    drawable.memoryType = GL_UNSIGNED_BYTE;
    makeCurrent(m_context, &drawable);
    if (!m_context->software)
      m_context->software = std::make_unique<ContextState>(*m_context);
    m_context->dirty = dirty::kAll;
    residency().enter(m_context->drawable);
  }
  void TearDown() override {
    if (!m_context)
      return;
    EXPECT_EQ(gl().GetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(m_context->pendingError, GLenum(GL_NO_ERROR));
    destroyContext(m_context);
    makeCurrent(nullptr);
    osMesa().destroy(m_osmesa);
  }

  Context &context() { return *m_context; }
  software::Residency &residency() { return m_context->software->residency; }
  const host::HostTable &gl() { return *m_context->host; }
  /// The application changed state.
  void changed(std::uint32_t bits = dirty::kAll) { m_context->dirty |= bits; }

  GLuint texture(GLenum internalFormat, int width, int height, const void *rgba = nullptr) {
    GLuint name = 0;
    gl().GenTextures(1, &name);
    gl().BindTexture(GL_TEXTURE_2D, name);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl().TexImage2D(GL_TEXTURE_2D, 0, GLint(internalFormat), width, height, 0, GL_RGBA,
                    GL_UNSIGNED_BYTE, rgba);
    changed();
    return name;
  }
  GLuint framebufferOf(GLuint name) {
    GLuint framebuffer = 0;
    gl().GenFramebuffers(1, &framebuffer);
    gl().BindFramebufferEXT(GL_FRAMEBUFFER, framebuffer);
    gl().FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
    changed();
    return framebuffer;
  }
  void bindFramebuffer(GLuint name) {
    gl().BindFramebufferEXT(GL_FRAMEBUFFER, name);
    changed(dirty::kFramebuffer);
  }

  /// A draw of the rasterizer's over `rect`.
  void draw(const swrast::Rect &rect, std::uint32_t rgba) {
    const char *reason = nullptr;
    const DrawTargets *const targets = residency().describeTargets(reason);
    ASSERT_NE(targets, nullptr) << reason;
    ASSERT_TRUE(residency().acquireTargets(rect, false, false));
    float color[4];
    for (int i = 0; i < 4; ++i)
      color[i] = float(rgba >> (24 - 8 * i) & 0xFF) / 255.0f;
    ASSERT_NE(targets->color[0], nullptr);
    swrast::fill(*targets->color[0], rect, color);
  }
  void drawAll(std::uint32_t rgba) { draw({0, 0, kWidth, kHeight}, rgba); }

  /// What the host has, after it was brought up to date.
  std::uint32_t hostPixel(int x, int y) {
    residency().synchronise("a test reads");
    EXPECT_FALSE(context().hostIsBehind);
    return directPixel(x, y);
  }
  /// What the host has now.
  std::uint32_t directPixel(int x, int y) {
    std::uint8_t bytes[4] = {};
    gl().ReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    return packed(bytes);
  }
  std::uint32_t ourPixel(int x, int y) {
    std::uint8_t bytes[4] = {};
    EXPECT_TRUE(residency().readPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes));
    return packed(bytes);
  }
  std::uint32_t hostTexel(int x, int y, int width, int height) {
    residency().synchronise("a test reads");
    Bytes all(std::size_t(width) * std::size_t(height) * 4);
    gl().GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
    return packed(&all[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4]);
  }
  static std::uint32_t packed(const std::uint8_t *b) {
    return std::uint32_t(b[0]) << 24 | std::uint32_t(b[1]) << 16 | std::uint32_t(b[2]) << 8 | b[3];
  }
  /// What is bound to GL_TEXTURE_2D.
  GLuint boundTexture() {
    GLint name = 0;
    gl().GetIntegerv(GL_TEXTURE_BINDING_2D, &name);
    return GLuint(name);
  }
  bool copy(int destX, int destY, int x, int y, int width, int height) {
    CopyToTexture command;
    command.texture = boundTexture();
    command.target = GL_TEXTURE_2D;
    command.destX = destX;
    command.destY = destY;
    command.x = x;
    command.y = y;
    command.width = width;
    command.height = height;
    return residency().copyToTexture(command);
  }
  /// A texel as a program samples it.
  std::uint32_t sampled(GLuint name, int x, int y) {
    const char *reason = nullptr;
    const TextureImages *const images =
        residency().acquireTexture(name, abi::Dimension::Tex2D, {}, false, reason);
    if (!images || !images->complete) {
      ADD_FAILURE() << (reason ? reason : "incomplete");
      return 0;
    }
    const abi::TextureLevel &level = images->view.levels[0];
    const std::uint8_t *const texel =
        level.base + y * level.rowStride + x * abi::bytesOf(images->format.layout);
    std::uint32_t result = 0;
    for (const abi::From from : images->format.swizzle)
      result = result << 8 | (from == abi::From::One    ? 255u
                              : from == abi::From::Zero ? 0u
                                                        : texel[int(from)]);
    return result;
  }
  ResidencyStatistics statistics() { return residency().statistics(); }

  OSMesaContext m_osmesa = nullptr;
  Context *m_context = nullptr;
  Bytes m_memory;
};

TEST_F(Residency, AFullDrawDownloadsNothing) {
  drawAll(0x11223344);
  EXPECT_EQ(statistics().downloads, 0u);
  EXPECT_TRUE(context().hostIsBehind);
  EXPECT_EQ(ourPixel(5, 6), 0x11223344u);
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
  EXPECT_EQ(ourPixel(0, 0), 0x336699FFu);
  EXPECT_EQ(ourPixel(8, 4), 0xFF000080u);
  EXPECT_EQ(ourPixel(17, 13), 0xFF000080u);
  EXPECT_EQ(ourPixel(18, 13), 0x336699FFu);
  for (const auto &[x, y] : {std::pair{0, 0}, {8, 4}, {7, 4}, {17, 13}, {17, 14}, {63, 47}})
    EXPECT_EQ(hostPixel(x, y), ourPixel(x, y)) << x << ", " << y;
}

TEST_F(Residency, AWholeCopyMovesNoPixel) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  drawAll(0x10203040);
  EXPECT_TRUE(copy(0, 0, 0, 0, kWidth, kHeight));
  EXPECT_EQ(statistics().copiesShared, 1u);
  drawAll(0x50607080);
  EXPECT_EQ(sampled(name, 3, 3), 0x10203040u) << "the draw went to the texture too";
  EXPECT_EQ(ourPixel(3, 3), 0x50607080u);
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
    // After the host's way and back.
    residency().synchronise("test");
    residency().textureRedefined(GL_TEXTURE_2D);
    EXPECT_EQ(sampled(name, 1, 1), row.expected);
  }
}

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
  EXPECT_EQ(ourPixel(2, 2), 0x0A0B0C0Du);
  EXPECT_EQ(hostPixel(2, 2), 0x0A0B0C0Du);
  bindFramebuffer(b);
  EXPECT_EQ(hostPixel(2, 2), 0x1A1B1C1Du);
  EXPECT_EQ(statistics().downloads, 0u);
}

TEST_F(Residency, RenderbuffersGoToTheHostAndBack) {
  GLuint renderbuffer = 0, framebuffer = 0;
  const auto generate =
      reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(osMesa().address("glGenRenderbuffers"));
  const auto storage =
      reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(osMesa().address("glRenderbufferStorage"));
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
  EXPECT_EQ(ourPixel(0, 0), 0x0000FFFFu);
  EXPECT_EQ(ourPixel(3, 3), 0xFF0000FFu);
  EXPECT_EQ(ourPixel(5, 7), 0x00070077u);
  EXPECT_EQ(hostPixel(0, 0), 0x0000FFFFu);
  EXPECT_TRUE(gl().IsEnabled(GL_SCISSOR_TEST));
}

/// Of a texture, else of a renderbuffer: what is held encoded is moved as it is, whether or not
/// what is written is encoded meanwhile; only Clear encodes, and is the host's then.
void checkSrgb(bool ofTexture, const std::function<void(std::uint32_t)> &drawAll,
               const std::function<std::uint32_t()> &hostPixel, software::Residency &residency,
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
  reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(osMesa().address("glGenRenderbuffers"))(
      1, &renderbuffer);
  gl().BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(osMesa().address("glRenderbufferStorage"))(
      GL_RENDERBUFFER, GL_SRGB8_ALPHA8, kWidth, kHeight);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  changed();
  checkSrgb(false, all, pixel, residency(), gl());
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

// A host may restore a whole group of state as soon as something in it was set in between, and then
// chooses the draw buffers of a framebuffer that is no longer bound.
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
  EXPECT_EQ(context().pendingError, GLenum(GL_INVALID_ENUM));
  context().pendingError = GL_NO_ERROR;
}

TEST_F(Residency, ClearIsInMemoryWhereTheShadowIsValid) {
  EXPECT_FALSE(residency().clear(GL_COLOR_BUFFER_BIT)) << "the host was the last to draw";
  drawAll(0x10203040);
  gl().ClearColor(1.0f, 0.0f, 1.0f, 0.0f);
  EXPECT_TRUE(residency().clear(GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(ourPixel(1, 1), 0xFF00FF00u);
  gl().Enable(GL_SCISSOR_TEST);
  gl().Scissor(4, 4, 2, 2);
  gl().ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
  gl().ClearColor(0.0f, 1.0f, 0.0f, 1.0f);
  EXPECT_TRUE(residency().clear(GL_COLOR_BUFFER_BIT));
  EXPECT_EQ(ourPixel(3, 4), 0xFF00FF00u);
  EXPECT_EQ(ourPixel(4, 4), 0xFFFFFF00u);
  EXPECT_EQ(hostPixel(5, 5), 0xFFFFFF00u);
  EXPECT_EQ(hostPixel(6, 5), 0xFF00FF00u);
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
  // And from the host, once it draws.
  context().software->hostDraws("test");
  gl().ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  gl().Clear(GL_COLOR_BUFFER_BIT);
  residency().flush(true);
  EXPECT_EQ(packed(&m_memory[0]), 0u);
}

TEST_F(Residency, TheHostDrawsOverOurs) {
  drawAll(0x10203040);
  context().software->hostDraws("test");
  gl().Enable(GL_SCISSOR_TEST);
  gl().Scissor(0, 0, 2, 2);
  gl().ClearColor(1.0f, 1.0f, 1.0f, 1.0f);
  gl().Clear(GL_COLOR_BUFFER_BIT);
  draw({1, 1, 1, 1}, 0x000000FF);
  EXPECT_EQ(ourPixel(0, 0), 0xFFFFFFFFu);
  EXPECT_EQ(ourPixel(1, 1), 0x000000FFu);
  EXPECT_EQ(ourPixel(2, 2), 0x10203040u);
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

class ResidencyOfDepth : public Residency, public testing::WithParamInterface<GLenum> {
protected:
  /// A draw of the rasterizer's that writes depth and stencil over `rect`.
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
        reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(osMesa().address("glGenRenderbuffers"));
    const auto storage =
        reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(osMesa().address("glRenderbufferStorage"));
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
  // A clear in memory, then the host's.
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
                         testing::Values(0, GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT24,
                                         GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT32,
                                         GL_DEPTH_COMPONENT32F));

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
    m_context->dirty |= dirty::kPixelStore;
  }
}

TEST_F(Residency, Texture0IsOneOfEachTarget) {
  const char *reason = nullptr;
  const auto zero = [&](abi::Dimension dimension) {
    const TextureImages *const images = residency().acquireTexture(0, dimension, {}, false, reason);
    EXPECT_NE(images, nullptr) << reason;
    return images;
  };
  for (int i = 0; i < 2; ++i)
    EXPECT_FALSE(zero(abi::Dimension::Tex2D)->complete) << "without an image";
  const GLuint other = texture(GL_RGBA8, 4, 4); // is bound: texture 0 is asked for all the same
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

  // Texels given to the one that is bound.
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
} // namespace arbiter::state::software
