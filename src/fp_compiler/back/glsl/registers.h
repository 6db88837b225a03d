#pragma once
#include <array>
#include <string>
#include <vector>

#include "fp_compiler/back/glsl/arrays.h"
#include "fp_compiler/back/glsl/bindings.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// Assigns GLSL names to everything that a program uses, and writes the declarations. Registers
/// that no instruction reads get no name. Requires: hoistRelative() has run.
class Registers {
public:
  /// \param numerics the arithmetic that the program follows. Under Fp24, each input is rounded
  /// into a local of its own.
  explicit Registers(const ir::Program &program, Numerics numerics = Numerics::Host,
                     const GlslHost &host = {});

  /// Returns the text of a source register. Requires: the operand is not relative.
  [[nodiscard]] const RegisterText &source(ir::File file, std::uint16_t index) const;
  /// Returns the name of a temporary: "t3".
  [[nodiscard]] const std::string &temporary(std::uint16_t index) const;
  [[nodiscard]] const OutputText &output(std::uint16_t index) const { return m_outputs[index]; }

  /// Returns declarations of uniforms, attributes, samplers and the arrays' functions.
  [[nodiscard]] std::string declarations() const;
  /// Returns local declarations, one on each line, for the top of main().
  [[nodiscard]] const std::string &locals() const { return m_locals; }
  [[nodiscard]] const std::vector<GlslUniform> &uniforms() const { return m_uniforms; }
  [[nodiscard]] const std::vector<GlslSampler> &samplers() const { return m_samplers; }
  [[nodiscard]] const std::vector<GlslAttribute> &attributes() const { return m_generics; }
  /// True for a vertex program, false for a fragment program.
  [[nodiscard]] bool ofVertices() const { return m_ofVertices; }
  /// Returns GlslHost::alphaDepths.
  [[nodiscard]] std::uint32_t alphaDepths() const { return m_alphaDepths; }
  /// True if the program reads fragment.position.
  [[nodiscard]] bool readsPosition() const { return m_readsPosition; }
  /// True if the program samples a rectangle texture. The text then needs GL_ARB_texture_rectangle.
  [[nodiscard]] bool readsRectangle() const { return m_readsRectangle; }

private:
  void nameUsed(const ir::Program &program, const ir::Operand &operand);
  void nameAttribute(const ir::Program &program, std::size_t index);
  [[nodiscard]] RegisterText spriteText(int index);
  void nameParameter(std::size_t index, const ir::Parameter &parameter);
  void nameUniform(RegisterText &name, const ir::Parameter &parameter);
  void nameTemporaries(const ir::Program &program);
  void nameAddresses(const ir::Program &program);
  void nameOutputs(const ir::Program &program);
  void nameSampler(const ir::Instruction &instruction);

  void makeLocal(RegisterText &name, const std::string &local, const char *function);

  Numerics m_numerics;
  std::uint32_t m_alphaDepths;
  std::uint8_t m_spriteUnits;
  bool m_negativeFogDistances;
  bool m_spriteS;
  bool m_ofVertices;
  std::string m_uniformArray; ///< "arb_param" or "arb_vparam"
  std::vector<GlslUniform> m_uniforms;
  Arrays m_arrays; ///< adds its uniforms first, so that rows also read by number share them
  std::vector<RegisterText> m_temporaries, m_attributes, m_parameters;
  std::vector<OutputText> m_outputs;
  std::vector<GlslSampler> m_samplers;
  std::vector<GlslAttribute> m_generics;
  std::string m_locals;
  bool m_readsPosition = false;
  bool m_readsRectangle = false;
};

} // namespace arbiter::fp::glsl
