#include "backend.h"

#include <epoxy/gl.h>

#include "fp_compiler/back/assembly/assembly.h"
#include "gl_host.h"
#include "scene.h"

namespace arbiter::differential {

namespace {
class ArbBackend : public Backend {
public:
  /// \param printed loads the printed text instead of the application's
  explicit ArbBackend(bool printed) : m_printed(printed) {}
  std::string use(const Stage &fragment, const Stage *vertex) override {
    std::string problem = load(GL_FRAGMENT_PROGRAM_ARB, m_fragment, fragment);
    if (problem.empty() && vertex)
      problem = load(GL_VERTEX_PROGRAM_ARB, m_vertex, *vertex);
    if (!vertex)
      glDisable(GL_VERTEX_PROGRAM_ARB);
    return problem;
  }
  bool hasProgramMatrices() const override { return true; }

private:
  std::string load(GLenum target, GLuint &name, const Stage &stage) const {
    const std::string text = m_printed ? fp::emitAssembly(stage.program) : stage.text;
    if (name)
      glDeleteProgramsARB(1, &name);
    glGenProgramsARB(1, &name);
    glBindProgramARB(target, name);
    glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
    GLint position = -1;
    glGetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
    if (position != -1) {
      const char *message =
          reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
      (void)takeErrors();
      return "refused at byte " + std::to_string(position) + ": " + (message ? message : "") +
             (m_printed ? "\n" + text : "");
    }
    applyLocalParameters(target);
    applyEnvParameters(target);
    glEnable(target);
    return takeErrors();
  }

  bool m_printed;
  GLuint m_fragment = 0, m_vertex = 0;
};

class GlslBackend : public Backend {
public:
  explicit GlslBackend(fp::Numerics numerics) : m_numerics(numerics) {}
  GlslBackend(const GlslBackend &) = delete;
  GlslBackend &operator=(const GlslBackend &) = delete;
  ~GlslBackend() override {
    glUseProgram(0);
    if (m_program)
      glDeleteProgram(m_program);
  }
  std::string use(const Stage &fragment, const Stage *vertex) override {
    const fp::GlslShader fragmentShader = fp::emitGlsl(fragment.program, {}, m_numerics);
    const fp::GlslShader vertexShader =
        vertex ? fp::emitGlsl(vertex->program, {}, m_numerics) : fp::GlslShader{};
    const std::string texts = vertexShader.text + fragmentShader.text;
    if (m_program)
      glDeleteProgram(m_program);
    m_program = glCreateProgram();
    std::string problem = attach(GL_FRAGMENT_SHADER, fragmentShader);
    if (vertex)
      problem += attach(GL_VERTEX_SHADER, vertexShader);
    for (const fp::GlslAttribute &attribute : vertexShader.attributes)
      glBindAttribLocation(m_program, attribute.index, attribute.name.c_str());
    glLinkProgram(m_program);
    GLint linked = 0;
    glGetProgramiv(m_program, GL_LINK_STATUS, &linked);
    if (!linked) {
      char log[4096] = "";
      glGetProgramInfoLog(m_program, sizeof log, nullptr, log);
      return "not compiled: " + problem + log + "\n" + texts;
    }
    glUseProgram(m_program);
    for (const fp::GlslShader *shader : {&fragmentShader, &vertexShader})
      for (const fp::GlslSampler &sampler : shader->samplers)
        glUniform1i(glGetUniformLocation(m_program, sampler.uniform.c_str()), sampler.unit);
    upload("arb_param", fragmentShader);
    upload("arb_vparam", vertexShader);
    const std::string errors = takeErrors();
    return errors.empty() ? "" : errors + "\n" + texts;
  }
  bool hasProgramMatrices() const override { return false; }

private:
  /// Attaches a shader. Returns the host's error messages, or "".
  std::string attach(GLenum type, const fp::GlslShader &emitted) const {
    const GLuint shader = glCreateShader(type);
    const char *text = emitted.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(m_program, shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    char log[4096] = "";
    if (!compiled)
      glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glDeleteShader(shader);
    return log;
  }

  void upload(const char *array, const fp::GlslShader &emitted) const {
    std::vector<float> values;
    for (const fp::GlslUniform &uniform : emitted.uniforms) {
      const Vec4 value = parameterValue(uniform.parameter);
      values.insert(values.end(), value.begin(), value.end());
    }
    if (!values.empty())
      glUniform4fv(glGetUniformLocation(m_program, array), GLsizei(values.size() / 4),
                   values.data());
  }

  fp::Numerics m_numerics;
  GLuint m_program = 0;
};
} // namespace

std::unique_ptr<Backend> arbBackend() { return std::make_unique<ArbBackend>(false); }
std::unique_ptr<Backend> assemblyBackend() { return std::make_unique<ArbBackend>(true); }
std::unique_ptr<Backend> glslBackend(fp::Numerics numerics) {
  return std::make_unique<GlslBackend>(numerics);
}

} // namespace arbiter::differential
