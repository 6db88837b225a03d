#include "fp_compiler/front/indirections.h"

namespace arbiter::fp {

using ir::File;

IndirectionCounter::Touched &IndirectionCounter::touched(std::uint16_t temporary) {
  if (temporary >= m_temporaries.size())
    m_temporaries.resize(std::size_t(temporary) + 1);
  return m_temporaries[temporary];
}

bool IndirectionCounter::add(const ir::Instruction &instruction) {
  const ir::OpInfo &op = info(instruction.op);
  const bool kills = op.has(ir::Kills);
  const bool isTexture = op.has(ir::Texture) || kills;
  const bool writesTemporary = !kills && instruction.dst.file == File::Temporary;
  bool opens = false;
  if (isTexture) {
    const ir::Operand &coordinate = instruction.src[0];
    opens = (coordinate.file == File::Temporary && touched(coordinate.index).written == m_node) ||
            (writesTemporary && touched(instruction.dst.index).byAlu == m_node);
    m_node += opens ? 1 : 0;
  } else {
    for (int i = 0; i < op.operandCount(); ++i)
      if (instruction.src[std::size_t(i)].file == File::Temporary)
        touched(instruction.src[std::size_t(i)].index).byAlu = m_node;
    if (writesTemporary)
      touched(instruction.dst.index).byAlu = m_node;
  }
  if (writesTemporary)
    touched(instruction.dst.index).written = m_node;
  return opens;
}

} // namespace arbiter::fp
