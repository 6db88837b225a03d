// The state of NV_texture_shader, 2 and 3: initial values, queries, attribute groups, lists.
#include "texture_shaders.h"

namespace api::shaders {
namespace {

using Four = std::array<GLfloat, 4>;

TEST_F(NvTextureShaders, InitialState) { // table 6.TextureShaders
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  for (int i = 0; i < units(); ++i) {
    unit(i);
    EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_NONE) << i;
    EXPECT_EQ(value(GL_PREVIOUS_TEXTURE_INPUT_NV), GL_TEXTURE0) << i;
    EXPECT_EQ(value(GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV), GL_UNSIGNED_IDENTITY_NV) << i;
    EXPECT_EQ(values(GL_OFFSET_TEXTURE_MATRIX_NV), (Four{1, 0, 0, 1})) << i;
    EXPECT_EQ(values(GL_OFFSET_TEXTURE_SCALE_NV)[0], 1.0f) << i;
    EXPECT_EQ(values(GL_OFFSET_TEXTURE_BIAS_NV)[0], 0.0f) << i;
    EXPECT_EQ(values(GL_CONST_EYE_NV), (Four{0, 0, -1, 9})) << i;
    GLint modes[4] = {};
    glGetTexEnviv(kShader, GL_CULL_MODES_NV, modes);
    for (const GLint mode : modes)
      EXPECT_EQ(mode, GL_GEQUAL) << i;
    EXPECT_TRUE(isConsistent(i)) << i;
  }
}

TEST_F(NvTextureShaders, WhatIsSetIsGivenBack) {
  const int last = units() - 1;
  unit(last);
  operation(GL_PASS_THROUGH_NV);
  previous(last - 1);
  const GLfloat matrix[] = {1.5f, -2, 3, -4.25f}, eye[] = {0.25f, -0.5f, 2};
  const GLint modes[] = {GL_LESS, GL_GEQUAL, GL_GEQUAL, GL_LESS};
  glTexEnvfv(kShader, GL_OFFSET_TEXTURE_MATRIX_NV, matrix);
  glTexEnvfv(kShader, GL_CONST_EYE_NV, eye);
  glTexEnviv(kShader, GL_CULL_MODES_NV, modes);
  glTexEnvf(kShader, GL_OFFSET_TEXTURE_SCALE_NV, -3);
  glTexEnvf(kShader, GL_OFFSET_TEXTURE_BIAS_NV, 0.125f);
  glTexEnvi(kShader, GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV, GL_FORCE_BLUE_TO_ONE_NV);
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_PASS_THROUGH_NV);
  EXPECT_EQ(value(GL_PREVIOUS_TEXTURE_INPUT_NV), GL_TEXTURE0 + last - 1);
  EXPECT_EQ(values(GL_OFFSET_TEXTURE_MATRIX_NV), (Four{1.5f, -2, 3, -4.25f}));
  EXPECT_EQ(values(GL_CONST_EYE_NV), (Four{0.25f, -0.5f, 2, 9}));
  EXPECT_EQ(values(GL_OFFSET_TEXTURE_SCALE_NV)[0], -3.0f);
  EXPECT_EQ(values(GL_OFFSET_TEXTURE_BIAS_NV)[0], 0.125f);
  EXPECT_EQ(value(GL_RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV), GL_FORCE_BLUE_TO_ONE_NV);
  GLint back[4] = {};
  glGetTexEnviv(kShader, GL_CULL_MODES_NV, back);
  EXPECT_EQ(back[0], GL_LESS);
  EXPECT_EQ(back[1], GL_GEQUAL);
  EXPECT_EQ(back[3], GL_LESS);
  unit(0); // it has its own state
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_NONE);
  EXPECT_EQ(values(GL_OFFSET_TEXTURE_MATRIX_NV), (Four{1, 0, 0, 1}));
}

TEST_F(NvTextureShaders, ContextsHaveTheirOwn) {
  operation(GL_PASS_THROUGH_NV);
  glEnable(GL_TEXTURE_SHADER_NV);
  const GlContext other(&m_context);
  other.makeCurrent();
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_NONE);
  m_context.makeCurrent();
  EXPECT_TRUE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_PASS_THROUGH_NV);
}

TEST_F(NvTextureShaders, TheEnvironmentNone) {
  unit(1);
  EXPECT_NO_GL_ERROR(glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE));
  EXPECT_EQ(value(GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV), GL_NONE);
  unit(0);
  EXPECT_EQ(value(GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV), GL_MODULATE);
  unit(1);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  EXPECT_EQ(value(GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV), GL_REPLACE);
}

TEST_F(NvTextureShaders, ScalesAndBiases) {
  constexpr GLenum kScales[] = {GL_HI_SCALE_NV, GL_LO_SCALE_NV,        GL_DS_SCALE_NV,
                                GL_DT_SCALE_NV, GL_MAGNITUDE_SCALE_NV, GL_VIBRANCE_SCALE_NV};
  constexpr GLenum kBiases[] = {GL_HI_BIAS_NV, GL_LO_BIAS_NV,        GL_DS_BIAS_NV,
                                GL_DT_BIAS_NV, GL_MAGNITUDE_BIAS_NV, GL_VIBRANCE_BIAS_NV};
  const auto get = [](GLenum name) {
    GLfloat result = 9;
    glGetFloatv(name, &result);
    return result;
  };
  for (const GLenum name : kScales)
    EXPECT_EQ(get(name), 1.0f);
  for (const GLenum name : kBiases)
    EXPECT_EQ(get(name), 0.0f);
  glPushAttrib(GL_PIXEL_MODE_BIT);
  for (std::size_t i = 0; i < 6; ++i) {
    glPixelTransferf(kScales[i], 2.0f + GLfloat(i));
    glPixelTransferf(kBiases[i], -0.5f * GLfloat(i));
  }
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(get(kScales[i]), 2.0f + GLfloat(i));
    EXPECT_EQ(get(kBiases[i]), -0.5f * GLfloat(i));
  }
  glPopAttrib();
  EXPECT_EQ(get(GL_VIBRANCE_SCALE_NV), 1.0f);
  EXPECT_EQ(get(GL_VIBRANCE_BIAS_NV), 0.0f);
  glPixelTransferi(GL_HI_SCALE_NV, 3);
  EXPECT_EQ(integer(GL_HI_SCALE_NV), 3);
}

TEST_F(NvTextureShaders, AttributeGroups) {
  glPushAttrib(GL_TEXTURE_BIT);
  glEnable(GL_TEXTURE_SHADER_NV);
  operation(GL_PASS_THROUGH_NV);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
  glPopAttrib();
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_NONE);
  EXPECT_EQ(value(GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV), GL_MODULATE);
  glPushAttrib(GL_ENABLE_BIT);
  glEnable(GL_TEXTURE_SHADER_NV);
  operation(GL_PASS_THROUGH_NV);
  glPopAttrib();
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_PASS_THROUGH_NV);
}

TEST_F(NvTextureShaders, DisplayLists) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glEnable(GL_TEXTURE_SHADER_NV);
  operation(GL_PASS_THROUGH_NV);
  glPixelTransferf(GL_LO_SCALE_NV, 4);
  glTexEnvi(kShader, GL_SHADER_OPERATION_NV, GL_FOG); // an error when the list is called
  glTexEnvf(kShader, GL_OFFSET_TEXTURE_BIAS_NV, 7);
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_NONE);
  glEndList();
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCallList(list));
  EXPECT_TRUE(glIsEnabled(GL_TEXTURE_SHADER_NV));
  EXPECT_EQ(value(GL_SHADER_OPERATION_NV), GL_PASS_THROUGH_NV);
  EXPECT_EQ(values(GL_OFFSET_TEXTURE_BIAS_NV)[0], 7.0f);
  EXPECT_EQ(integer(GL_LO_SCALE_NV), 4);
  glDeleteLists(list, 1);
}

TEST_F(NvTextureShaders, ConsistencyFollowsTextures) {
  operation(GL_TEXTURE_2D);
  EXPECT_FALSE(isConsistent(0)) << "the default texture is incomplete";
  makeTexture(GL_TEXTURE_2D, kRedPixel);
  EXPECT_TRUE(isConsistent(0));
  unit(1);
  makeTexture(GL_TEXTURE_2D, kRedPixel);
  operation(GL_DEPENDENT_AR_TEXTURE_2D_NV);
  EXPECT_TRUE(isConsistent(1));
  unit(0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_FALSE(isConsistent(0)) << "a filter of a pyramid that is not there";
  EXPECT_FALSE(isConsistent(1)) << "and with it what reads it";
  unit(0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  EXPECT_TRUE(isConsistent(0));
  EXPECT_TRUE(isConsistent(1));
  unit(0);
  const GLbyte texel[] = {127, 0, -127, 127};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SIGNED_RGBA8_NV, 1, 1, 0, GL_RGBA, GL_BYTE, texel);
  EXPECT_TRUE(isConsistent(0));
  EXPECT_FALSE(isConsistent(1)) << "a dependent AR read is of unsigned colours";
}

} // namespace
} // namespace api::shaders
