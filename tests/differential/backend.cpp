#include "backend.h"

#include <epoxy/gl.h>

#include "gl_host.h"
#include "scene.h"

namespace arbiter::differential {

namespace {
class ArbBackend : public Backend {
public:
  std::string use(const std::string &text, const fp::ir::Program &) override {
    if (m_name)
      glDeleteProgramsARB(1, &m_name);
    glGenProgramsARB(1, &m_name);
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_name);
    glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                       text.data());
    GLint position = -1;
    glGetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
    if (position != -1) {
      const char *message =
          reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
      (void)takeErrors();
      return "refused at byte " + std::to_string(position) + ": " + (message ? message : "");
    }
    applyLocalParameters();
    applyEnvParameters();
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    return takeErrors();
  }
  bool hasProgramMatrices() const override { return true; }

private:
  GLuint m_name = 0;
};

class GlslBackend : public Backend {
public:
  std::string use(const std::string &, const fp::ir::Program &program) override {
    const fp::GlslShader emitted = fp::emitGlsl(program);
    if (m_program)
      glDeleteProgram(m_program);
    m_program = glCreateProgram();
    const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
    const char *text = emitted.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(m_program, shader);
    glLinkProgram(m_program);
    glDeleteShader(shader);
    GLint linked = 0;
    glGetProgramiv(m_program, GL_LINK_STATUS, &linked);
    if (!linked) {
      char log[4096] = "";
      glGetShaderInfoLog(shader, sizeof log, nullptr, log);
      if (!log[0])
        glGetProgramInfoLog(m_program, sizeof log, nullptr, log);
      return std::string("not compiled: ") + log + "\n" + emitted.text;
    }
    glUseProgram(m_program);
    for (const fp::GlslSampler &sampler : emitted.samplers)
      glUniform1i(glGetUniformLocation(m_program, sampler.uniform.c_str()), sampler.unit);
    std::vector<float> values;
    for (const fp::GlslUniform &uniform : emitted.uniforms) {
      const Vec4 value = parameterValue(uniform.parameter);
      values.insert(values.end(), value.begin(), value.end());
    }
    if (!values.empty())
      glUniform4fv(glGetUniformLocation(m_program, "arb_param"), GLsizei(values.size() / 4),
                   values.data());
    const std::string errors = takeErrors();
    return errors.empty() ? "" : errors + "\n" + emitted.text;
  }
  bool hasProgramMatrices() const override { return false; }

private:
  GLuint m_program = 0;
};
} // namespace

std::unique_ptr<Backend> arbBackend() { return std::make_unique<ArbBackend>(); }
std::unique_ptr<Backend> glslBackend() { return std::make_unique<GlslBackend>(); }

} // namespace arbiter::differential
