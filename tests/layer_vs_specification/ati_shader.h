#pragma once
#include "fixture.h"

/// Shorthands for the commands of ATI_fragment_shader ("AFS").
namespace api::ati {

struct Arg {
  GLuint source;
  GLuint replicate = GL_NONE;
  GLuint modifiers = GL_NONE;
};

inline void pass(GLuint dst, GLuint coord, GLenum swizzle = GL_SWIZZLE_STR_ATI) {
  glPassTexCoordATI(dst, coord, swizzle);
}
inline void sample(GLuint dst, GLuint coord, GLenum swizzle = GL_SWIZZLE_STR_ATI) {
  glSampleMapATI(dst, coord, swizzle);
}
inline void color1(GLenum op, GLuint dst, Arg a, GLuint mask = GL_NONE, GLuint mod = GL_NONE) {
  glColorFragmentOp1ATI(op, dst, mask, mod, a.source, a.replicate, a.modifiers);
}
inline void color2(GLenum op, GLuint dst, Arg a, Arg b, GLuint mask = GL_NONE,
                   GLuint mod = GL_NONE) {
  glColorFragmentOp2ATI(op, dst, mask, mod, a.source, a.replicate, a.modifiers, b.source,
                        b.replicate, b.modifiers);
}
inline void color3(GLenum op, GLuint dst, Arg a, Arg b, Arg c, GLuint mask = GL_NONE,
                   GLuint mod = GL_NONE) {
  glColorFragmentOp3ATI(op, dst, mask, mod, a.source, a.replicate, a.modifiers, b.source,
                        b.replicate, b.modifiers, c.source, c.replicate, c.modifiers);
}
inline void alpha1(GLenum op, GLuint dst, Arg a, GLuint mod = GL_NONE) {
  glAlphaFragmentOp1ATI(op, dst, mod, a.source, a.replicate, a.modifiers);
}
inline void alpha2(GLenum op, GLuint dst, Arg a, Arg b, GLuint mod = GL_NONE) {
  glAlphaFragmentOp2ATI(op, dst, mod, a.source, a.replicate, a.modifiers, b.source, b.replicate,
                        b.modifiers);
}
inline void alpha3(GLenum op, GLuint dst, Arg a, Arg b, Arg c, GLuint mod = GL_NONE) {
  glAlphaFragmentOp3ATI(op, dst, mod, a.source, a.replicate, a.modifiers, b.source, b.replicate,
                        b.modifiers, c.source, c.replicate, c.modifiers);
}
/// Sets the constant's r, g, b and a.
inline void constant(GLuint name, GLfloat r, GLfloat g, GLfloat b, GLfloat a) {
  const GLfloat value[] = {r, g, b, a};
  glSetFragmentShaderConstantATI(name, value);
}
/// Moves all four components of `source` to REG_0.
inline void moveAll(GLuint source) {
  color1(GL_MOV_ATI, GL_REG_0_ATI, {source});
  alpha1(GL_MOV_ATI, GL_REG_0_ATI, {source});
}
/// Binds a new shader defined by `body`, and returns its name.
template <typename Body> GLuint makeShader(Body &&body) {
  const GLuint name = glGenFragmentShadersATI(1);
  glBindFragmentShaderATI(name);
  glBeginFragmentShaderATI();
  body();
  glEndFragmentShaderATI();
  return name;
}
/// Makes a shader that outputs constant `name` for every fragment.
inline GLuint makeConstantShader(GLuint name) {
  return makeShader([&] { moveAll(name); });
}

} // namespace api::ati
