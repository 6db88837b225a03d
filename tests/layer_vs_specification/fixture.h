#pragma once
#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include "programs.h"

/// An application of the program API: surfaceless EGL, libepoxy, a 32x32 RGBA8 framebuffer. It
/// knows nothing of the layer except whether to expect its answers.
namespace api {

/// Width and height of the framebuffer.
inline constexpr int kSize = 32;

/// A GL context of its own or in the share group of another, with a framebuffer object bound.
class GlContext {
public:
  enum class Profile { Compatibility, Core };
  explicit GlContext(const GlContext *share = nullptr, Profile profile = Profile::Compatibility);
  ~GlContext();
  GlContext(const GlContext &) = delete;
  GlContext &operator=(const GlContext &) = delete;
  void makeCurrent() const;

private:
  EGLContext m_context = EGL_NO_CONTEXT;
  GLuint m_framebuffer = 0;
  GLuint m_renderbuffer = 0;
};

/// Runs tests in one current context that has no errors before and after each.
class ApiTest : public ::testing::Test {
protected:
  void SetUp() override { ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }
  void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << "left behind"; }
  GlContext m_context;
};

/// True with the layer in front.
bool layered();

/// True if the layer's rasterizer draws every frame, and the host none (ARBITER_BACKEND=swrast).
bool rasterizerDrawsAll();

/// Returns the first number of the host's Mesa release; 0 for another GL.
int mesaRelease();

/// Skips a test of an extension that is not offered.
#define NEEDS(extension)                                                                           \
  if (!epoxy_has_gl_extension(extension))                                                          \
  GTEST_SKIP() << extension << " is not offered here"
/// Skips a test whose expectation the bare host (Mesa 22.3.6) does not meet, with what it does.
#define BARE_HOST_DIFFERS(what)                                                                    \
  if (!api::layered())                                                                             \
  GTEST_SKIP() << "bare host: " << what
/// Skips a test that Mesa does not meet from that release on.
#define BARE_MESA_DIFFERS(release, what)                                                           \
  if (!api::layered() && api::mesaRelease() >= (release))                                          \
  GTEST_SKIP() << "bare host: " << what

#define EXPECT_GL_ERROR(error, call)                                                               \
  do {                                                                                             \
    call;                                                                                          \
    EXPECT_EQ(glGetError(), GLenum(error)) << #call;                                               \
  } while (false)
#define EXPECT_NO_GL_ERROR(call) EXPECT_GL_ERROR(GL_NO_ERROR, call)

} // namespace api
