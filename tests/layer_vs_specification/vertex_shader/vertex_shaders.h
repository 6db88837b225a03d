#pragma once
#include <array>

#include "fixture.h"

/// Shared parts of the tests of EXT_vertex_shader.
namespace api::vertex_shaders {

/// Skips tests if the extension is not offered, as on the bare host and under other profiles.
class EraVertexShaders : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_EXT_vertex_shader");
  }
};

inline GLuint symbol(GLenum type, GLenum storage, GLuint count = 1,
                     GLenum range = GL_FULL_RANGE_EXT) {
  return glGenSymbolsEXT(type, storage, range, count);
}
inline GLuint vertex() { return glBindParameterEXT(GL_CURRENT_VERTEX_EXT); }
inline GLuint color() { return glBindParameterEXT(GL_CURRENT_COLOR); }
inline void move(GLuint to, GLuint from) { glShaderOp1EXT(GL_OP_MOV_EXT, to, from); }

/// Makes and binds a shader: the position is the vertex's, and `rest` adds operations.
template <typename Rest> GLuint shader(Rest rest) {
  const GLuint name = glGenVertexShadersEXT(1);
  glBindVertexShaderEXT(name);
  glBeginVertexShaderEXT();
  move(GL_OUTPUT_VERTEX_EXT, vertex());
  rest();
  glEndVertexShaderEXT();
  return name;
}
/// Makes a shader whose color is a symbol's value.
inline GLuint colored(GLuint from) {
  return shader([&] { move(GL_OUTPUT_COLOR0_EXT, from); });
}

using Values = std::array<GLfloat, 16>;
inline Values invariant(GLuint name) {
  Values values{};
  glGetInvariantFloatvEXT(name, GL_INVARIANT_VALUE_EXT, values.data());
  return values;
}
inline Values variant(GLuint name) {
  Values values{};
  glGetVariantFloatvEXT(name, GL_VARIANT_VALUE_EXT, values.data());
  return values;
}

} // namespace api::vertex_shaders
