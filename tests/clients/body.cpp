#include "body.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace clients {

namespace {

constexpr const char *kProgram = "!!ARBfp1.0\n"
                                 "PARAM scale = program.local[0];\n"
                                 "MUL result.color, fragment.color, scale;\n"
                                 "END\n";

bool near(int a, int b) { return std::abs(a - b) <= 1; }

} // namespace

void die(const char *message, const char *detail) {
  std::fprintf(stderr, "client: %s %s\n", message, detail);
  std::exit(3);
}

void loadArb(Gl &gl, void *(*get)(const char *name)) {
#define X(name, result, parameters)                                                                \
  gl.name = reinterpret_cast<decltype(gl.name)>(get("gl" #name));                                  \
  if (!gl.name)                                                                                    \
    die("no function", "gl" #name);
  CLIENT_ARB_FUNCTIONS(X)
#undef X
}

Gl load(void *(*get)(const char *name)) {
  Gl gl;
#define X(name, result, parameters)                                                                \
  gl.name = reinterpret_cast<decltype(gl.name)>(get("gl" #name));                                  \
  if (!gl.name)                                                                                    \
    die("no function", "gl" #name);
  CLIENT_GL_FUNCTIONS(X)
#undef X
  loadArb(gl, get);
  return gl;
}

bool drawAndReport(const Gl &gl, const char *client, float scale, bool quiet) {
  GLuint program = 0;
  gl.Viewport(0, 0, 32, 32);
  gl.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.GenProgramsARB(1, &program);
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  gl.ProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                      GLsizei(std::strlen(kProgram)), kProgram);
  gl.ProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, scale, scale * 0.5f, scale * 0.25f, 1);
  gl.Enable(GL_FRAGMENT_PROGRAM_ARB);
  gl.Color4f(0.8f, 0.8f, 0.8f, 1.0f);
  gl.Begin(GL_QUADS);
  gl.Vertex2f(-1, -1);
  gl.Vertex2f(1, -1);
  gl.Vertex2f(1, 1);
  gl.Vertex2f(-1, 1);
  gl.End();
  unsigned char pixel[4] = {};
  gl.ReadPixels(16, 16, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  GLint indirections = 0;
  gl.GetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB,
                     &indirections);
  gl.Disable(GL_FRAGMENT_PROGRAM_ARB);
  gl.DeleteProgramsARB(1, &program);
  const GLenum error = gl.GetError();
  const bool right = near(pixel[0], int(204 * scale + 0.5f)) &&
                     near(pixel[1], int(102 * scale + 0.5f)) &&
                     near(pixel[2], int(51 * scale + 0.5f)) && error == GL_NO_ERROR;
  if (!quiet)
    std::printf("{\"client\": \"%s\", \"pixel\": [%d, %d, %d, %d], \"indirections\": %d, "
                "\"error\": %u, \"right\": %s}\n",
                client, pixel[0], pixel[1], pixel[2], pixel[3], indirections, error,
                right ? "true" : "false");
  std::fflush(stdout);
  return right;
}

} // namespace clients
