#include "rows.h"

#include <chrono>
#include <epoxy/gl.h>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Returns the average time of \p call(i) over \p count calls.
template <typename Call> std::vector<double> average(int count, Call call) {
  const auto begin = Clock::now();
  for (int i = 0; i < count; ++i)
    call(i);
  const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
  return {time.count() / count};
}

/// Returns two program objects with a text each, made once; the first one is bound and enabled.
const GLuint *programs() {
  static GLuint names[2] = {0, 0};
  if (names[0])
    return names;
  static constexpr std::string_view kText =
      "!!ARBfp1.0\nMAD result.color, fragment.color, program.local[0], program.env[0];\nEND\n";
  glGenProgramsARB(2, names);
  for (GLuint i = 2; i-- > 0;) {
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names[i]);
    glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(kText.size()),
                       kText.data());
  }
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  return names;
}

/// Returns two vertex programs, made once; the first one is bound and enabled.
const GLuint *vertexPrograms() {
  static GLuint names[2] = {0, 0};
  if (!names[0]) {
    static constexpr std::string_view kText =
        "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
        "MAD result.color, vertex.color, program.local[0], program.env[0];\nEND\n";
    glGenProgramsARB(2, names);
    for (const GLuint name : names) {
      glBindProgramARB(GL_VERTEX_PROGRAM_ARB, name);
      glProgramStringARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(kText.size()),
                         kText.data());
    }
  }
  glBindProgramARB(GL_VERTEX_PROGRAM_ARB, names[0]);
  glEnable(GL_VERTEX_PROGRAM_ARB);
  return names;
}

// The layer does not intercept these calls: they go from libglvnd straight to the host.
std::vector<double> color(int count, unsigned) {
  return average(count, [](int i) { glColor4f(float(i & 1), 0.5f, 0.25f, 1.0f); });
}
std::vector<double> blendFunc(int count, unsigned) {
  return average(count, [](int i) { glBlendFunc(i & 1 ? GL_ONE : GL_SRC_ALPHA, GL_ZERO); });
}
std::vector<double> activeTexture(int count, unsigned) {
  auto time = average(count, [](int i) { glActiveTexture(GL_TEXTURE0 + GLenum(i & 1)); });
  glActiveTexture(GL_TEXTURE0);
  return time;
}

// The layer intercepts these: it inspects the call, or the state is its own.
std::vector<double> local(int count, unsigned) {
  programs();
  return average(count, [](int i) {
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, float(i & 1), 0.5f, 0.25f, 1.0f);
  });
}
std::vector<double> localFv(int count, unsigned) {
  programs();
  return average(count, [](int i) {
    const GLfloat values[4] = {float(i & 1), 0.5f, 0.25f, 1.0f};
    glProgramLocalParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, 0, values);
  });
}
std::vector<double> localDv(int count, unsigned) {
  programs();
  return average(count, [](int i) {
    const GLdouble values[4] = {double(i & 1), 0.5, 0.25, 1.0};
    glProgramLocalParameter4dvARB(GL_FRAGMENT_PROGRAM_ARB, 0, values);
  });
}
std::vector<double> env(int count, unsigned) {
  programs();
  return average(count, [](int i) {
    glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, float(i & 1), 0.5f, 0.25f, 1.0f);
  });
}
std::vector<double> bind(int count, unsigned) {
  const GLuint *names = programs();
  auto time =
      average(count, [&](int i) { glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names[i & 1]); });
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, names[0]);
  return time;
}
std::vector<double> vertexLocal(int count, unsigned) {
  vertexPrograms();
  auto time = average(count, [](int i) {
    glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, float(i & 1), 0.5f, 0.25f, 1.0f);
  });
  glDisable(GL_VERTEX_PROGRAM_ARB);
  return time;
}
std::vector<double> vertexEnv(int count, unsigned) {
  vertexPrograms();
  auto time = average(count, [](int i) {
    glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, float(i & 1), 0.5f, 0.25f, 1.0f);
  });
  glDisable(GL_VERTEX_PROGRAM_ARB);
  return time;
}
std::vector<double> vertexBind(int count, unsigned) {
  const GLuint *names = vertexPrograms();
  auto time = average(count, [&](int i) { glBindProgramARB(GL_VERTEX_PROGRAM_ARB, names[i & 1]); });
  glDisable(GL_VERTEX_PROGRAM_ARB);
  return time;
}
std::vector<double> enableVertexProgram(int count, unsigned) {
  vertexPrograms();
  auto time = average(count, [](int i) { (i & 1 ? glEnable : glDisable)(GL_VERTEX_PROGRAM_ARB); });
  glDisable(GL_VERTEX_PROGRAM_ARB);
  return time;
}
std::vector<double> enableBlend(int count, unsigned) {
  auto time = average(count, [](int i) { (i & 1 ? glDisable : glEnable)(GL_BLEND); });
  glDisable(GL_BLEND);
  return time;
}
std::vector<double> enableProgram(int count, unsigned) {
  programs();
  auto time =
      average(count, [](int i) { (i & 1 ? glEnable : glDisable)(GL_FRAGMENT_PROGRAM_ARB); });
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  return time;
}
std::vector<double> texParameter(int count, unsigned) {
  return average(count, [](int i) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, i & 1 ? GL_LINEAR : GL_NEAREST);
  });
}
std::vector<double> getError(int count, unsigned) {
  return average(count, [](int) { static_cast<void>(glGetError()); });
}

} // namespace

const std::vector<Row> &callRows() {
  static const std::vector<Row> rows = {
      {"call/glColor4f", color},
      {"call/glBlendFunc", blendFunc},
      {"call/glActiveTexture", activeTexture},
      {"call/glProgramLocalParameter4fARB", local},
      {"call/glProgramLocalParameter4fvARB", localFv},
      {"call/glProgramLocalParameter4dvARB", localDv},
      {"call/glProgramEnvParameter4fARB", env},
      {"call/glBindProgramARB", bind},
      {"call/glEnable(BLEND)", enableBlend},
      {"call/glEnable(FRAGMENT_PROGRAM_ARB)", enableProgram},
      {"call/glProgramLocalParameter4fARB, vertex", vertexLocal},
      {"call/glProgramEnvParameter4fARB, vertex", vertexEnv},
      {"call/glBindProgramARB, vertex", vertexBind},
      {"call/glEnable(VERTEX_PROGRAM_ARB)", enableVertexProgram},
      {"call/glTexParameteri", texParameter},
      {"call/glGetError", getError},
  };
  return rows;
}

} // namespace bench
