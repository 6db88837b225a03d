#include "naive.h"

#include <algorithm>
#include <vector>

#include "fp_compiler/ir/reads.h"

namespace arbiter::r300 {

using namespace fp::ir;

namespace {
/// Returns the slots of an opcode by Mesa 22.3.6's r300 compiler, without presubtract.
std::uint32_t slotsOf(Opcode op) {
  switch (op) {
  case Opcode::Flr:
  case Opcode::Xpd:
  case Opcode::Lrp:
  case Opcode::Sge:
  case Opcode::Slt:
    return 2;
  case Opcode::Pow:
    return 3;
  case Opcode::Dst:
    return 5;
  case Opcode::Sin:
  case Opcode::Cos:
    return 7;
  case Opcode::Lit:
    return 9;
  case Opcode::Scs:
    return 12;
  default:
    return 1;
  }
}

bool nativeSwizzle(const Swizzle &swizzle, std::uint8_t used) {
  using S = std::array<Select, 3>;
  constexpr Select X = Select::X, Y = Select::Y, Z = Select::Z, W = Select::W;
  constexpr S kNative[] = {{X, Y, Z},
                           {X, X, X},
                           {Y, Y, Y},
                           {Z, Z, Z},
                           {W, W, W},
                           {Y, Z, X},
                           {Z, X, Y},
                           {W, Z, Y},
                           {Select::Zero, Select::Zero, Select::Zero},
                           {Select::One, Select::One, Select::One}};
  return std::any_of(std::begin(kNative), std::end(kNative), [&](const S &native) {
    for (std::size_t c = 0; c < 3; ++c)
      if ((used >> c & 1) && swizzle[c] != native[c])
        return false;
    return true;
  });
}

/// Returns the number of copies that bring an operand into a form that the RGB unit reads, one for
/// each component.
std::uint32_t copiesFor(const Operand &operand, std::uint8_t used) {
  const std::uint8_t rgb = used & 7;
  const std::uint8_t signs = operand.negate & rgb;
  if (nativeSwizzle(operand.swizzle, rgb) && (signs == 0 || signs == rgb))
    return 0;
  return std::uint32_t(__builtin_popcount(rgb)) + (used & 8 ? 1 : 0);
}

class Counter {
public:
  Counter(const Program &program, bool scaleRectangles)
      : m_program(program), m_scaleRectangles(scaleRectangles),
        m_written(program.temporaries.size(), false), m_touched(program.temporaries.size(), false),
        m_components(program.temporaries.size(), 0) {}

  NaiveCounts run() {
    for (const Attribute &attribute : m_program.attributes)
      m_counts.pairs += attribute.kind == AttributeKind::Position ? 3 : 0;
    for (const Instruction &instruction : m_program.code) {
      const OpInfo &row = info(instruction.op);
      if (row.has(Texture) || row.has(Kills))
        texture(instruction);
      else
        arithmetic(instruction);
    }
    for (const Output &output : m_program.outputs) {
      if (output.kind != OutputKind::Color)
        continue;
      // This counts a copy to the result; a clamp and the sum; the factor, a clamp, LRP and alpha's
      // clamp.
      m_counts.pairs += 1 + (m_program.options.colorSum ? 2 : 0) +
                        (m_program.options.fog != FogMode::None ? 7 : 0);
    }
    m_counts.pairs += m_counts.nodes; // each node may need an empty slot
    return m_counts;
  }

private:
  void arithmetic(const Instruction &instruction) {
    m_counts.pairs += slotsOf(instruction.op);
    for (int i = 0; i < info(instruction.op).operandCount(); ++i) {
      const Operand &operand = instruction.src[std::size_t(i)];
      m_counts.pairs += copiesFor(operand, operandMask(instruction, i));
      touch(operand);
    }
    wrote(instruction.dst);
  }

  void wrote(const Destination &dst) {
    if (dst.file != File::Temporary)
      return;
    m_written[dst.index] = m_touched[dst.index] = true;
    m_components[dst.index] |= dst.mask;
  }

  void touch(const Operand &operand) {
    if (operand.file == File::Temporary)
      m_touched[operand.index] = true;
  }

  void texture(const Instruction &instruction) {
    ++m_counts.textures;
    const Operand &coordinate = instruction.src[0];
    // A component that was never written is a constant zero.
    const bool inRegister = coordinate.file == File::Attribute ||
                            (coordinate.file == File::Temporary &&
                             (registerMask(instruction, 0) & ~m_components[coordinate.index]) == 0);
    const bool plain = inRegister && coordinate.swizzle == kIdentity && coordinate.negate == 0;
    const bool rectangle = m_scaleRectangles && (instruction.target == TexTarget::Rect ||
                                                 instruction.target == TexTarget::ShadowRect);
    const bool position = coordinate.file == File::Attribute &&
                          m_program.attributes[coordinate.index].kind == AttributeKind::Position;
    if (!plain)
      m_counts.pairs += 4;
    m_counts.pairs += rectangle;
    // The read needs a new node after another read, or if arithmetic of this node uses the
    // register.
    const bool reads = coordinate.file == File::Temporary && m_written[coordinate.index];
    const bool writes = !info(instruction.op).has(Kills) &&
                        instruction.dst.file == File::Temporary && m_touched[instruction.dst.index];
    if (reads || writes || !plain || rectangle || position) {
      ++m_counts.nodes;
      std::fill(m_written.begin(), m_written.end(), false);
      std::fill(m_touched.begin(), m_touched.end(), false);
    }
    if (info(instruction.op).has(Kills))
      return;
    // This counts mask, clamp and output; for a shadow target the comparison, with the divided
    // reference.
    m_counts.pairs += isShadow(instruction.target) ? 6 : 1;
    wrote(instruction.dst);
  }

  const Program &m_program;
  bool m_scaleRectangles;
  std::vector<bool> m_written, m_touched; ///< in this node
  std::vector<std::uint8_t> m_components; ///< written anywhere before
  NaiveCounts m_counts;
};
} // namespace

NaiveCounts naiveCounts(const Program &program, bool scaleRectangles) {
  return Counter(program, scaleRectangles).run();
}

} // namespace arbiter::r300
