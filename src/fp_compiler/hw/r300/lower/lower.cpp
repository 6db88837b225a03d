#include "fp_compiler/hw/r300/lower/lower.h"

#include <algorithm>

#include "fp_compiler/hw/r300/lower/arithmetic.h"
#include "fp_compiler/hw/r300/lower/results.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::hw::r300 {

namespace {
class Lowering {
public:
  Lowering(const ir::Program &program, const CompileOptions &options, Flow &flow)
      : m_program(program), m_options(options),
        m_emit(program, program.temporaries.size() + program.outputs.size(), flow),
        m_operands(program, m_emit), m_arithmetic(m_emit),
        m_results(program, flow, m_emit, m_operands), m_masks(program.code.size(), 0),
        m_once(program.code.size(), 0) {}

  void run() {
    liveMasks();
    for (std::size_t i = 0; i < m_program.code.size(); ++i)
      if (m_masks[i] || ir::info(m_program.code[i].op).has(ir::Kills))
        instruction(i);
    m_results.epilogue();
    m_results.outputs();
  }

private:
  [[nodiscard]] Variable variableOf(const ir::Destination &dst) const {
    return dst.file == ir::File::Output ? Variable(m_program.temporaries.size()) + dst.index
                                        : dst.index;
  }
  [[nodiscard]] bool isDepth(const ir::Destination &dst) const {
    return dst.file == ir::File::Output &&
           m_program.outputs[dst.index].kind == ir::OutputKind::Depth;
  }

  /// Finds the components of each instruction's result that are read, and whether there is one
  /// reader.
  void liveMasks() {
    std::vector<std::uint8_t> readers(m_program.temporaries.size() + m_program.outputs.size(), 0);
    std::vector<std::uint8_t> live(m_program.temporaries.size() + m_program.outputs.size(), 0);
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
      live[m_program.temporaries.size() + i] = ir::resultMask(m_program.outputs[i].kind);
    for (std::size_t at = m_program.code.size(); at-- > 0;) {
      ir::Instruction instruction = m_program.code[at];
      const ir::OpInfo &row = ir::info(instruction.op);
      if (!row.has(ir::Kills)) {
        std::uint8_t &liveMask = live[variableOf(instruction.dst)];
        instruction.dst.mask &= liveMask;
        m_masks[at] = instruction.dst.mask;
        if (instruction.dst.mask == 0)
          continue;
        liveMask &= std::uint8_t(~instruction.dst.mask);
        std::uint8_t &count = readers[variableOf(instruction.dst)];
        m_once[at] = count == 1;
        count = liveMask == 0 ? std::uint8_t(0) : count;
      }
      for (int i = 0; i < row.operandCount(); ++i)
        if (instruction.src[std::size_t(i)].file == ir::File::Temporary) {
          const std::size_t variable = instruction.src[std::size_t(i)].index;
          live[variable] |= ir::registerMask(instruction, i);
          readers[variable] = std::uint8_t(std::min(readers[variable] + 1, 2));
        }
    }
  }
  void instruction(std::size_t at) {
    const ir::Instruction &instruction = m_program.code[at];
    const ir::OpInfo &row = ir::info(instruction.op);
    const bool kills = row.has(ir::Kills);
    const Variable destination = kills ? kNoVariable : variableOf(instruction.dst);
    m_emit.begin(std::uint16_t(at), destination);
    std::array<Value, 3> operands;
    for (int i = 0; i < row.operandCount(); ++i)
      operands[std::size_t(i)] = m_operands.read(instruction.src[std::size_t(i)]);
    if (kills) {
      (void)m_emit.texture(TexOp::Kill, instruction, 0xF, operands[0], 0, false);
      return;
    }
    EmitOptions options;
    options.toDestination = true;
    options.clamp = instruction.dst.saturate;
    std::uint8_t mask = m_masks[at];
    if (isDepth(instruction.dst)) {
      depth(instruction, operands, options);
      return;
    }
    const Value result = row.has(ir::Texture)
                             ? sampled(instruction, mask, operands[0], options)
                             : m_arithmetic.computed(instruction.op, mask, operands, options);
    m_emit.set(destination, mask, result, m_once[at]);
  }

  /// Emits an instruction that writes depth. Only the alpha half writes depth, so z is computed in
  /// w.
  void depth(const ir::Instruction &instruction, std::array<Value, 3> &operands,
             const EmitOptions &options) {
    const ir::OpInfo &row = ir::info(instruction.op);
    Value result;
    if (row.has(ir::PerComponent) || row.has(ir::Replicates)) {
      if (row.has(ir::PerComponent))
        for (Value &operand : operands)
          operand = broadcast(operand, 2);
      result = m_arithmetic.computed(instruction.op, 8, operands, options);
    } else {
      EmitOptions own;
      const Value whole = row.has(ir::Texture)
                              ? sampled(instruction, 4, operands[0], own)
                              : m_arithmetic.computed(instruction.op, 4, operands, own);
      result = m_arithmetic.copied(8, broadcast(whole, 2), options);
    }
    m_emit.set(variableOf(instruction.dst), 8, result);
  }

  Value sampled(const ir::Instruction &instruction, std::uint8_t mask, const Value &operand,
                const EmitOptions &options) {
    ir::Instruction trimmed = instruction;
    trimmed.dst.mask = mask;
    const std::uint8_t coordinates = ir::operandMask(trimmed, 0);
    const bool rectangle = instruction.target == ir::TexTarget::Rect ||
                           instruction.target == ir::TexTarget::ShadowRect;
    EmitOptions own;
    Value coordinate = operand;
    if (rectangle && m_options.scaleRectangles) {
      own.cause = Cause::Rectangle;
      coordinate = m_emit.mad(coordinates, operand,
                              m_operands.row(Constant::Kind::RectangleScale, instruction.unit),
                              literals(-0.0f), own);
    }
    const TexOp op = instruction.op == ir::Opcode::Txp   ? TexOp::Project
                     : instruction.op == ir::Opcode::Txb ? TexOp::Bias
                                                         : TexOp::Load;
    const bool shadow = ir::isShadow(instruction.target);
    const bool plain = !shadow && options.toDestination && !options.clamp &&
                       instruction.dst.file == ir::File::Temporary;
    const Refs texel = m_emit.texture(op, instruction, coordinates, coordinate,
                                      std::uint8_t(plain ? mask : 0), plain);
    if (plain)
      return valueOf(texel);
    EmitOptions last = options;
    last.cause = Cause::TextureResult;
    if (!shadow)
      return m_arithmetic.copied(mask, valueOf(texel), last);
    last.clamp = false;
    return m_arithmetic.copied(mask, broadcast(withinDepth(texel, operand, op), 2), last);
  }

  /// Returns in z 1 if the reference is within the sampled depth, otherwise 0.
  Value withinDepth(const Refs &texel, const Value &coordinate, TexOp op) {
    EmitOptions own;
    own.cause = Cause::TextureResult;
    Value reference = coordinate;
    if (op == TexOp::Project)
      reference =
          m_emit.mad(4, coordinate, broadcast(m_emit.scalar(AlphaOp::Rcp, 8, coordinate, own), 3),
                     literals(-0.0f), own);
    return m_emit.compare(4, valueOf(texel), reference, 0.0f, 1.0f, own);
  }

  const ir::Program &m_program;
  const CompileOptions &m_options;
  Emitter m_emit;
  Operands m_operands;
  Arithmetic m_arithmetic;
  Results m_results;
  std::vector<std::uint8_t> m_masks, m_once;
};
} // namespace

void lower(const ir::Program &program, const CompileOptions &options, Flow &flow) {
  Lowering(program, options, flow).run();
}

} // namespace arbiter::fp::hw::r300
