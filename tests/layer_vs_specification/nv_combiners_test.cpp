// The state of NV_register_combiners and 2: initial values, queries, errors, attribute groups,
// lists.
#include "nv_combiners.h"

namespace api::combiners {
namespace {

using Color = std::array<GLfloat, 4>;

TEST_F(NvCombiners, InitialState) { // tables RC.5 and RC.6, section 3.8.12.4
  EXPECT_FALSE(glIsEnabled(GL_REGISTER_COMBINERS_NV));
  EXPECT_FALSE(glIsEnabled(GL_PER_STAGE_CONSTANTS_NV));
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), 1);
  EXPECT_EQ(integer(GL_COLOR_SUM_CLAMP_NV), GL_TRUE);
  const int stages = integer(GL_MAX_GENERAL_COMBINERS_NV);
  EXPECT_EQ(stages, 8);
  EXPECT_EQ(constantValue(GL_CONSTANT_COLOR0_NV), (Color{0, 0, 0, 0}));
  EXPECT_EQ(constantValue(GL_CONSTANT_COLOR1_NV), (Color{0, 0, 0, 0}));
  for (GLenum stage = GL_COMBINER0_NV; stage < GLenum(GL_COMBINER0_NV + stages); ++stage)
    for (const GLenum portion : {GL_RGB, GL_ALPHA}) {
      const auto is = [&](GLenum variable, GLint source, GLint mapping) {
        EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV, variable, portion, stage), source);
        EXPECT_EQ(inputValue(GL_COMBINER_MAPPING_NV, variable, portion, stage), mapping);
        EXPECT_EQ(inputValue(GL_COMBINER_COMPONENT_USAGE_NV, variable, portion, stage),
                  GLint(portion));
      };
      is(GL_VARIABLE_A_NV, GL_PRIMARY_COLOR_NV, GL_UNSIGNED_IDENTITY_NV);
      is(GL_VARIABLE_B_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV);
      is(GL_VARIABLE_C_NV, GL_ZERO, GL_UNSIGNED_IDENTITY_NV);
      is(GL_VARIABLE_D_NV, GL_ZERO, GL_UNSIGNED_IDENTITY_NV);
      for (const GLenum flag :
           {GL_COMBINER_AB_DOT_PRODUCT_NV, GL_COMBINER_CD_DOT_PRODUCT_NV, GL_COMBINER_MUX_SUM_NV})
        EXPECT_EQ(outputValue(flag, portion, stage), GL_FALSE);
      EXPECT_EQ(outputValue(GL_COMBINER_SCALE_NV, portion, stage), GL_NONE);
      EXPECT_EQ(outputValue(GL_COMBINER_BIAS_NV, portion, stage), GL_NONE);
      EXPECT_EQ(outputValue(GL_COMBINER_AB_OUTPUT_NV, portion, stage), GL_DISCARD_NV);
      EXPECT_EQ(outputValue(GL_COMBINER_CD_OUTPUT_NV, portion, stage), GL_DISCARD_NV);
      EXPECT_EQ(outputValue(GL_COMBINER_SUM_OUTPUT_NV, portion, stage), GL_SPARE0_NV);
    }
  constexpr GLint kFinals[7][2] = {
      {GL_FOG, GL_ALPHA},      {GL_SPARE0_PLUS_SECONDARY_COLOR_NV, GL_RGB},
      {GL_FOG, GL_RGB},        {GL_ZERO, GL_RGB},
      {GL_ZERO, GL_RGB},       {GL_ZERO, GL_RGB},
      {GL_SPARE0_NV, GL_ALPHA}};
  for (GLenum v = 0; v < 7; ++v) {
    EXPECT_EQ(finalValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_A_NV + v), kFinals[v][0]) << v;
    EXPECT_EQ(finalValue(GL_COMBINER_COMPONENT_USAGE_NV, GL_VARIABLE_A_NV + v), kFinals[v][1]) << v;
    EXPECT_EQ(finalValue(GL_COMBINER_MAPPING_NV, GL_VARIABLE_A_NV + v), GL_UNSIGNED_IDENTITY_NV);
  }
}

TEST_F(NvCombiners, WhatIsSetIsGivenBack) {
  constexpr GLenum kRegisters[] = {GL_ZERO,      GL_CONSTANT_COLOR0_NV, GL_CONSTANT_COLOR1_NV,
                                   GL_FOG,       GL_PRIMARY_COLOR_NV,   GL_SECONDARY_COLOR_NV,
                                   GL_SPARE0_NV, GL_SPARE1_NV,          GL_TEXTURE0,
                                   GL_TEXTURE1};
  for (const GLenum source : kRegisters)
    for (GLenum mapping = GL_UNSIGNED_IDENTITY_NV; mapping <= GL_SIGNED_NEGATE_NV; ++mapping) {
      input(GL_COMBINER3_NV, GL_RGB, GL_VARIABLE_C_NV, source, mapping, GL_RGB);
      EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_C_NV, GL_RGB, GL_COMBINER3_NV),
                GLint(source));
      EXPECT_EQ(inputValue(GL_COMBINER_MAPPING_NV, GL_VARIABLE_C_NV, GL_RGB, GL_COMBINER3_NV),
                GLint(mapping));
    }
  input(GL_COMBINER1_NV, GL_ALPHA, GL_VARIABLE_D_NV, GL_FOG, GL_SIGNED_NEGATE_NV, GL_BLUE);
  EXPECT_EQ(inputValue(GL_COMBINER_COMPONENT_USAGE_NV, GL_VARIABLE_D_NV, GL_ALPHA, GL_COMBINER1_NV),
            GL_BLUE);
  glCombinerOutputNV(GL_COMBINER2_NV, GL_RGB, GL_TEXTURE1, GL_SPARE1_NV, GL_PRIMARY_COLOR_NV,
                     GL_SCALE_BY_TWO_NV, GL_BIAS_BY_NEGATIVE_ONE_HALF_NV, GL_TRUE, GL_FALSE,
                     GL_TRUE);
  const auto of2 = [](GLenum pname) { return outputValue(pname, GL_RGB, GL_COMBINER2_NV); };
  EXPECT_EQ(of2(GL_COMBINER_AB_OUTPUT_NV), GL_TEXTURE1);
  EXPECT_EQ(of2(GL_COMBINER_CD_OUTPUT_NV), GL_SPARE1_NV);
  EXPECT_EQ(of2(GL_COMBINER_SUM_OUTPUT_NV), GL_PRIMARY_COLOR_NV);
  EXPECT_EQ(of2(GL_COMBINER_SCALE_NV), GL_SCALE_BY_TWO_NV);
  EXPECT_EQ(of2(GL_COMBINER_BIAS_NV), GL_BIAS_BY_NEGATIVE_ONE_HALF_NV);
  EXPECT_EQ(of2(GL_COMBINER_AB_DOT_PRODUCT_NV), GL_TRUE);
  EXPECT_EQ(of2(GL_COMBINER_CD_DOT_PRODUCT_NV), GL_FALSE);
  EXPECT_EQ(of2(GL_COMBINER_MUX_SUM_NV), GL_TRUE);
  final(GL_VARIABLE_D_NV, GL_E_TIMES_F_NV, GL_RGB, GL_UNSIGNED_INVERT_NV);
  EXPECT_EQ(finalValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_D_NV), GL_E_TIMES_F_NV);
  EXPECT_EQ(finalValue(GL_COMBINER_MAPPING_NV, GL_VARIABLE_D_NV), GL_UNSIGNED_INVERT_NV);
  GLfloat asFloat = -1;
  glGetFinalCombinerInputParameterfvNV(GL_VARIABLE_D_NV, GL_COMBINER_INPUT_NV, &asFloat);
  EXPECT_EQ(asFloat, GLfloat(GL_E_TIMES_F_NV));
  glGetCombinerOutputParameterfvNV(GL_COMBINER2_NV, GL_RGB, GL_COMBINER_SCALE_NV, &asFloat);
  EXPECT_EQ(asFloat, GLfloat(GL_SCALE_BY_TWO_NV));
  glGetCombinerInputParameterfvNV(GL_COMBINER1_NV, GL_ALPHA, GL_VARIABLE_D_NV, GL_COMBINER_INPUT_NV,
                                  &asFloat);
  EXPECT_EQ(asFloat, GLfloat(GL_FOG));
}

TEST_F(NvCombiners, ColorsAreClampedAndConverted) {
  constant(GL_CONSTANT_COLOR0_NV, -1, 0.25f, 2, 0.5f);
  EXPECT_EQ(constantValue(GL_CONSTANT_COLOR0_NV), (Color{0, 0.25f, 1, 0.5f}));
  const GLint integers[] = {INT32_MAX, 0, INT32_MIN, INT32_MAX};
  glCombinerParameterivNV(GL_CONSTANT_COLOR1_NV, integers);
  EXPECT_EQ(constantValue(GL_CONSTANT_COLOR1_NV)[0], 1.0f);
  EXPECT_NEAR(constantValue(GL_CONSTANT_COLOR1_NV)[1], 0.0f, 1e-6f);
  EXPECT_EQ(constantValue(GL_CONSTANT_COLOR1_NV)[2], 0.0f);
  GLint back[4] = {};
  glGetIntegerv(GL_CONSTANT_COLOR1_NV, back);
  EXPECT_EQ(back[0], INT32_MAX);
  GLboolean set[4] = {};
  glGetBooleanv(GL_CONSTANT_COLOR0_NV, set);
  EXPECT_EQ(set[0], GL_FALSE);
  EXPECT_EQ(set[1], GL_TRUE);
  GLdouble wide[4] = {};
  glGetDoublev(GL_CONSTANT_COLOR0_NV, wide);
  EXPECT_EQ(wide[1], 0.25);
  const GLfloat own[] = {0.5f, -1, 3, 1};
  glCombinerStageParameterfvNV(GL_COMBINER7_NV, GL_CONSTANT_COLOR1_NV, own);
  EXPECT_EQ(stageConstantValue(GL_COMBINER7_NV, GL_CONSTANT_COLOR1_NV), (Color{0.5f, 0, 1, 1}));
  EXPECT_EQ(stageConstantValue(GL_COMBINER7_NV, GL_CONSTANT_COLOR0_NV), (Color{0, 0, 0, 0}));
}

TEST_F(NvCombiners, ParametersOfOneValue) {
  glCombinerParameterfNV(GL_NUM_GENERAL_COMBINERS_NV, 3.0f);
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), 3);
  const GLint most = integer(GL_MAX_GENERAL_COMBINERS_NV);
  EXPECT_NO_GL_ERROR(glCombinerParameterivNV(GL_NUM_GENERAL_COMBINERS_NV, &most));
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), most);
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, most + 1));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 0));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, -1));
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), most);
  glCombinerParameterfNV(GL_COLOR_SUM_CLAMP_NV, 0.0f);
  EXPECT_EQ(integer(GL_COLOR_SUM_CLAMP_NV), GL_FALSE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCombinerParameteriNV(GL_CONSTANT_COLOR0_NV, 1));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCombinerParameterfNV(GL_MAX_GENERAL_COMBINERS_NV, 1));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCombinerParameterfvNV(GL_FOG, nullptr));
}

TEST_F(NvCombiners, ErrorsOfInputs) {
  const GLint before = inputValue(GL_COMBINER_INPUT_NV);
  struct Row {
    GLenum error, stage, portion, variable, source, mapping, usage;
  };
  constexpr Row kRows[] = {
      {GL_INVALID_ENUM, GL_COMBINER7_NV + 1, GL_RGB, GL_VARIABLE_A_NV, GL_ZERO,
       GL_SIGNED_IDENTITY_NV, GL_RGB},
      {GL_INVALID_ENUM, GL_COMBINER0_NV, GL_BLUE, GL_VARIABLE_A_NV, GL_ZERO, GL_SIGNED_IDENTITY_NV,
       GL_BLUE},
      {GL_INVALID_ENUM, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_E_NV, GL_ZERO, GL_SIGNED_IDENTITY_NV,
       GL_RGB},
      {GL_INVALID_ENUM, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_E_TIMES_F_NV,
       GL_SIGNED_IDENTITY_NV, GL_RGB},
      {GL_INVALID_ENUM, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_DISCARD_NV,
       GL_SIGNED_IDENTITY_NV, GL_RGB},
      {GL_INVALID_ENUM, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_TEXTURE31,
       GL_SIGNED_IDENTITY_NV, GL_RGB},
      {GL_INVALID_ENUM, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_ZERO, GL_NONE, GL_RGB},
      {GL_INVALID_ENUM, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_ZERO, GL_SIGNED_IDENTITY_NV,
       GL_RED},
      {GL_INVALID_OPERATION, GL_COMBINER0_NV, GL_ALPHA, GL_VARIABLE_A_NV, GL_ZERO,
       GL_SIGNED_IDENTITY_NV, GL_RGB},
      {GL_INVALID_OPERATION, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_ZERO,
       GL_SIGNED_IDENTITY_NV, GL_BLUE},
      {GL_INVALID_OPERATION, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_FOG,
       GL_SIGNED_IDENTITY_NV, GL_ALPHA},
  };
  for (const Row &row : kRows)
    EXPECT_GL_ERROR(
        row.error, input(row.stage, row.portion, row.variable, row.source, row.mapping, row.usage));
  EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV), before);
}

TEST_F(NvCombiners, ErrorsOfOutputs) {
  const auto put = [](GLenum portion, GLenum ab, GLenum cd, GLenum sum, GLenum scale, GLenum bias,
                      GLboolean dot) {
    glCombinerOutputNV(GL_COMBINER0_NV, portion, ab, cd, sum, scale, bias, dot, GL_FALSE, GL_FALSE);
  };
  constexpr GLenum kNothing = GL_DISCARD_NV;
  EXPECT_GL_ERROR(GL_INVALID_ENUM, put(GL_RGB, GL_ZERO, kNothing, kNothing, GL_NONE, GL_NONE, 0));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, put(GL_RGB, kNothing, GL_FOG, kNothing, GL_NONE, GL_NONE, 0));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  put(GL_RGB, kNothing, kNothing, GL_CONSTANT_COLOR0_NV, GL_NONE, GL_NONE, 0));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, put(GL_RGB, kNothing, kNothing, kNothing,
                                       GL_BIAS_BY_NEGATIVE_ONE_HALF_NV, GL_NONE, 0));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  put(GL_RGB, kNothing, kNothing, kNothing, GL_NONE, GL_SCALE_BY_TWO_NV, 0));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  put(GL_ALPHA, kNothing, kNothing, kNothing, GL_NONE, GL_NONE, GL_TRUE));
  for (const GLenum scale : {GL_SCALE_BY_FOUR_NV, GL_SCALE_BY_ONE_HALF_NV})
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, put(GL_RGB, kNothing, kNothing, kNothing, scale,
                                              GL_BIAS_BY_NEGATIVE_ONE_HALF_NV, 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  put(GL_RGB, GL_SPARE0_NV, GL_SPARE0_NV, kNothing, GL_NONE, GL_NONE, 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  put(GL_RGB, kNothing, GL_SPARE1_NV, GL_SPARE1_NV, GL_NONE, GL_NONE, 0));
  EXPECT_NO_GL_ERROR(put(GL_RGB, kNothing, kNothing, kNothing, GL_NONE, GL_NONE, 0));
  // A sum of dot products is legal since version 1.6.
  EXPECT_NO_GL_ERROR(put(GL_RGB, kNothing, kNothing, GL_SPARE0_NV, GL_NONE, GL_NONE, GL_TRUE));
}

TEST_F(NvCombiners, ErrorsOfTheFinalCombiner) {
  for (const GLenum variable : {GL_VARIABLE_E_NV, GL_VARIABLE_F_NV, GL_VARIABLE_G_NV})
    for (const GLenum source : {GL_E_TIMES_F_NV, GL_SPARE0_PLUS_SECONDARY_COLOR_NV})
      EXPECT_GL_ERROR(GL_INVALID_OPERATION, final(variable, source));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, final(GL_VARIABLE_A_NV, GL_SPARE0_PLUS_SECONDARY_COLOR_NV));
  EXPECT_NO_GL_ERROR(final(GL_VARIABLE_A_NV, GL_E_TIMES_F_NV));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, final(GL_VARIABLE_G_NV, GL_ZERO, GL_RGB));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, final(GL_VARIABLE_B_NV, GL_ZERO, GL_BLUE));
  EXPECT_NO_GL_ERROR(final(GL_VARIABLE_G_NV, GL_FOG, GL_BLUE));
  EXPECT_NO_GL_ERROR(final(GL_VARIABLE_B_NV, GL_FOG, GL_ALPHA)); // the fog factor
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, final(GL_VARIABLE_B_NV, GL_E_TIMES_F_NV, GL_ALPHA));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, final(GL_VARIABLE_B_NV, GL_ZERO, GL_RGB, GL_SIGNED_IDENTITY_NV));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, final(GL_VARIABLE_G_NV + 1, GL_ZERO));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, final(GL_VARIABLE_B_NV, GL_DISCARD_NV));
}

TEST_F(NvCombiners, ErrorsOfQueries) {
  GLint value = 0;
  GLfloat color[4] = {};
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetCombinerInputParameterivNV(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_G_NV,
                                                  GL_COMBINER_INPUT_NV, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetCombinerInputParameterivNV(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV,
                                                  GL_COMBINER_SCALE_NV, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetCombinerOutputParameterivNV(GL_COMBINER0_NV, GL_BLUE,
                                                                    GL_COMBINER_SCALE_NV, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetFinalCombinerInputParameterivNV(
                                       GL_VARIABLE_A_NV - 1, GL_COMBINER_INPUT_NV, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetCombinerStageParameterfvNV(GL_COMBINER0_NV, GL_FOG, color));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glCombinerStageParameterfvNV(GL_COMBINER7_NV + 1, GL_CONSTANT_COLOR0_NV, color));
}

TEST_F(NvCombiners, BetweenBeginAndEnd) {
  glBegin(GL_TRIANGLES);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 2);
  rgb(GL_VARIABLE_A_NV, GL_ZERO);
  output(GL_SPARE1_NV);
  final(GL_VARIABLE_A_NV, GL_ZERO);
  glEnable(GL_REGISTER_COMBINERS_NV);
  glEnable(GL_PER_STAGE_CONSTANTS_NV);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  while (glGetError() != GL_NO_ERROR) {
  }
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), 1);
  EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV), GL_PRIMARY_COLOR_NV);
  EXPECT_EQ(outputValue(GL_COMBINER_SUM_OUTPUT_NV), GL_SPARE0_NV);
  EXPECT_EQ(finalValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_A_NV), GL_FOG);
  EXPECT_FALSE(glIsEnabled(GL_REGISTER_COMBINERS_NV));
  EXPECT_FALSE(glIsEnabled(GL_PER_STAGE_CONSTANTS_NV));
}

void setAll() {
  glEnable(GL_REGISTER_COMBINERS_NV);
  glEnable(GL_PER_STAGE_CONSTANTS_NV);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 4);
  constant(GL_CONSTANT_COLOR0_NV, 1, 1, 1);
  rgb(GL_VARIABLE_B_NV, GL_SPARE1_NV);
}

void expectAll(bool set) {
  EXPECT_EQ(glIsEnabled(GL_REGISTER_COMBINERS_NV) == GL_TRUE, set);
  EXPECT_EQ(glIsEnabled(GL_PER_STAGE_CONSTANTS_NV) == GL_TRUE, set);
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), set ? 4 : 1);
  EXPECT_EQ(constantValue(GL_CONSTANT_COLOR0_NV)[1], set ? 1.0f : 0.0f);
  EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_B_NV), set ? GL_SPARE1_NV : GL_ZERO);
}

TEST_F(NvCombiners, AttributeGroups) {
  glPushAttrib(GL_TEXTURE_BIT);
  setAll();
  expectAll(true);
  glPopAttrib();
  expectAll(false);
  glPushAttrib(GL_ENABLE_BIT);
  setAll();
  glPopAttrib();
  EXPECT_FALSE(glIsEnabled(GL_REGISTER_COMBINERS_NV));
  EXPECT_FALSE(glIsEnabled(GL_PER_STAGE_CONSTANTS_NV));
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), 4);
  EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_B_NV), GL_SPARE1_NV);
}

TEST_F(NvCombiners, DisplayLists) {
  const GLuint list = glGenLists(2);
  glNewList(list, GL_COMPILE);
  setAll();
  EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_B_NV), GL_ZERO) << "a query is no part";
  glEndList();
  expectAll(false);
  glCallList(list);
  expectAll(true);
  // An error is raised when the list is called, once for each command, and changes nothing.
  glNewList(list + 1, GL_COMPILE);
  EXPECT_NO_GL_ERROR(glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 0));
  rgb(GL_VARIABLE_B_NV, GL_FOG);
  glEndList();
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCallList(list + 1));
  EXPECT_EQ(integer(GL_NUM_GENERAL_COMBINERS_NV), 4);
  EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_B_NV), GL_FOG) << "what follows is done";
  glNewList(list, GL_COMPILE_AND_EXECUTE);
  rgb(GL_VARIABLE_B_NV, GL_ZERO);
  glEndList();
  EXPECT_EQ(inputValue(GL_COMBINER_INPUT_NV, GL_VARIABLE_B_NV), GL_ZERO);
  glDeleteLists(list, 2);
}

TEST_F(NvCombiners, ContextsHaveTheirOwn) {
  setAll();
  const GlContext other(&m_context);
  other.makeCurrent();
  expectAll(false);
  m_context.makeCurrent();
  expectAll(true);
}

} // namespace
} // namespace api::combiners
