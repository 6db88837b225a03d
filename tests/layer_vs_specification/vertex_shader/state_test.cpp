// EXT_vertex_shader: objects, symbols, their values and arrays, attribute stacks, lists.
#include "vertex_shaders.h"

namespace api::vertex_shaders {
namespace {

TEST_F(EraVertexShaders, NamesInARow) {
  const GLuint first = glGenVertexShadersEXT(3);
  ASSERT_NE(first, 0u);
  EXPECT_EQ(glGenVertexShadersEXT(0), 0u);
  const GLuint next = glGenVertexShadersEXT(1);
  EXPECT_TRUE(next < first || next > first + 2);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_BINDING_EXT), 0);
  glBindVertexShaderEXT(first + 1);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_BINDING_EXT), GLint(first) + 1);
  glDeleteVertexShaderEXT(first + 1);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_BINDING_EXT), 0);
  glDeleteVertexShaderEXT(0);
  glDeleteVertexShaderEXT(12345);
}

TEST_F(EraVertexShaders, EnableAndItsAttributeGroup) {
  EXPECT_EQ(glIsEnabled(GL_VERTEX_SHADER_EXT), GL_FALSE);
  glPushAttrib(GL_ENABLE_BIT);
  glEnable(GL_VERTEX_SHADER_EXT);
  EXPECT_EQ(glIsEnabled(GL_VERTEX_SHADER_EXT), GL_TRUE);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_EXT), 1);
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glDisable(GL_VERTEX_SHADER_EXT);
  glPopAttrib();
  EXPECT_EQ(glIsEnabled(GL_VERTEX_SHADER_EXT), GL_TRUE);
  glPopAttrib();
  EXPECT_EQ(glIsEnabled(GL_VERTEX_SHADER_EXT), GL_FALSE);
}

TEST_F(EraVertexShaders, LimitsAreTheLeastAtLeast) {
  const struct {
    GLenum most, mostOptimized;
    GLint least;
  } kLimits[] = {
      {GL_MAX_VERTEX_SHADER_INSTRUCTIONS_EXT, GL_MAX_OPTIMIZED_VERTEX_SHADER_INSTRUCTIONS_EXT, 32},
      {GL_MAX_VERTEX_SHADER_VARIANTS_EXT, GL_MAX_OPTIMIZED_VERTEX_SHADER_VARIANTS_EXT, 4},
      {GL_MAX_VERTEX_SHADER_INVARIANTS_EXT, GL_MAX_OPTIMIZED_VERTEX_SHADER_INVARIANTS_EXT, 16},
      {GL_MAX_VERTEX_SHADER_LOCAL_CONSTANTS_EXT, GL_MAX_OPTIMIZED_VERTEX_SHADER_LOCAL_CONSTANTS_EXT,
       8},
      {GL_MAX_VERTEX_SHADER_LOCALS_EXT, GL_MAX_OPTIMIZED_VERTEX_SHADER_LOCALS_EXT, 4}};
  for (const auto &limit : kLimits) {
    EXPECT_GE(integer(limit.most), limit.least) << std::hex << limit.most;
    EXPECT_GE(integer(limit.mostOptimized), limit.least) << std::hex << limit.mostOptimized;
  }
}

TEST_F(EraVertexShaders, WhatAShaderUses) {
  const GLuint constants = symbol(GL_VECTOR_EXT, GL_LOCAL_CONSTANT_EXT, 3);
  const GLuint fixed = symbol(GL_MATRIX_EXT, GL_INVARIANT_EXT);
  const GLuint local = symbol(GL_VECTOR_EXT, GL_LOCAL_EXT, 5);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_INSTRUCTIONS_EXT), 0);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_OPTIMIZED_EXT), 0);
  const GLuint name = shader([&] {
    glShaderOp2EXT(GL_OP_MULTIPLY_MATRIX_EXT, local + 1, fixed, vertex());
    glShaderOp2EXT(GL_OP_ADD_EXT, GL_OUTPUT_COLOR0_EXT, local + 1, constants + 2);
  });
  EXPECT_EQ(integer(GL_VERTEX_SHADER_INSTRUCTIONS_EXT), 6);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_VARIANTS_EXT), 1);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_INVARIANTS_EXT), 4);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_LOCAL_CONSTANTS_EXT), 1);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_LOCALS_EXT), 1);
  GLboolean optimized = GL_FALSE;
  glGetBooleanv(GL_VERTEX_SHADER_OPTIMIZED_EXT, &optimized);
  EXPECT_EQ(optimized, GL_TRUE);
  glBindVertexShaderEXT(0);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_INSTRUCTIONS_EXT), 0);
  glBindVertexShaderEXT(name);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_INSTRUCTIONS_EXT), 6);
}

TEST_F(EraVertexShaders, SymbolsInARow) {
  const GLuint first = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT, 4);
  const GLfloat value[] = {1, 2, 3, 4};
  for (GLuint i = 0; i < 4; ++i)
    EXPECT_NO_GL_ERROR(glSetInvariantEXT(first + i, GL_FLOAT, value));
  EXPECT_EQ(glBindParameterEXT(GL_MVP_MATRIX_EXT), glBindParameterEXT(GL_MVP_MATRIX_EXT));
  EXPECT_NE(glBindParameterEXT(GL_MVP_MATRIX_EXT), glBindParameterEXT(GL_MODELVIEW_MATRIX));
}

TEST_F(EraVertexShaders, InvariantsOfEachTypeAndRange) {
  const GLuint full = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT),
               scalar = symbol(GL_SCALAR_EXT, GL_INVARIANT_EXT),
               matrix = symbol(GL_MATRIX_EXT, GL_INVARIANT_EXT),
               normalized = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT, 1, GL_NORMALIZED_RANGE_EXT);
  const GLbyte bytes[] = {-128, 127, 0, 5};
  glSetInvariantEXT(full, GL_BYTE, bytes);
  EXPECT_EQ(invariant(full)[0], -128);
  glSetInvariantEXT(normalized, GL_BYTE, bytes);
  EXPECT_FLOAT_EQ(invariant(normalized)[0], -1);
  EXPECT_FLOAT_EQ(invariant(normalized)[1], 1);
  EXPECT_FLOAT_EQ(invariant(normalized)[2], 1.0f / 255);
  const GLushort shorts[] = {65535, 0, 1, 2};
  glSetInvariantEXT(normalized, GL_UNSIGNED_SHORT, shorts);
  EXPECT_FLOAT_EQ(invariant(normalized)[0], 1);
  EXPECT_FLOAT_EQ(invariant(normalized)[2], 1.0f / 65535);
  const GLdouble doubles[] = {3, -4, 0.5, 1};
  glSetInvariantEXT(normalized, GL_DOUBLE, doubles);
  EXPECT_EQ(invariant(normalized)[0], 1);
  EXPECT_EQ(invariant(normalized)[1], -1);
  EXPECT_EQ(invariant(normalized)[2], 0.5f);
  glSetInvariantEXT(scalar, GL_DOUBLE, doubles);
  EXPECT_EQ(invariant(scalar)[0], 3);
  Values numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = GLfloat(i);
  glSetInvariantEXT(matrix, GL_FLOAT, numbers.data());
  EXPECT_EQ(invariant(matrix), numbers);
  GLint type = 0;
  glGetInvariantIntegervEXT(matrix, GL_INVARIANT_DATATYPE_EXT, &type);
  EXPECT_EQ(type, GL_MATRIX_EXT);
  GLint rounded[4] = {};
  const GLfloat parts[] = {1.6f, -1.6f, 0, 0};
  glSetInvariantEXT(full, GL_FLOAT, parts);
  glGetInvariantIntegervEXT(full, GL_INVARIANT_VALUE_EXT, rounded);
  EXPECT_EQ(rounded[0], 2);
  EXPECT_EQ(rounded[1], -2);
  GLboolean truth[4] = {};
  glGetInvariantBooleanvEXT(full, GL_INVARIANT_VALUE_EXT, truth);
  EXPECT_EQ(truth[0], GL_TRUE);
  EXPECT_EQ(truth[2], GL_FALSE);
}

TEST_F(EraVertexShaders, LocalConstantsAndVariants) {
  const GLuint constant = symbol(GL_VECTOR_EXT, GL_LOCAL_CONSTANT_EXT);
  const GLint whole[] = {1, 2, 3, 4};
  glBeginVertexShaderEXT();
  glSetLocalConstantEXT(constant, GL_INT, whole);
  glEndVertexShaderEXT();
  GLfloat value[4] = {};
  glGetLocalConstantFloatvEXT(constant, GL_LOCAL_CONSTANT_VALUE_EXT, value);
  EXPECT_EQ(value[3], 4);
  const GLuint vector = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT),
               matrix = symbol(GL_MATRIX_EXT, GL_VARIANT_EXT),
               normalized = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT, 1, GL_NORMALIZED_RANGE_EXT);
  glVariantivEXT(vector, whole);
  EXPECT_EQ(variant(vector)[1], 2);
  const GLubyte bytes[] = {255, 0, 51, 1};
  glVariantubvEXT(normalized, bytes);
  EXPECT_FLOAT_EQ(variant(normalized)[2], 0.2f);
  glVariantubvEXT(vector, bytes);
  EXPECT_EQ(variant(vector)[2], 51);
  Values numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = GLfloat(i);
  glVariantfvEXT(matrix, numbers.data());
  EXPECT_EQ(variant(matrix), numbers);
  const GLfloat color_[] = {0.25f, 0.5f, 0.75f, 1};
  glColor4fv(color_);
  EXPECT_EQ(variant(color())[2], 0.75f) << "a bound one has GL's value";
}

TEST_F(EraVertexShaders, ArraysAreClientState) {
  const GLuint vector = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT);
  static const GLshort kNumbers[16] = {};
  const auto value = [&](GLenum pname) {
    GLint number = -1;
    glGetVariantIntegervEXT(vector, pname, &number);
    return number;
  };
  EXPECT_EQ(value(GL_VARIANT_ARRAY_TYPE_EXT), GL_FLOAT);
  EXPECT_EQ(glIsVariantEnabledEXT(vector, GL_VARIANT_ARRAY_EXT), GL_FALSE);
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  glVariantPointerEXT(vector, GL_SHORT, 16, kNumbers);
  glEnableVariantClientStateEXT(vector);
  EXPECT_EQ(value(GL_VARIANT_ARRAY_TYPE_EXT), GL_SHORT);
  EXPECT_EQ(value(GL_VARIANT_ARRAY_STRIDE_EXT), 16);
  EXPECT_EQ(value(GL_VARIANT_DATATYPE_EXT), GL_VECTOR_EXT);
  void *pointer = nullptr;
  glGetVariantPointervEXT(vector, GL_VARIANT_ARRAY_POINTER_EXT, &pointer);
  EXPECT_EQ(pointer, kNumbers);
  EXPECT_EQ(glIsVariantEnabledEXT(vector, GL_VARIANT_ARRAY_EXT), GL_TRUE);
  glPopClientAttrib();
  EXPECT_EQ(glIsVariantEnabledEXT(vector, GL_VARIANT_ARRAY_EXT), GL_FALSE);
  EXPECT_EQ(value(GL_VARIANT_ARRAY_STRIDE_EXT), 0);
}

TEST_F(EraVertexShaders, BoundValuesAreGLs) {
  glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 30);
  glLightf(GL_LIGHT1, GL_SPOT_EXPONENT, 7);
  const GLfloat direction[] = {1, 2, 3};
  glLightfv(GL_LIGHT1, GL_SPOT_DIRECTION, direction);
  EXPECT_FLOAT_EQ(invariant(glBindLightParameterEXT(GL_LIGHT1, GL_SPOT_CUTOFF))[0], 30);
  EXPECT_FLOAT_EQ(invariant(glBindLightParameterEXT(GL_LIGHT1, GL_SPOT_EXPONENT))[0], 7);
  EXPECT_EQ(invariant(glBindLightParameterEXT(GL_LIGHT1, GL_SPOT_DIRECTION))[3], 0);
  glFogf(GL_FOG_END, 9);
  EXPECT_EQ(invariant(glBindParameterEXT(GL_FOG_END))[0], 9);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(5, 6, 7);
  const Values matrix = invariant(glBindParameterEXT(GL_MODELVIEW_MATRIX));
  EXPECT_EQ(matrix[12], 5);
  EXPECT_EQ(matrix[14], 7);
  const GLfloat shininess = 12;
  glMaterialfv(GL_BACK, GL_SHININESS, &shininess);
  EXPECT_EQ(variant(glBindMaterialParameterEXT(GL_BACK, GL_SHININESS))[0], 12);
  EXPECT_EQ(variant(glBindMaterialParameterEXT(GL_FRONT, GL_SHININESS))[0], 0);
}

} // namespace
} // namespace api::vertex_shaders
