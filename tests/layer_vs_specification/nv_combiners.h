#pragma once
#include <array>

#include "fixture.h"

/// Shared parts of the tests of NV_register_combiners and 2.
namespace api::combiners {

/// Skips tests if the extensions are not offered, as on the bare host and under other profiles.
class NvCombiners : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_NV_register_combiners2");
  }
};

inline void input(GLenum stage, GLenum portion, GLenum variable, GLenum source, GLenum mapping,
                  GLenum usage) {
  glCombinerInputNV(stage, portion, variable, source, mapping, usage);
}
/// Sets an input of stage 0's RGB portion.
inline void rgb(GLenum variable, GLenum source, GLenum mapping = GL_UNSIGNED_IDENTITY_NV,
                GLenum usage = GL_RGB) {
  input(GL_COMBINER0_NV, GL_RGB, variable, source, mapping, usage);
}
inline void final(GLenum variable, GLenum source, GLenum usage = GL_RGB,
                  GLenum mapping = GL_UNSIGNED_IDENTITY_NV) {
  glFinalCombinerInputNV(variable, source, mapping, usage);
}
inline void output(GLenum sum, GLenum portion = GL_RGB, GLenum scale = GL_NONE,
                   GLenum bias = GL_NONE) {
  glCombinerOutputNV(GL_COMBINER0_NV, portion, GL_DISCARD_NV, GL_DISCARD_NV, sum, scale, bias,
                     GL_FALSE, GL_FALSE, GL_FALSE);
}
inline GLint inputValue(GLenum pname, GLenum variable = GL_VARIABLE_A_NV, GLenum portion = GL_RGB,
                        GLenum stage = GL_COMBINER0_NV) {
  GLint value = -1;
  glGetCombinerInputParameterivNV(stage, portion, variable, pname, &value);
  return value;
}
inline GLint outputValue(GLenum pname, GLenum portion = GL_RGB, GLenum stage = GL_COMBINER0_NV) {
  GLint value = -1;
  glGetCombinerOutputParameterivNV(stage, portion, pname, &value);
  return value;
}
inline GLint finalValue(GLenum pname, GLenum variable) {
  GLint value = -1;
  glGetFinalCombinerInputParameterivNV(variable, pname, &value);
  return value;
}
inline void constant(GLenum name, GLfloat r, GLfloat g, GLfloat b, GLfloat a = 1) {
  const GLfloat color[] = {r, g, b, a};
  glCombinerParameterfvNV(name, color);
}
inline std::array<GLfloat, 4> constantValue(GLenum name) {
  std::array<GLfloat, 4> value = {9, 9, 9, 9};
  glGetFloatv(name, value.data());
  return value;
}
inline std::array<GLfloat, 4> stageConstantValue(GLenum stage, GLenum name) {
  std::array<GLfloat, 4> value = {9, 9, 9, 9};
  glGetCombinerStageParameterfvNV(stage, name, value.data());
  return value;
}

} // namespace api::combiners
