#include <epoxy/gl.h>
#include <vector>

#include "backend.h"
#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/testing/random.h"
#include "gl_host.h"
#include "scene.h"
#include "subject.h"

namespace arbiter::differential {

using namespace fp::ati;

namespace {

/// Sets the textures, the fog and the color sum for the subject.
void applyFixedFunction(const fp::ir::Options &options) {
  for (std::size_t unit = 0; unit < fp::testing::kUnitTargets.size(); ++unit) {
    const fp::ir::TexTarget target = fp::testing::kUnitTargets[unit];
    if (fp::ir::TexTarget::Shadow1D <= target)
      continue;
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glEnable(textureTarget(target));
  }
  glActiveTexture(GL_TEXTURE0);
  constexpr GLint kModes[] = {0, GL_EXP, GL_EXP2, GL_LINEAR};
  if (options.fog == fp::ir::FogMode::None) {
    glDisable(GL_FOG);
  } else {
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, kModes[std::size_t(options.fog)]);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
  }
  (options.colorSum ? glEnable : glDisable)(GL_COLOR_SUM);
}

Vec4 valueOf(const Constant &constant) {
  fp::ir::Parameter row;
  row.index = constant.index;
  row.kind = constant.kind == ConstantKind::Env ? fp::ir::ParameterKind::Env
                                                : fp::ir::ParameterKind::Local;
  return constant.kind == ConstantKind::Value ? constant.value : parameterValue(row);
}

/// Draws with ARB programs, by which the suite measures attributes, and with one form of ATI's
/// shaders.
class AtiBackend : public Backend {
public:
  std::string use(const Stage &fragment, const Stage *vertex) final {
    const bool ati = fragment.text.starts_with(kHeader);
    (ati ? glEnable : glDisable)(m_capability);
    if (!ati)
      return m_arb->use(fragment, vertex);
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
    applyFixedFunction(fragment.program.options);
    return load(fragment.text);
  }
  bool hasProgramMatrices() const final { return true; }

protected:
  explicit AtiBackend(GLenum capability) : m_capability(capability) {}
  virtual std::string load(const std::string &text) = 0;

private:
  GLenum m_capability;
  std::unique_ptr<Backend> m_arb = arbBackend();
};

class TextBackend final : public AtiBackend {
public:
  TextBackend() : AtiBackend(kTarget) {}

private:
  static constexpr GLenum kTarget = 0x8200; // TEXT_FRAGMENT_SHADER_ATI, which no header has

  std::string load(const std::string &text) override {
    if (m_name)
      glDeleteProgramsARB(1, &m_name);
    glGenProgramsARB(1, &m_name);
    glBindProgramARB(kTarget, m_name);
    glProgramStringARB(kTarget, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
    GLint position = -1;
    glGetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
    if (position != -1)
      return "refused at byte " + std::to_string(position) + "; " + takeErrors();
    fp::ir::Parameter row;
    for (row.index = 0; row.index < kConstants; ++row.index) {
      row.kind = fp::ir::ParameterKind::Env;
      glProgramEnvParameter4fvARB(kTarget, row.index, parameterValue(row).data());
      row.kind = fp::ir::ParameterKind::Local;
      glProgramLocalParameter4fvARB(kTarget, row.index, parameterValue(row).data());
    }
    return takeErrors();
  }

  GLuint m_name = 0;
};

class ApiBackend final : public AtiBackend {
public:
  ApiBackend() : AtiBackend(GL_FRAGMENT_SHADER_ATI) {}

private:
  std::string load(const std::string &text) override {
    const std::optional<Shader> shader =
        parse(text, {suiteLimits(), fp::LimitPolicy::Enforce}).shader;
    if (m_name)
      glDeleteFragmentShaderATI(m_name);
    m_name = glGenFragmentShadersATI(1);
    glBindFragmentShaderATI(m_name);
    glBeginFragmentShaderATI();
    for (std::size_t i = 0; i < kConstants; ++i)
      if (shader->constants[i].kind != ConstantKind::Env)
        setConstant(i, shader->constants[i]);
    for (std::size_t i = 0; i < shader->passCount; ++i)
      issue(shader->passes[i]);
    glEndFragmentShaderATI();
    // These constants are global, and read at the draw.
    for (std::size_t i = 0; i < kConstants; ++i)
      if (shader->constants[i].kind == ConstantKind::Env)
        setConstant(i, shader->constants[i]);
    return takeErrors();
  }

  /// Sets a clamped constant: the specification leaves values outside [0,1] undefined, and hosts
  /// differ.
  static void setConstant(std::size_t number, const Constant &constant) {
    Vec4 value = valueOf(constant);
    for (float &component : value)
      component = fp::ir::saturated(component);
    glSetFragmentShaderConstantATI(GL_CON_0_ATI + GLuint(number), value.data());
  }

  static void issue(const Pass &pass) {
    for (std::size_t i = 0; i < pass.setups.size(); ++i) {
      const Setup &setup = pass.setups[i];
      const GLuint source = (setup.fromRegister ? GL_REG_0_ATI : GL_TEXTURE0) + setup.source;
      const GLenum swizzle = GL_SWIZZLE_STR_ATI + GLenum(setup.coordinates);
      if (setup.kind == SetupKind::PassTexCoord)
        glPassTexCoordATI(GL_REG_0_ATI + GLuint(i), source, swizzle);
      else if (setup.kind == SetupKind::SampleMap)
        glSampleMapATI(GL_REG_0_ATI + GLuint(i), source, swizzle);
    }
    for (std::size_t i = 0; i < pass.pairCount; ++i) {
      if (pass.pairs[i].color)
        issue(*pass.pairs[i].color, false);
      if (pass.pairs[i].alpha)
        issue(*pass.pairs[i].alpha, true);
    }
  }

  struct RawArgument {
    GLuint source, replicate, modifiers;
  };

  static RawArgument raw(const Argument &argument) {
    constexpr GLuint kSources[] = {GL_REG_0_ATI, GL_CON_0_ATI,     GL_ZERO,
                                   GL_ONE,       GL_PRIMARY_COLOR, GL_SECONDARY_INTERPOLATOR_ATI};
    constexpr GLuint kReplicates[] = {GL_NONE, GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
    const bool indexed = argument.source <= Source::Constant;
    return {kSources[std::size_t(argument.source)] + (indexed ? argument.index : 0u),
            kReplicates[std::size_t(argument.replicate)],
            (argument.complement ? GL_COMP_BIT_ATI : 0u) | (argument.bias ? GL_BIAS_BIT_ATI : 0u) |
                (argument.twice ? GL_2X_BIT_ATI : 0u) | (argument.negate ? GL_NEGATE_BIT_ATI : 0u)};
  }

  static void issue(const Operation &op, bool alpha) {
    constexpr GLenum kOps[] = {GL_MOV_ATI,  GL_ADD_ATI,  GL_MUL_ATI,     GL_SUB_ATI,
                               GL_DOT3_ATI, GL_DOT4_ATI, GL_MAD_ATI,     GL_LERP_ATI,
                               GL_CND_ATI,  GL_CND0_ATI, GL_DOT2_ADD_ATI};
    constexpr GLuint kScales[] = {GL_NONE,          GL_2X_BIT_ATI,   GL_4X_BIT_ATI,
                                  GL_8X_BIT_ATI,    GL_HALF_BIT_ATI, GL_QUARTER_BIT_ATI,
                                  GL_EIGHTH_BIT_ATI};
    const GLenum name = kOps[std::size_t(op.op)];
    const GLuint to = GL_REG_0_ATI + op.destination;
    const GLuint mask = op.mask == 7 ? GLuint(GL_NONE) : op.mask;
    const GLuint modifiers =
        kScales[std::size_t(op.scale)] | (op.saturate ? GL_SATURATE_BIT_ATI : 0u);
    const RawArgument a = raw(op.arguments[0]), b = raw(op.arguments[1]), c = raw(op.arguments[2]);
    switch (argumentCount(op.op) * 2 + int(alpha)) {
    case 2:
      return glColorFragmentOp1ATI(name, to, mask, modifiers, a.source, a.replicate, a.modifiers);
    case 3:
      return glAlphaFragmentOp1ATI(name, to, modifiers, a.source, a.replicate, a.modifiers);
    case 4:
      return glColorFragmentOp2ATI(name, to, mask, modifiers, a.source, a.replicate, a.modifiers,
                                   b.source, b.replicate, b.modifiers);
    case 5:
      return glAlphaFragmentOp2ATI(name, to, modifiers, a.source, a.replicate, a.modifiers,
                                   b.source, b.replicate, b.modifiers);
    case 6:
      return glColorFragmentOp3ATI(name, to, mask, modifiers, a.source, a.replicate, a.modifiers,
                                   b.source, b.replicate, b.modifiers, c.source, c.replicate,
                                   c.modifiers);
    default:
      return glAlphaFragmentOp3ATI(name, to, modifiers, a.source, a.replicate, a.modifiers,
                                   b.source, b.replicate, b.modifiers, c.source, c.replicate,
                                   c.modifiers);
    }
  }

  GLuint m_name = 0;
};

} // namespace

std::unique_ptr<Backend> atiTextBackend() { return std::make_unique<TextBackend>(); }
std::unique_ptr<Backend> atiApiBackend() { return std::make_unique<ApiBackend>(); }

} // namespace arbiter::differential
