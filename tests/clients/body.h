#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

/// The drawing of every client, which proves who drew it: a fragment program multiplies the color
/// by a local parameter, and one pixel is read back. It also queries a limit for which the layer
/// returns another value than any host (MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB is 4 on the r300
/// profile).
namespace clients {

/// The GL functions that the client found. Signatures are spelled out, because some loaders define
/// the names as macros.
struct Gl {
#define CLIENT_GL_FUNCTIONS(X)                                                                     \
  X(Begin, void, (GLenum))                                                                         \
  X(End, void, ())                                                                                 \
  X(Vertex2f, void, (GLfloat, GLfloat))                                                            \
  X(Color4f, void, (GLfloat, GLfloat, GLfloat, GLfloat))                                           \
  X(Clear, void, (GLbitfield))                                                                     \
  X(ClearColor, void, (GLclampf, GLclampf, GLclampf, GLclampf))                                    \
  X(Viewport, void, (GLint, GLint, GLsizei, GLsizei))                                              \
  X(Enable, void, (GLenum))                                                                        \
  X(Disable, void, (GLenum))                                                                       \
  X(IsEnabled, GLboolean, (GLenum))                                                                \
  X(ReadPixels, void, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, GLvoid *))                  \
  X(GetError, GLenum, ())                                                                          \
  X(GetString, const GLubyte *, (GLenum))                                                          \
  X(GetIntegerv, void, (GLenum, GLint *))                                                          \
  X(Finish, void, ())
#define CLIENT_ARB_FUNCTIONS(X)                                                                    \
  X(GenProgramsARB, void, (GLsizei, GLuint *))                                                     \
  X(BindProgramARB, void, (GLenum, GLuint))                                                        \
  X(ProgramStringARB, void, (GLenum, GLenum, GLsizei, const void *))                               \
  X(DeleteProgramsARB, void, (GLsizei, const GLuint *))                                            \
  X(ProgramLocalParameter4fARB, void, (GLenum, GLuint, GLfloat, GLfloat, GLfloat, GLfloat))        \
  X(GetProgramivARB, void, (GLenum, GLenum, GLint *))
#define X(name, result, parameters) result(*name) parameters = nullptr;
  CLIENT_GL_FUNCTIONS(X)
  CLIENT_ARB_FUNCTIONS(X)
#undef X
};

/// Looks up all functions by `get`; exits the client if one is null.
Gl load(void *(*get)(const char *name));
/// Looks up the ARB functions only.
void loadArb(Gl &gl, void *(*get)(const char *name));

/// Draws into the current context's buffer (at least 32x32). `scale` distinguishes contexts. Prints
/// one line of JSON unless quiet. Returns true if the pixel is right.
bool drawAndReport(const Gl &gl, const char *client, float scale = 1.0f, bool quiet = false);

/// Exits the client with a message.
[[noreturn]] void die(const char *message, const char *detail = "");

} // namespace clients
