#pragma once
#include <array>
#include <string>
#include <vector>

#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// How a source register is spelled: as a variable that can be swizzled, or as four components.
struct RegisterText {
  std::string variable; ///< empty: only the components can be named
  std::array<std::string, 4> components;
};

/// The GLSL names of everything a program uses, and the declarations they need. Registers that no
/// instruction reads are given no name and no declaration.
class Registers {
public:
  explicit Registers(const ir::Program &program);

  [[nodiscard]] const RegisterText &source(ir::File file, std::uint16_t index) const;
  /// "t3", "gl_FragColor", "gl_FragData[1]", "arb_color[0]"; empty for result.depth.
  [[nodiscard]] const std::string &temporary(std::uint16_t index) const;
  [[nodiscard]] const std::string &output(std::uint16_t index) const;

  /// Local declarations, one a line, for the top of main().
  [[nodiscard]] const std::string &locals() const { return m_locals; }
  [[nodiscard]] const std::vector<GlslUniform> &uniforms() const { return m_uniforms; }
  [[nodiscard]] const std::vector<GlslSampler> &samplers() const { return m_samplers; }
  [[nodiscard]] bool readsPosition() const { return m_readsPosition; }
  [[nodiscard]] bool readsRectangle() const { return m_readsRectangle; }

private:
  void nameUsed(const ir::Program &program, const ir::Operand &operand);
  void nameAttribute(std::size_t index, const ir::Attribute &attribute);
  void nameParameter(std::size_t index, const ir::Parameter &parameter);
  void nameUniform(RegisterText &name, const ir::Parameter &parameter);
  void nameTemporaries(const ir::Program &program);
  void nameOutputs(const ir::Program &program);
  void nameSampler(const ir::Instruction &instruction);

  std::vector<RegisterText> m_temporaries, m_attributes, m_parameters;
  std::vector<std::string> m_outputs;
  std::vector<GlslUniform> m_uniforms;
  std::vector<GlslSampler> m_samplers;
  std::string m_locals;
  bool m_readsPosition = false;
  bool m_readsRectangle = false;
};

} // namespace arbiter::fp::glsl
