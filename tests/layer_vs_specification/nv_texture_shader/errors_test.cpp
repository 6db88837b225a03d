// The errors of NV_texture_shader, 2 and 3.
#include "texture_shaders.h"

namespace api::shaders {
namespace {

constexpr GLenum kBehindAnother[] = { // operations that unit 0 cannot have
    GL_OFFSET_TEXTURE_2D_NV,
    GL_OFFSET_TEXTURE_2D_SCALE_NV,
    GL_OFFSET_TEXTURE_RECTANGLE_NV,
    GL_OFFSET_TEXTURE_RECTANGLE_SCALE_NV,
    GL_DEPENDENT_AR_TEXTURE_2D_NV,
    GL_DEPENDENT_GB_TEXTURE_2D_NV,
    GL_DOT_PRODUCT_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_2D_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_2D_SCALE_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_RECTANGLE_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_RECTANGLE_SCALE_NV,
    GL_OFFSET_HILO_TEXTURE_2D_NV,
    GL_OFFSET_HILO_TEXTURE_RECTANGLE_NV,
    GL_OFFSET_HILO_PROJECTIVE_TEXTURE_2D_NV,
    GL_OFFSET_HILO_PROJECTIVE_TEXTURE_RECTANGLE_NV,
    GL_DEPENDENT_HILO_TEXTURE_2D_NV,
    GL_DEPENDENT_RGB_TEXTURE_3D_NV,
    GL_DEPENDENT_RGB_TEXTURE_CUBE_MAP_NV,
    GL_DOT_PRODUCT_PASS_THROUGH_NV,
    GL_DOT_PRODUCT_TEXTURE_1D_NV,
    GL_DOT_PRODUCT_AFFINE_DEPTH_REPLACE_NV};
constexpr GLenum kOfTwoStages[] = {
    GL_DOT_PRODUCT_TEXTURE_2D_NV, GL_DOT_PRODUCT_TEXTURE_RECTANGLE_NV,
    GL_DOT_PRODUCT_DIFFUSE_CUBE_MAP_NV, GL_DOT_PRODUCT_DEPTH_REPLACE_NV};
constexpr GLenum kOfThreeStages[] = {
    GL_DOT_PRODUCT_TEXTURE_CUBE_MAP_NV, GL_DOT_PRODUCT_REFLECT_CUBE_MAP_NV,
    GL_DOT_PRODUCT_CONST_EYE_REFLECT_CUBE_MAP_NV, GL_DOT_PRODUCT_TEXTURE_3D_NV};

/// Expects that `first` is the first unit that may have the operations (3.8.13.2).
template <std::size_t N> void expectFirst(const GLenum (&operations)[N], int first) {
  for (const GLenum name : operations)
    for (int i = 0; i <= first; ++i) {
      unit(i);
      operation(GL_PASS_THROUGH_NV);
      EXPECT_GL_ERROR(i < first ? GL_INVALID_OPERATION : GL_NO_ERROR, operation(name));
      EXPECT_EQ(value(GL_SHADER_OPERATION_NV), i < first ? GL_PASS_THROUGH_NV : GLint(name))
          << "unit " << i;
    }
}

TEST_F(NvTextureShaders, OperationsThatAUnitCannotHave) {
  expectFirst(kBehindAnother, 1);
  expectFirst(kOfTwoStages, 2);
  expectFirst(kOfThreeStages, 3);
  unit(units() - 1);
  operation(GL_PASS_THROUGH_NV);
  for (const GLenum name : {GL_DOT_PRODUCT_NV, GL_DOT_PRODUCT_DIFFUSE_CUBE_MAP_NV})
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, operation(name));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_PASS_THROUGH_NV);
  unit(0);
  for (const GLenum name : {GL_NONE, GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D,
                            GL_TEXTURE_RECTANGLE_NV, GL_TEXTURE_CUBE_MAP, GL_CULL_FRAGMENT_NV})
    EXPECT_NO_GL_ERROR(operation(name));
}

TEST_F(NvTextureShaders, NamesAndValues) {
  unit(1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, operation(GL_FOG));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(kShader, GL_TEXTURE_ENV_MODE, GL_REPLACE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(kShader, GL_SHADER_CONSISTENT_NV, GL_TRUE));
  for (const GLenum name : {GL_CULL_MODES_NV, GL_OFFSET_TEXTURE_MATRIX_NV, GL_CONST_EYE_NV})
    EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(kShader, name, GL_LESS));
  const GLint modes[] = {GL_LESS, GL_LESS, GL_EQUAL, GL_LESS};
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnviv(kShader, GL_CULL_MODES_NV, modes));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(kShader, GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV,
                                             GL_SIGNED_IDENTITY_NV));
  GLint out[4] = {};
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetTexEnviv(kShader, GL_TEXTURE_ENV_MODE, out));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_NONE);
}

TEST_F(NvTextureShaders, PreviousInputs) {
  unit(2);
  EXPECT_NO_GL_ERROR(previous(0));
  EXPECT_NO_GL_ERROR(previous(1));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, previous(2)); // not an earlier unit
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, previous(3));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(kShader, GL_PREVIOUS_TEXTURE_INPUT_NV, GL_TEXTURE_2D));
  EXPECT_EQ(value(GL_PREVIOUS_TEXTURE_INPUT_NV), GL_TEXTURE1);
}

TEST_F(NvTextureShaders, BetweenBeginAndEnd) {
  glBegin(GL_TRIANGLES);
  operation(GL_PASS_THROUGH_NV);
  glEnable(GL_TEXTURE_SHADER_NV);
  glPixelTransferf(GL_HI_SCALE_NV, 3);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  while (glGetError() != GL_NO_ERROR) {
  }
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_NONE);
  EXPECT_EQ(integer(GL_HI_SCALE_NV), 1);
}

/// An internal format, and a suitable format for TexImage; 0: colors.
struct Pair {
  GLenum internal, format;
};
constexpr Pair kPairs[] = {{GL_SIGNED_RGBA_NV, 0},
                           {GL_SIGNED_RGB8_NV, 0},
                           {GL_SIGNED_LUMINANCE_NV, 0},
                           {GL_SIGNED_RGB_UNSIGNED_ALPHA_NV, 0},
                           {GL_RGBA8, 0},
                           {GL_HILO_NV, GL_HILO_NV},
                           {GL_HILO16_NV, GL_HILO_NV},
                           {GL_SIGNED_HILO_NV, GL_HILO_NV},
                           {GL_SIGNED_HILO8_NV, GL_HILO_NV},
                           {GL_DSDT_NV, GL_DSDT_NV},
                           {GL_DSDT8_NV, GL_DSDT_NV},
                           {GL_DSDT_MAG_NV, GL_DSDT_MAG_NV},
                           {GL_DSDT8_MAG8_NV, GL_DSDT_MAG_NV},
                           {GL_DSDT_MAG_INTENSITY_NV, GL_DSDT_MAG_VIB_NV},
                           {GL_DSDT8_MAG8_INTENSITY8_NV, GL_DSDT_MAG_VIB_NV}};
constexpr GLenum kFormats[] = {GL_RGBA,    GL_RGB,         GL_LUMINANCE,       GL_HILO_NV,
                               GL_DSDT_NV, GL_DSDT_MAG_NV, GL_DSDT_MAG_VIB_NV, GL_RED,
                               GL_ALPHA};

bool fits(const Pair &pair, GLenum format) {
  const bool isComponents = format == GL_HILO_NV || format == GL_DSDT_NV ||
                            format == GL_DSDT_MAG_NV || format == GL_DSDT_MAG_VIB_NV;
  return pair.format == 0 ? !isComponents : format == pair.format;
}

TEST_F(NvTextureShaders, FormatsThatDoNotGoWithAnInternalFormat) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  GLubyte pixels[64] = {};
  for (const Pair &pair : kPairs)
    for (const GLenum format : kFormats) {
      SCOPED_TRACE(testing::Message() << std::hex << pair.internal << " of " << format);
      const GLenum expected = fits(pair, format) ? GL_NO_ERROR : GL_INVALID_OPERATION;
      EXPECT_GL_ERROR(expected, glTexImage2D(GL_TEXTURE_2D, 0, GLint(pair.internal), 1, 1, 0,
                                             format, GL_UNSIGNED_BYTE, pixels));
      if (expected != GL_NO_ERROR)
        continue;
      for (const GLenum other : kFormats) {
        const GLenum wanted = fits(pair, other) ? GL_NO_ERROR : GL_INVALID_OPERATION;
        EXPECT_GL_ERROR(
            wanted, glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, other, GL_UNSIGNED_BYTE, pixels));
        EXPECT_GL_ERROR(wanted, glGetTexImage(GL_TEXTURE_2D, 0, other, GL_UNSIGNED_BYTE, pixels));
      }
      break;
    }
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, TypesThatDoNotGoWithAFormat) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const GLuint pixel = 0;
  const auto define = [&](GLenum internal, GLenum format, GLenum type) {
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(internal), 1, 1, 0, format, type, &pixel);
  };
  for (const GLenum type : {GL_UNSIGNED_INT_S8_S8_8_8_NV, GL_UNSIGNED_INT_8_8_S8_S8_REV_NV}) {
    EXPECT_NO_GL_ERROR(define(GL_DSDT_MAG_INTENSITY_NV, GL_DSDT_MAG_VIB_NV, type));
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, define(GL_DSDT_MAG_NV, GL_DSDT_MAG_NV, type));
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, define(GL_HILO_NV, GL_HILO_NV, type));
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, define(GL_RGBA8, GL_RGBA, type));
    EXPECT_GL_ERROR(GL_INVALID_ENUM, glReadPixels(0, 0, 1, 1, GL_RGBA, type, nullptr));
  }
  for (const GLenum format : {GL_HILO_NV, GL_DSDT_NV, GL_DSDT_MAG_NV, GL_DSDT_MAG_VIB_NV}) {
    GLubyte pixels[16] = {};
    EXPECT_GL_ERROR(GL_INVALID_ENUM, glReadPixels(0, 0, 1, 1, format, GL_UNSIGNED_BYTE, pixels));
    EXPECT_GL_ERROR(GL_INVALID_ENUM, glDrawPixels(1, 1, format, GL_UNSIGNED_BYTE, pixels));
  }
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, SizesThatNoImageHas) {
  const GLubyte texel[] = {10, 20};
  const GLuint name = makeTexel(GL_HILO_NV, GL_HILO_NV, GL_UNSIGNED_BYTE, texel);
  const auto define = [](GLint level, GLsizei width, GLsizei height) {
    glTexImage2D(GL_TEXTURE_2D, level, GL_HILO_NV, width, height, 0, GL_HILO_NV, GL_UNSIGNED_BYTE,
                 "");
  };
  EXPECT_GL_ERROR(GL_INVALID_VALUE, define(0, 1 << 28, 1));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, define(0, 1, 1 << 28));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, define(0, -1, 1));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, define(-1, 1, 1));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 1, 1, GL_HILO_NV,
                                                    GL_UNSIGNED_BYTE, texel));
  EXPECT_EQ(levelValue(GL_TEXTURE_INTERNAL_FORMAT), GL_HILO_NV) << "the old image stays";
  EXPECT_EQ(levelValue(GL_TEXTURE_WIDTH), 1);
  EXPECT_NO_GL_ERROR(
      glTexImage2D(GL_TEXTURE_2D, 0, GL_HILO_NV, 4, 4, 0, GL_HILO_NV, GL_UNSIGNED_BYTE, nullptr));
  EXPECT_EQ(levelValue(GL_TEXTURE_WIDTH), 4);
  glDeleteTextures(1, &name);
}

TEST_F(NvTextureShaders, CopiesToImagesWithoutColors) { // 3.8.2
  const GLubyte texel[] = {10, 20};
  const GLuint name = makeTexel(GL_HILO_NV, GL_HILO_NV, GL_UNSIGNED_BYTE, texel);
  for (const GLenum internal :
       {GL_HILO_NV, GL_SIGNED_HILO_NV, GL_DSDT_NV, GL_DSDT_MAG_NV, GL_DSDT_MAG_INTENSITY_NV})
    EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                    glCopyTexImage2D(GL_TEXTURE_2D, 0, internal, 0, 0, 1, 1, 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1));
  EXPECT_NO_GL_ERROR(glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 1, 1, 0));
  EXPECT_EQ(levelValue(GL_TEXTURE_INTERNAL_FORMAT), GL_RGBA8);
  EXPECT_NO_GL_ERROR(glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1));
  glDeleteTextures(1, &name);
}

} // namespace
} // namespace api::shaders
