#pragma once
#include <cstring>
#include <string_view>

#include "fixture.h"

/// Finds the commands of NV_vertex_program and NV_fragment_program by eglGetProcAddress. libepoxy
/// follows gl.xml, which wrongly lists some as aliases of others.
namespace api::nv {

#define API_NV_COMMANDS(X)                                                                         \
  X(void, LoadProgramNV, (GLenum, GLuint, GLsizei, const GLubyte *))                               \
  X(void, BindProgramNV, (GLenum, GLuint))                                                         \
  X(void, DeleteProgramsNV, (GLsizei, const GLuint *))                                             \
  X(void, GenProgramsNV, (GLsizei, GLuint *))                                                      \
  X(GLboolean, IsProgramNV, (GLuint))                                                              \
  X(void, ExecuteProgramNV, (GLenum, GLuint, const GLfloat *))                                     \
  X(void, ProgramParameter4fNV, (GLenum, GLuint, GLfloat, GLfloat, GLfloat, GLfloat))              \
  X(void, GetProgramParameterfvNV, (GLenum, GLuint, GLenum, GLfloat *))                            \
  X(void, TrackMatrixNV, (GLenum, GLuint, GLenum, GLenum))                                         \
  X(void, ProgramNamedParameter4fNV,                                                               \
    (GLuint, GLsizei, const GLubyte *, GLfloat, GLfloat, GLfloat, GLfloat))                        \
  X(void, VertexAttrib2fNV, (GLuint, GLfloat, GLfloat))                                            \
  X(void, VertexAttrib4fNV, (GLuint, GLfloat, GLfloat, GLfloat, GLfloat))                          \
  X(void, VertexAttrib4ubNV, (GLuint, GLubyte, GLubyte, GLubyte, GLubyte))                         \
  X(void, VertexAttribs4fvNV, (GLuint, GLsizei, const GLfloat *))                                  \
  X(void, GetVertexAttribfvNV, (GLuint, GLenum, GLfloat *))                                        \
  X(void, VertexAttribPointerNV, (GLuint, GLint, GLenum, GLsizei, const void *))                   \
  X(GLboolean, AreProgramsResidentNV, (GLsizei, const GLuint *, GLboolean *))

#define API_NV_POINTER(result, name, parameters) inline result(*name) parameters = nullptr;
API_NV_COMMANDS(API_NV_POINTER)
#undef API_NV_POINTER

inline constexpr GLenum kVertexNv = GL_VERTEX_PROGRAM_NV, kFragmentNv = GL_FRAGMENT_PROGRAM_NV,
                        kState = GL_VERTEX_STATE_PROGRAM_NV;

/// Skips tests if the languages are not offered, as on the bare host and under other profiles.
class NvTest : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_NV_vertex_program");
    NEEDS("GL_NV_fragment_program");
#define API_NV_LOOK_UP(result, name, parameters)                                                   \
  name = reinterpret_cast<result(*) parameters>(eglGetProcAddress("gl" #name));                    \
  ASSERT_TRUE(name) << #name;
    API_NV_COMMANDS(API_NV_LOOK_UP)
#undef API_NV_LOOK_UP
  }
};

inline void load(GLenum target, GLuint id, std::string_view text) {
  LoadProgramNV(target, id, GLsizei(text.size()), reinterpret_cast<const GLubyte *>(text.data()));
}

/// Loads, binds and enables a program.
inline void use(GLenum target, GLuint id, std::string_view text) {
  load(target, id, text);
  BindProgramNV(target, id);
  glEnable(target);
  ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << glGetString(GL_PROGRAM_ERROR_STRING_ARB) << "\n"
                                               << text;
}

inline void setNamed(GLuint id, std::string_view name, const std::array<GLfloat, 4> &v) {
  ProgramNamedParameter4fNV(id, GLsizei(name.size()),
                            reinterpret_cast<const GLubyte *>(name.data()), v[0], v[1], v[2], v[3]);
}

inline constexpr char kThroughVp[] = "!!VP1.0\nMOV o[HPOS], v[OPOS];\nMOV o[COL0], v[COL0];\nEND";

inline void vertices() {
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
}

/// Draws a quad over everything with the current attributes, and returns its color.
inline Pixel quad() {
  clear();
  glBegin(GL_QUADS);
  vertices();
  glEnd();
  return readPixel();
}

} // namespace api::nv
