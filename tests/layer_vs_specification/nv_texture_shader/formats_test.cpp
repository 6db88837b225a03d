// The internal formats of NV_texture_shader and 3: sizes, pixels of every type, queries.
#include <cstring>
#include <string>

#include "texture_shaders.h"

namespace api::shaders {
namespace {

struct Sizes {
  GLenum internal, format;
  GLenum first;  ///< the query of a size
  GLint bits;    ///< its result
  GLenum second; ///< another query
  GLint more;    ///< its result
};
constexpr Sizes kSizes[] = {
    {GL_SIGNED_RGBA_NV, GL_RGBA, GL_TEXTURE_RED_SIZE, 8, GL_TEXTURE_ALPHA_SIZE, 8},
    {GL_SIGNED_RGBA8_NV, GL_RGBA, GL_TEXTURE_GREEN_SIZE, 8, GL_TEXTURE_HI_SIZE_NV, 0},
    {GL_SIGNED_RGB_NV, GL_RGB, GL_TEXTURE_BLUE_SIZE, 8, GL_TEXTURE_ALPHA_SIZE, 0},
    {GL_SIGNED_RGB8_NV, GL_RGB, GL_TEXTURE_RED_SIZE, 8, GL_TEXTURE_LUMINANCE_SIZE, 0},
    {GL_SIGNED_LUMINANCE_NV, GL_LUMINANCE, GL_TEXTURE_LUMINANCE_SIZE, 8, GL_TEXTURE_RED_SIZE, 0},
    {GL_SIGNED_LUMINANCE8_ALPHA8_NV, GL_RGBA, GL_TEXTURE_LUMINANCE_SIZE, 8, GL_TEXTURE_ALPHA_SIZE,
     8},
    {GL_SIGNED_ALPHA_NV, GL_ALPHA, GL_TEXTURE_ALPHA_SIZE, 8, GL_TEXTURE_RED_SIZE, 0},
    {GL_SIGNED_INTENSITY8_NV, GL_LUMINANCE, GL_TEXTURE_INTENSITY_SIZE, 8, GL_TEXTURE_ALPHA_SIZE, 0},
    {GL_SIGNED_RGB_UNSIGNED_ALPHA_NV, GL_RGBA, GL_TEXTURE_RED_SIZE, 8, GL_TEXTURE_ALPHA_SIZE, 8},
    {GL_HILO_NV, GL_HILO_NV, GL_TEXTURE_HI_SIZE_NV, 16, GL_TEXTURE_LO_SIZE_NV, 16},
    {GL_HILO16_NV, GL_HILO_NV, GL_TEXTURE_HI_SIZE_NV, 16, GL_TEXTURE_RED_SIZE, 0},
    {GL_HILO8_NV, GL_HILO_NV, GL_TEXTURE_HI_SIZE_NV, 8, GL_TEXTURE_DS_SIZE_NV, 0},
    {GL_SIGNED_HILO16_NV, GL_HILO_NV, GL_TEXTURE_LO_SIZE_NV, 16, GL_TEXTURE_GREEN_SIZE, 0},
    {GL_SIGNED_HILO8_NV, GL_HILO_NV, GL_TEXTURE_LO_SIZE_NV, 8, GL_TEXTURE_BLUE_SIZE, 0},
    {GL_DSDT_NV, GL_DSDT_NV, GL_TEXTURE_DS_SIZE_NV, 8, GL_TEXTURE_DT_SIZE_NV, 8},
    {GL_DSDT_MAG_NV, GL_DSDT_MAG_NV, GL_TEXTURE_MAG_SIZE_NV, 8, GL_TEXTURE_INTENSITY_SIZE, 0},
    {GL_DSDT8_MAG8_INTENSITY8_NV, GL_DSDT_MAG_VIB_NV, GL_TEXTURE_MAG_SIZE_NV, 8,
     GL_TEXTURE_INTENSITY_SIZE, 8},
    {GL_RGBA8, GL_RGBA, GL_TEXTURE_RED_SIZE, 8, GL_TEXTURE_DS_SIZE_NV, 0},
};

TEST_F(NvTextureShaders, InternalFormatsAndTheirSizes) {
  const GLubyte texel[16] = {};
  for (const Sizes &row : kSizes) {
    SCOPED_TRACE(testing::Message() << std::hex << row.internal);
    const GLuint name = makeTexel(row.internal, row.format, GL_UNSIGNED_BYTE, texel);
    EXPECT_EQ(levelValue(GL_TEXTURE_INTERNAL_FORMAT), GLint(row.internal));
    EXPECT_EQ(levelValue(row.first), row.bits);
    EXPECT_EQ(levelValue(row.second), row.more);
    GLfloat asFloat = -1;
    glGetTexLevelParameterfv(GL_TEXTURE_2D, 0, row.first, &asFloat);
    EXPECT_EQ(asFloat, GLfloat(row.bits));
    glDeleteTextures(1, &name);
  }
}

TEST_F(NvTextureShaders, ANameThatIsUsedAgainHasNoFormat) {
  const GLubyte texel[16] = {};
  const GLuint name = makeTexel(GL_HILO_NV, GL_HILO_NV, GL_UNSIGNED_BYTE, texel);
  glDeleteTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  EXPECT_EQ(levelValue(GL_TEXTURE_HI_SIZE_NV), 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
  EXPECT_EQ(levelValue(GL_TEXTURE_INTERNAL_FORMAT), GL_RGB16) << "what the host has HILO in";
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, TargetsOfAllDimensions) {
  const GLubyte texels[64] = {};
  GLuint names[4] = {};
  glGenTextures(4, names);
  glBindTexture(GL_TEXTURE_1D, names[0]);
  EXPECT_NO_GL_ERROR(glTexImage1D(GL_TEXTURE_1D, 0, GL_DSDT_NV, 4, 0, GL_DSDT_NV, GL_BYTE, texels));
  EXPECT_EQ(levelValue(GL_TEXTURE_DS_SIZE_NV, GL_TEXTURE_1D), 8);
  EXPECT_NO_GL_ERROR(glTexSubImage1D(GL_TEXTURE_1D, 0, 1, 2, GL_DSDT_NV, GL_BYTE, texels));
  glBindTexture(GL_TEXTURE_3D, names[1]);
  EXPECT_NO_GL_ERROR(glTexImage3D(GL_TEXTURE_3D, 0, GL_HILO_NV, 2, 2, 2, 0, GL_HILO_NV,
                                  GL_UNSIGNED_SHORT, texels));
  EXPECT_EQ(levelValue(GL_TEXTURE_HI_SIZE_NV, GL_TEXTURE_3D), 16);
  EXPECT_NO_GL_ERROR(
      glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 1, 2, 2, 1, GL_HILO_NV, GL_UNSIGNED_BYTE, texels));
  glBindTexture(GL_TEXTURE_CUBE_MAP, names[2]);
  EXPECT_NO_GL_ERROR(glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_DSDT_MAG_NV, 1, 1, 0,
                                  GL_DSDT_MAG_NV, GL_FLOAT, texels));
  EXPECT_EQ(levelValue(GL_TEXTURE_MAG_SIZE_NV, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y), 8);
  EXPECT_EQ(levelValue(GL_TEXTURE_MAG_SIZE_NV, GL_TEXTURE_CUBE_MAP_POSITIVE_X), 0);
  glBindTexture(GL_TEXTURE_RECTANGLE, names[3]);
  EXPECT_NO_GL_ERROR(glTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_SIGNED_HILO_NV, 3, 1, 0, GL_HILO_NV,
                                  GL_SHORT, texels));
  EXPECT_EQ(levelValue(GL_TEXTURE_LO_SIZE_NV, GL_TEXTURE_RECTANGLE), 16);
  EXPECT_NO_GL_ERROR(glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_HILO_NV, 4, 4, 0, GL_HILO_NV,
                                  GL_UNSIGNED_BYTE, nullptr));
  EXPECT_EQ(levelValue(GL_TEXTURE_WIDTH, GL_PROXY_TEXTURE_2D), 4);
  glDeleteTextures(4, names);
}

/// Returns the stored texel, queried as floats.
std::array<GLfloat, 4> texelOf(GLenum format) {
  std::array<GLfloat, 4> texel = {9, 9, 9, 9};
  glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, texel.data());
  return texel;
}

template <typename T>
void expectPixels(GLenum type, const std::array<T, 4> &values,
                  const std::array<GLfloat, 4> &expected,
                  GLenum internal = GL_DSDT_MAG_INTENSITY_NV, GLenum format = GL_DSDT_MAG_VIB_NV) {
  SCOPED_TRACE(testing::Message() << std::hex << type);
  const GLuint name = makeTexel(internal, format, type, values.data());
  const auto texel = texelOf(format);
  for (std::size_t i = 0; i < (format == GL_HILO_NV ? 2u : 4u); ++i)
    EXPECT_NEAR(texel[i], expected[i], 1e-5) << i;
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, PixelsOfEveryType) { // ds and dt are signed, magnitude and vibrance not
  expectPixels(GL_BYTE, std::array<GLbyte, 4>{127, -127, 127, 0}, {1, -1, 1, 0});
  expectPixels(GL_UNSIGNED_BYTE, std::array<GLubyte, 4>{255, 0, 51, 255}, {1, 0, 0.2f, 1});
  expectPixels(GL_SHORT, std::array<GLshort, 4>{32767, -32767, 32767, 0}, {1, -1, 1, 0});
  expectPixels(GL_UNSIGNED_SHORT, std::array<GLushort, 4>{65535, 0, 13107, 65535}, {1, 0, 0.2f, 1});
  expectPixels(GL_INT, std::array<GLint, 4>{INT32_MAX, -INT32_MAX, INT32_MAX, 0}, {1, -1, 1, 0});
  expectPixels(GL_UNSIGNED_INT, std::array<GLuint, 4>{UINT32_MAX, 0, 858993459u, UINT32_MAX},
               {1, 0, 0.2f, 1});
  expectPixels(GL_FLOAT, std::array<GLfloat, 4>{-2, 2, -1, 0.2f}, {-1, 1, 0, 0.2f});
  expectPixels(GL_FLOAT, std::array<GLfloat, 4>{0.25f, 0.75f}, {16384.0f / 65535, 49151.0f / 65535},
               GL_HILO_NV, GL_HILO_NV);
  expectPixels(GL_SHORT, std::array<GLshort, 4>{-32767, 16384}, {-1, 16384.0f / 32767},
               GL_SIGNED_HILO_NV, GL_HILO_NV);
}

/// Expects the two components of the bound texture, read as a type.
template <typename T> void expectRead(GLenum type, std::array<T, 2> expected) {
  SCOPED_TRACE(testing::Message() << std::hex << type);
  std::array<T, 2> texel{};
  EXPECT_NO_GL_ERROR(glGetTexImage(GL_TEXTURE_2D, 0, GL_HILO_NV, type, texel.data()));
  EXPECT_EQ(texel, expected);
}

TEST_F(NvTextureShaders, PixelsAreReadAsEveryType) { // -1 is the second smallest, as it is written
  const GLshort shorts[] = {-32767, 16384};
  const GLuint name = makeTexel(GL_SIGNED_HILO_NV, GL_HILO_NV, GL_SHORT, shorts);
  expectRead(GL_BYTE, std::array<GLbyte, 2>{-127, 64});
  expectRead(GL_UNSIGNED_BYTE, std::array<GLubyte, 2>{0, 128});
  expectRead(GL_SHORT, std::array<GLshort, 2>{-32767, 16384});
  std::array<GLint, 2> ints{};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_HILO_NV, GL_INT, ints.data());
  EXPECT_EQ(ints[0], -INT32_MAX);
  EXPECT_NEAR(ints[1] / double(INT32_MAX), 16384.0 / 32767, 1e-6);
  std::array<GLuint, 2> unsignedInts{};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_HILO_NV, GL_UNSIGNED_INT, unsignedInts.data());
  EXPECT_EQ(unsignedInts[0], 0u);
  EXPECT_NEAR(unsignedInts[1] / double(UINT32_MAX), 16384.0 / 32767, 1e-6);

  glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
  expectRead(GL_SHORT, std::array<GLshort, 2>{0x0180, 0x0040});
  glPixelStorei(GL_PACK_SWAP_BYTES, GL_FALSE);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_PACK_BUFFER, 8, nullptr, GL_STATIC_READ);
  void *const behind = reinterpret_cast<void *>(4);
  EXPECT_NO_GL_ERROR(glGetTexImage(GL_TEXTURE_2D, 0, GL_HILO_NV, GL_SHORT, behind));
  std::array<GLshort, 2> back{};
  glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 4, 4, back.data());
  EXPECT_EQ(back, (std::array<GLshort, 2>{-32767, 16384}));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glGetTexImage(GL_TEXTURE_2D, 0, GL_HILO_NV, GL_INT, behind));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, PackedPixels) { // table 3.8: S8 components are signed
  const GLuint word = 0x7F81C040;
  GLuint name =
      makeTexel(GL_DSDT_MAG_INTENSITY_NV, GL_DSDT_MAG_VIB_NV, GL_UNSIGNED_INT_S8_S8_8_8_NV, &word);
  auto texel = texelOf(GL_DSDT_MAG_VIB_NV);
  EXPECT_NEAR(texel[0], 1, 1e-5);
  EXPECT_NEAR(texel[1], -1, 1e-5);
  EXPECT_NEAR(texel[2], 192.0f / 255, 1e-5);
  EXPECT_NEAR(texel[3], 64.0f / 255, 1e-5);
  GLuint back = 0;
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DSDT_MAG_VIB_NV, GL_UNSIGNED_INT_S8_S8_8_8_NV, &back);
  EXPECT_EQ(back, word);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DSDT_MAG_VIB_NV, GL_UNSIGNED_INT_8_8_S8_S8_REV_NV, &back);
  EXPECT_EQ(back, 0x40C0817Fu);
  glDeleteTextures(1, &name);
  name = makeTexel(GL_DSDT_MAG_INTENSITY_NV, GL_DSDT_MAG_VIB_NV, GL_UNSIGNED_INT_8_8_S8_S8_REV_NV,
                   &back);
  texel = texelOf(GL_DSDT_MAG_VIB_NV);
  EXPECT_NEAR(texel[1], -1, 1e-5);
  EXPECT_NEAR(texel[3], 64.0f / 255, 1e-5);
  glDeleteTextures(1, &name);
}

/// Places a 2x2 image of HILO bytes within memory, by row length and skips.
TEST_F(NvTextureShaders, WherePixelsLieInMemory) {
  GLubyte memory[64] = {};
  // There are three texels a row; one row and one texel are skipped.
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t column = 0; column < 2; ++column)
      memory[(row + 1) * 6 + (column + 1) * 2] = GLubyte(51 * (1 + row * 2 + column));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 3);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const auto define = [](const void *pixels) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_HILO8_NV, 2, 2, 0, GL_HILO_NV, GL_UNSIGNED_BYTE, pixels);
  };
  const auto expectAll = [] {
    GLfloat texels[8] = {};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_HILO_NV, GL_FLOAT, texels);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(texels[i * 2], 0.2f * GLfloat(i + 1), 1e-4) << i;
  };
  define(memory);
  expectAll();
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_UNPACK_BUFFER, sizeof memory, memory, GL_STATIC_DRAW);
  define(nullptr);
  expectAll();
  glBufferData(GL_PIXEL_UNPACK_BUFFER, 8, memory, GL_STATIC_DRAW);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, define(nullptr));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
  const GLushort swapped[] = {0x3412, 0};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_HILO_NV, 1, 1, 0, GL_HILO_NV, GL_UNSIGNED_SHORT, swapped);
  EXPECT_NEAR(texelOf(GL_HILO_NV)[0], GLfloat(0x1234) / 65535, 1e-5);
  glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, ScalesAndBiasesOfComponents) { // 3.6.5
  glPixelTransferf(GL_HI_SCALE_NV, 0.5f);
  glPixelTransferf(GL_LO_BIAS_NV, 0.25f);
  glPixelTransferf(GL_DS_SCALE_NV, -1);
  glPixelTransferf(GL_VIBRANCE_BIAS_NV, -2);
  expectPixels(GL_FLOAT, std::array<GLfloat, 4>{0.8f, 0.5f}, {0.4f, 0.75f}, GL_HILO_NV, GL_HILO_NV);
  expectPixels(GL_FLOAT, std::array<GLfloat, 4>{1, 1, 1, 1}, {-1, 1, 1, 0});
  glPixelTransferf(GL_RED_SCALE, 0.25f); // for colors only, not for these
  expectPixels(GL_FLOAT, std::array<GLfloat, 4>{0.8f, 0.5f}, {0.4f, 0.75f}, GL_HILO_NV, GL_HILO_NV);
  glPixelTransferf(GL_RED_SCALE, 1);
}

TEST_F(NvTextureShaders, SignedColors) {
  const GLfloat color[] = {-1, 0.5f, -2, 1};
  const GLuint name = makeTexel(GL_SIGNED_RGBA_NV, GL_RGBA, GL_FLOAT, color);
  auto texel = texelOf(GL_RGBA);
  EXPECT_NEAR(texel[0], -1, 1e-2);
  EXPECT_NEAR(texel[1], 0.5f, 1e-2);
  EXPECT_NEAR(texel[2], -1, 1e-2);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SIGNED_RGB_UNSIGNED_ALPHA_NV, 1, 1, 0, GL_RGBA, GL_FLOAT,
               color);
  texel = texelOf(GL_RGBA);
  EXPECT_NEAR(texel[0], -1, 1e-2);
  EXPECT_NEAR(texel[3], 1, 1e-2);
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, ImagesInLists) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  GLubyte texel[] = {255, 51};
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_HILO_NV, 1, 1, 0, GL_HILO_NV, GL_UNSIGNED_BYTE, texel);
  glEndList();
  EXPECT_EQ(levelValue(GL_TEXTURE_WIDTH), 0);
  std::memset(texel, 0, sizeof texel); // the list has a copy
  glPixelTransferf(GL_HI_SCALE_NV, 0.5f);
  glCallList(list);
  EXPECT_EQ(levelValue(GL_TEXTURE_INTERNAL_FORMAT), GL_HILO_NV);
  EXPECT_NEAR(texelOf(GL_HILO_NV)[0], 0.5f, 1e-4) << "scaled by what is set at the call";
  EXPECT_NEAR(texelOf(GL_HILO_NV)[1], 0.2f, 1e-4);
  glDeleteLists(list, 1);
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, BorderValuesAreNotClamped) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const GLfloat border[] = {-1, 2, 0.5f, -0.25f};
  EXPECT_NO_GL_ERROR(glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_VALUES_NV, border));
  GLfloat back[4] = {};
  EXPECT_NO_GL_ERROR(glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_VALUES_NV, back));
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(back[i], border[i]) << i;
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_VALUES_NV, 1));
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, FormatsAreTheGroups) {
  const GLubyte texel[16] = {};
  const GLuint name = makeTexel(GL_DSDT_NV, GL_DSDT_NV, GL_BYTE, texel);
  const GlContext other(&m_context);
  other.makeCurrent();
  glBindTexture(GL_TEXTURE_2D, name);
  EXPECT_EQ(levelValue(GL_TEXTURE_INTERNAL_FORMAT), GL_DSDT_NV);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel));
  m_context.makeCurrent();
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, WhatProgramsSample) { // NV_fragment_program, table X.5
  makeProgram("!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
              "MAD result.color, t, {0.5,0.5,0.5,0.5}, {0.5,0.5,0.5,0.5};\nEND");
  glEnable(kFragment);
  const auto expectDrawn = [](const std::array<float, 4> &texel) {
    const Pixel pixel = drawn();
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(float(pixel[i]), (texel[i] * 0.5f + 0.5f) * 255, 2) << i;
  };
  const GLfloat half[] = {-0.5f, 0.5f, -1, 0.25f};
  GLuint name = makeTexel(GL_SIGNED_HILO_NV, GL_HILO_NV, GL_FLOAT, half);
  expectDrawn({-0.5f, 0.5f, 0.7071f, 1});
  glDeleteTextures(1, &name);
  name = makeTexel(GL_SIGNED_RGBA_NV, GL_RGBA, GL_FLOAT, half);
  expectDrawn({-0.5f, 0.5f, -1, 0.25f});
  glDeleteTextures(1, &name);
  name = makeTexel(GL_HILO_NV, GL_HILO_NV, GL_FLOAT, half);
  expectDrawn({0, 0.5f, 1, 1});
  glDeleteTextures(1, &name);
}

} // namespace
} // namespace api::shaders
