#pragma once
#include <array>
#include <string>

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

/// An application of the program API: surfaceless EGL, libepoxy, a 32x32 RGBA8 framebuffer. It
/// knows nothing of the layer except whether it is told to expect its answers.
namespace api {

/// A GL context of its own or in the share group of another, with a framebuffer object bound.
class GlContext {
public:
  explicit GlContext(const GlContext *share = nullptr);
  ~GlContext();
  GlContext(const GlContext &) = delete;
  GlContext &operator=(const GlContext &) = delete;
  void makeCurrent() const;

private:
  EGLContext m_context = EGL_NO_CONTEXT;
  GLuint m_framebuffer = 0;
  GLuint m_renderbuffer = 0;
};

using Pixel = std::array<int, 4>;

/// One context, current, without errors before and after each test.
class ApiTest : public ::testing::Test {
protected:
  void SetUp() override { ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }
  void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << "left behind"; }
  GlContext m_context;
};

/// True with the layer in front.
bool layered();

/// Skips a test whose expectation the bare host (Mesa 22.3.6) does not meet, with what it does.
#define BARE_HOST_DIFFERS(what)                                                                    \
  if (!api::layered())                                                                             \
  GTEST_SKIP() << "bare host: " << what

inline constexpr GLenum kFragment = GL_FRAGMENT_PROGRAM_ARB;
inline constexpr GLenum kVertex = GL_VERTEX_PROGRAM_ARB;
inline constexpr char kRed[] = "!!ARBfp1.0\nMOV result.color, {1,0,0,1};\nEND";
inline constexpr char kGreen[] = "!!ARBfp1.0\nMOV result.color, {0,1,0,1};\nEND";
inline constexpr char kEnv0[] = "!!ARBfp1.0\nMOV result.color, program.env[0];\nEND";
inline constexpr char kLocal0[] = "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND";
inline constexpr char kBad[] = "!!ARBfp1.0\nMOV result.color, nothing;\nEND";
inline constexpr Pixel kBlack = {0, 0, 0, 0};
inline constexpr Pixel kRedPixel = {255, 0, 0, 255};
inline constexpr Pixel kGreenPixel = {0, 255, 0, 255};
inline constexpr Pixel kBluePixel = {0, 0, 255, 255};

void load(const std::string &text, GLenum target = kFragment);
/// A new program object with that text, bound.
GLuint makeProgram(const std::string &text, GLenum target = kFragment);
GLint programiv(GLenum pname, GLenum target = kFragment);
GLint integer(GLenum pname);
/// Draws a quad over everything in blue (if nothing else shades it), after a clear to zero.
void drawQuad();
void clear();
Pixel readPixel(int x = 16, int y = 16);
/// clear, drawQuad, readPixel.
Pixel drawn();
/// A linked GLSL program of the stages whose text is given.
GLuint makeGlsl(const char *vertex, const char *fragment);

#define EXPECT_GL_ERROR(error, call)                                                               \
  do {                                                                                             \
    call;                                                                                          \
    EXPECT_EQ(glGetError(), GLenum(error)) << #call;                                               \
  } while (false)
#define EXPECT_NO_GL_ERROR(call) EXPECT_GL_ERROR(GL_NO_ERROR, call)

} // namespace api
