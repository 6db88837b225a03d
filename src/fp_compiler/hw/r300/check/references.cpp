#include "fp_compiler/hw/r300/check/references.h"

#include <algorithm>

namespace arbiter::fp::hw::r300 {

namespace {
class References {
public:
  References(const Code &code, const ir::Program &program, std::vector<Fault> &faults)
      : m_code(code), m_program(program), m_faults(faults) {}

  void run() {
    for (std::size_t i = 0; i < m_code.pairs.size(); ++i) {
      origin(m_code.pairs[i].rgb, say("pair ", i, ", RGB"));
      origin(m_code.pairs[i].alpha, say("pair ", i, ", alpha"));
    }
    for (std::size_t i = 0; i < m_code.textures.size(); ++i)
      textureOrigin(m_code.textures[i], say("TEX ", i));
    for (std::size_t i = 0; i < m_code.constants.size(); ++i)
      constant(m_code.constants[i], say("constant ", i));
    interpolators();
  }

private:
  void add(Rule rule, std::string text) { m_faults.push_back({rule, std::move(text)}); }

  template <typename Half> void origin(const Half &half, const std::string &where) {
    if (half.op != decltype(half.op)::None)
      originOf(half.origin, half.cause == Cause::Instruction, where);
    const auto bound = [&](const ir::Output &output) {
      return output.kind == ir::OutputKind::Color && output.index == half.output;
    };
    if (half.outputMask && std::none_of(m_program.outputs.begin(), m_program.outputs.end(), bound))
      add(Rule::Reference, say(where, ": the program has no result.color[", half.output, "]"));
  }

  void originOf(std::uint16_t origin, bool needed, const std::string &where) {
    if (origin == kNone ? needed : origin >= m_program.code.size())
      add(Rule::Reference, where + ": no such instruction for its origin");
  }

  void textureOrigin(const Texture &texture, const std::string &where) {
    originOf(texture.origin, true, where);
    if (texture.origin >= m_program.code.size())
      return;
    const ir::Instruction &instruction = m_program.code[texture.origin];
    const ir::OpInfo &row = ir::info(instruction.op);
    const bool kill = texture.op == TexOp::Kill;
    if (kill ? !row.has(ir::Kills)
             : !row.has(ir::Texture) || instruction.unit != texture.unit ||
                   instruction.target != texture.target)
      add(Rule::Reference, where + ": its origin is another kind of instruction");
  }

  void constant(const Constant &constant, const std::string &where) {
    if (constant.kind == Constant::Kind::Parameter && constant.index >= m_program.parameters.size())
      add(Rule::Reference, where + ": the program has no such parameter");
    originOf(constant.origin, false, where);
  }

  void interpolators() {
    std::uint32_t used = 0;
    for (const Interpolant &interpolant : m_code.interpolants) {
      if (interpolant.attribute == kFogCoordinate) {
        ++used;
        continue;
      }
      if (interpolant.attribute == kSecondaryColor)
        continue;
      if (interpolant.attribute >= m_program.attributes.size()) {
        add(Rule::Reference,
            say("interpolant ", interpolant.attribute, ": the program has no such attribute"));
        continue;
      }
      const ir::AttributeKind kind = m_program.attributes[interpolant.attribute].kind;
      used += kind != ir::AttributeKind::ColorPrimary && kind != ir::AttributeKind::ColorSecondary;
    }
    if (used != m_code.interpolators)
      add(Rule::Interpolators,
          say(m_code.interpolators, " interpolators are claimed, ", used, " are used"));
  }

  const Code &m_code;
  const ir::Program &m_program;
  std::vector<Fault> &m_faults;
};
} // namespace

void addReferenceFaults(const Code &code, const ir::Program &program, std::vector<Fault> &faults) {
  References(code, program, faults).run();
}

} // namespace arbiter::fp::hw::r300
