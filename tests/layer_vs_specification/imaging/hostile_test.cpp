// Commands of ARB_imaging with random arguments, most of them invalid, also in lists and
// primitives. Nothing crashes, and valid commands work afterwards.
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iterator>

#include "imaging.h"

namespace api::imaging {
namespace {

class ImagingHostile : public ImagingTest {
protected:
  std::mt19937 m_random{20021128};
  std::vector<GLfloat> m_memory = std::vector<GLfloat>(1u << 20, 0.25f);
  std::vector<GLfloat> m_written = std::vector<GLfloat>(1u << 20);

  GLenum one(std::initializer_list<GLenum> of) { return of.begin()[m_random() % of.size()]; }
  GLenum target() {
    return one({GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE, GL_POST_COLOR_MATRIX_COLOR_TABLE,
                GL_PROXY_COLOR_TABLE, GL_CONVOLUTION_1D, GL_CONVOLUTION_2D, GL_SEPARABLE_2D,
                GL_HISTOGRAM, GL_PROXY_HISTOGRAM, GL_MINMAX, GL_TEXTURE_2D, 0});
  }
  GLenum internal() {
    return one({GL_ALPHA, GL_LUMINANCE8, GL_LUMINANCE_ALPHA, GL_INTENSITY16, GL_RGB, GL_RGBA,
                GL_RGBA8, GL_R3_G3_B2, GL_DEPTH_COMPONENT, 4, 0});
  }
  GLenum format() {
    return one({GL_RGBA, GL_RGB, GL_BGRA, GL_RED, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                GL_COLOR_INDEX, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_RGBA_INTEGER, 0});
  }
  GLenum type() {
    return one({GL_UNSIGNED_BYTE, GL_BYTE, GL_SHORT, GL_UNSIGNED_INT, GL_FLOAT, GL_BITMAP,
                GL_UNSIGNED_SHORT_5_6_5, GL_UNSIGNED_INT_8_8_8_8_REV, GL_HALF_FLOAT, GL_DOUBLE, 0});
  }
  GLenum pname() {
    return one({GL_COLOR_TABLE_SCALE, GL_COLOR_TABLE_BIAS, GL_COLOR_TABLE_WIDTH,
                GL_COLOR_TABLE_ALPHA_SIZE, GL_CONVOLUTION_BORDER_MODE, GL_CONVOLUTION_BORDER_COLOR,
                GL_CONVOLUTION_FILTER_SCALE, GL_CONVOLUTION_FILTER_BIAS, GL_CONVOLUTION_WIDTH,
                GL_HISTOGRAM_WIDTH, GL_HISTOGRAM_SINK, GL_MINMAX_FORMAT, 0});
  }
  GLsizei size() {
    constexpr GLsizei kSizes[] = {-1, 0, 1, 2, 3, 4, 7, 8, 11, 12, 16, 64};
    return kSizes[m_random() % std::size(kSizes)];
  }
  GLint place() { return GLint(m_random() % 80) - 20; }
  GLfloat number() {
    constexpr GLfloat kNumbers[] = {0, 1, -1, 0.5f, 1e30f, -1e30f, 33107, GL_REDUCE};
    const auto at = m_random() % (std::size(kNumbers) + 1);
    return at < std::size(kNumbers) ? kNumbers[at] : std::nanf("");
  }
  const void *in() { return m_memory.data(); }
  void *out() { return m_written.data(); }
  GLfloat *floats() {
    for (int i = 0; i < 4; ++i)
      m_four[i] = number();
    return m_four;
  }
  GLint *integers() {
    for (GLint &value : m_integers)
      value = GLint(m_random());
    return m_integers;
  }

  void call();
  void callPixels();

  GLfloat m_four[16] = {};
  GLint m_integers[16] = {};
};

void ImagingHostile::call() {
  const std::function<void()> commands[] = {
      [&] { glColorTable(target(), internal(), size(), format(), type(), in()); },
      [&] { glColorTable(target(), internal(), 1 << 28, format(), type(), in()); },
      [&] { glColorSubTable(target(), size(), size(), format(), type(), in()); },
      [&] { glCopyColorTable(target(), internal(), place(), place(), size()); },
      [&] { glCopyColorSubTable(target(), size(), place(), place(), size()); },
      [&] { glColorTableParameterfv(target(), pname(), floats()); },
      [&] { glColorTableParameteriv(target(), pname(), integers()); },
      [&] { glGetColorTable(target(), format(), type(), out()); },
      [&] { glGetColorTableParameterfv(target(), pname(), m_four); },
      [&] { glGetColorTableParameteriv(target(), pname(), m_integers); },
      [&] { glConvolutionFilter1D(target(), internal(), size(), format(), type(), in()); },
      [&] { glConvolutionFilter2D(target(), internal(), size(), size(), format(), type(), in()); },
      [&] {
        glSeparableFilter2D(target(), internal(), size(), size(), format(), type(), in(), in());
      },
      [&] { glCopyConvolutionFilter1D(target(), internal(), place(), place(), size()); },
      [&] { glCopyConvolutionFilter2D(target(), internal(), place(), place(), size(), size()); },
      [&] { glConvolutionParameterf(target(), pname(), number()); },
      [&] { glConvolutionParameteri(target(), pname(), GLint(m_random())); },
      [&] { glConvolutionParameterfv(target(), pname(), floats()); },
      [&] { glConvolutionParameteriv(target(), pname(), integers()); },
      [&] { glGetConvolutionFilter(target(), format(), type(), out()); },
      [&] { glGetSeparableFilter(target(), format(), type(), out(), out(), out()); },
      [&] { glGetConvolutionParameterfv(target(), pname(), m_four); },
      [&] { glGetConvolutionParameteriv(target(), pname(), m_integers); },
      [&] { glHistogram(target(), size(), internal(), GLboolean(m_random() & 1)); },
      [&] { glMinmax(target(), internal(), GLboolean(m_random() & 1)); },
      [&] { glResetHistogram(target()); },
      [&] { glResetMinmax(target()); },
      [&] { glGetHistogram(target(), GLboolean(m_random() & 1), format(), type(), out()); },
      [&] { glGetMinmax(target(), GLboolean(m_random() & 1), format(), type(), out()); },
      [&] { glGetHistogramParameteriv(target(), pname(), m_integers); },
      [&] { glGetMinmaxParameterfv(target(), pname(), m_four); },
      [&] { glEnable(target()); },
      [&] { glDisable(target()); },
      [&] { glPixelTransferf(GL_POST_CONVOLUTION_RED_SCALE + m_random() % 8, number()); },
      [&] { glPixelTransferi(GL_POST_COLOR_MATRIX_RED_SCALE + m_random() % 8, place()); },
      [&] {
        glMatrixMode(one({GL_COLOR, GL_MODELVIEW, GL_MATRIX7_ARB, GL_TEXTURE}));
      },
      [&] { glLoadMatrixf(m_memory.data()); },
      [&] { glPushMatrix(); },
      [&] { glPopMatrix(); },
      [&] {
        glPushAttrib(one({GL_PIXEL_MODE_BIT, GL_ENABLE_BIT, GL_TRANSFORM_BIT}));
      },
      [&] { glPopAttrib(); },
      [&] {
        glGetFloatv(one({GL_COLOR_MATRIX, GL_TRANSPOSE_COLOR_MATRIX}), m_four);
      },
      [&] { glGetIntegerv(GL_POST_COLOR_MATRIX_RED_SCALE + m_random() % 8, m_integers); },
  };
  commands[m_random() % std::size(commands)]();
}

void ImagingHostile::callPixels() {
  const std::function<void()> commands[] = {
      [&] { glDrawPixels(size(), size(), format(), type(), in()); },
      [&] {
        glCopyPixels(place(), place(), size(), size(), one({GL_COLOR, GL_DEPTH, 0}));
      },
      [&] { glReadPixels(place(), place(), size(), size(), format(), type(), out()); },
      [&] { glTexImage1D(GL_TEXTURE_1D, 0, GLint(internal()), size(), 0, format(), type(), in()); },
      [&] {
        glTexImage2D(one({GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D, 0}), 0, GLint(internal()), size(),
                     size(), 0, format(), type(), in());
      },
      [&] {
        glTexSubImage2D(GL_TEXTURE_2D, 0, place(), place(), size(), size(), format(), type(), in());
      },
      [&] {
        glTexImage3D(GL_TEXTURE_3D, 0, GLint(internal()), 4, size() % 5, 4, 0, format(), type(),
                     in());
      },
      [&] { glCopyTexImage2D(GL_TEXTURE_2D, 0, internal(), place(), place(), size(), size(), 0); },
      [&] {
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, place(), place(), place(), place(), size(), size());
      },
      [&] { glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, size(), 0, 0, 4, 4); },
  };
  commands[m_random() % std::size(commands)]();
}

TEST_F(ImagingHostile, CommandsAtRandom) {
  for (int step = 0; step < 20'000; ++step) {
    const unsigned kind = m_random() % 400;
    if (kind == 0) {
      glNewList(1, one({GL_COMPILE, GL_COMPILE_AND_EXECUTE}));
    } else if (kind == 1) {
      glEndList();
      glCallList(1);
    } else if (kind == 2) {
      glBegin(GL_POINTS);
      call();
      callPixels();
      glEnd();
    } else if (kind < 200) {
      callPixels();
    } else {
      call();
    }
    if (step % 64 == 0)
      while (glGetError() != GL_NO_ERROR) {
      }
  }
  glEndList();
  glMatrixMode(GL_MODELVIEW);
  for (int i = 0; i < 64; ++i) {
    glPopAttrib();
    glGetError();
  }
  while (glGetError() != GL_NO_ERROR) {
  }
  glDeleteLists(1, 1);
  glMatrixMode(GL_COLOR);
  for (int i = 0; i < 8; ++i)
    glPopMatrix();
  while (glGetError() != GL_NO_ERROR) {
  }

  const GLfloat ones[] = {1, 1, 1, 1}, zeros[] = {0, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    glColorTableParameterfv(kTables[i], GL_COLOR_TABLE_SCALE, ones);
    glColorTableParameterfv(kTables[i], GL_COLOR_TABLE_BIAS, zeros);
    glConvolutionParameterfv(kFilters[i], GL_CONVOLUTION_FILTER_SCALE, ones);
    glConvolutionParameterfv(kFilters[i], GL_CONVOLUTION_FILTER_BIAS, zeros);
  }
  Model model = randomModel(m_random);
  const std::vector<GLubyte> bytes = randomBytes(m_random, 16 * 16 * 4);
  const Image expected = model.transfer(imageOf(bytes, 16, 16), 2);
  apply(model);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  EXPECT_EQ(differences(expected, texels(GL_TEXTURE_2D, expected).data()), 0);
  reset();
}

} // namespace
} // namespace api::imaging
