// Every command that transfers colors, with random state of ARB_imaging, against plain C++: the
// bytes are equal.
#include <cmath>

#include "imaging.h"

namespace api::imaging {
namespace {

constexpr int kTrials = 40;
constexpr int kSize = 32; ///< of the framebuffer

/// Returns the framebuffer's bytes, and clears it to black.
std::vector<GLubyte> framebuffer() {
  std::vector<GLubyte> bytes(kSize * kSize * 4);
  glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}
std::vector<GLubyte> part(const std::vector<GLubyte> &bytes, int x, int y, int width, int height) {
  std::vector<GLubyte> result;
  for (int row = y; row < y + height; ++row)
    result.insert(result.end(), bytes.begin() + (row * kSize + x) * 4,
                  bytes.begin() + (row * kSize + x + width) * 4);
  return result;
}

void clear() {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

/// Fills the framebuffer with bytes, without any transfer.
void fill(const std::vector<GLubyte> &bytes) {
  glWindowPos2i(0, 0);
  glDrawPixels(kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

class ImagingTransfer : public ImagingTest {
protected:
  std::mt19937 m_random{20020926};
  int m_known = 0, m_unknown = 0; ///< components of expected images

  /// Counts known components; most of what is compared must be known.
  void note(const Image &image) {
    for (const Color &color : image.colors)
      for (const double component : color)
        ++(std::isnan(component) ? m_unknown : m_known);
  }

  /// Runs trials: a model, an image of a random size, and the model's result.
  template <typename F> void trials(int dimensions, F function) {
    for (int trial = 0; trial < kTrials; ++trial) {
      SCOPED_TRACE(trial);
      Model model = randomModel(m_random);
      const int width = 8 + int(m_random() % 17);
      const int height = dimensions == 1 ? 1 : 8 + int(m_random() % 17);
      const std::vector<GLubyte> bytes = randomBytes(m_random, width * height * 4);
      const Image expected = model.transfer(imageOf(bytes, width, height), dimensions);
      note(expected);
      function(model, bytes, width, height, expected);
      reset();
    }
    EXPECT_LT(m_unknown * 20, m_known);
  }
};

TEST_F(ImagingTransfer, DrawPixels) {
  trials(2, [](const Model &model, const auto &bytes, int width, int height,
               const Image &expected) {
    clear();
    apply(model);
    glWindowPos2i(0, 0);
    glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    reset();
    const auto all = framebuffer();
    EXPECT_EQ(differences(expected, part(all, 0, 0, expected.width, expected.height).data()), 0);
    EXPECT_EQ(all[std::size_t(expected.width) * 4], 0) << "nothing beside it";
    EXPECT_EQ(all[std::size_t(expected.height) * kSize * 4 + 3], 0) << "nor above";
  });
}

TEST_F(ImagingTransfer, ReadPixels) {
  trials(2,
         [&](const Model &model, const auto &bytes, int width, int height, const Image &expected) {
           glWindowPos2i(0, 0);
           glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
           apply(model);
           std::vector<GLubyte> read(std::size_t(expected.width * expected.height) * 4 + 4, 77);
           glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
           EXPECT_EQ(differences(expected, read.data()), 0);
           EXPECT_EQ(read[read.size() - 1], 77) << "no more is written than the image has";
         });
}

TEST_F(ImagingTransfer, CopyPixels) {
  trials(2,
         [&](const Model &model, const auto &bytes, int width, int height, const Image &expected) {
           glWindowPos2i(0, 0);
           glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
           apply(model);
           glWindowPos2i(2, 1);
           glCopyPixels(0, 0, width, height, GL_COLOR);
           reset();
           EXPECT_EQ(differences(expected,
                                 part(framebuffer(), 2, 1, expected.width, expected.height).data()),
                     0);
         });
}

TEST_F(ImagingTransfer, TexImage1D) {
  trials(1, [](const Model &model, const auto &bytes, int width, int, const Image &expected) {
    apply(model);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, width, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    EXPECT_EQ(levelSize(GL_TEXTURE_1D, GL_TEXTURE_WIDTH), expected.width);
    EXPECT_EQ(differences(expected, texels(GL_TEXTURE_1D, expected).data()), 0)
        << "nor is GetTexImage's image transferred";
    glTexSubImage1D(GL_TEXTURE_1D, 0, 0, width, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    EXPECT_EQ(differences(expected, texels(GL_TEXTURE_1D, expected).data()), 0);
  });
}

TEST_F(ImagingTransfer, TexImage2D) {
  trials(2,
         [](const Model &model, const auto &bytes, int width, int height, const Image &expected) {
           apply(model);
           glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                        bytes.data());
           EXPECT_EQ(levelSize(GL_TEXTURE_2D, GL_TEXTURE_WIDTH), expected.width);
           EXPECT_EQ(levelSize(GL_TEXTURE_2D, GL_TEXTURE_HEIGHT), expected.height);
           EXPECT_EQ(differences(expected, texels(GL_TEXTURE_2D, expected).data()), 0);
         });
}

TEST_F(ImagingTransfer, TexSubImage2D) {
  trials(2, [](const Model &model, const auto &bytes, int width, int height,
               const Image &expected) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, expected.width, expected.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, nullptr);
    apply(model);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    EXPECT_EQ(differences(expected, texels(GL_TEXTURE_2D, expected).data()), 0);
  });
}

TEST_F(ImagingTransfer, TexImage3D) {
  // A 3D image is never convolved.
  trials(3,
         [](const Model &model, const auto &bytes, int width, int height, const Image &expected) {
           apply(model);
           glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, width, height, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                        bytes.data());
           EXPECT_EQ(differences(expected, texels(GL_TEXTURE_3D, expected).data()), 0);
           glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                           bytes.data());
           EXPECT_EQ(differences(expected, texels(GL_TEXTURE_3D, expected).data()), 0);
         });
}

TEST_F(ImagingTransfer, CopyTexImage) {
  trials(2,
         [](const Model &model, const auto &bytes, int width, int height, const Image &expected) {
           glWindowPos2i(0, 0);
           glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
           apply(model);
           glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, width, height, 0);
           EXPECT_EQ(levelSize(GL_TEXTURE_2D, GL_TEXTURE_WIDTH), expected.width);
           EXPECT_EQ(differences(expected, texels(GL_TEXTURE_2D, expected).data()), 0);
           glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
           EXPECT_EQ(differences(expected, texels(GL_TEXTURE_2D, expected).data()), 0);
         });
}

TEST_F(ImagingTransfer, CopyTexImage1D) {
  trials(1, [](const Model &model, const auto &bytes, int width, int, const Image &expected) {
    glWindowPos2i(0, 0);
    glDrawPixels(width, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    apply(model);
    glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 0, 0, width, 0);
    EXPECT_EQ(differences(expected, texels(GL_TEXTURE_1D, expected).data()), 0);
    glCopyTexSubImage1D(GL_TEXTURE_1D, 0, 0, 0, 0, width);
    EXPECT_EQ(differences(expected, texels(GL_TEXTURE_1D, expected).data()), 0);
  });
}

TEST_F(ImagingTransfer, CopyTexSubImage3D) {
  trials(2,
         [](const Model &model, const auto &bytes, int width, int height, const Image &expected) {
           glWindowPos2i(0, 0);
           glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
           glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, expected.width, expected.height, 1, 0, GL_RGBA,
                        GL_UNSIGNED_BYTE, nullptr);
           apply(model);
           glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, width, height);
           EXPECT_EQ(differences(expected, texels(GL_TEXTURE_3D, expected).data()), 0);
         });
}

TEST_F(ImagingTransfer, HistogramAndMinmaxCount) {
  constexpr GLenum kFormats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA};
  for (int trial = 0; trial < kTrials; ++trial) {
    SCOPED_TRACE(trial);
    Model model = randomModel(m_random);
    model.convolution2D = model.separable = false; // float sums would not be exact
    model.first = {};
    model.matrix = Model{}.matrix;
    model.postColorMatrix = {};
    model.histogramOn = model.minmaxOn = true;
    model.histogram.resize(1u << (m_random() % 9));
    model.histogramFormat = kFormats[m_random() % 5];
    const auto bytes = randomBytes(m_random, 16 * 16 * 4);
    apply(model);
    glMinmax(GL_MINMAX, GL_RGBA, GL_FALSE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    (void)model.transfer(imageOf(bytes, 16, 16), 2);
    std::vector<std::array<GLuint, 4>> counted(model.histogram.size(), {9, 9, 9, 9});
    glGetHistogram(GL_HISTOGRAM, GL_TRUE, GL_RGBA, GL_UNSIGNED_INT, counted.data());
    EXPECT_EQ(counted, model.histogram);
    glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_INT, counted.data());
    EXPECT_EQ(counted, decltype(counted)(counted.size())) << "reset";
    GLfloat minmax[8] = {};
    glGetMinmax(GL_MINMAX, GL_FALSE, GL_RGBA, GL_FLOAT, minmax);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_FLOAT_EQ(minmax[c], GLfloat(model.least[c]));
      EXPECT_FLOAT_EQ(minmax[4 + c], GLfloat(model.most[c]));
    }
    reset();
  }
}

TEST_F(ImagingTransfer, MapsComeBeforeTheTables) {
  const GLfloat inverted[] = {1, 0};
  glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, inverted);
  glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
  Model model;
  model.tables[0] = {GL_RGBA, {{0.2, 0, 0, 1}, {0.6, 0, 0, 1}}};
  model.tableOn[0] = true;
  apply(model);
  const GLubyte white[] = {255, 255, 255, 255};
  glWindowPos2i(0, 0);
  glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
  glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
  reset();
  EXPECT_EQ(framebuffer()[0], 51) << "1 becomes 0, which is the first entry";
}

TEST_F(ImagingTransfer, EveryKindOfMemoryIsRead) {
  Model model;
  model.postColorMatrix.scale = {0.5, 1, 1, 1};
  apply(model);
  glWindowPos2i(0, 0);
  const GLushort packed[] = {0xF800, 0xF800, 0x07E0, 0x07E0};
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 4);
  glDrawPixels(2, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, packed);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  const GLubyte luminance[] = {1, 2, 3, 200};
  glBufferData(GL_PIXEL_UNPACK_BUFFER, 4, luminance, GL_STATIC_DRAW);
  glWindowPos2i(2, 0);
  glDrawPixels(1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, reinterpret_cast<void *>(3));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
  reset();
  const auto bytes = framebuffer();
  EXPECT_EQ(part(bytes, 0, 0, 3, 1),
            (std::vector<GLubyte>{128, 0, 0, 255, 0, 255, 0, 255, 100, 200, 200, 255}));
}

TEST_F(ImagingTransfer, EveryKindOfMemoryIsWritten) {
  fill(std::vector<GLubyte>(kSize * kSize * 4, 102));
  Model model;
  model.postColorMatrix.scale = {2, 1, 1, 1};
  apply(model);
  GLubyte luminance = 0;
  glReadPixels(0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &luminance);
  EXPECT_EQ(luminance, 255) << "a sum";
  GLfloat floats[4] = {};
  glReadPixels(0, 0, 1, 1, GL_BGRA, GL_FLOAT, floats);
  EXPECT_FLOAT_EQ(floats[2], 0.8f);
  EXPECT_FLOAT_EQ(floats[0], 0.4f);
  GLushort packed = 0;
  glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, &packed);
  EXPECT_EQ(packed, 25 << 11 | 25 << 5 | 12);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_PACK_BUFFER, 8, nullptr, GL_STATIC_READ);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, reinterpret_cast<void *>(4));
  GLubyte bytes[4] = {};
  glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 4, 4, bytes);
  EXPECT_EQ(bytes[0], 204);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
  reset();
}

} // namespace
} // namespace api::imaging
