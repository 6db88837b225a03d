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

/// The GLSL names of everything a program uses, and the declarations they need. Registers that no
/// instruction reads are given no name and no declaration. Requires hoistRelative().
class Registers {
public:
  /// \param numerics that the program follows: under Fp24 everything from outside is read into a
  /// local of its own, rounded
  explicit Registers(const ir::Program &program, Numerics numerics = Numerics::Host,
                     const GlslHost &host = {});

  /// Requires: the operand is not relative.
  [[nodiscard]] const RegisterText &source(ir::File file, std::uint16_t index) const;
  /// "t3"
  [[nodiscard]] const std::string &temporary(std::uint16_t index) const;
  [[nodiscard]] const OutputText &output(std::uint16_t index) const { return m_outputs[index]; }

  /// Uniforms, attributes, samplers and the arrays' functions.
  [[nodiscard]] std::string declarations() const;
  /// Local declarations, one a line, for the top of main().
  [[nodiscard]] const std::string &locals() const { return m_locals; }
  [[nodiscard]] const std::vector<GlslUniform> &uniforms() const { return m_uniforms; }
  [[nodiscard]] const std::vector<GlslSampler> &samplers() const { return m_samplers; }
  [[nodiscard]] const std::vector<GlslAttribute> &attributes() const { return m_generics; }
  /// The registers are a vertex program's, else a fragment program's.
  [[nodiscard]] bool ofVertices() const { return m_ofVertices; }
  /// GlslHost::alphaDepths
  [[nodiscard]] std::uint32_t alphaDepths() const { return m_alphaDepths; }
  /// The program reads fragment.position.
  [[nodiscard]] bool readsPosition() const { return m_readsPosition; }
  /// The program samples a rectangle texture: the text needs GL_ARB_texture_rectangle.
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
  Arrays m_arrays; ///< first among the uniforms, so that rows read by number too share its elements
  std::vector<RegisterText> m_temporaries, m_attributes, m_parameters;
  std::vector<OutputText> m_outputs;
  std::vector<GlslSampler> m_samplers;
  std::vector<GlslAttribute> m_generics;
  std::string m_locals;
  bool m_readsPosition = false;
  bool m_readsRectangle = false;
};

} // namespace arbiter::fp::glsl
