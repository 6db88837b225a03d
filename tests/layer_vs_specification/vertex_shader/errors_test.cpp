// EXT_vertex_shader: the errors; an error changes nothing.
#include <vector>

#include "vertex_shaders.h"

namespace api::vertex_shaders {
namespace {

TEST_F(EraVertexShaders, PairsOfBeginAndEnd) {
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glEndVertexShaderEXT());
  glBeginVertexShaderEXT();
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBeginVertexShaderEXT());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBindVertexShaderEXT(3));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glDeleteVertexShaderEXT(3));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, EXPECT_EQ(glGenVertexShadersEXT(1), 0u));
  EXPECT_NO_GL_ERROR(glEndVertexShaderEXT());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glEndVertexShaderEXT());
  const GLuint local = symbol(GL_VECTOR_EXT, GL_LOCAL_EXT);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, move(local, vertex()));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glSwizzleEXT(local, vertex(), GL_X_EXT, GL_X_EXT, GL_X_EXT, GL_X_EXT));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glWriteMaskEXT(local, vertex(), 1, 1, 1, 1));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glInsertComponentEXT(local, vertex(), 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glExtractComponentEXT(local, vertex(), 0));
}

TEST_F(EraVertexShaders, NothingBetweenBeginAndEnd) {
  const GLuint variable = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT);
  const GLfloat value[4] = {1, 2, 3, 4};
  std::vector<GLenum> errors;
  const auto call = [&](auto command) {
    glBegin(GL_POINTS);
    command();
    glEnd();
    errors.push_back(glGetError());
  };
  call([] { glBeginVertexShaderEXT(); });
  call([] { glBindVertexShaderEXT(0); });
  call([] { glGenVertexShadersEXT(1); });
  call([] { glDeleteVertexShaderEXT(1); });
  call([] { symbol(GL_VECTOR_EXT, GL_LOCAL_EXT); });
  call([] { glBindParameterEXT(GL_FOG_COLOR); });
  call([&] { glVariantPointerEXT(variable, GL_FLOAT, 0, value); });
  call([&] { glEnableVariantClientStateEXT(variable); });
  call([&] { glIsVariantEnabledEXT(variable, GL_VARIANT_ARRAY_EXT); });
  for (const GLenum error : errors)
    EXPECT_EQ(error, GLenum(GL_INVALID_OPERATION));
  glBegin(GL_POINTS);
  glVariantfvEXT(variable, value);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << "variants are set there";
  EXPECT_EQ(variant(variable)[2], 3);
}

TEST_F(EraVertexShaders, SymbolsOfNoKind) {
  EXPECT_GL_ERROR(GL_INVALID_ENUM, EXPECT_EQ(symbol(GL_FLOAT, GL_LOCAL_EXT), 0u));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, EXPECT_EQ(symbol(GL_VECTOR_EXT, GL_VECTOR_EXT), 0u));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, EXPECT_EQ(symbol(GL_VECTOR_EXT, GL_LOCAL_EXT, 1, 0), 0u));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, EXPECT_EQ(symbol(GL_VECTOR_EXT, GL_LOCAL_EXT, 0), 0u));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, EXPECT_EQ(symbol(GL_VECTOR_EXT, GL_LOCAL_EXT, ~0u), 0u));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindParameterEXT(GL_FOG_MODE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindLightParameterEXT(GL_LIGHT0 + 8, GL_DIFFUSE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindLightParameterEXT(GL_LIGHT0, GL_EMISSION));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindMaterialParameterEXT(GL_FRONT_AND_BACK, GL_DIFFUSE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindTexGenParameterEXT(GL_TEXTURE0, GL_S, GL_SPHERE_MAP));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glBindTexGenParameterEXT(GL_TEXTURE0, GL_VECTOR_EXT, GL_EYE_PLANE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindTextureUnitParameterEXT(GL_TEXTURE31, GL_TEXTURE_MATRIX));
}

TEST_F(EraVertexShaders, ValuesOfOtherStorage) {
  const GLfloat value[16] = {};
  const GLuint local = symbol(GL_VECTOR_EXT, GL_LOCAL_EXT),
               constant = symbol(GL_VECTOR_EXT, GL_LOCAL_CONSTANT_EXT),
               fixed = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT),
               varying = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT);
  for (const GLuint other : {local, constant, varying, vertex(), 0u, 7u})
    EXPECT_GL_ERROR(GL_INVALID_VALUE, glSetInvariantEXT(other, GL_FLOAT, value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glSetInvariantEXT(fixed, GL_VECTOR_EXT, value));
  for (const GLuint other : {local, constant, fixed, vertex(), 0u}) {
    EXPECT_GL_ERROR(GL_INVALID_VALUE, glVariantfvEXT(other, value));
    EXPECT_GL_ERROR(GL_INVALID_VALUE, glVariantPointerEXT(other, GL_FLOAT, 0, value));
    EXPECT_GL_ERROR(GL_INVALID_VALUE, glEnableVariantClientStateEXT(other));
  }
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glVariantPointerEXT(varying, GL_BOOL, 0, value));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glVariantPointerEXT(varying, GL_FLOAT, 0x80000000u, value));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glSetLocalConstantEXT(constant, GL_FLOAT, value));
  glBeginVertexShaderEXT();
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glSetInvariantEXT(fixed, GL_FLOAT, value));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glSetLocalConstantEXT(fixed, GL_FLOAT, value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glSetLocalConstantEXT(constant, GL_VECTOR_EXT, value));
  EXPECT_NO_GL_ERROR(glSetLocalConstantEXT(constant, GL_FLOAT, value));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glSetLocalConstantEXT(constant, GL_FLOAT, value));
  glEndVertexShaderEXT();
  glBeginVertexShaderEXT();
  // It belongs to another definition
  EXPECT_NO_GL_ERROR(glSetLocalConstantEXT(constant, GL_FLOAT, value));
  glEndVertexShaderEXT();
}

TEST_F(EraVertexShaders, QueriesOfOtherStorage) {
  GLfloat value[16] = {5};
  GLint number = 5;
  void *pointer = nullptr;
  const GLuint fixed = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT),
               varying = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT);
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGetVariantFloatvEXT(fixed, GL_VARIANT_VALUE_EXT, value));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glGetInvariantFloatvEXT(varying, GL_INVARIANT_VALUE_EXT, value));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glGetLocalConstantFloatvEXT(fixed, GL_LOCAL_CONSTANT_VALUE_EXT, value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetInvariantIntegervEXT(fixed, GL_VARIANT_DATATYPE_EXT, &number));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetVariantIntegervEXT(varying, GL_INVARIANT_DATATYPE_EXT, &number));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetVariantPointervEXT(varying, GL_VARIANT_VALUE_EXT, &pointer));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glGetVariantPointervEXT(fixed, GL_VARIANT_ARRAY_POINTER_EXT, &pointer));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glIsVariantEnabledEXT(varying, GL_VERTEX_ARRAY));
  EXPECT_EQ(value[0], 5);
  EXPECT_EQ(number, 5);
}

TEST_F(EraVertexShaders, OperationsOutsideTheTable) {
  const GLuint scalar = symbol(GL_SCALAR_EXT, GL_LOCAL_EXT),
               vector = symbol(GL_VECTOR_EXT, GL_LOCAL_EXT),
               matrix = symbol(GL_MATRIX_EXT, GL_LOCAL_EXT),
               fixed = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT);
  const GLuint mvp = glBindParameterEXT(GL_MVP_MATRIX_EXT);
  glBeginVertexShaderEXT();
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glShaderOp1EXT(GL_X_EXT, vector, vector));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glShaderOp1EXT(GL_OP_ADD_EXT, vector, vector));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glShaderOp2EXT(GL_OP_ADD_EXT, scalar, vector, vector));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glShaderOp2EXT(GL_OP_ADD_EXT, fixed, vector, vector));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glShaderOp2EXT(GL_OP_ADD_EXT, vector, vector, GL_OUTPUT_COLOR0_EXT));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glShaderOp2EXT(GL_OP_ADD_EXT, vector, vector, 12));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glShaderOp2EXT(GL_OP_ADD_EXT, 12, vector, vector));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, move(matrix, mvp));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, move(GL_OUTPUT_FOG_EXT, vector));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, move(GL_OUTPUT_TEXTURE_COORD31_EXT, vector));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glShaderOp2EXT(GL_OP_MULTIPLY_MATRIX_EXT, vector, vector, mvp));
  EXPECT_NO_GL_ERROR(glShaderOp2EXT(GL_OP_MULTIPLY_MATRIX_EXT, vector, mvp, vector));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glWriteMaskEXT(scalar, vector, 1, 1, 1, 1));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glWriteMaskEXT(fixed, vector, 1, 1, 1, 1));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glWriteMaskEXT(vector, vector, 1, 2, 1, 1));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glSwizzleEXT(vector, scalar, GL_X_EXT, GL_X_EXT, GL_X_EXT, GL_X_EXT));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glSwizzleEXT(vector, vector, GL_X_EXT, GL_ONE, GL_X_EXT, GL_X_EXT));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glInsertComponentEXT(vector, scalar, 4));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glInsertComponentEXT(vector, vector, 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glInsertComponentEXT(matrix, scalar, 0));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glExtractComponentEXT(scalar, vector, 4));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glExtractComponentEXT(scalar, mvp, 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glExtractComponentEXT(vector, vector, 0));
  glEndVertexShaderEXT();
  EXPECT_EQ(integer(GL_VERTEX_SHADER_INSTRUCTIONS_EXT), 5) << "the one that was no error";
}

} // namespace
} // namespace api::vertex_shaders
